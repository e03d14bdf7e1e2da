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

// A filter that averages sample sets. `Reader` tells what samples read: what it prepares for a set,
// and the sum over it.
template <class Reader>
class SampledFilter final : public PreparedFilter {
public:
    SampledFilter(std::string_view method, std::span<const Lobe> lobes, const FilterPlan& plan,
                  Reader reader)
        : method_(method),
          lobes_(lobes.begin(), lobes.end()),
          plan_(plan),
          reader_(std::move(reader)) {
        if (shares_samples())
            for (const Lobe& lobe : lobes)
                shared_.push_back(prepared(reader_.samples(
                    lobe, plan.samples, PointList::hammersley(uint32_t(plan.samples)))));
    }

    void evaluate(size_t lobe_index, const Directions& directions,
                  std::span<Vec3> out) const override {
        for (size_t i = 0; i < out.size(); ++i) {
            const uint32_t key = directions.first_key + uint32_t(i);
            const Frame frame = frame_towards(directions.towards[i], sample_angle(plan_, key));
            out[i] = shares_samples() ? sum(shared_[lobe_index], frame)
                                      : sum(prepared(own_samples(lobe_index, key)), frame);
        }
    }

    LevelAccount account(size_t) const override { return {.method = std::string(method_)}; }

private:
    struct Prepared {
        SampleSet set;
        typename Reader::Lookups lookups;
    };

    // Random points are others at every texel: shared ones would make one error of all texels'.
    bool shares_samples() const { return plan_.sequence == PointSequence::hammersley; }

    SampleSet own_samples(size_t lobe_index, uint32_t key) const {
        return reader_.samples(lobes_[lobe_index], plan_.samples,
                               PointList::random({plan_.seed, key}));
    }

    Prepared prepared(SampleSet set) const {
        auto lookups = reader_.lookups_of(set);
        return {std::move(set), std::move(lookups)};
    }

    Vec3 sum(const Prepared& samples, const Frame& frame) const {
        return reader_.sum(samples.set, samples.lookups, frame);
    }

    std::string_view method_;
    std::vector<Lobe> lobes_;
    FilterPlan plan_;
    Reader reader_;
    std::vector<Prepared> shared_;  // one a lobe
};

template <class Reader>
std::unique_ptr<PreparedFilter> make_filter(std::string_view method, std::span<const Lobe> lobes,
                                            const FilterPlan& plan, Reader reader) {
    return std::make_unique<SampledFilter<Reader>>(method, lobes, plan, std::move(reader));
}

// Reads the panorama's texels.
struct TexelReader {
    struct Lookups {};

    const Environment* environment;
    SampleSet (*samples)(const Lobe& lobe, int count, const PointList& points);

    Lookups lookups_of(const SampleSet&) const { return {}; }
    Vec3 sum(const SampleSet& set, const Lookups&, const Frame& frame) const {
        return sum_of_texels(*environment, set, frame);
    }
};

// The level whose texels come closest to the footprint, by ratio of solid angles. Footprints are
// taken larger than 1 / (N pdf), so that neighbours overlap: of the factors 1/4, 1/2, 1, sqrt 2
// and 2, this one has the smallest error on the four captures named in tests/benchmarks/README.md.
const RingLevel& level_of_footprint(const std::vector<RingLevel>& levels, double finest,
                                    double solid_angle) {
    constexpr double overlap = std::numbers::sqrt2;
    const double halvings = std::log2(overlap * solid_angle / finest);
    return levels[size_t(std::clamp<double>(std::round(halvings), 0, double(levels.size() - 1)))];
}

RingLookups levels_of_samples(const RingPyramid& pyramid, const SampleSet& set) {
    RingLookups lookups;
    lookups.level.reserve(set.solid_angle.size());
    lookups.ring_count.reserve(set.solid_angle.size());
    const double finest = pyramid.levels[0].solid_angle();
    for (const float solid_angle : set.solid_angle) {
        const RingLevel& level =
            level_of_footprint(pyramid.levels, finest, std::max(double(solid_angle), 1e-30));
        lookups.level.push_back(&level);
        lookups.ring_count.push_back(float(level.ring_count));
    }
    return lookups;
}

// Reads the levels of a pyramid.
struct RingReader {
    using Lookups = RingLookups;

    std::unique_ptr<const RingPyramid> pyramid;

    SampleSet samples(const Lobe& lobe, int count, const PointList& points) const {
        return importance_samples(lobe, count, points);
    }
    RingLookups lookups_of(const SampleSet& set) const { return levels_of_samples(*pyramid, set); }
    Vec3 sum(const SampleSet& set, const RingLookups& lookups, const Frame& frame) const {
        return sum_of_rings(lookups, set, frame);
    }
};

}  // namespace

std::unique_ptr<PreparedFilter> prepare_importance(const FilterSource& source,
                                                   std::span<const Lobe> lobes,
                                                   const FilterPlan& plan) {
    return make_filter("importance", lobes, plan,
                       TexelReader{&source.environment, importance_samples});
}

std::unique_ptr<PreparedFilter> prepare_riemann(const FilterSource& source,
                                                std::span<const Lobe> lobes,
                                                const FilterPlan& plan) {
    FilterPlan grid = plan;
    grid.sequence = PointSequence::hammersley;  // the grid has no points to be drawn
    const auto samples = [](const Lobe& lobe, int count, const PointList&) {
        return riemann_samples(lobe, count);
    };
    return make_filter("riemann", lobes, grid, TexelReader{&source.environment, samples});
}

std::unique_ptr<PreparedFilter> prepare_filtered(const FilterSource& source,
                                                 std::span<const Lobe> lobes,
                                                 const FilterPlan& plan) {
    return make_filter("filtered", lobes, plan,
                       RingReader{std::make_unique<RingPyramid>(ring_pyramid(source.environment))});
}

}  // namespace splitsum
