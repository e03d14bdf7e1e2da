#include "splitsum/imageio/channel_choice_detail.h"

#include <algorithm>
#include <optional>

#include "splitsum/base/text.h"

namespace splitsum {
namespace {

struct Channel {
    std::string layer;  ///< "" for the default layer
    std::string name;   ///< in lower case
};

Channel parse(const std::string& full_name) {
    const size_t dot = full_name.rfind('.');
    Channel channel;
    if (dot != std::string::npos) channel.layer = full_name.substr(0, dot);
    channel.name = dot == std::string::npos ? full_name : full_name.substr(dot + 1);
    std::ranges::transform(channel.name, channel.name.begin(), [](char c) {
        return 'A' <= c && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    });
    return channel;
}

/// The channels of one file, looked up by layer and lower-case name.
class ChannelList {
public:
    explicit ChannelList(const std::vector<std::string>& names) {
        for (const std::string& name : names) channels_.push_back(parse(name));
    }

    int size() const { return static_cast<int>(channels_.size()); }
    const Channel& operator[](int i) const { return channels_[static_cast<size_t>(i)]; }

    std::optional<int> find(const std::string& layer, const char* name,
                            const char* long_name) const {
        for (int i = 0; i < size(); ++i)
            if ((*this)[i].layer == layer &&
                ((*this)[i].name == name || (*this)[i].name == long_name))
                return i;
        return std::nullopt;
    }

    std::optional<std::array<int, 3>> find_rgb(const std::string& layer) const {
        const auto r = find(layer, "r", "red");
        const auto g = find(layer, "g", "green");
        const auto b = find(layer, "b", "blue");
        if (!r || !g || !b) return std::nullopt;
        return std::array{*r, *g, *b};
    }

    /// A luminance Y: not the y of a vector x, y, z.
    std::optional<int> find_luminance(const std::string& layer) const {
        if (find(layer, "x", "x")) return std::nullopt;
        return find(layer, "y", "luminance");
    }

    /// Layers that have a name and colours, in file order.
    std::vector<std::string> color_layers() const {
        std::vector<std::string> layers;
        for (const Channel& channel : channels_)
            if (!channel.layer.empty() && std::ranges::count(layers, channel.layer) == 0 &&
                (find_rgb(channel.layer) || find_luminance(channel.layer)))
                layers.push_back(channel.layer);
        return layers;
    }

private:
    std::vector<Channel> channels_;
};

bool is_alpha(const Channel& channel) {
    return channel.name == "a" || channel.name == "alpha" || channel.name == "ar" ||
           channel.name == "ag" || channel.name == "ab";
}

/// Colours, or a luminance as grey, of one layer; nothing where it has neither.
Result<std::optional<std::array<int, 3>>> colors_of_layer(const ChannelList& list,
                                                          const std::string& layer) {
    if (const auto rgb = list.find_rgb(layer)) return rgb;
    const auto y = list.find_luminance(layer);
    if (!y) return std::optional<std::array<int, 3>>();
    if (list.find(layer, "ry", "ry") || list.find(layer, "by", "by"))
        return Error{ErrorKind::unusable_input,
                     "holds luminance and chroma (Y, RY, BY); save it with R, G and B channels"};
    return std::optional(std::array{*y, *y, *y});
}

bool is_depth(const Channel& channel) {
    return channel.name == "z" || channel.name == "zback" || channel.name == "depth";
}

/// A file whose one channel, alpha aside, has a name that says nothing.
std::optional<std::array<int, 3>> only_channel(const ChannelList& list) {
    std::optional<std::array<int, 3>> only;
    for (int i = 0; i < list.size(); ++i) {
        if (list.size() > 1 && is_alpha(list[i])) continue;
        if (only || is_depth(list[i])) return std::nullopt;
        only = std::array{i, i, i};
    }
    return only;
}

std::vector<std::string> notes_on(const ChannelList& list, const std::vector<std::string>& names,
                                  const std::array<int, 3>& rgb) {
    std::vector<std::string> notes;
    const std::string& layer = list[rgb[0]].layer;
    if (!layer.empty()) notes.push_back(cat("read layer '", layer, "'"));
    if (rgb[0] == rgb[1])
        notes.push_back(cat("channel ", names[static_cast<size_t>(rgb[0])], " was read as grey"));
    std::vector<std::string> ignored;
    bool alpha = false;
    for (int i = 0; i < list.size(); ++i) {
        if (std::ranges::count(rgb, i) > 0) continue;
        if (is_alpha(list[i]) && list[i].layer == layer)
            alpha = true;
        else
            ignored.push_back(names[static_cast<size_t>(i)]);
    }
    if (alpha) notes.emplace_back("alpha was dropped; colours are used as stored");
    if (!ignored.empty()) notes.push_back(cat("ignored channels: ", join(ignored, ", ")));
    return notes;
}

Result<std::array<int, 3>> find_colors(const ChannelList& list,
                                       const std::vector<std::string>& names,
                                       const std::string& layer) {
    const auto layers = list.color_layers();
    auto colors = colors_of_layer(list, layer);
    if (!colors) return colors.error();
    if (*colors) return **colors;
    if (!layer.empty())
        return Error{ErrorKind::bad_argument,
                     cat("has no layer '", layer, "' with colours; it has: ",
                         layers.empty() ? join(names, ", ") : join(layers, ", "))};
    if (layers.size() > 1)
        return Error{ErrorKind::unusable_input,
                     cat("has no colours outside its layers; choose one of: ", join(layers, ", "))};
    if (layers.size() == 1) {
        colors = colors_of_layer(list, layers.front());
        if (!colors) return colors.error();
        return **colors;
    }
    if (const auto grey = only_channel(list)) return *grey;
    return Error{ErrorKind::unusable_input,
                 cat("has no colour channels R, G, B or Y; it has: ", join(names, ", "))};
}

}  // namespace

Result<ChannelChoice> choose_channels(const std::vector<std::string>& names,
                                      const std::string& layer) {
    const ChannelList list(names);
    const auto rgb = find_colors(list, names, layer);
    if (!rgb) return rgb.error();
    return ChannelChoice{*rgb, notes_on(list, names, *rgb)};
}

}  // namespace splitsum
