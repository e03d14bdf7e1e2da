#pragma once

#include <vector>

#include "splitsum/base/parallel.h"
#include "splitsum/filter/filter_cubemap.h"
#include "splitsum/filter/spectral.h"
#include "splitsum/preview/baked_light.h"
#include "splitsum/table/split_sum_exact.h"

namespace splitsum::tests {

/// Environment light as a bake would store it in floats, with `levels` levels of `face_size`
/// texels, each half as large as the one before, and an exact table of 32² texels.
inline BakedLight baked(const Environment& environment, const Mat3d& panorama_from_cube,
                        int face_size, int levels) {
    NoProgress progress;
    std::vector<Lobe> lobes = {{LobeKind::cosine}};
    for (const double r : roughness_of_levels({}, levels))
        lobes.push_back({LobeKind::ggx, std::max(r * r, 0.01)});  // nearly a mirror
    const auto filter = prepare_spectral(FilterSource(environment), lobes, {});
    const auto cubemap = [&](size_t lobe, int size) {
        return filter_cubemap(*filter, lobe, size, panorama_from_cube, 0, progress)->cubemap;
    };
    BakedLight light;
    light.irradiance = cubemap(0, 32);
    for (int level = 0; level < levels; ++level)
        light.specular.push_back(cubemap(size_t(level) + 1, std::max(face_size >> level, 16)));
    constexpr int size = 32;
    light.split_sum = blank_table(size, size, 2);
    parallel_rows(size, [&](int y) {
        for (int x = 0; x < size; ++x) {
            const double r = (y + 0.5) / size;
            const SplitSum sum =
                split_sum_exact(SmithTerm::height_correlated, (x + 0.5) / size, r * r);
            light.split_sum.texel(x, y)[0] = float(sum.a);
            light.split_sum.texel(x, y)[1] = float(sum.b);
        }
    });
    return light;
}

}  // namespace splitsum::tests
