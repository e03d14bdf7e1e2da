#include <utility>

#include "splitsum/atlas/answers.h"
#include "splitsum/atlas/exact_mirror.h"
#include "splitsum/atlas/light_cases.h"
#include "splitsum/atlas/pictures.h"
#include "splitsum/base/text.h"
#include "splitsum/filter/reference.h"

namespace splitsum {
namespace {

std::vector<Lobe> lobes_of(const LightCase& light) {
    std::vector<Lobe> lobes;
    for (const double r : light.perceptual_roughness) lobes.push_back(reflection(r));
    if (light.diffuse) lobes.push_back({LobeKind::cosine});
    return lobes;
}

// An effort and what the heading of its columns says about it.
using Effort = std::pair<FilterPlan, std::string>;

std::vector<Effort> efforts_of(const LightCase& light, const AtlasPlan& plan) {
    const FilterPlan usual{.samples = plan.samples, .accuracy = plan.accuracy};
    std::vector<Effort> efforts;
    for (const int samples : light.samples) {
        efforts.emplace_back(usual, cat(samples, " samples, "));
        efforts.back().first.samples = samples;
    }
    for (const double accuracy : light.accuracies) {
        efforts.emplace_back(usual, cat("accuracy ", accuracy, ", "));
        efforts.back().first.accuracy = accuracy;
    }
    if (efforts.empty()) efforts.emplace_back(usual, "");
    return efforts;
}

int face_size_of(const LightCase& light, const AtlasPlan& plan) {
    return light.face_size.value_or(plan.face_size);
}

Cubemap filled(int face_size, const Vec3& radiance) {
    Cubemap cubemap(face_size);
    for (Vec3& texel : cubemap.texels) texel = radiance;
    return cubemap;
}

Result<Cubemap> truth_of(const LightCase& light, const FilterSource& source, const Lobe& lobe,
                         int face_size, Progress& progress) {
    if (light.everywhere) return filled(face_size, *light.everywhere);
    if (lobe.alpha == 0) return exact_mirror(source.environment, face_size, progress);
    const auto reference = prepare_reference(source, {&lobe, 1}, {});
    auto truth = filter_cubemap(*reference, 0, face_size, Mat3d(1), 0, progress);
    if (!truth) return truth.error();
    return std::move(truth->cubemap);
}

/// A case with all that its rows are judged by.
struct Trial {
    const LightCase& light;
    const AtlasPlan& plan;
    const FilterSource& source;
    std::vector<Lobe> lobes;
    std::vector<Effort> efforts;
    std::vector<Cubemap> truths;  // one a lobe
};

AtlasCell cell_of(const Trial& trial, const Effort& effort, size_t lobe,
                  const std::optional<FilteredCubemap>& answer) {
    if (!answer) return refusal_of(trial.lobes[lobe]);
    const double tolerance = trial.light.tolerance.value_or(effort.first.accuracy);
    AtlasCell cell = judged(*answer, trial.truths[lobe], tolerance);
    if (trial.plan.pictures)
        cell.png = picture_of(answer->cubemap, exposure_of(trial.truths[lobe]));
    return cell;
}

// The judge need not be asked twice.
bool is_the_truth(const LightCase& light, const FilterMethod& method) {
    return method.prepare == prepare_reference && !light.everywhere;
}

Answers answers_of_the_judge(const Trial& trial) {
    Answers answers;
    for (const Cubemap& truth : trial.truths)
        answers.push_back(FilteredCubemap{truth, {.method = "the judge itself"}});
    return answers;
}

Result<AtlasRow> row_of(const Trial& trial, const FilterMethod& method, Progress& progress) {
    AtlasRow row{std::string(method.name)};
    for (const Effort& effort : trial.efforts) {
        const auto answers = is_the_truth(trial.light, method)
                                 ? answers_of_the_judge(trial)
                                 : answers_of(method, trial.source, trial.lobes, effort.first,
                                              face_size_of(trial.light, trial.plan), progress);
        if (!answers) return answers.error();
        for (size_t lobe = 0; lobe < trial.lobes.size(); ++lobe)
            row.cells.push_back(cell_of(trial, effort, lobe, (*answers)[lobe]));
    }
    return row;
}

}  // namespace

Result<AtlasEntry> light_entry(const LightCase& light, const AtlasPlan& plan, Progress& progress) {
    const Environment sky = light.sky(light.rows.value_or(plan.sky_rows));
    const FilterSource source(sky);
    Trial trial{light, plan, source, lobes_of(light), efforts_of(light, plan), {}};
    for (const Lobe& lobe : trial.lobes) {
        auto truth = truth_of(light, source, lobe, face_size_of(light, plan), progress);
        if (!truth) return truth.error();
        trial.truths.push_back(std::move(*truth));
    }
    AtlasEntry entry{light.id, light.title, light.problem, light.conduct};
    if (plan.pictures) entry.png = picture_of(sky);
    for (const Effort& effort : trial.efforts)
        for (const Lobe& lobe : trial.lobes)
            entry.table.columns.push_back(effort.second + describe(lobe));
    for (const FilterMethod& method : plan.methods) {
        auto row = row_of(trial, method, progress);
        if (!row) return row.error();
        entry.table.rows.push_back(std::move(*row));
    }
    return entry;
}

}  // namespace splitsum
