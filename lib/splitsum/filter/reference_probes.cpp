#include "splitsum/filter/reference_probes.h"

#include "splitsum/base/parallel.h"
#include "splitsum/filter/reference.h"

namespace splitsum {

ReferenceProbes::ReferenceProbes(int height, std::span<const Probe> probes)
    : rows_(height, reference_near_texels) {
    for (const Probe& probe : probes) sums_.push_back({probe.lobe, rows_.towards(probe.towards)});
}

void ReferenceProbes::add_rows(int row_count, const float* texels, int floats_per_texel) {
    const size_t floats_per_row = size_t(floats_per_texel) * 2 * size_t(rows_.height());
    parallel_rows(int(sums_.size()), [&](int i) {
        Sum& probe = sums_[size_t(i)];
        for (int row = 0; row < row_count; ++row)
            probe.sum += rows_.over_hemisphere(
                probe.lobe, probe.towards,
                {next_row_ + row, texels + floats_per_row * size_t(row), floats_per_texel});
    });
    next_row_ += row_count;
}

std::vector<Vec3> ReferenceProbes::finish() const {
    std::vector<Vec3> radiance;
    for (const Sum& probe : sums_) radiance.push_back(Vec3(probe.sum / lobe_integral(probe.lobe)));
    return radiance;
}

}  // namespace splitsum
