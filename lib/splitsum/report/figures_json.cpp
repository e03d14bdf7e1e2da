#include "splitsum/report/figures_json.h"

namespace splitsum {

using Json = nlohmann::ordered_json;

Json figures_json(const ErrorFigures& figures) {
    return {{"rel_rms", figures.rel_rms},
            {"max_rel", figures.max_rel},
            {"max_abs", figures.max_abs},
            {"bias", figures.bias},
            {"texels", figures.texels}};
}

Json account_json(const LevelAccount& account) {
    Json json = {{"method", account.method}, {"reason", account.reason}};
    if (account.bands > 0) {
        json["bands"] = account.bands;
        json["error_bound"] = account.error_bound;
    }
    json["clamped_negative"] = account.clamped_negative;
    return json;
}

Json check_json(const LevelCheck& check) {
    Json json = {{"level", check.level},
                 {"face_size", check.face_size},
                 {"perceptual_roughness", check.perceptual_roughness}};
    if (check.figures.texels > 0) json.update(figures_json(check.figures));
    const Vec3d& mean = check.mean_radiance;
    json["mean_radiance"] = {mean.x, mean.y, mean.z};
    return json;
}

Json readings_json(std::span<const ReconstructionError> bands) {
    Json json = Json::array();
    for (const ReconstructionError& band : bands) {
        json.push_back({{"from", band.range.from}, {"to", band.range.to}});
        if (band.figures.texels > 0) json.back().update(figures_json(band.figures));
    }
    return json;
}

}  // namespace splitsum
