#pragma once

#include <array>
#include <vector>

#include "splitsum/ltc/fit.h"

namespace splitsum {

/// How much a transformed cosine differs from a target lobe, as a sum of squares that a fit can
/// make smaller (the sum is stated at fit_ltc). Directions stay where the lobe that it was made
/// with put them.
class LobeDifference {
public:
    /// The quadratic model of the sum about one shape: value, half of the gradient, and half of the
    /// Hessian of Gauss and Newton.
    struct Model {
        static constexpr int n = LtcShape::parameter_count;
        double value = 0;
        std::array<double, n> gradient{};
        std::array<std::array<double, n>, n> hessian{};
    };

    LobeDifference(const TargetLobe& target, const LtcShape& around, const LtcFitPlan& plan);

    /// The sum of squares for a shape.
    double value(const LtcShape& shape) const;
    Model model(const LtcShape& shape) const;

private:
    void add_direction(const TargetLobe& target, const LtcInverse& around, const Vec3d& direction,
                       double weight);
    void make_kernel();
    std::vector<double> lower_half(const std::vector<double>& values) const;

    std::vector<Vec3d> directions_;
    std::vector<double> densities_;    ///< of the target
    std::vector<double> weights_;      ///< of the quadrature
    std::vector<double> chi_weights_;  ///< weights of e²
    std::vector<float> kernel_;        ///< of pairs of directions, rows up to the diagonal
};

}  // namespace splitsum
