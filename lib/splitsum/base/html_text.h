#pragma once

#include <string>
#include <string_view>

namespace splitsum {

/// `text` as it stands between tags of HTML, or between the double quotes of an attribute.
std::string html_text(std::string_view text);

}  // namespace splitsum
