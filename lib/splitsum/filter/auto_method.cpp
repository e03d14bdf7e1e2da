#include "splitsum/filter/auto_method.h"

#include <vector>

#include "splitsum/base/text.h"
#include "splitsum/filter/reference.h"
#include "splitsum/filter/spectral.h"

namespace splitsum {
namespace {

class AutoFilter final : public PreparedFilter {
public:
    AutoFilter(const FilterSource& source, std::span<const Lobe> lobes, const FilterPlan& plan)
        : spectral_(prepare_spectral(source, lobes, plan)), accuracy_(plan.accuracy) {
        bool all_hold = true;
        for (size_t i = 0; i < lobes.size(); ++i) all_hold = all_hold && bound_holds(i);
        if (!all_hold) reference_ = prepare_reference(source, lobes, plan);
    }

    void evaluate(size_t lobe_index, const Directions& directions,
                  std::span<Vec3> out) const override {
        chosen(lobe_index).evaluate(lobe_index, directions, out);
    }

    LevelAccount account(size_t lobe_index) const override {
        LevelAccount account = chosen(lobe_index).account(lobe_index);
        const LevelAccount spectral = spectral_->account(lobe_index);
        account.reason =
            bound_holds(lobe_index)
                ? cat("cheapest with an error bound under ", accuracy_)
                : cat("the bound of spectral, ", spectral.error_bound, ", is over ", accuracy_);
        return account;
    }

private:
    bool bound_holds(size_t lobe_index) const {
        return spectral_->account(lobe_index).error_bound <= accuracy_;
    }

    const PreparedFilter& chosen(size_t lobe_index) const {
        return bound_holds(lobe_index) ? *spectral_ : *reference_;
    }

    std::unique_ptr<PreparedFilter> spectral_;
    std::unique_ptr<PreparedFilter> reference_;  // where a bound does not hold
    double accuracy_;
};

}  // namespace

std::unique_ptr<PreparedFilter> prepare_auto(const FilterSource& source,
                                             std::span<const Lobe> lobes, const FilterPlan& plan) {
    return std::make_unique<AutoFilter>(source, lobes, plan);
}

}  // namespace splitsum
