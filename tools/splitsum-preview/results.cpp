#include "results.h"

#include <iostream>
#include <nlohmann/json.hpp>

#include "splitsum/base/text.h"
#include "splitsum/report/figures_json.h"
#include "splitsum/report/figures_text.h"

namespace splitsum::tools {
namespace {

using Json = nlohmann::ordered_json;

Json list_of(const Vec3d& v) { return {v.x, v.y, v.z}; }

Json sphere_json(const SphereResult& result) {
    const Material& material = result.sphere.material;
    return {{"name", result.sphere.name},
            {"base_color", list_of(material.base_color)},
            {"metalness", material.metalness},
            {"perceptual_roughness", material.perceptual_roughness},
            {"pixels", result.pixels}};
}

const char* name_of(TruthEnd end) {
    switch (end) {
        case TruthEnd::noise_reached: return "noise_reached";
        case TruthEnd::out_of_time: return "out_of_time";
        case TruthEnd::cancelled: return "cancelled";
        case TruthEnd::out_of_points: return "out_of_points";
    }
    return "";
}

Json truth_json(const TruthResult& truth) {
    return {{"noise", truth.noise},
            {"samples", truth.samples},
            {"passes", truth.passes},
            {"ended", name_of(truth.end)}};
}

Json results_json(const PreviewResults& results) {
    Json json = {{"file", results.file.string()},
                 {"pictures", results.pictures},
                 {"view", results.view},
                 {"exposure_stops", results.exposure_stops},
                 {"notes", results.notes}};
    if (!results.page.empty()) json["page"] = results.page.string();
    json["spheres"] = Json::array();
    for (const SphereResult& sphere : results.spheres)
        json["spheres"].push_back(sphere_json(sphere));
    if (results.truth) json["truth"] = truth_json(*results.truth);
    if (results.chain.levels.empty()) return json;
    json["levels"] = Json::array();
    for (const LevelCheck& level : results.chain.levels)
        json["levels"].push_back(check_json(level));
    json["between_texels_and_levels"] = readings_json(results.chain.between);
    return json;
}

void print_text(const PreviewResults& results) {
    for (const std::string& note : results.notes) std::cout << "note: " << note << "\n";
    if (!results.chain.levels.empty()) {
        std::cout << figures_heading(false);
        for (const LevelCheck& level : results.chain.levels)
            std::cout << figures_line(cat("level ", level.level), level);
        std::cout << "What an engine reads between texels and levels:\n"
                  << readings_text(results.chain.between);
    }
    if (results.truth)
        std::cout << cat("The truth has a mean relative standard error of ", results.truth->noise,
                         " (", name_of(results.truth->end), ", ", results.truth->samples,
                         " samples).\n");
    if (results.pictures.size() > 1)
        std::cout << "pictures: " << join(results.pictures, ", ") << "\n";
    std::cout << results.file.string() << "\n";
    if (!results.page.empty()) std::cout << results.page.string() << "\n";
}

}  // namespace

void print(const PreviewResults& results, bool json) {
    if (json)
        std::cout << results_json(results).dump(2) << "\n";
    else
        print_text(results);
}

}  // namespace splitsum::tools
