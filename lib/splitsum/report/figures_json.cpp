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

Json check_json(const LevelCheck& check) {
    Json json = {{"level", check.level},
                 {"face_size", check.face_size},
                 {"perceptual_roughness", check.perceptual_roughness}};
    json.update(figures_json(check.figures));
    const Vec3d& mean = check.mean_radiance;
    json["mean_radiance"] = {mean.x, mean.y, mean.z};
    return json;
}

}  // namespace splitsum
