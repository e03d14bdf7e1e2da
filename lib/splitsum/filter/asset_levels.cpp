#include "splitsum/filter/asset_levels.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "splitsum/base/parallel.h"
#include "splitsum/filter/filter_cubemap.h"
#include "splitsum/filter/methods.h"
#include "splitsum/sphere/area_filter.h"

namespace splitsum {
namespace {

// One cubemap to make.
struct Job {
    Lobe lobe;
    int face_size;
    size_t lobe_index = 0;   // among the lobes, if it is not the mirror image
    uint32_t first_key = 0;  // as of Directions: no two texels of the jobs have the same
};

bool is_mirror(const Job& job) { return job.lobe.kind == LobeKind::ggx && job.lobe.alpha == 0; }

std::vector<Job> jobs_of(const LevelsPlan& plan) {
    std::vector<Job> jobs;
    if (plan.specular)
        for (const double r : roughness_of_levels(plan.specular->roughness, plan.specular->levels))
            jobs.push_back(
                {{LobeKind::ggx, r * r}, std::max(1, plan.specular->face_size >> jobs.size())});
    if (plan.irradiance) jobs.push_back({{LobeKind::cosine}, plan.irradiance->face_size});
    size_t lobes = 0;
    uint32_t texels = 0;
    for (Job& job : jobs) {
        job.lobe_index = is_mirror(job) ? 0 : lobes++;
        job.first_key = texels;
        texels += uint32_t(face_count * job.face_size * job.face_size);
    }
    return jobs;
}

// The method, able to filter everything the plan asks for.
Result<FilterMethod> method_of(const LevelsPlan& plan) {
    if (plan.irradiance)
        if (const auto found = find_filter_method(plan.filter.method, LobeKind::cosine); !found)
            return found;
    return find_filter_method(plan.filter.method, plan.specular ? LobeKind::ggx : LobeKind::cosine);
}

Result<Cubemap> mirror_image(const FilterSource& source, int face_size,
                             const Mat3d& panorama_from_cube, Progress& progress) {
    const auto made = std::ranges::find(source.mirrors, face_size, &Cubemap::face_size);
    if (made != source.mirrors.end()) {
        progress.advance(face_count * face_size);
        return *made;
    }
    const auto geometry =
        source.tables->area_geometry(source.environment.height(), face_size, panorama_from_cube);
    return area_filtered_cubemap(source.environment, geometry, progress);
}

Result<FilteredCubemap> mirror_level(const FilterSource& source, int face_size,
                                     const Mat3d& panorama_from_cube, Progress& progress) {
    auto cubemap = mirror_image(source, face_size, panorama_from_cube, progress);
    if (!cubemap) return cubemap.error();
    LevelAccount account{.method = "mirror"};
    account.clamped_negative = clamp_negative(cubemap->texels);
    return FilteredCubemap{std::move(*cubemap), account};
}

// The mirror image beside the transform, then all levels at once: small levels alone would leave
// most threads idle.
Result<std::vector<FilteredCubemap>> run(const std::vector<Job>& jobs, const FilterMethod& method,
                                         const FilterSource& source, const LevelsPlan& plan,
                                         Progress& progress) {
    int rows = 0;
    for (const Job& job : jobs) rows += face_count * job.face_size;
    progress.begin("filtering", rows);
    const Mat3d panorama_from_cube = splitsum::panorama_from_cube(plan.orientation);
    std::vector<std::optional<Result<FilteredCubemap>>> made(jobs.size());
    const auto for_each = [&](bool mirrors, const auto& make) {
        parallel_rows(int(jobs.size()), [&](int i) {
            if (is_mirror(jobs[size_t(i)]) == mirrors) made[size_t(i)] = make(jobs[size_t(i)]);
        });
    };
    const auto make_mirrors = [&] {
        for_each(true, [&](const Job& job) {
            return mirror_level(source, job.face_size, panorama_from_cube, progress);
        });
    };
    const auto make_others = [&] {
        const auto filter = method.prepare(source, lobes_of(plan), plan.filter);
        for_each(false, [&](const Job& job) {
            return filter_cubemap(*filter, job.lobe_index, job.face_size, panorama_from_cube,
                                  job.first_key, progress);
        });
    };
    run_both(make_others, make_mirrors);
    std::vector<FilteredCubemap> levels;
    for (auto& level : made) {
        if (!*level) return level->error();
        levels.push_back(std::move(**level));
    }
    return levels;
}

}  // namespace

Status validate(const LevelsPlan& plan) {
    if (const Status valid = validate(plan.filter); !valid) return valid;
    if (const Status valid = validate(plan.orientation); !valid) return valid;
    if (plan.specular)
        if (const Status valid = validate(*plan.specular); !valid) return valid;
    if (plan.irradiance)
        if (const Status valid = validate(*plan.irradiance); !valid) return valid;
    return ok;
}

std::vector<Lobe> lobes_of(const LevelsPlan& plan) {
    std::vector<Lobe> lobes;
    for (const Job& job : jobs_of(plan))
        if (!is_mirror(job)) lobes.push_back(job.lobe);
    return lobes;
}

std::vector<int> mirror_sizes(const LevelsPlan& plan) {
    std::vector<int> sizes;
    for (const Job& job : jobs_of(plan))
        if (is_mirror(job)) sizes.push_back(job.face_size);
    return sizes;
}

Result<AssetLevels> filter_levels(const FilterSource& source, const LevelsPlan& plan,
                                  Progress& progress) {
    if (const Status valid = validate(plan); !valid) return valid.error();
    const auto method = method_of(plan);
    if (!method) return method.error();
    auto filtered = run(jobs_of(plan), *method, source, plan, progress);
    if (!filtered) return filtered.error();

    AssetLevels levels;
    for (FilteredCubemap& level : *filtered) {
        levels.accounts.push_back(std::move(level.account));
        levels.specular.push_back(std::move(level.cubemap));
    }
    if (plan.irradiance) {
        levels.irradiance = std::move(levels.specular.back());
        levels.specular.pop_back();
        if (plan.irradiance->store_irradiance)
            for (Vec3& texel : levels.irradiance->texels) texel *= std::numbers::pi_v<float>;
    }
    return levels;
}

}  // namespace splitsum
