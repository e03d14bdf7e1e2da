// The split-sum table of each geometry term beside the scalar loop it is usually baked with, each
// with its largest error against nested quadrature at texels spread over the table.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <vector>

#include "counters.h"
#include "scalar_split_sum.h"
#include "splitsum/base/parallel.h"
#include "splitsum/base/text.h"
#include "splitsum/math/low_discrepancy.h"
#include "splitsum/table/ggx_tables.h"
#include "splitsum/table/split_sum.h"
#include "splitsum/table/split_sum_exact.h"

namespace splitsum::benchmarks {
namespace {

constexpr int table_size = 128;
constexpr int samples = 1024;
constexpr int probe_count = 256;

// Texels spread over the table, the corners among them.
std::vector<int> probes(int size) {
    std::vector<int> texels = {0, size - 1, size * (size - 1), size * size - 1};
    for (int i = 0; i < probe_count; ++i) {
        const Vec2d point = hammersley(uint32_t(i), probe_count);
        texels.push_back(int(point.y * size) * size + int(point.x * size));
    }
    return texels;
}

double max_abs(const Table& table, SmithTerm term) {
    const std::vector<int> texels = probes(table.width);
    std::vector<double> differences(texels.size());
    parallel_rows(int(texels.size()), [&](int i) {
        const int texel = texels[size_t(i)];
        const double r = (texel / table.width + 0.5) / table.height;
        const SplitSum exact =
            split_sum_exact(term, (texel % table.width + 0.5) / table.width, r * r);
        const auto found = table.texel(texel % table.width, texel / table.width);
        differences[size_t(i)] =
            std::max(std::abs(double(found[0]) - exact.a), std::abs(double(found[1]) - exact.b));
    });
    return *std::max_element(differences.begin(), differences.end());
}

void show_table(benchmark::State& state, const Table& table, SmithTerm term) {
    state.counters["max_abs"] = max_abs(table, term);
    show_rate(state, "texels/s", double(table.texel_count()));
}

void library_table(benchmark::State& state, std::string_view method, SmithTerm term, int size,
                   int threads) {
    NoProgress progress;
    TablePlan plan;
    plan.method = method;
    plan.geometry = term;
    plan.size = size;
    plan.samples = samples;
    const TableGrid grid = grid_of(plan, ViewAxis::cosine);
    Table table;
    {
        const ThreadLimit limit(threads);
        for (auto _ : state) table = *bake_ggx(plan, grid, progress);
    }
    show_table(state, table, term);
}

void scalar_table(benchmark::State& state, SmithTerm term, int size) {
    Table table;
    for (auto _ : state) table = scalar_split_sum_table(term, size, samples);
    show_table(state, table, term);
}

template <class... Arguments>
void register_case(const std::string& name, const Arguments&... arguments) {
    benchmark::RegisterBenchmark(name.c_str(), arguments...)
        ->Unit(benchmark::kMillisecond)
        ->UseRealTime();
}

const bool registered = [] {
    for (const SmithTermInfo& info : smith_terms()) {
        register_case(cat(info.name, "/", table_size, "/scalar"), scalar_table, info.term,
                      table_size);
        for (const SplitSumMethod& method : split_sum_methods())
            for (const int size : {table_size, 512})
                for (const int threads : {1, 0})
                    register_case(cat(info.name, "/", size, "/", method.name,
                                      "/threads:", threads == 0 ? "all" : "1"),
                                  library_table, method.name, info.term, size, threads);
    }
    return true;
}();

}  // namespace
}  // namespace splitsum::benchmarks
