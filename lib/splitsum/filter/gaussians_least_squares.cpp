#include "splitsum/filter/gaussians_least_squares.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace splitsum {
namespace {

constexpr double diagonal_share = 1e-10;
constexpr double gradient_limit = 1e-12;  // of the largest |b|

class ActiveSet {
public:
    ActiveSet(std::span<const double> matrix, std::span<const double> rhs)
        : matrix_(matrix), rhs_(rhs), values_(rhs.size(), 0.0), free_(rhs.size(), false) {
        for (const double b : rhs) largest_ = std::max(largest_, std::abs(b));
    }

    std::vector<double> solve() {
        // Every step lowers the sum, so no set comes twice; the limit is for rounding alone.
        for (size_t step = 0; step < 10 * rhs_.size() && free_steepest(); ++step) settle();
        return values_;
    }

private:
    double entry(size_t row, size_t column) const {
        const double value = matrix_[row * rhs_.size() + column];
        return row == column ? value * (1 + diagonal_share) : value;
    }

    // Frees the bound unknown that lowers the sum fastest; false if none does.
    bool free_steepest() {
        double steepest = gradient_limit * largest_;
        size_t best = rhs_.size();
        for (size_t i = 0; i < rhs_.size(); ++i) {
            if (free_[i]) continue;
            double descent = rhs_[i];
            for (size_t j = 0; j < rhs_.size(); ++j) descent -= entry(i, j) * values_[j];
            if (descent > steepest) steepest = descent, best = i;
        }
        if (best == rhs_.size()) return false;
        free_[best] = true;
        return true;
    }

    // Moves to the minimum over the free unknowns, binding those that reach 0 on the way.
    void settle() {
        for (std::vector<size_t> free = free_indices(); !free.empty(); free = free_indices()) {
            const std::vector<double> target = minimum_over(free);
            double step = 1;
            size_t first_at_zero = rhs_.size();
            for (size_t k = 0; k < free.size(); ++k) {
                const double value = values_[free[k]];
                if (target[k] > 0) continue;
                const double reach = value > 0 ? value / (value - target[k]) : 0;
                if (first_at_zero == rhs_.size() || reach < step)
                    step = reach, first_at_zero = free[k];
            }
            for (size_t k = 0; k < free.size(); ++k)
                values_[free[k]] += step * (target[k] - values_[free[k]]);
            if (first_at_zero == rhs_.size()) return;
            values_[first_at_zero] = 0;
            free_[first_at_zero] = false;
        }
    }

    std::vector<size_t> free_indices() const {
        std::vector<size_t> indices;
        for (size_t i = 0; i < rhs_.size(); ++i)
            if (free_[i]) indices.push_back(i);
        return indices;
    }

    // Cholesky's factorisation of the free rows and columns, then both triangles.
    std::vector<double> minimum_over(const std::vector<size_t>& free) const {
        const size_t n = free.size();
        std::vector<double> lower(n * n), x(n);
        for (size_t i = 0; i < n; ++i)
            for (size_t j = 0; j <= i; ++j) {
                double sum = entry(free[i], free[j]);
                for (size_t k = 0; k < j; ++k) sum -= lower[i * n + k] * lower[j * n + k];
                lower[i * n + j] = i == j ? std::sqrt(std::max(sum, smallest_pivot(free[i])))
                                          : sum / lower[j * n + j];
            }
        for (size_t i = 0; i < n; ++i) {
            x[i] = rhs_[free[i]];
            for (size_t k = 0; k < i; ++k) x[i] -= lower[i * n + k] * x[k];
            x[i] /= lower[i * n + i];
        }
        for (size_t i = n; i-- > 0;) {
            for (size_t k = i + 1; k < n; ++k) x[i] -= lower[k * n + i] * x[k];
            x[i] /= lower[i * n + i];
        }
        return x;
    }

    double smallest_pivot(size_t i) const { return diagonal_share * entry(i, i); }

    std::span<const double> matrix_;
    std::span<const double> rhs_;
    std::vector<double> values_;
    std::vector<bool> free_;
    double largest_ = 0;
};

}  // namespace

std::vector<double> non_negative_least_squares(std::span<const double> matrix,
                                               std::span<const double> rhs) {
    return ActiveSet(matrix, rhs).solve();
}

}  // namespace splitsum
