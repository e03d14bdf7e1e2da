#include "splitsum/filter/reference.h"

#include <vector>

#include "splitsum/filter/texel_quadrature.h"

namespace splitsum {
namespace {

class ReferenceFilter final : public PreparedFilter {
public:
    ReferenceFilter(const Environment& environment, std::span<const Lobe> lobes)
        : quadrature_(environment, reference_near_texels), lobes_(lobes.begin(), lobes.end()) {
        for (const Lobe& lobe : lobes) integrals_.push_back(lobe_integral(lobe));
    }

    void evaluate(size_t lobe_index, const Directions& directions,
                  std::span<Vec3> out) const override {
        for (size_t i = 0; i < out.size(); ++i)
            out[i] = Vec3(quadrature_.over_hemisphere(lobes_[lobe_index], directions.towards[i]) /
                          integrals_[lobe_index]);
    }

    LevelAccount account(size_t) const override { return {.method = "reference"}; }

private:
    TexelQuadrature quadrature_;
    std::vector<Lobe> lobes_;
    std::vector<double> integrals_;
};

}  // namespace

std::unique_ptr<PreparedFilter> prepare_reference(const FilterSource& source,
                                                  std::span<const Lobe> lobes, const FilterPlan&) {
    return std::make_unique<ReferenceFilter>(source.environment, lobes);
}

}  // namespace splitsum
