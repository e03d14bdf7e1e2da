// Prints lib/splitsum/table/split_sum_fit_coefficients.cpp: the fits of every geometry term.

#include <cstdio>

#include "splitsum/table/split_sum_fit.h"

int main() {
    using namespace splitsum;
    std::printf(
        "// Printed by tests/benchmarks/fit_split_sum.cpp; clang-format follows.\n"
        "#include \"splitsum/table/split_sum_fit.h\"\n\n"
        "namespace splitsum {\nnamespace {\n\n"
        "constexpr SplitSumFit fits[] = {\n");
    for (const SmithTermInfo& info : smith_terms()) {
        std::printf("    // %s\n    {{", info.name.data());
        for (const auto& [a, b] : fit_split_sum(info.term))
            std::printf("{%.9gF, %.9gF},\n", double(a), double(b));
        std::printf("}},\n");
    }
    std::printf(
        "};\n\n}  // namespace\n\n"
        "const SplitSumFit& shipped_fit(SmithTerm term) { return fits[static_cast<size_t>(term)]; "
        "}\n\n}  // namespace splitsum\n");
}
