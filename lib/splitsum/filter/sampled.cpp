#include "splitsum/filter/sampled.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "splitsum/base/random.h"
#include "splitsum/filter/sample_kernels.h"
#include "splitsum/filter/sample_set.h"
#include "splitsum/sphere/ring_pyramid.h"

namespace splitsum {
namespace {

// The angle by which a texel turns the sample set: none, or one that depends on its key alone.
double sample_angle(const FilterPlan& plan, uint32_t key) {
    if (!plan.rotate_samples) return 0;
    return 2 * std::numbers::pi * double(unit_float(mix_bits(key) ^ plan.seed));
}

// A filter that averages sample sets; `Sum` tells what the samples of lobe i read.
template <class Sum>
class SampledFilter final : public PreparedFilter {
public:
    SampledFilter(std::string_view method, std::vector<SampleSet> sets, const FilterPlan& plan,
                  Sum sum)
        : method_(method), sets_(std::move(sets)), plan_(plan), sum_(std::move(sum)) {}

    void evaluate(size_t lobe_index, const Directions& directions,
                  std::span<Vec3> out) const override {
        for (size_t i = 0; i < out.size(); ++i) {
            const double angle = sample_angle(plan_, directions.first_key + uint32_t(i));
            const Frame frame = frame_towards(directions.towards[i], angle);
            out[i] = sum_(lobe_index, sets_[lobe_index], frame);
        }
    }

    LevelAccount account(size_t) const override { return {.method = std::string(method_)}; }

private:
    std::string_view method_;
    std::vector<SampleSet> sets_;
    FilterPlan plan_;
    Sum sum_;
};

template <class Sum>
std::unique_ptr<PreparedFilter> make_filter(std::string_view method, std::vector<SampleSet> sets,
                                            const FilterPlan& plan, Sum sum) {
    return std::make_unique<SampledFilter<Sum>>(method, std::move(sets), plan, std::move(sum));
}

std::vector<SampleSet> sets_of(std::span<const Lobe> lobes, int samples,
                               SampleSet (*make)(const Lobe&, int)) {
    std::vector<SampleSet> sets;
    for (const Lobe& lobe : lobes) sets.push_back(make(lobe, samples));
    return sets;
}

std::unique_ptr<PreparedFilter> texel_filter(std::string_view method,
                                             const Environment& environment,
                                             std::vector<SampleSet> sets, const FilterPlan& plan) {
    return make_filter(method, std::move(sets), plan,
                       [&environment](size_t, const SampleSet& set, const Frame& frame) {
                           return sum_of_texels(environment, set, frame);
                       });
}

// The level whose texels come closest to the footprint, by ratio of solid angles. Footprints are
// taken larger than 1 / (N pdf), so that neighbours overlap: of the factors 1/4, 1/2, 1, sqrt 2
// and 2, this one has the smallest error on the four captures named in tests/benchmarks/README.md.
const RingLevel& level_of_footprint(const RingPyramid& pyramid, double solid_angle) {
    constexpr double overlap = std::numbers::sqrt2;
    const auto& levels = pyramid.levels;
    const double halvings = std::log2(overlap * solid_angle / levels[0].solid_angle());
    return levels[size_t(std::clamp<double>(std::round(halvings), 0, double(levels.size() - 1)))];
}

RingLookups lookups_of(const RingPyramid& pyramid, const SampleSet& set) {
    RingLookups lookups;
    for (const float solid_angle : set.solid_angle) {
        const RingLevel& level = level_of_footprint(pyramid, std::max(double(solid_angle), 1e-30));
        lookups.level.push_back(&level);
        lookups.ring_count.push_back(float(level.ring_count));
    }
    return lookups;
}

}  // namespace

std::unique_ptr<PreparedFilter> prepare_importance(const FilterSource& source,
                                                   std::span<const Lobe> lobes,
                                                   const FilterPlan& plan) {
    return texel_filter("importance", source.environment,
                        sets_of(lobes, plan.samples, importance_samples), plan);
}

std::unique_ptr<PreparedFilter> prepare_riemann(const FilterSource& source,
                                                std::span<const Lobe> lobes,
                                                const FilterPlan& plan) {
    return texel_filter("riemann", source.environment,
                        sets_of(lobes, plan.samples, riemann_samples), plan);
}

std::unique_ptr<PreparedFilter> prepare_filtered(const FilterSource& source,
                                                 std::span<const Lobe> lobes,
                                                 const FilterPlan& plan) {
    auto pyramid = std::make_unique<RingPyramid>(ring_pyramid(source.environment));
    std::vector<SampleSet> sets = sets_of(lobes, plan.samples, importance_samples);
    std::vector<RingLookups> lookups;
    for (const SampleSet& set : sets) lookups.push_back(lookups_of(*pyramid, set));
    return make_filter("filtered", std::move(sets), plan,
                       [pyramid = std::move(pyramid), lookups = std::move(lookups)](
                           size_t lobe_index, const SampleSet& set, const Frame& frame) {
                           return sum_of_rings(lookups[lobe_index], set, frame);
                       });
}

}  // namespace splitsum
