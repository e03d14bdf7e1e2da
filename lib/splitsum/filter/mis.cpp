#include "splitsum/filter/mis.h"

#include <vector>

#include "splitsum/filter/mis_estimate.h"

namespace splitsum {
namespace {

class MisFilter final : public PreparedFilter {
public:
    MisFilter(const Environment& environment, std::span<const Lobe> lobes, const FilterPlan& plan)
        : light_(environment), lobes_(lobes.begin(), lobes.end()), plan_(plan) {}

    void evaluate(size_t lobe_index, const Directions& directions,
                  std::span<Vec3> out) const override {
        for (size_t i = 0; i < out.size(); ++i)
            out[i] = Vec3(estimate(lobe_index, directions, i).mean);
    }

    LevelAccount account(size_t) const override { return {.method = "mis"}; }

    std::vector<Vec3> standard_errors(size_t lobe_index,
                                      const Directions& directions) const override {
        std::vector<Vec3> errors;
        for (size_t i = 0; i < directions.towards.size(); ++i)
            errors.emplace_back(estimate(lobe_index, directions, i).standard_error);
        return errors;
    }

private:
    MisEstimate estimate(size_t lobe_index, const Directions& directions, size_t i) const {
        const PointKey key{plan_.seed, directions.first_key + uint32_t(i)};
        const MisPoints points(light_, plan_.samples, plan_.sequence, key);
        const LobeSampler& lobe = lobes_[lobe_index];
        const Vec3d& towards = directions.towards[i];
        return plan_.heuristic == MisHeuristic::power
                   ? mis_estimate(light_, lobe, towards, points, PowerShare())
                   : mis_estimate(light_, lobe, towards, points, BalanceShare());
    }

    LightSampler light_;
    std::vector<LobeSampler> lobes_;
    FilterPlan plan_;
};

// The lists of the lobe and of the light must not be the same points.
PointKey with_stream(PointKey key, uint32_t stream) {
    key.stream = stream;
    return key;
}

}  // namespace

MisPoints::MisPoints(const LightSampler& sampler, int count, PointSequence sequence, PointKey key)
    : lobe_count(sampler.is_flat() ? count : count - count / 2),
      light_count(count - lobe_count),
      lobe(unbiased_points(sequence, uint32_t(lobe_count), with_stream(key, 1))),
      light(unbiased_points(sequence, uint32_t(light_count), with_stream(key, 2))) {}

std::unique_ptr<PreparedFilter> prepare_mis(const FilterSource& source, std::span<const Lobe> lobes,
                                            const FilterPlan& plan) {
    return std::make_unique<MisFilter>(source.environment, lobes, plan);
}

}  // namespace splitsum
