#include "splitsum/filter/asset_levels.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "splitsum/filter/filter_cubemap.h"
#include "splitsum/filter/methods.h"
#include "splitsum/sphere/area_filter.h"

namespace splitsum {
namespace {

// One cubemap to make, in the order in which they are made.
struct Job {
    Lobe lobe;
    int face_size;
};

std::vector<Job> specular_jobs(const SpecularPlan& plan) {
    std::vector<Job> jobs;
    for (const double r : roughness_of_levels(plan.roughness, plan.levels))
        jobs.push_back({{LobeKind::ggx, r * r}, std::max(1, plan.face_size >> jobs.size())});
    return jobs;
}

std::vector<Job> jobs_of(const LevelsPlan& plan) {
    std::vector<Job> jobs;
    if (plan.specular) jobs = specular_jobs(*plan.specular);
    if (plan.irradiance) jobs.push_back({{LobeKind::cosine}, plan.irradiance->face_size});
    return jobs;
}

bool is_mirror(const Job& job) { return job.lobe.kind == LobeKind::ggx && job.lobe.alpha == 0; }

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

Result<std::vector<FilteredCubemap>> run(const std::vector<Job>& jobs, const FilterMethod& method,
                                         const FilterSource& source, const LevelsPlan& plan,
                                         Progress& progress) {
    int rows = 0;
    for (const Job& job : jobs) rows += face_count * job.face_size;
    progress.begin("filtering", rows);
    const auto filter = method.prepare(source, lobes_of(plan), plan.filter);
    const Mat3d panorama_from_cube = splitsum::panorama_from_cube(plan.orientation);
    std::vector<FilteredCubemap> levels;
    size_t lobe = 0;
    uint32_t first_key = 0;
    for (const Job& job : jobs) {
        auto level = is_mirror(job)
                         ? mirror_level(source, job.face_size, panorama_from_cube, progress)
                         : filter_cubemap(*filter, lobe++, job.face_size, panorama_from_cube,
                                          first_key, progress);
        if (!level) return level.error();
        first_key += uint32_t(level->cubemap.texels.size());
        levels.push_back(std::move(*level));
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
