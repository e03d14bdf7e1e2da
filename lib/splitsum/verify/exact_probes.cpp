#include "splitsum/verify/exact_probes.h"

#include "splitsum/sphere/cubemap.h"
#include "splitsum/verify/all_rows_detail.h"

namespace splitsum {
namespace {

bool is_mirror(const Lobe& lobe) { return lobe.kind == LobeKind::ggx && lobe.alpha == 0; }

}  // namespace

ExactProbes::ExactProbes(int height, const Mat3d& panorama_from_cube,
                         std::span<const ProbedCubemap> cubemaps, int probes)
    : reference_(height, {}), means_(height, panorama_from_cube, {}) {
    std::vector<ReferenceProbes::Probe> directions;
    std::vector<CubeTexel> areas;
    for (const ProbedCubemap& cubemap : cubemaps) {
        const int size = cubemap.face_size;
        ExactTexels exact{size, probe_texels(size, probes), {}};
        exact.radiance.resize(exact.texels.size());
        for (size_t i = 0; i < exact.texels.size(); ++i) {
            const auto [face, x, y] = exact.texels[i];
            (is_mirror(cubemap.lobe) ? mean_of_ : reference_of_).push_back({exact_.size(), i});
            if (is_mirror(cubemap.lobe))
                areas.push_back({size, face, x, y});
            else
                directions.push_back(
                    {cubemap.lobe, panorama_from_cube * direction_of_texel(face, x, y, size)});
        }
        exact_.push_back(std::move(exact));
    }
    reference_ = ReferenceProbes(height, directions);
    means_ = TexelMeans(height, panorama_from_cube, areas);
}

void ExactProbes::add_rows(int row_count, const float* texels, int floats_per_texel) {
    reference_.add_rows(row_count, texels, floats_per_texel);
    means_.add_rows(row_count, texels, floats_per_texel);
}

std::vector<ExactTexels> ExactProbes::finish() && {
    const auto fill = [&](const std::vector<Place>& places, const std::vector<Vec3>& radiance) {
        for (size_t i = 0; i < places.size(); ++i)
            exact_[places[i].cubemap].radiance[places[i].texel] = radiance[i];
    };
    fill(reference_of_, reference_.finish());
    fill(mean_of_, means_.finish());
    return std::move(exact_);
}

Result<std::vector<ExactTexels>> exact_texels(const Environment& environment,
                                              const Mat3d& panorama_from_cube,
                                              std::span<const ProbedCubemap> cubemaps, int probes,
                                              Progress& progress) {
    ExactProbes exact(environment.height(), panorama_from_cube, cubemaps, probes);
    const Status added = add_all_rows(exact, exact.texel_count(), environment, progress);
    if (!added) return added.error();
    return std::move(exact).finish();
}

}  // namespace splitsum
