// What SIMD and threads are worth: the library's `filtered` beside a plain scalar loop that gives the
// same level, both timed in turn within one run. samples/s counts texels times samples.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <string>
#include <vector>

#include "scalar_filtered.h"
#include "splitsum/base/parallel.h"
#include "splitsum/base/text.h"
#include "splitsum/filter/asset_levels.h"
#include "splitsum/measure/error_figures.h"
#include "support/lopsided_sky.h"

namespace splitsum::benchmarks {
namespace {

constexpr int environment_height = 512;
constexpr int samples = 1024;

// How far two texels of the same level may be apart: a lookup's azimuth is rounded to 1e-7 turns,
// 1e-4 texels of the finest level, at whose edge the sun of 50 begins. Measured: up to 3.4e-6; a level
// chosen without the factor sqrt(2) differs by 0.04.
constexpr double rounding = 2e-5;

template <class Bake>
double seconds_of(const Bake& bake) {
    const auto before = std::chrono::steady_clock::now();
    bake();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - before).count();
}

double median(std::vector<double> values) {
    std::nth_element(values.begin(), values.begin() + ptrdiff_t(values.size() / 2), values.end());
    return values[values.size() / 2];
}

template <class Towards>
Cubemap scalar_level(int face_size, const Towards& towards) {
    Cubemap level(face_size);
    for (int face = 0; face < face_count; ++face)
        for (int y = 0; y < face_size; ++y)
            for (int x = 0; x < face_size; ++x)
                level.at(face, x, y) = towards(direction_of_texel(face, x, y, face_size));
    return level;
}

// One level by the library, pyramid and sample set included.
Cubemap library_level(const Environment& environment, const SpecularPlan& specular, int threads) {
    const ThreadLimit limit(threads);
    LevelsPlan plan;
    plan.specular = specular;
    plan.filter.method = "filtered";
    plan.filter.samples = samples;
    NoProgress progress;
    return std::move(filter_levels(environment, plan, progress)->specular.front());
}

// Ways to make the same level, the one that the others are compared with first.
struct Contest {
    std::array<const char*, 4> names = {"scalar_float", "scalar_double", "library_1_thread",
                                        "library_all_threads"};
    std::array<std::vector<double>, 4> seconds;
    std::array<Cubemap, 4> levels;

    void round(const Environment& environment, const ScalarFiltered& scalar,
               const SpecularPlan& plan) {
        const auto enter = [&](size_t i, const auto& bake) {
            seconds[i].push_back(seconds_of([&] { levels[i] = bake(); }));
        };
        enter(0, [&] {
            return scalar_level(plan.face_size,
                                [&](const Vec3d& d) { return scalar.towards_in_float(d); });
        });
        enter(1, [&] {
            return scalar_level(plan.face_size,
                                [&](const Vec3d& d) { return scalar.towards_in_double(d); });
        });
        enter(2, [&] { return library_level(environment, plan, 1); });
        enter(3, [&] { return library_level(environment, plan, 0); });
    }

    double worst_difference() const {
        double worst = 0;
        for (const Cubemap& level : levels)
            worst = std::max(worst, error_figures(level.texels, levels[1].texels).max_rel);
        return worst;
    }

    void show(benchmark::State& state) const {
        const double work = double(levels[0].texels.size()) * samples;
        for (size_t i = 0; i < names.size(); ++i)
            state.counters[cat(names[i], "/s")] = work / median(seconds[i]);
        const double slowest = median(seconds[0]);
        state.counters["times_1_thread"] = slowest / median(seconds[2]);
        state.counters["times_all_threads"] = slowest / median(seconds[3]);
        state.counters["max_rel"] = worst_difference();
    }
};

void beside_scalar_loop(benchmark::State& state) {
    const double perceptual_roughness = double(state.range(0)) / 1000;
    const Environment environment = tests::lopsided_sky(environment_height);
    const ScalarFiltered scalar(
        environment, {LobeKind::ggx, perceptual_roughness * perceptual_roughness}, samples);
    const SpecularPlan plan{
        int(state.range(1)), 1, {RoughnessCurve::Kind::list, {perceptual_roughness}}};
    Contest contest;
    for (auto _ : state) contest.round(environment, scalar, plan);
    contest.show(state);
    if (!(contest.worst_difference() < rounding))
        state.SkipWithError(cat("the levels differ by ", contest.worst_difference()).c_str());
}

BENCHMARK(beside_scalar_loop)
    ->ArgNames({"perceptual_roughness_x1000", "face_size"})
    ->Args({500, 16})
    ->Args({167, 64})
    ->Args({500, 64})
    ->Args({1000, 64})
    ->Iterations(3)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace splitsum::benchmarks
