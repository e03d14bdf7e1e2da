// The whole specular chain as the tools make it by default: 256 x 256, 7 levels, linear, from
// 1024 x 512 texels that are in memory, or from the panoramas named on the command line. The error is that of the worst level beyond the mirror
// image; `reference` is left out, which judges the others and takes a minute.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "benchmark_main.h"
#include "counters.h"
#include "sky_made_once.h"
#include "splitsum/base/parallel.h"
#include "splitsum/base/text.h"
#include "splitsum/filter/asset_levels.h"
#include "splitsum/filter/methods.h"
#include "splitsum/panorama/panorama.h"
#include "splitsum/verify/check_levels.h"

namespace splitsum::benchmarks {
namespace {

constexpr int environment_height = 512;

LevelsPlan plan_of(const FilterMethod& method) {
    LevelsPlan plan;
    plan.specular = SpecularPlan{};
    plan.filter.method = method.name;
    return plan;
}

void show_errors(benchmark::State& state, const std::vector<Cubemap>& levels,
                 const LevelsPlan& plan, const Environment& environment) {
    NoProgress progress;
    const auto roughness = roughness_of_levels(plan.specular->roughness, plan.specular->levels);
    const auto checks = check_specular(levels, roughness, {environment, Mat3d(1)}, progress);
    const auto worst = std::max_element(checks->begin() + 1, checks->end(),
                                        [](const LevelCheck& a, const LevelCheck& b) {
                                            return a.figures.rel_rms < b.figures.rel_rms;
                                        });
    show(state, worst->figures);
    state.counters["worst_level"] = worst->level;
    state.counters["mirror_rel_rms"] = checks->front().figures.rel_rms;
}

void filter_chain(benchmark::State& state, const Environment& environment,
                  const FilterMethod& method, int threads) {
    const LevelsPlan plan = plan_of(method);
    NoProgress progress;
    std::vector<Cubemap> levels;
    {
        const ThreadLimit limit(threads);
        for (auto _ : state) levels = filter_levels(environment, plan, progress)->specular;
    }
    show_errors(state, levels, plan, environment);
}

// `environment` gives an Environment that outlives the benchmarks.
void register_chains(const std::string& name, const auto& environment) {
    for (const FilterMethod& method : filter_methods()) {
        if (!method.filters_ggx || method.name == "reference") continue;
        for (const int threads : {1, 0})
            benchmark::RegisterBenchmark(
                cat(name, "/", method.name, "/threads:", threads == 0 ? "all" : "1").c_str(),
                [=](benchmark::State& state) {
                    filter_chain(state, environment(), method, threads);
                })
                ->Unit(benchmark::kMillisecond)
                ->UseRealTime();
    }
}

const bool registered = [] {
    for (const tests::NamedSky& sky : tests::skies())
        register_chains(std::string(sky.name), [sky]() -> const Environment& {
            return sky_made_once(sky, environment_height);
        });
    return true;
}();

const ForEachFile captures([](const char* path) {
    NoProgress progress;
    PanoramaOptions options;
    options.repair = true;  // some captures hold tiny negative values
    const auto panorama = read_panorama(path, options, progress);
    if (!panorama) {
        std::cerr << panorama.error().message << "\n";
        std::exit(2);
    }
    const auto environment = std::make_shared<const Environment>(panorama->pixels);
    register_chains(panorama->source,
                    [environment]() -> const Environment& { return *environment; });
});

}  // namespace
}  // namespace splitsum::benchmarks
