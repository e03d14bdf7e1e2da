#include "splitsum/preview/page.h"

#include <array>
#include <nlohmann/json.hpp>
#include <utility>

#include "splitsum/base/atomic_file.h"
#include "splitsum/base/base64.h"
#include "splitsum/base/html_text.h"
#include "splitsum/base/text.h"
#include "splitsum/base/version.h"
#include "splitsum/preview/difference.h"
#include "splitsum/preview/page_files_detail.h"
#include "splitsum/preview/page_texels.h"
#include "splitsum/preview/view_lut.h"

namespace splitsum {
namespace {

using Json = nlohmann::ordered_json;

// What the page's script finds in the document: facts as JSON, and texels by the name under which the
// facts speak of them.
struct PageData {
    Json facts;
    std::string texels;  // elements
};

// Text cannot end the element: neither '<' nor any other letter of HTML is a digit of base 64.
void add_texels(PageData& data, const std::string& name, const std::string& base64) {
    data.texels +=
        cat("<script type=\"text/plain\" id=\"texels-", name, "\">", base64, "</script>\n");
}

Json list_of(const Vec3d& v) { return {v.x, v.y, v.z}; }

Json sphere_json(const Sphere& sphere) {
    return {{"name", sphere.name},
            {"centre", list_of(sphere.centre)},
            {"radius", sphere.radius},
            {"baseColor", list_of(sphere.material.base_color)},
            {"metalness", sphere.material.metalness},
            {"perceptualRoughness", sphere.material.perceptual_roughness}};
}

Json table_json(const PageTable& table) {
    return {{"heading", table.heading},
            {"note", table.note},
            {"columns", table.columns},
            {"rows", table.rows}};
}

Json start_json(const Page& page) {
    return {{"width", page.viewpoint.width},
            {"height", page.viewpoint.height},
            {"yaw", page.viewpoint.yaw_degrees},
            {"pitch", page.viewpoint.pitch_degrees},
            {"background", page.background == Background::light ? "level-0" : "none"},
            {"exposure", page.exposure_stops},
            {"view", page.view}};
}

void add_levels(PageData& data, const std::string& name, std::span<const Cubemap> levels) {
    const PageTexels texels = page_texels(levels);
    Json sizes = Json::array();
    for (const Cubemap& level : levels) sizes.push_back(level.face_size);
    data.facts[name] = {{"format", texels.format}, {"exact", texels.exact}, {"sizes", sizes}};
    add_texels(data, name, texels.base64);
}

void add_light(PageData& data, const BakedLight& light) {
    add_levels(data, "specular", light.specular);
    const RoughnessCurve::Kind kind = light.curve.kind;
    data.facts["specular"]["curve"] = kind == RoughnessCurve::Kind::linear     ? "linear"
                                      : kind == RoughnessCurve::Kind::filament ? "filament"
                                                                               : "list";
    data.facts["specular"]["perceptualRoughness"] =
        roughness_of_levels(light.curve, int(light.specular.size()));
    add_levels(data, "irradiance", std::span(&light.irradiance, 1));
    const PageTexels table = page_texels(light.split_sum);
    data.facts["table"] = {{"format", table.format},
                           {"exact", table.exact},
                           {"width", light.split_sum.width},
                           {"height", light.split_sum.height}};
    add_texels(data, "table", table.base64);
}

// A view as a table of colours; one without `view` is a formula of the page.
void add_view(PageData& data, std::string_view name, const View* view) {
    Json facts = {{"name", name}};
    if (view != nullptr) {
        const ViewLut lut = view_lut_of(*view);
        const std::string texels_name = cat("view-", data.facts["views"].size());
        facts["lut"] = {{"size", lut.size},
                        {"texels", texels_name},
                        {"steepness", ViewLut::steepness},
                        {"brightest", ViewLut::brightest}};
        const auto* bytes = reinterpret_cast<const char*>(lut.rgb10.data());
        add_texels(data, texels_name, base64({bytes, 4 * lut.rgb10.size()}));
    }
    data.facts["views"].push_back(facts);
}

Status add_views(PageData& data, const Page& page) {
    data.facts["views"] = Json::array();
    for (const ViewInfo& info : views()) {
        if (info.name == "srgb" || info.name == "filmic") {
            add_view(data, info.name, nullptr);
            continue;
        }
        const auto view = View::find(std::string(info.name), {});
        if (!view) return view.error();
        add_view(data, info.name, &*view);
    }
    if (page.more_view != nullptr) add_view(data, page.view, page.more_view);
    return ok;
}

void add_truth(PageData& data, const Page& page) {
    data.facts["noTruth"] = page.no_truth;
    if (!page.truth) return;
    const Image& picture = *page.truth->picture;
    data.facts["truth"] = {{"width", picture.width},
                           {"height", picture.height},
                           {"note", page.truth->note},
                           {"leastLuminance", page.truth->least_luminance},
                           {"fullDifference", full_difference},
                           {"tooBright", difference_color(full_difference)},
                           {"tooDark", difference_color(-full_difference)},
                           {"differenceBackground", difference_background}};
    add_texels(data, "truth", page_texels(picture).base64);
}

Result<PageData> data_of(const Page& page) {
    PageData data;
    data.facts = {{"version", version},
                  {"title", page.title},
                  {"notes", page.notes},
                  {"fieldDegrees", vertical_field_degrees},
                  {"start", start_json(page)}};
    data.facts["sceneNote"] = page.scene_note;
    data.facts["spheres"] = Json::array();
    for (const Sphere& sphere : page.scene.spheres)
        data.facts["spheres"].push_back(sphere_json(sphere));
    data.facts["tables"] = Json::array();
    for (const PageTable& table : page.tables) data.facts["tables"].push_back(table_json(table));
    add_light(data, *page.light);
    if (const Status added = add_views(data, page); !added) return added.error();
    add_truth(data, page);
    return data;
}

// JSON inside of an element: a '<' would begin a tag, and is a letter of strings alone.
std::string json_element_text(const Json& json) {
    std::string text;
    for (const char letter : json.dump(-1, ' ', false, Json::error_handler_t::replace))
        if (letter == '<')
            text += "\\u003c";
        else
            text += letter;
    return text;
}

// `text` with every {{name}} replaced by its value; values are not looked into.
std::string filled(std::string_view text,
                   std::span<const std::pair<std::string_view, std::string_view>> values) {
    std::string result;
    while (true) {
        const size_t open = text.find("{{");
        result += text.substr(0, open);
        if (open == text.npos) return result;
        const size_t close = text.find("}}", open);
        const std::string_view name = text.substr(open + 2, close - open - 2);
        for (const auto& [known, value] : values)
            if (name == known) result += value;
        text.remove_prefix(close + 2);
    }
}

}  // namespace

Result<std::string> page_text(const Page& page) {
    const auto data = data_of(page);
    if (!data) return data.error();
    const std::string title = html_text(page.title);
    const std::string facts = json_element_text(data->facts);
    const std::array<std::pair<std::string_view, std::string_view>, 7> values = {{
        {"title", title},
        {"style", page_files::style},
        {"facts", facts},
        {"texels", data->texels},
        {"vertex_shader", page_files::vertex_shader},
        {"fragment_shader", page_files::fragment_shader},
        {"script", page_files::script},
    }};
    return filled(page_files::html, values);
}

Status write_page(const Page& page, const std::filesystem::path& path) {
    const auto text = page_text(page);
    if (!text) return text.error();
    return write_text_whole(path, *text);
}

}  // namespace splitsum
