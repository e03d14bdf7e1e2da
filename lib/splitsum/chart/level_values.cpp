#include "splitsum/chart/level_values.h"

#include "splitsum/base/parallel.h"
#include "splitsum/filter/reference.h"

namespace splitsum {
namespace {

void add(const Vec3& value, std::vector<float>& values) {
    values.insert(values.end(), {value.x, value.y, value.z});
}

}  // namespace

void add_values_at(const Cubemap& cubemap, const std::vector<ProbeTexel>& probes,
                   std::vector<float>& values) {
    for (const ProbeTexel& p : probes) add(cubemap.at(p.face, p.x, p.y), values);
}

void add_exact_values(const Environment& environment, const Lobe& lobe, int face_size,
                      const std::vector<ProbeTexel>& probes, std::vector<float>& values,
                      Progress& progress) {
    const auto reference = prepare_reference(environment, {&lobe, 1}, {});
    std::vector<Vec3> exact(probes.size());
    parallel_rows(int(probes.size()), [&](int i) {
        if (progress.cancelled()) return;
        const ProbeTexel& p = probes[size_t(i)];
        const Vec3d towards = direction_of_texel(p.face, p.x, p.y, face_size);
        reference->evaluate(0, {{&towards, 1}}, {&exact[size_t(i)], 1});
    });
    for (const Vec3& value : exact) add(value, values);
}

}  // namespace splitsum
