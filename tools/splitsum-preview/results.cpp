#include "results.h"

#include <iomanip>
#include <iostream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "splitsum/base/text.h"
#include "splitsum/report/figures_json.h"
#include "splitsum/report/figures_text.h"

namespace splitsum::tools {
namespace {

using Json = nlohmann::ordered_json;

Json list_of(const Vec3d& v) { return {v.x, v.y, v.z}; }

Json noisy_json(const NoisyFigures& figures) {
    return {{"rel_rms", figures.rel_rms},
            {"bias", figures.bias},
            {"noise", figures.noise},
            {"pixels", figures.pixels}};
}

Json sphere_json(const SphereResult& result) {
    const Material& material = result.sphere.material;
    Json json = {{"name", result.sphere.name},
                 {"base_color", list_of(material.base_color)},
                 {"metalness", material.metalness},
                 {"perceptual_roughness", material.perceptual_roughness},
                 {"pixels", result.pixels}};
    if (!result.errors) return json;
    json["baked_data"] = figures_json(result.errors->baked_data);
    json["approximation"] = noisy_json(result.errors->approximation);
    json["together"] = noisy_json(result.errors->together);
    return json;
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

// Nothing to add where the noise that was asked for was reached.
const char* ending_of(TruthEnd end) {
    switch (end) {
        case TruthEnd::noise_reached: return "";
        case TruthEnd::out_of_time: return "; then the time was up";
        case TruthEnd::cancelled: return "; then it was interrupted";
        case TruthEnd::out_of_points: return "; there are no more points to take";
    }
    return "";
}

Json truth_json(const TruthResult& truth) {
    return {{"noise", truth.noise},
            {"samples", truth.samples},
            {"passes", truth.passes},
            {"ended", name_of(truth.end)},
            {"split_exact", figures_json(truth.split_exact)}};
}

Json results_json(const PreviewResults& results) {
    Json json = {{"file", results.file.string()},
                 {"pictures", results.pictures},
                 {"view", results.view},
                 {"exposure_stops", results.exposure_stops},
                 {"yaw_degrees", results.yaw_degrees},
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

// "dielectric 3               1.23e-03 ...": as the levels' figures are printed.
std::string sphere_line(const SphereResult& result) {
    std::ostringstream line;
    line << std::left << std::setw(16) << result.sphere.name << std::right << std::fixed
         << std::setprecision(4) << std::setw(15) << result.sphere.material.perceptual_roughness
         << std::scientific << std::setprecision(2) << std::setw(12)
         << result.errors->baked_data.rel_rms << std::setw(15)
         << result.errors->approximation.rel_rms << std::setw(11) << result.errors->together.rel_rms
         << std::setw(11) << result.errors->approximation.noise << "\n";
    return line.str();
}

void print_spheres(const PreviewResults& results) {
    if (results.spheres.empty() || !results.spheres.front().errors) return;
    std::cout << "What each sphere misses the truth by (rel_rms), and the truth's own noise:\n"
              << "                      roughness  baked data  approximation   together      "
                 "noise\n";
    for (const SphereResult& sphere : results.spheres) std::cout << sphere_line(sphere);
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
    print_spheres(results);
    if (results.truth)
        std::cout << cat("The truth has a mean relative standard error of ", results.truth->noise,
                         " after ", results.truth->samples, " directions",
                         ending_of(results.truth->end), ".\n");
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
