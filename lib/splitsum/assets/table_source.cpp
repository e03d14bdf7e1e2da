#include <algorithm>
#include <array>
#include <charconv>
#include <sstream>

#include "splitsum/assets/table_source_detail.h"
#include "splitsum/base/text.h"

namespace splitsum {
namespace {

// The position of a lookup among texel centres, before it is clamped, in a syntax that C++ and GLSL
// share: expressions of n_dot_v and perceptual_roughness, both in [0, 1].
struct Position {
    std::string x;
    std::string y;
};

std::string view_coordinate(const TableKind& kind, const std::string& square_root) {
    return kind.view_axis == ViewAxis::cosine ? "n_dot_v" : cat(square_root, "(1.0 - n_dot_v)");
}

std::string roughness_coordinate(const TablePlan& plan) {
    return plan.roughness_axis == RoughnessAxis::perceptual
               ? "perceptual_roughness"
               : "perceptual_roughness * perceptual_roughness";
}

// `number` spells a literal: "64.0" or "64.0f".
template <class Number>
Position position_of(const TableAsset& asset, const std::string& square_root,
                     const Number& number) {
    const int size = asset.table.width;
    const bool centre = asset.plan.layout == TexelLayout::centre;
    const auto placed = [&](const std::string& coordinate) {
        const std::string factor = number(centre ? size : size - 1);
        return cat(coordinate, " * ", factor, centre ? cat(" - ", number(0.5)) : "");
    };
    std::string view = placed(view_coordinate(asset.kind, square_root));
    std::string rough = placed(roughness_coordinate(asset.plan));
    if (asset.plan.axes == TableAxes::roughness_nv) std::swap(view, rough);
    if (asset.plan.flip) rough = cat(number(size - 1), " - (", rough, ")");
    return {view, rough};
}

std::string numbers(std::span<const float> values, const std::string& suffix) {
    std::string text;
    for (size_t i = 0; i < values.size(); ++i)
        text += cat(i == 0 ? "    " : i % 8 == 0 ? ",\n    " : ", ", float_text(values[i]), suffix);
    return text;
}

constexpr std::array<const char*, 5> glsl_types = {"", "float", "vec2", "vec3", "vec4"};

std::span<const float> values_of_layer(const Table& table, int layer) {
    const size_t count = table.values.size() / static_cast<size_t>(table.layers);
    return std::span(table.values).subspan(static_cast<size_t>(layer) * count, count);
}

std::string glsl_array(const Table& table, int layer, const std::string& name) {
    const std::string type = glsl_types[static_cast<size_t>(table.channels)];
    const int texels = table.width * table.height;
    const auto channels = static_cast<size_t>(table.channels);
    const auto values = values_of_layer(table, layer);
    std::ostringstream text;
    text << "const " << type << " " << name << "_texels[" << texels << "] = " << type << "["
         << texels << "](";
    for (size_t i = 0; i < values.size(); i += channels)
        text << (i == 0                  ? "\n    "
                 : i / channels % 4 == 0 ? ",\n    "
                                         : ", ")
             << type << "(" << join(values.subspan(i, channels), ", ", float_text) << ")";
    text << ");\n";
    return text.str();
}

std::string glsl_lookup(const TableAsset& asset, int layer, const std::string& name) {
    const Table& table = asset.table;
    const std::string type = glsl_types[static_cast<size_t>(table.channels)];
    const auto number = [](double value) { return float_text(static_cast<float>(value)); };
    const Position at = position_of(asset, "sqrt", number);
    const std::string last = number(table.width - 1);
    return cat(glsl_array(table, layer, name), "\n", type, " ", name,
               "(float n_dot_v, float perceptual_roughness) {\n"
               "    n_dot_v = clamp(n_dot_v, 0.0, 1.0);\n"
               "    perceptual_roughness = clamp(perceptual_roughness, 0.0, 1.0);\n"
               "    vec2 at = clamp(vec2(",
               at.x, ", ", at.y, "), 0.0, ", last,
               ");\n"
               "    ivec2 low = ivec2(at);\n"
               "    ivec2 high = min(low + 1, ivec2(",
               table.width - 1,
               "));\n"
               "    vec2 part = at - vec2(low);\n"
               "    return mix(mix(",
               name, "_texels[low.y * ", table.width,
               " + low.x],\n"
               "                   ",
               name, "_texels[low.y * ", table.width,
               " + high.x], part.x),\n"
               "               mix(",
               name, "_texels[high.y * ", table.width,
               " + low.x],\n"
               "                   ",
               name, "_texels[high.y * ", table.width,
               " + high.x], part.x),\n"
               "               part.y);\n"
               "}\n");
}

std::string channels_text(const TableKind& kind) { return join(kind.channel_names, ", "); }

}  // namespace

std::string float_text(float value) {
    std::array<char, 32> digits;
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
    std::string text(digits.data(), end);
    return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
}

std::string identifier_of(const TableKind& kind) {
    std::string name = cat("splitsum_", kind.name);
    std::ranges::replace(name, '-', '_');
    return name;
}

std::string metadata_comment(const TableAsset& asset) {
    std::string text;
    for (const auto& [key, value] : asset.texture.metadata)
        text += cat("// ", key, ": ", value, "\n");
    return text;
}

std::string table_as_glsl(const TableAsset& asset) {
    if (asset.kind.is_closed_form()) return formula_as_glsl(asset);
    const std::string name = identifier_of(asset.kind);
    std::string text = cat("// ", asset.kind.value, "\n// channels: ", channels_text(asset.kind),
                           "\n", metadata_comment(asset));
    for (int layer = 0; layer < asset.table.layers; ++layer) {
        const std::string suffix = asset.table.layers == 1 ? "" : cat("_layer", layer);
        text += cat("\n", glsl_lookup(asset, layer, cat(name, suffix)));
    }
    return text;
}

std::string table_as_cpp(const TableAsset& asset) {
    if (asset.kind.is_closed_form()) return formula_as_cpp(asset);
    const Table& table = asset.table;
    const auto number = [](double value) { return float_text(static_cast<float>(value)) + "f"; };
    const Position at = position_of(asset, "std::sqrt", number);
    const int channels = table.channels * table.layers;
    return cat(
        "// ", asset.kind.value, "\n", metadata_comment(asset),
        "#pragma once\n\n#include <algorithm>\n#include <cmath>\n\nnamespace ",
        identifier_of(asset.kind), " {\n\nconstexpr int width = ", table.width,
        ", height = ", table.height, ", channels = ", table.channels, ", layers = ", table.layers,
        ";\n\n// Layer by layer, row by row, texel by texel: ", channels_text(asset.kind),
        ".\ninline constexpr float values[] = {\n", numbers(table.values, "f"),
        "};\n\n"
        "// What a sampler with a linear filter and clamp-to-edge returns: ",
        channels,
        " numbers into `read`.\n"
        "inline void look_up(float n_dot_v, float perceptual_roughness, float* read) {\n"
        "    n_dot_v = std::clamp(n_dot_v, 0.0f, 1.0f);\n"
        "    perceptual_roughness = std::clamp(perceptual_roughness, 0.0f, 1.0f);\n"
        "    const float x = std::clamp(",
        at.x,
        ", 0.0f, width - 1.0f);\n"
        "    const float y = std::clamp(",
        at.y,
        ", 0.0f, height - 1.0f);\n"
        "    const int left = static_cast<int>(x), top = static_cast<int>(y);\n"
        "    const int right = std::min(left + 1, width - 1);\n"
        "    const int bottom = std::min(top + 1, height - 1);\n"
        "    const float across = x - static_cast<float>(left);\n"
        "    const float down = y - static_cast<float>(top);\n"
        "    for (int i = 0; i < channels * layers; ++i) {\n"
        "        const float* layer = values + i / channels * width * height * channels;\n"
        "        const auto texel = [&](int column, int row) {\n"
        "            return layer[(row * width + column) * channels + i % channels];\n"
        "        };\n"
        "        const float above = texel(left, top) + across * (texel(right, top) - texel(left, "
        "top));\n"
        "        const float below =\n"
        "            texel(left, bottom) + across * (texel(right, bottom) - texel(left, bottom));\n"
        "        read[i] = above + down * (below - above);\n"
        "    }\n"
        "}\n\n}  // namespace ",
        identifier_of(asset.kind), "\n");
}

}  // namespace splitsum
