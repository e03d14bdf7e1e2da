#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "splitsum/base/result.h"
#include "splitsum/brdf/lobe.h"
#include "splitsum/filter/filter_source.h"
#include "splitsum/math/vec.h"
#include "splitsum/plan/asset_plan.h"

namespace splitsum {

/// Unit directions in panorama space at which a lobe is to be evaluated.
struct Directions {
    std::span<const Vec3d> towards;
    /// The key of the first direction, one more for each that follows: where a method turns its
    /// samples by a hash, the same texel gets the same turn whichever thread visits it.
    uint32_t first_key = 0;
};

/// How one level was made, for the report.
struct LevelAccount {
    std::string method{};          ///< the row of filter_methods() that did the work
    std::string reason{};          ///< why `auto` chose it; "" where the user did
    int bands = 0;                 ///< spherical-harmonic bands kept; 0 where there are none
    double error_bound = 0;        ///< relative error (rel_rms) by theory; 0 where theory has none
    int64_t clamped_negative = 0;  ///< channel values below 0 that were set to 0
};

/// A method made ready for one environment and a list of lobes; whatever the lobes can share
/// (a pyramid, sample sets, a transform) has been computed once.
class PreparedFilter {
public:
    virtual ~PreparedFilter() = default;

    /// out[i] = the radiance around directions.towards[i], averaged with lobe `lobe_index` of the
    /// list. Safe to call from many threads; one direction's result does not depend on the others.
    virtual void evaluate(size_t lobe_index, const Directions& directions,
                          std::span<Vec3> out) const = 0;

    /// How lobe `lobe_index` is filtered (without clamped_negative, which is not known yet).
    virtual LevelAccount account(size_t lobe_index) const = 0;

    /// The standard error of every channel that evaluate() gives there, which the method estimates
    /// from the spread of its own samples; empty of methods that cannot. Costs as much as
    /// evaluate().
    virtual std::vector<Vec3> standard_errors(size_t /*lobe_index*/,
                                              const Directions& /*directions*/) const {
        return {};
    }
};

/// One way to filter light. All methods answer the same question (filter/README.md), so any of
/// them can stand in for another, and every one is tested against theorems and `reference`.
struct FilterMethod {
    std::string_view name;     ///< as typed after --method
    std::string_view summary;  ///< one line for --help
    bool filters_ggx;          ///< can filter reflections
    bool filters_cosine;       ///< can filter diffuse light
    /// Lobes must have alpha > 0 and be of a kind the method filters; `plan` must be valid and
    /// what `source` refers to must outlive the result.
    std::unique_ptr<PreparedFilter> (*prepare)(const FilterSource& source,
                                               std::span<const Lobe> lobes, const FilterPlan& plan);
    bool draws_points = false;   ///< FilterPlan::sequence matters
    bool weighs_points = false;  ///< FilterPlan::heuristic matters
};

/// Every method: --help, tests and benchmarks iterate this table.
std::span<const FilterMethod> filter_methods();

/// The method with that name, which must filter `kind`. Fails with bad_argument, naming those
/// that would do.
Result<FilterMethod> find_filter_method(std::string_view name, LobeKind kind);

}  // namespace splitsum
