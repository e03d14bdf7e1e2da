#include <functional>
#include <nlohmann/json.hpp>

#include "splitsum/assets/table_source_detail.h"
#include "splitsum/base/text.h"
#include "splitsum/table/split_sum_fit.h"

namespace splitsum {
namespace {

// Spells coefficient `index` of the fit.
using Literal = std::function<std::string(size_t index)>;

// "c0 + v * (c1 + v * (c2 ...))" over `parts`, lowest power first.
std::string horner(const std::vector<std::string>& parts, const std::string& variable) {
    std::string text = parts.back();
    for (size_t i = parts.size() - 1; i-- > 0;)
        text = cat(parts[i], " + ", variable, " * (", text, ")");
    return text;
}

// Lines `name`_ij: the polynomial in t that x^i r^j has; then the sum over j for each i; then the
// polynomial in x itself.
std::string nested(const std::string& type, const std::string& name, const Literal& literal) {
    std::string text;
    std::vector<std::string> in_x;
    size_t next = 0;
    for (int i = 0; i <= fit_degree; ++i) {
        std::vector<std::string> in_r;
        for (int j = 0; i + j <= fit_degree; ++j) {
            std::vector<std::string> in_t;
            for (int k = 0; i + j + k <= fit_degree; ++k) in_t.push_back(literal(next++));
            in_r.push_back(cat(name, i, j));
            text += cat("    ", type, " ", in_r.back(), " = ", horner(in_t, "t"), ";\n");
        }
        in_x.push_back(cat(name, i));
        text += cat("    ", type, " ", in_x.back(), " = ", horner(in_r, "r"), ";\n");
    }
    return text + cat("    ", type, " ", name, " = ", horner(in_x, "x"), ";\n");
}

// L of t = x / L as an expression of x and r that both languages read; `square_root` names the
// function and `suffix` ends a literal.
std::string view_length(SmithTerm term, const std::string& square_root, const std::string& suffix) {
    const auto number = [&](double value) {
        return cat(float_text(static_cast<float>(value)), suffix);
    };
    if (term == SmithTerm::height_correlated)
        return cat(square_root, "(x * x + r * r * r * r * (", number(1), " - x * x))");
    return cat("(x + ", number(schlick_k(term, 1)), " * r * r * (", number(1), " - x))");
}

Literal channel_of(const SplitSumFit& fit, size_t channel) {
    return [&fit, channel](size_t index) { return float_text(fit[index][channel]) + "f"; };
}

}  // namespace

nlohmann::ordered_json formula_json(const TableAsset& asset) {
    nlohmann::ordered_json formula;
    formula["variables"] = {{"x", "n.v"},
                            {"r", "perceptual roughness"},
                            {"t", cat("x / ", view_length(asset.plan.geometry, "sqrt", ""))}};
    formula["terms"] = "sum of c x^i r^j t^k, clamped to [0, 1]";
    formula["coefficients"] = nlohmann::ordered_json::array();
    const SplitSumFit& fit = shipped_fit(asset.plan.geometry);
    size_t next = 0;
    for (int i = 0; i <= fit_degree; ++i)
        for (int j = 0; i + j <= fit_degree; ++j)
            for (int k = 0; i + j + k <= fit_degree; ++k, ++next)
                formula["coefficients"].push_back(
                    {{"i", i}, {"j", j}, {"k", k}, {"a", fit[next][0]}, {"b", fit[next][1]}});
    return formula;
}

std::string formula_as_glsl(const TableAsset& asset) {
    const SplitSumFit& fit = shipped_fit(asset.plan.geometry);
    const Literal pair = [&](size_t index) {
        return cat("vec2(", float_text(fit[index][0]), ", ", float_text(fit[index][1]), ")");
    };
    const std::string name = identifier_of(asset.kind);
    return cat("// ", asset.kind.value, "\n", metadata_comment(asset), "vec2 ", name,
               "(float n_dot_v, float perceptual_roughness) {\n"
               "    float x = clamp(n_dot_v, 0.0, 1.0);\n"
               "    float r = clamp(perceptual_roughness, 0.0, 1.0);\n"
               "    float t = x / max(",
               view_length(asset.plan.geometry, "sqrt", ""), ", 1e-7);\n",
               nested("vec2", "s", pair), "    return clamp(s, 0.0, 1.0);\n}\n");
}

std::string formula_as_cpp(const TableAsset& asset) {
    const SplitSumFit& fit = shipped_fit(asset.plan.geometry);
    const std::string name = identifier_of(asset.kind);
    return cat("// ", asset.kind.value, "\n", metadata_comment(asset),
               "#pragma once\n\n#include <algorithm>\n#include <cmath>\n\nnamespace ", name,
               " {\n\nconstexpr int channels = 2, layers = 1;\n\n"
               "// a and b into `read`.\n"
               "inline void look_up(float n_dot_v, float perceptual_roughness, float* read) {\n"
               "    const float x = std::clamp(n_dot_v, 0.0f, 1.0f);\n"
               "    const float r = std::clamp(perceptual_roughness, 0.0f, 1.0f);\n"
               "    const float t = x / std::max(",
               view_length(asset.plan.geometry, "std::sqrt", "f"), ", 1e-7f);\n",
               nested("const float", "a", channel_of(fit, 0)),
               nested("const float", "b", channel_of(fit, 1)),
               "    read[0] = std::clamp(a, 0.0f, 1.0f);\n"
               "    read[1] = std::clamp(b, 0.0f, 1.0f);\n}\n\n}  // namespace ",
               name, "\n");
}

}  // namespace splitsum
