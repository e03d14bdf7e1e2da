#include "splitsum/atlas/answers.h"

#include <cmath>
#include <iomanip>
#include <memory>

#include "splitsum/base/text.h"
#include "splitsum/sphere/area_filter.h"

namespace splitsum {
namespace {

bool is_mirror(const Lobe& lobe) { return lobe.kind == LobeKind::ggx && lobe.alpha == 0; }

bool filters(const FilterMethod& method, const Lobe& lobe) {
    return lobe.kind == LobeKind::ggx ? method.filters_ggx : method.filters_cosine;
}

std::string how(const LevelAccount& account) {
    std::string text = account.method;
    if (account.bands > 0) text += cat(", ", account.bands, " bands");
    if (account.error_bound > 0) text += cat(", bound ", std::setprecision(2), account.error_bound);
    return text;
}

}  // namespace

Lobe reflection(double perceptual_roughness) {
    return {LobeKind::ggx, perceptual_roughness * perceptual_roughness};
}

std::string describe(const Lobe& lobe) {
    if (lobe.kind == LobeKind::cosine) return "diffuse";
    return is_mirror(lobe) ? "mirror, r = 0" : cat("r = ", std::sqrt(lobe.alpha));
}

Result<Answers> answers_of(const FilterMethod& method, const FilterSource& source,
                           std::span<const Lobe> lobes, const FilterPlan& effort, int face_size,
                           Progress& progress) {
    std::vector<Lobe> prepared;
    for (const Lobe& lobe : lobes)
        if (filters(method, lobe) && !is_mirror(lobe)) prepared.push_back(lobe);
    const auto filter = prepared.empty() ? nullptr : method.prepare(source, prepared, effort);
    Answers answers;
    size_t next = 0;
    for (const Lobe& lobe : lobes) {
        auto& answer = answers.emplace_back();
        if (!filters(method, lobe)) continue;
        if (is_mirror(lobe)) {
            auto mirror = area_filtered_cubemap(source.environment, face_size, Mat3d(1), progress);
            if (!mirror) return mirror.error();
            clamp_negative(mirror->texels);  // rounding, as filter_levels does
            answer = FilteredCubemap{std::move(*mirror), {.method = "mirror"}};
            continue;
        }
        auto filtered = filter_cubemap(*filter, next++, face_size, Mat3d(1), 0, progress);
        if (!filtered) return filtered.error();
        answer = std::move(*filtered);
    }
    return answers;
}

AtlasCell refusal_of(const Lobe& lobe) {
    return {.verdict = Verdict::refuses,
            .text = lobe.kind == LobeKind::ggx ? "does not filter reflections"
                                               : "does not filter diffuse light"};
}

int64_t count_no_light(const Cubemap& cubemap) {
    int64_t count = 0;
    for (const Vec3& texel : cubemap.texels)
        for (int c = 0; c < 3; ++c) count += !(std::isfinite(texel[c]) && texel[c] >= 0);
    return count;
}

AtlasCell judged(const FilteredCubemap& answer, const Cubemap& truth, double accuracy) {
    AtlasCell cell;
    cell.figures = error_figures(answer.cubemap.texels, truth.texels);
    cell.verdict = verdict_of(*cell.figures, accuracy);
    cell.text = how(answer.account);
    if (const int64_t wrong = count_no_light(answer.cubemap); wrong > 0) {
        cell.verdict = Verdict::fails;
        cell.text += cat(", ", wrong, " values that are no light");
    }
    return cell;
}

}  // namespace splitsum
