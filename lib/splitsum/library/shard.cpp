#include "splitsum/library/shard.h"

#include <algorithm>
#include <charconv>
#include <numeric>
#include <tuple>

#include "splitsum/base/text.h"

namespace splitsum {
namespace {

// All of the text, or nothing.
bool parse_whole(std::string_view text, int& value) {
    const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
    return failure == std::errc() && end == text.data() + text.size();
}

struct Load {
    int64_t pixels = 0;
    size_t items = 0;  // decides where pixels do not: unreadable files are spread as well
};

}  // namespace

Result<Shard> parse_shard(const std::string& text) {
    Shard shard;
    const std::string_view whole = text;
    const size_t slash = whole.find('/');
    if (slash == std::string_view::npos || !parse_whole(whole.substr(0, slash), shard.index) ||
        !parse_whole(whole.substr(slash + 1), shard.count) || shard.index < 1 ||
        shard.index > shard.count)
        return Error{ErrorKind::bad_argument,
                     cat("'", text, "' is no shard; the second of eight is 2/8")};
    return shard;
}

std::vector<size_t> items_of(const Shard& shard, std::span<const int64_t> pixels) {
    std::vector<size_t> order(pixels.size());
    std::iota(order.begin(), order.end(), size_t{0});
    std::ranges::stable_sort(order, [&](size_t a, size_t b) { return pixels[a] > pixels[b]; });

    std::vector<Load> loads(static_cast<size_t>(shard.count));
    std::vector<size_t> items;
    for (const size_t item : order) {
        const auto least = std::ranges::min_element(
            loads, {}, [](const Load& load) { return std::tuple(load.pixels, load.items); });
        least->pixels += pixels[item];
        ++least->items;
        if (least - loads.begin() == shard.index - 1) items.push_back(item);
    }
    std::ranges::sort(items);
    return items;
}

int64_t pixels_in(const std::filesystem::path& panorama, const PanoramaOptions& reading) {
    const auto size = panorama_size(panorama, reading);
    return size ? int64_t{size->width} * size->height : 0;
}

}  // namespace splitsum
