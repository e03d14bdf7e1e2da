// Every method at every roughness on every sky: what an error costs. One level of 16 x 16 texels a
// face from a panorama of 512 x 256, on all threads; making the filter ready is shown apart.

#include <benchmark/benchmark.h>

#include <chrono>
#include <string>
#include <vector>

#include "counters.h"
#include "sky_made_once.h"
#include "splitsum/base/text.h"
#include "splitsum/filter/filter_cubemap.h"
#include "splitsum/filter/methods.h"
#include "splitsum/verify/check_levels.h"
#include "support/lopsided_sky.h"

namespace splitsum::benchmarks {
namespace {

constexpr int environment_height = 256;
constexpr int face_size = 16;

struct LevelCase {
    tests::NamedSky sky;
    FilterMethod method;
    Lobe lobe;
    int samples;  ///< 1 for a method that ignores it
};

FilterPlan plan_of(const LevelCase& c) {
    FilterPlan plan;
    plan.method = c.method.name;
    plan.samples = c.samples;
    return plan;
}

LevelCheck check(const Cubemap& level, const LevelCase& c, const Environment& environment) {
    NoProgress progress;
    const CheckedAgainst truth{environment, Mat3d(1)};
    if (c.lobe.kind == LobeKind::cosine) return *check_irradiance(level, 1, truth, progress);
    const double perceptual_roughness = std::sqrt(c.lobe.alpha);
    return check_specular({&level, 1}, {&perceptual_roughness, 1}, truth, progress)->front();
}

void filter_level(benchmark::State& state, const LevelCase& c) {
    const Environment& environment = sky_made_once(c.sky, environment_height);
    NoProgress progress;
    const auto before = std::chrono::steady_clock::now();
    const auto filter = c.method.prepare(environment, {&c.lobe, 1}, plan_of(c));
    const std::chrono::duration<double, std::milli> preparing =
        std::chrono::steady_clock::now() - before;

    Cubemap level;
    for (auto _ : state)
        level = filter_cubemap(*filter, 0, face_size, Mat3d(1), 0, progress)->cubemap;

    show(state, check(level, c, environment).figures);
    state.counters["prepare_ms"] = preparing.count();
    const double texels = double(level.texels.size());
    show_rate(state, "texels/s", texels);
    show_rate(state, "samples/s", c.samples > 1 ? texels * c.samples : 0);
}

// Whether the number of samples makes a difference to the method's result; exact methods ignore it.
bool takes_samples(const FilterMethod& method, const Lobe& lobe) {
    const Environment sky = tests::lopsided_sky(16);
    const Vec3d towards = normalize(Vec3d(0.3, 0.4, -0.8));
    const auto with = [&](int samples) {
        FilterPlan plan;
        plan.samples = samples;
        Vec3 radiance;
        method.prepare(sky, {&lobe, 1}, plan)->evaluate(0, {{&towards, 1}}, {&radiance, 1});
        return radiance;
    };
    return with(16) != with(61);
}

std::string name_of(const LevelCase& c) {
    const std::string lobe = c.lobe.kind == LobeKind::cosine ? std::string("cosine")
                                                             : cat("r:", std::sqrt(c.lobe.alpha));
    const std::string effort = c.samples > 1 ? cat("samples:", c.samples) : std::string("exact");
    return cat(c.sky.name, "/", lobe, "/", c.method.name, "/", effort);
}

void register_case(const LevelCase& c) {
    benchmark::RegisterBenchmark(name_of(c).c_str(), filter_level, c)
        ->Unit(benchmark::kMillisecond)
        ->UseRealTime();
}

void register_lobe(const tests::NamedSky& sky, const Lobe& lobe) {
    for (const FilterMethod& method : filter_methods()) {
        if (lobe.kind == LobeKind::ggx ? !method.filters_ggx : !method.filters_cosine) continue;
        if (!takes_samples(method, lobe)) {
            register_case({sky, method, lobe, 1});
            continue;
        }
        for (const int samples : {64, 256, 1024, 4096}) register_case({sky, method, lobe, samples});
    }
}

const bool registered = [] {
    for (const tests::NamedSky& sky : tests::skies()) {
        for (const double r : {0.1, 0.25, 0.5, 1.0}) register_lobe(sky, {LobeKind::ggx, r * r});
        register_lobe(sky, {LobeKind::cosine});
    }
    return true;
}();

}  // namespace
}  // namespace splitsum::benchmarks
