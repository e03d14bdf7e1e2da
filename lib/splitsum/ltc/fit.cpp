#include "splitsum/ltc/fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "splitsum/ltc/lobe_difference.h"

namespace splitsum {
namespace {

constexpr int n = LtcShape::parameter_count;
constexpr double longest_step = 0.5;
constexpr double first_damping = 1e-3;
constexpr double most_damping = 1e6;

using Parameters = std::array<double, n>;

// Solves (H + damping diag H) step = -gradient by Gauss-Jordan elimination with pivoting.
Parameters damped_step(const LobeDifference::Model& model, double damping) {
    std::array<std::array<double, n + 1>, n> rows{};
    for (size_t a = 0; a < n; ++a) {
        for (size_t b = 0; b < n; ++b) rows[a][b] = model.hessian[a][b];
        rows[a][a] += damping * model.hessian[a][a] + 1e-300;
        rows[a][n] = -model.gradient[a];
    }
    for (size_t column = 0; column < n; ++column) {
        size_t pivot = column;
        for (size_t row = column + 1; row < n; ++row)
            if (std::abs(rows[row][column]) > std::abs(rows[pivot][column])) pivot = row;
        std::swap(rows[column], rows[pivot]);
        for (size_t row = 0; row < n; ++row) {
            if (row == column) continue;
            const double factor = rows[row][column] / rows[column][column];
            for (size_t k = column; k <= n; ++k) rows[row][k] -= factor * rows[column][k];
        }
    }
    Parameters step{};
    for (size_t a = 0; a < n; ++a)
        step[a] = std::clamp(rows[a][n] / rows[a][a], -longest_step, longest_step);
    return step;
}

LtcShape moved(const LtcShape& shape, const Parameters& step) {
    Parameters values = shape.parameters();
    for (size_t a = 0; a < n; ++a) values[a] += step[a];
    LtcShape result = shape;
    result.set_parameters(values);
    return result;
}

double largest(const Parameters& step) {
    double most = 0;
    for (const double value : step) most = std::max(most, std::abs(value));
    return most;
}

// Levenberg 1944, Marquardt 1963: Gauss-Newton steps, shortened until they lead downwards.
LtcShape descend(const LobeDifference& difference, LtcShape shape, const LtcFitPlan& plan) {
    double damping = first_damping;
    for (int i = 0; i < plan.steps; ++i) {
        const LobeDifference::Model model = difference.model(shape);
        for (;; damping *= 8) {
            if (damping > most_damping) return shape;
            const Parameters step = damped_step(model, damping);
            const LtcShape next = moved(shape, step);
            if (!(difference.value(next) < model.value)) continue;
            shape = next;
            damping *= 0.125;
            if (largest(step) < plan.accuracy) return shape;
            break;
        }
    }
    return shape;
}

}  // namespace

LtcShape fit_ltc(const TargetLobe& target, const LtcShape& start, const LtcFitPlan& plan) {
    LtcShape shape = start;
    for (int round = 0; round < plan.rounds; ++round)
        shape = descend(LobeDifference(target, shape, plan), shape, plan);
    return shape;
}

}  // namespace splitsum
