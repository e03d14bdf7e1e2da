// What is asked of whole levels rather than of texels: steps at edges, equal bits for all threads.
#include <algorithm>
#include <cmath>
#include <utility>

#include "splitsum/atlas/answers.h"
#include "splitsum/atlas/entries.h"
#include "splitsum/atlas/pictures.h"
#include "splitsum/atlas/skies.h"
#include "splitsum/base/parallel.h"
#include "splitsum/base/text.h"

namespace splitsum {
namespace {

const std::vector<Lobe> lobes = {
    reflection(0), reflection(0.15), reflection(0.4), reflection(1), {LobeKind::cosine}};

FilterPlan effort_of(const AtlasPlan& plan) {
    return {.samples = plan.samples, .accuracy = plan.accuracy};
}

struct Steps {
    double inside = 0;
    double across = 0;
};

// The texel beside (x, y), which may be on the next face.
const Vec3& beside(const Cubemap& level, int face, int x, int y) {
    const int size = level.face_size;
    const FacePoint at =
        face_point_towards(direction_on_face(face, (x + 0.5) / size, (y + 0.5) / size));
    return level.at(at.face, std::min(static_cast<int>(at.s * size), size - 1),
                    std::min(static_cast<int>(at.t * size), size - 1));
}

Steps steps_of(const Cubemap& level) {
    const int size = level.face_size;
    Steps steps;
    for (int face = 0; face < face_count; ++face)
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x)
                for (const auto& [dx, dy] : {std::pair(1, 0), {-1, 0}, {0, 1}, {0, -1}}) {
                    const int to_x = x + dx, to_y = y + dy;
                    const bool leaves = to_x < 0 || to_y < 0 || to_x == size || to_y == size;
                    double& largest = leaves ? steps.across : steps.inside;
                    largest = std::max<double>(
                        largest, length(level.at(face, x, y) - beside(level, face, to_x, to_y)));
                }
    return steps;
}

// Steps across edges are between texels that are closer together than those inside.
AtlasCell steps_cell(const Cubemap& level) {
    const Steps steps = steps_of(level);
    const double ratio = steps.across / steps.inside;
    const bool no_seam = ratio <= 1 && count_no_light(level) == 0;
    return {.verdict = no_seam ? Verdict::meets : Verdict::fails,
            .text = cat("across / inside = ", std::round(1000 * ratio) / 1000)};
}

bool same_bits(const Answers& a, const Answers& b) {
    for (size_t i = 0; i < a.size(); ++i)
        if (a[i] && a[i]->cubemap.texels != b[i]->cubemap.texels) return false;
    return true;
}

template <class MakeRow>
Result<AtlasEntry> entry_of_methods(AtlasEntry entry, const AtlasPlan& plan, const Environment& sky,
                                    const MakeRow& make_row) {
    if (plan.pictures) entry.png = picture_of(sky);
    for (const FilterMethod& method : plan.methods) {
        AtlasRow row{std::string(method.name)};
        if (const Status made = make_row(method, row); !made) return made.error();
        entry.table.rows.push_back(std::move(row));
    }
    return entry;
}

}  // namespace

Result<AtlasEntry> edges_entry(const AtlasPlan& plan, Progress& progress) {
    const Environment sky = gradient_sky(plan.sky_rows);
    const FilterSource source(sky);
    AtlasEntry entry{"edges", "Edges and corners of the cube under a smooth sky",
                     "Faces that are filtered or blurred one by one show seams.",
                     "Texels of all faces ask the panorama; the largest step across an edge is no "
                     "larger than the largest inside a face."};
    for (const Lobe& lobe : lobes) entry.table.columns.push_back(describe(lobe));
    return entry_of_methods(
        std::move(entry), plan, sky, [&](const FilterMethod& method, AtlasRow& row) -> Status {
            const auto answers =
                answers_of(method, source, lobes, effort_of(plan), plan.face_size, progress);
            if (!answers) return answers.error();
            for (size_t i = 0; i < lobes.size(); ++i)
                row.cells.push_back((*answers)[i] ? steps_cell((*answers)[i]->cubemap)
                                                  : refusal_of(lobes[i]));
            return ok;
        });
}

Result<AtlasEntry> threads_entry(const AtlasPlan& plan, Progress& progress) {
    const Environment sky = night_sky(plan.sky_rows);
    const FilterSource source(sky);
    AtlasEntry entry{"threads", "Different numbers of threads",
                     "Sums in the order in which threads finish, and generators of threads: other "
                     "bits each time.",
                     "Sums have a fixed order and random numbers come from keys: the same bits."};
    const std::vector<int> counts = {2, 7};
    for (const int threads : counts) entry.table.columns.push_back(cat("1 and ", threads));
    return entry_of_methods(
        std::move(entry), plan, sky, [&](const FilterMethod& method, AtlasRow& row) -> Status {
            const auto with = [&](int threads) {
                const ThreadLimit limit(threads);
                return answers_of(method, source, lobes, effort_of(plan), plan.face_size, progress);
            };
            const auto alone = with(1);
            if (!alone) return alone.error();
            for (const int threads : counts) {
                const auto together = with(threads);
                if (!together) return together.error();
                const bool same = same_bits(*alone, *together);
                row.cells.push_back({.verdict = same ? Verdict::meets : Verdict::fails,
                                     .text = same ? "the same bits" : "other bits"});
            }
            return ok;
        });
}

}  // namespace splitsum
