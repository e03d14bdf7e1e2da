#include "splitsum/ltc/ltc_table.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "splitsum/base/parallel.h"

namespace splitsum {
namespace {

// A lobe is a good start for one whose width is this much smaller, not for any.
constexpr double narrowest_ratio = 0.5;
constexpr double largest_stride = 0.05;  // in perceptual roughness

// Where the mean of the target's directions lies in the plane of view and normal.
double mean_angle(const TargetLobe& target, int nodes) {
    double x = 0, z = 0;
    for (const LobeNode& node : target.nodes(nodes)) {
        const double mass = node.weight * target.density(node.light);
        x += mass * node.light.x;
        z += mass * node.light.z;
    }
    return std::atan2(x, z);
}

// Walks from rough to smooth surfaces seen from one direction.
class Walk {
public:
    Walk(LtcTarget target, double n_dot_v, const LtcFitPlan& plan)
        : target_(target), n_dot_v_(n_dot_v), plan_(plan) {}

    LtcFit to(double perceptual_roughness) {
        const double goal = std::max(perceptual_roughness, TargetLobe::smoothest);
        while (at_ > goal) {
            const double reachable =
                std::max(at_ - largest_stride, at_ * std::sqrt(narrowest_ratio));
            const bool last = reachable <= goal;
            step_to(last ? goal : reachable);
        }
        if (!started_) step_to(goal);
        return {inverse_of(shape_), std::clamp(std::exp(shape_.log_magnitude),
                                               1 - LtcFit::most_change, 1 + LtcFit::most_change)};
    }

private:
    void step_to(double perceptual_roughness) {
        const TargetLobe target(target_, n_dot_v_, perceptual_roughness);
        shape_.axis_angle = mean_angle(target, plan_.nodes);
        if (started_ && target_ == LtcTarget::ggx) narrow(perceptual_roughness / at_);
        shape_ = fit_ltc(target, shape_, plan_);
        at_ = perceptual_roughness;
        started_ = true;
    }

    // The width of a GGX lobe goes with the square of its roughness.
    void narrow(double ratio) {
        if (at_ > 0.4) return;
        shape_.log_width_x += 2 * std::log(ratio);
        shape_.log_width_y += 2 * std::log(ratio);
    }

    LtcTarget target_;
    double n_dot_v_;
    LtcFitPlan plan_;
    LtcShape shape_;
    double at_ = 1;
    bool started_ = false;
};

std::vector<size_t> roughest_first(std::span<const double> perceptual_roughness) {
    std::vector<size_t> order(perceptual_roughness.size());
    std::iota(order.begin(), order.end(), size_t{0});
    std::ranges::stable_sort(order, [&](size_t a, size_t b) {
        return perceptual_roughness[a] > perceptual_roughness[b];
    });
    return order;
}

}  // namespace

Result<std::vector<LtcFit>> fit_ltc_table(LtcTarget target, std::span<const double> n_dot_v,
                                          std::span<const double> perceptual_roughness,
                                          Progress& progress, const LtcFitPlan& plan) {
    const std::vector<size_t> order = roughest_first(perceptual_roughness);
    std::vector<LtcFit> fits(n_dot_v.size() * perceptual_roughness.size());
    parallel_rows(static_cast<int>(n_dot_v.size()), [&](int i) {
        const auto column = static_cast<size_t>(i);
        Walk walk(target, n_dot_v[column], plan);
        for (const size_t row : order) {
            if (progress.cancelled()) return;
            fits[row * n_dot_v.size() + column] = walk.to(perceptual_roughness[row]);
        }
        progress.advance(1);
    });
    if (progress.cancelled())
        return Error{ErrorKind::interrupted, "the fit of the table was cancelled before its end"};
    return fits;
}

}  // namespace splitsum
