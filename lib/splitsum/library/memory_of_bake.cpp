#include "splitsum/library/memory_of_bake.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "splitsum/filter/asset_levels.h"

namespace splitsum {
namespace {

// Bytes are counted as doubles: plans may ask for more than any memory holds.
constexpr double most_bands = 2000;         // filter/spectral.cpp
constexpr double fewest_transformed = 256;  // likewise
constexpr int most_rows_kept = 1024;        // bake/light.cpp
constexpr double per_thread = 2e6;          // stacks, FFT lines, the heap's own slack
constexpr double picture_bytes = 26e6;      // pixels, rows, and the file that libpng makes of them

// A lobe in harmonics, as filter/spectral.cpp plans it.
struct Harmonics {
    double transformed;  // bands that the transform must reach
    double kept;         // bands that are left when the light is known
    double rings;        // of its grid

    double grid_bytes() const { return 16 * (rings + 6) * (2.1 * rings + 6); }
    double synthesis_bytes() const { return 24 * kept * rings; }
};

// bands_for_point_light takes (5.05 + 1.24 log10(0.01 / accuracy)) / alpha bands of a narrow lobe.
double bands_of_narrow(const Lobe& lobe, double accuracy) {
    return (5.1 + 1.24 * std::log10(0.01 / accuracy)) / lobe.alpha;
}

// A lobe that ends at the horizon has some power in all bands, and no more are kept than a point of
// light takes: 43 at an accuracy of 1e-2 and roughness 1, 431 at 3e-4, 859 at 1e-4.
double bands_of_horizon(const Lobe& lobe, double accuracy) {
    const double width = lobe.kind == LobeKind::ggx ? lobe.alpha : 1;
    return 450 * std::pow(3e-4 / accuracy, 2.0 / 3) * width;
}

Harmonics harmonics_of(const Lobe& lobe, double accuracy) {
    const bool narrow = lobe.kind == LobeKind::ggx && lobe_width(lobe) <= 0.5;
    const double point = narrow ? std::min(bands_of_narrow(lobe, accuracy), most_bands) : 1;
    const double horizon = narrow ? 1 : std::min(bands_of_horizon(lobe, accuracy), most_bands);
    const double per_band = 1.65 * std::pow(1.21, std::log10(0.01 / accuracy));
    return {std::max({fewest_transformed, point, horizon}), std::max(point, horizon),
            std::max(per_band * point, 1.25 * horizon)};
}

// What the plan comes to, in sizes.
struct Work {
    double texels;
    double height;
    double threads;
    bool harmonic = false;  // `auto` and `spectral`
    bool kept = true;       // all texels stay in memory
    double bands = 0;       // of the transform
    std::vector<Harmonics> lobes{};
    double mirror_size = 0;  // texels along an edge
    double cube_texels = 0;  // of all levels
};

bool beyond_reach(const Lobe& lobe, double accuracy) {
    return lobe.kind == LobeKind::ggx && bands_of_narrow(lobe, accuracy) > most_bands;
}

double cube_texels_of(const BakePlan& plan) {
    double texels = 6.0 * plan.irradiance.face_size * plan.irradiance.face_size;
    for (int level = 0; level < plan.specular.levels; ++level) {
        const double face_size = std::max(1, level < 31 ? plan.specular.face_size >> level : 0);
        texels += 6 * face_size * face_size;
    }
    return texels;
}

Work work_of(const PanoramaSize& size, const BakePlan& plan, int threads) {
    const LevelsPlan levels{plan.specular, plan.irradiance, plan.filter, plan.orientation};
    Work work{.texels = double(size.width) * size.height,
              .height = double(size.height),
              .threads = double(threads)};
    work.harmonic = plan.filter.method == "auto" || plan.filter.method == "spectral";
    work.kept = size.height <= most_rows_kept || !work.harmonic;
    for (const Lobe& lobe : lobes_of(levels)) {
        work.lobes.push_back(harmonics_of(lobe, plan.filter.accuracy));
        work.bands = std::max(work.bands, work.lobes.back().transformed);
        work.kept = work.kept || beyond_reach(lobe, plan.filter.accuracy);
    }
    for (const int face_size : mirror_sizes(levels))
        work.mirror_size = std::max(work.mirror_size, double(face_size));
    work.cube_texels = cube_texels_of(plan);
    return work;
}

// The mirror image, and where its texels lie in the panorama.
double mirror_bytes(const Work& work) {
    const double rows = std::max(work.height, 512.0);  // narrow panoramas are cut into more columns
    return 72 * work.mirror_size * work.mirror_size + 12 * rows * work.mirror_size;
}

// Beside that while it is made (sphere/area_filter_builder.h): sums.
double mirror_sums_bytes(const Work& work) {
    return 168 * work.mirror_size * work.mirror_size + std::max(0.5e6, 5 * 48 * work.height);
}

// filter/spectrum.h: Fourier coefficients of the lines, and the spectrum.
double transform_bytes(const Work& work) {
    const double rings = std::max(std::min(3 * work.bands, work.height / 2), 64.0);
    const bool gathered = 4 * rings >= 9 * work.bands && 2 * rings <= work.height;
    const double lines = gathered ? rings : work.height;
    const double window = gathered ? 24 * 2 * work.height * 16 : 0;
    return 24 * lines * work.bands + window;
}

double spectrum_bytes(const Work& work) { return 24 * work.bands * work.bands; }

// The grids of all lobes, and the coefficients of those that are made at the same time.
double synthesis_bytes(const Work& work) {
    double bytes = 0;
    std::vector<double> coefficients;
    for (const Harmonics& lobe : work.lobes) {
        bytes += lobe.grid_bytes();
        coefficients.push_back(lobe.synthesis_bytes());
    }
    std::ranges::sort(coefficients, std::greater());
    for (size_t i = 0; i < coefficients.size() && double(i) < work.threads; ++i)
        bytes += coefficients[i];
    return bytes;
}

// What the other methods prepare beside the texels.
double sampling_bytes(const Work& work, const FilterPlan& plan) {
    const double set = 36.0 * plan.samples;  // positions, weights and levels of the points
    const bool shared = plan.sequence == PointSequence::hammersley;
    const double sets = set * (shared ? double(work.lobes.size()) : work.threads);
    if (plan.method == "filtered") return sets + 28 * work.texels;
    if (plan.method == "mis") return sets + 9 * work.texels;
    return plan.method == "reference" ? 0 : sets;
}

// Points of the exact means, of the mirror image's texels that are measured.
double probe_bytes(const Work& work, const BakePlan& plan) {
    const double asked = plan.probes.value_or(default_probes(int(work.height)));
    return 600e3 * std::min(asked, 6 * work.mirror_size * work.mirror_size);
}

// Levels, stored texels, what is read back of them, and the file (compressed beside that).
double output_bytes(const Work& work, const BakePlan& plan) {
    const double stored = info_of(plan.format).bytes_per_texel;
    const double files = plan.container.ktx2.zstd ? 3 : 1;
    return work.cube_texels * (12 + 12 + stored * (1 + files));
}

}  // namespace

int64_t memory_of_bake(const PanoramaSize& size, const BakePlan& plan, int threads) {
    const Work work = work_of(size, plan, threads);
    const double texels = work.kept ? 16 * work.texels : 16 * 2 * 256 * 256;
    const double reading = std::max(double(size.reading_bytes), 3 * 64 * 12 * 2 * work.height);
    const double levels = 12 * work.cube_texels;
    const double probes = probe_bytes(work, plan);
    const double filtering =
        work.harmonic
            ? std::max(transform_bytes(work), synthesis_bytes(work)) + spectrum_bytes(work)
            : sampling_bytes(work, plan.filter);
    const double mirrors = mirror_bytes(work), sums = mirror_sums_bytes(work);
    const double while_reading =
        reading + (work.kept ? 12 * work.texels : transform_bytes(work) + mirrors + sums + probes);
    const double while_filtering = filtering + mirrors + (work.kept ? sums : 0) + levels;
    const double at_the_end =
        std::max({output_bytes(work, plan), levels + probes, plan.picture ? picture_bytes : 0.0});
    const double most = texels + std::max({while_reading, while_filtering, at_the_end});
    return int64_t(std::min(most + per_thread * (1 + work.threads), 9e18));
}

}  // namespace splitsum
