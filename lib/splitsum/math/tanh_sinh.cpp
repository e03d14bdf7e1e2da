#include "splitsum/math/tanh_sinh.h"

#include <cmath>
#include <numbers>

namespace splitsum {

// With a = pi / 2 sinh t: x = 1 / (1 + exp(-2 a)), dx/dt = pi / 2 cosh t / (2 cosh² a).
std::vector<UnitNode> tanh_sinh(double step) {
    constexpr double farthest = 3.125;  // where the nodes are 1e-15 from the ends
    const int each_side = static_cast<int>(farthest / step);
    std::vector<UnitNode> nodes;
    nodes.reserve(static_cast<size_t>(2 * each_side + 1));
    for (int i = -each_side; i <= each_side; ++i) {
        const double a = 0.5 * std::numbers::pi * std::sinh(i * step);
        const double cosh_a = std::cosh(a);
        nodes.push_back({1 / (1 + std::exp(-2 * a)), 1 / (1 + std::exp(2 * a)),
                         step * 0.25 * std::numbers::pi * std::cosh(i * step) / (cosh_a * cosh_a)});
    }
    return nodes;
}

}  // namespace splitsum
