#include "splitsum/table/split_sum_quadrature.h"

#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <span>

#include "splitsum/base/parallel.h"
#include "splitsum/table/chebyshev.h"
#include "splitsum/table/half_vector_kernel.h"
#include "splitsum/table/half_vector_rules.h"

namespace splitsum {
namespace {

// Narrower lobes are the mirror: the table differs from its limit by less than alpha / n·v, and at
// n·v = 0 by less than 5 alpha.
constexpr double narrowest_alpha = 1e-12;

// Of a tolerance, what interpolation and each of the two directions of integration may take.
constexpr double share = 0.2;

// The polar rules that the views of one alpha need, each made once.
class RowRules {
public:
    RowRules(const GaussRules& gauss, double alpha, double tolerance)
        : gauss_(gauss), alpha_(alpha), tolerance_(tolerance) {}

    const PolarRule& at(double n_dot_v) {
        const int octave = polar_octave(alpha_, n_dot_v);
        const auto found = rules_.find(octave);
        if (found != rules_.end()) return found->second;
        return rules_.emplace(octave, polar_rule(gauss_, alpha_, n_dot_v, tolerance_))
            .first->second;
    }

private:
    const GaussRules& gauss_;
    double alpha_;
    double tolerance_;
    std::map<int, PolarRule> rules_;
};

// One axis of the grid, n·v or alpha: 0 is a limit, and what is above it is computed where it lies or,
// where that is less work, at Chebyshev nodes.
class Axis {
public:
    Axis(const std::vector<double>& points, double lowest, double tolerance) {
        for (size_t i = 0; i < points.size(); ++i)
            (points[i] >= lowest ? above_ : zero_).push_back(i);
        for (const size_t i : above_) values_.push_back(points[i]);
        if (values_.empty()) return;
        const double least = std::min(0.5, *std::ranges::min_element(values_));
        const int nodes = log_chebyshev_nodes(least, tolerance);
        if (values_.size() > static_cast<size_t>(nodes))
            interpolation_.emplace(least, nodes, values_);
    }

    /// Where values are needed.
    const std::vector<double>& nodes() const {
        return interpolation_ ? interpolation_->nodes() : values_;
    }
    /// The points of the grid that are zero, and above, as indices.
    const std::vector<size_t>& zero() const { return zero_; }
    const std::vector<size_t>& above() const { return above_; }

    /// What the values at the nodes give for point above()[i].
    double at_point(std::span<const double> values, size_t i) const {
        return interpolation_ ? interpolation_->at_point(values, i) : values[i];
    }
    /// And for all of them.
    void spread(std::span<const double> values, std::span<double> out) const {
        if (interpolation_)
            interpolation_->spread(values, out);
        else
            std::ranges::copy(values, out.begin());
    }

private:
    std::vector<size_t> zero_;
    std::vector<size_t> above_;
    std::vector<double> values_;
    std::optional<LogChebyshev> interpolation_;
};

// A sum that is 0 may come out below it by a part of the tolerance.
SplitSum at_least_0(const SplitSum& sum) { return {std::max(0.0, sum.a), std::max(0.0, sum.b)}; }

std::vector<double> alphas_of(const TableGrid& grid) {
    std::vector<double> alphas;
    for (const double r : grid.perceptual_roughness) alphas.push_back(r * r);
    return alphas;
}

// The split sums at the nodes of both axes, and what follows from them for a texel.
class ExactValues {
public:
    ExactValues(const TablePlan& plan, const TableGrid& grid)
        : geometry_(plan.geometry),
          tolerance_(share * quadrature_tolerance(plan)),
          views_(grid.n_dot_v, std::numeric_limits<double>::min(), tolerance_),
          alphas_(alphas_of(grid), narrowest_alpha, tolerance_) {
        for (const double n_dot_v : views_.nodes())
            azimuths_.push_back(azimuth_rule(gauss_, n_dot_v, tolerance_));
        azimuths_.push_back(azimuth_rule(gauss_, 0, tolerance_));
        if (views_.zero().empty()) azimuths_.pop_back();
        a_.assign(azimuths_.size(), std::vector<double>(alphas_.nodes().size()));
        b_ = a_;
        parallel_rows(static_cast<int>(alphas_.nodes().size()),
                      [&](int row) { integrate(static_cast<size_t>(row)); });
    }

    const Axis& views() const { return views_; }
    const Axis& alphas() const { return alphas_; }

    /// Row alphas().above()[i] of the grid.
    void fill(size_t i, SplitSum* row) const {
        std::vector<double> a, b;
        for (size_t k = 0; k < azimuths_.size(); ++k) {
            a.push_back(alphas_.at_point(a_[k], i));
            b.push_back(alphas_.at_point(b_[k], i));
        }
        const size_t nodes = views_.nodes().size();
        std::vector<double> all_a(views_.above().size()), all_b(all_a);
        views_.spread(std::span(a).first(nodes), all_a);
        views_.spread(std::span(b).first(nodes), all_b);
        for (size_t x = 0; x < all_a.size(); ++x)
            row[views_.above()[x]] = at_least_0({all_a[x], all_b[x]});
        for (const size_t x : views_.zero()) row[x] = at_least_0({a.back(), b.back()});
    }

private:
    void integrate(size_t row) {
        const double alpha = alphas_.nodes()[row];
        RowRules rules(gauss_, alpha, tolerance_);
        for (size_t k = 0; k < azimuths_.size(); ++k) {
            const SplitSum sum = integrate_half_vectors(
                geometry_, alpha, rules.at(azimuths_[k].n_dot_v), azimuths_[k]);
            a_[k][row] = sum.a;
            b_[k][row] = sum.b;
        }
    }

    GaussRules gauss_;
    SmithTerm geometry_;
    double tolerance_;
    Axis views_;
    Axis alphas_;
    std::vector<AzimuthRule> azimuths_;   // of the views' nodes, and of n·v = 0 if the grid has it
    std::vector<std::vector<double>> a_;  // [view][alpha node]
    std::vector<std::vector<double>> b_;
};

}  // namespace

SplitSum split_sum_by_quadrature(SmithTerm term, double n_dot_v, double alpha, double tolerance) {
    if (alpha < narrowest_alpha) return mirror_split_sum(n_dot_v);
    const double part = share * tolerance;
    const GaussRules gauss;
    return integrate_half_vectors(term, alpha, polar_rule(gauss, alpha, n_dot_v, part),
                                  azimuth_rule(gauss, n_dot_v, part));
}

std::vector<SplitSum> split_sums_by_quadrature(const TablePlan& plan, const TableGrid& grid,
                                               Progress& progress) {
    const size_t columns = grid.n_dot_v.size();
    std::vector<SplitSum> sums(columns * grid.perceptual_roughness.size());
    const ExactValues values(plan, grid);
    const Axis& alphas = values.alphas();
    for (const size_t y : alphas.zero())
        for (size_t x = 0; x < columns; ++x)
            sums[y * columns + x] = mirror_split_sum(grid.n_dot_v[x]);
    parallel_rows(static_cast<int>(alphas.above().size()), [&](int i) {
        if (progress.cancelled()) return;
        const size_t y = alphas.above()[static_cast<size_t>(i)];
        values.fill(static_cast<size_t>(i), sums.data() + y * columns);
        progress.advance(1);
    });
    return sums;
}

}  // namespace splitsum
