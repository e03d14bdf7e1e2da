#include "splitsum/manifest/setting.h"

#include <algorithm>
#include <iterator>

#include "splitsum/base/text.h"

namespace splitsum {

std::string place_of(const Setting& setting) {
    return cat(setting.file.string(), ":", setting.line);
}

std::vector<Setting> overlaid(const std::vector<Setting>& above,
                              const std::vector<Setting>& below) {
    std::vector<Setting> both;
    both.reserve(above.size() + below.size());
    // Of equals set_union takes the first range's.
    std::ranges::set_union(above, below, std::back_inserter(both), {}, &Setting::option,
                           &Setting::option);
    return both;
}

}  // namespace splitsum
