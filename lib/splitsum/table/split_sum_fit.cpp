#include "splitsum/table/split_sum_fit.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "splitsum/table/split_sum_quadrature.h"

namespace splitsum {
namespace {

using Terms = std::array<double, fit_terms>;

double view_length(SmithTerm term, double n_dot_v, double alpha) {
    if (term == SmithTerm::height_correlated)
        return std::sqrt(n_dot_v * n_dot_v * (1 - alpha * alpha) + alpha * alpha);
    const double k = schlick_k(term, alpha);
    return n_dot_v * (1 - k) + k;
}

Terms terms_at(SmithTerm term, double n_dot_v, double perceptual_roughness) {
    const double alpha = perceptual_roughness * perceptual_roughness;
    const double t = n_dot_v / std::max(view_length(term, n_dot_v, alpha), 1e-7);
    Terms terms;
    size_t next = 0;
    double in_x = 1;
    for (int i = 0; i <= fit_degree; ++i, in_x *= n_dot_v) {
        double in_r = in_x;
        for (int j = 0; i + j <= fit_degree; ++j, in_r *= perceptual_roughness) {
            double in_t = in_r;
            for (int k = 0; i + j + k <= fit_degree; ++k, in_t *= t) terms[next++] = in_t;
        }
    }
    return terms;
}

double polynomial(const Terms& coefficients, const Terms& terms) {
    double sum = 0;
    for (size_t i = 0; i < terms.size(); ++i) sum += coefficients[i] * terms[i];
    return sum;
}

// Where the fit is made, with the values there.
struct Sample {
    Terms terms;
    SplitSum exact;
};

std::vector<Sample> samples_of(SmithTerm term) {
    constexpr int count = 65;
    TableGrid grid;
    for (int i = 0; i < count; ++i) {
        const double at =
            (i + 0.5) / (count - 0.5);  // up to 1, short of the corner without a limit
        grid.n_dot_v.push_back(at * at);
        grid.perceptual_roughness.push_back(at);
    }
    TablePlan plan;
    plan.geometry = term;
    NoProgress progress;
    const auto sums = split_sums_by_quadrature(plan, grid, progress);
    std::vector<Sample> samples;
    for (size_t i = 0; i < sums.size(); ++i)
        samples.push_back(
            {terms_at(term, grid.n_dot_v[i % count], grid.perceptual_roughness[i / count]),
             sums[i]});
    return samples;
}

// A symmetric positive system, by Cholesky's factors; `matrix` holds its lower half.
Terms solved(std::array<Terms, fit_terms>& matrix, Terms right) {
    for (size_t i = 0; i < fit_terms; ++i) {
        for (size_t j = 0; j <= i; ++j) {
            double sum = matrix[i][j];
            for (size_t k = 0; k < j; ++k) sum -= matrix[i][k] * matrix[j][k];
            matrix[i][j] = i == j ? std::sqrt(sum) : sum / matrix[j][j];
        }
        for (size_t k = 0; k < i; ++k) right[i] -= matrix[i][k] * right[k];
        right[i] /= matrix[i][i];
    }
    for (size_t i = fit_terms; i-- > 0;) {
        for (size_t k = i + 1; k < fit_terms; ++k) right[i] -= matrix[k][i] * right[k];
        right[i] /= matrix[i][i];
    }
    return right;
}

Terms weighted_least_squares(const std::vector<Sample>& samples, const std::vector<double>& weights,
                             double SplitSum::*channel) {
    constexpr double ridge = 1e-11;  // keeps the factors real where terms nearly agree
    std::array<Terms, fit_terms> matrix{};
    Terms right{};
    for (size_t s = 0; s < samples.size(); ++s)
        for (size_t i = 0; i < fit_terms; ++i) {
            const double weighted = weights[s] * samples[s].terms[i];
            right[i] += weighted * (samples[s].exact.*channel);
            for (size_t j = 0; j <= i; ++j) matrix[i][j] += weighted * samples[s].terms[j];
        }
    for (size_t i = 0; i < fit_terms; ++i) matrix[i][i] *= 1 + ridge;
    return solved(matrix, right);
}

// Multiplies the weights by powers of the errors; returns the largest error.
double reweigh(const std::vector<Sample>& samples, const Terms& coefficients,
               double SplitSum::*channel, std::vector<double>& weights) {
    constexpr double damping = 0.6, floor = 0.02;
    std::vector<double> errors;
    for (const Sample& sample : samples)
        errors.push_back(std::abs(polynomial(coefficients, sample.terms) - sample.exact.*channel));
    const double largest = *std::ranges::max_element(errors);
    double sum = 0;
    for (size_t s = 0; s < samples.size(); ++s)
        sum += weights[s] *= std::pow(errors[s] / largest + floor, damping);
    for (double& weight : weights) weight *= static_cast<double>(samples.size()) / sum;
    return largest;
}

Terms minimax(const std::vector<Sample>& samples, double SplitSum::*channel) {
    constexpr int rounds = 200;
    std::vector<double> weights(samples.size(), 1.0);
    Terms best{};
    double least = 1e9;
    for (int round = 0; round < rounds; ++round) {
        const Terms coefficients = weighted_least_squares(samples, weights, channel);
        const double largest = reweigh(samples, coefficients, channel, weights);
        if (largest >= least) continue;
        least = largest;
        best = coefficients;
    }
    return best;
}

}  // namespace

SplitSum evaluate(const SplitSumFit& fit, SmithTerm term, double n_dot_v,
                  double perceptual_roughness) {
    const Terms terms = terms_at(term, n_dot_v, perceptual_roughness);
    SplitSum sum{0, 0};
    for (size_t i = 0; i < terms.size(); ++i) {
        sum.a += static_cast<double>(fit[i][0]) * terms[i];
        sum.b += static_cast<double>(fit[i][1]) * terms[i];
    }
    return {std::clamp(sum.a, 0.0, 1.0), std::clamp(sum.b, 0.0, 1.0)};
}

SplitSumFit fit_split_sum(SmithTerm term) {
    const std::vector<Sample> samples = samples_of(term);
    const Terms a = minimax(samples, &SplitSum::a);
    const Terms b = minimax(samples, &SplitSum::b);
    SplitSumFit fit;
    for (size_t i = 0; i < fit_terms; ++i)
        fit[i] = {static_cast<float>(a[i]), static_cast<float>(b[i])};
    return fit;
}

Result<Table> bake_ggx_fit(const TablePlan& plan, const TableGrid& grid, Progress& progress) {
    const auto columns = static_cast<int>(grid.n_dot_v.size());
    const auto rows = static_cast<int>(grid.perceptual_roughness.size());
    progress.begin("closed form", rows);
    Table table = blank_table(columns, rows, 2);
    for (int y = 0; y < rows; ++y) {
        for (int x = 0; x < columns; ++x) {
            const SplitSum sum = evaluate(shipped_fit(plan.geometry), plan.geometry,
                                          grid.n_dot_v[static_cast<size_t>(x)],
                                          grid.perceptual_roughness[static_cast<size_t>(y)]);
            table.texel(x, y)[0] = static_cast<float>(sum.a);
            table.texel(x, y)[1] = static_cast<float>(sum.b);
        }
        progress.advance(1);
    }
    return table;
}

void evaluate_ggx_fit(const TablePlan& plan, double n_dot_v, double perceptual_roughness,
                      std::span<double> read) {
    const SplitSum sum =
        evaluate(shipped_fit(plan.geometry), plan.geometry, n_dot_v, perceptual_roughness);
    read[0] = sum.a;
    read[1] = sum.b;
}

}  // namespace splitsum
