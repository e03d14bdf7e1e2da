// What an engine reads from stored levels, against functions whose right answer is known.
#include "splitsum/verify/reconstruction.h"

#include <gtest/gtest.h>

#include <cmath>

#include "splitsum/brdf/band_factors.h"
#include "splitsum/filter/asset_levels.h"
#include "support/lopsided_sky.h"

namespace splitsum {
namespace {

const Mat3d straight(1.0);

Cubemap cubemap_of(int size, const auto& f) {
    Cubemap cubemap(size);
    for (int face = 0; face < face_count; ++face)
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x)
                cubemap.at(face, x, y) = f(direction_of_texel(face, x, y, size));
    return cubemap;
}

ReconstructionProbes probes_of(const Environment& sky, int count,
                               const Mat3d& panorama_from_cube = straight) {
    NoProgress progress;
    return *reconstruction_probes(sky, panorama_from_cube, roughness_bands(), count, progress);
}

TEST(TrilinearLookup, IsLinearBetweenTheLevelsOfEveryCurve) {
    std::vector<Cubemap> levels;
    for (int level = 0; level < 4; ++level)
        levels.push_back(cubemap_of(8 >> level, [&](const Vec3d&) { return Vec3(float(level)); }));
    for (const char* name : {"linear", "filament", "0,0.2,0.5,0.9"}) {
        const RoughnessCurve curve = *parse_roughness_curve(name);
        for (double r = 0; r <= 1; r += 0.01)
            EXPECT_NEAR(trilinear_lookup(levels, curve, {0.3, -2, 1}, r).x,
                        level_of_roughness(curve, 4, r), 1e-6)
                << name << " " << r;
    }
}

TEST(TrilinearLookup, ReadsASingleLevelAtEveryRoughness) {
    const std::vector<Cubemap> levels = {cubemap_of(4, [](const Vec3d& d) { return Vec3(d); })};
    for (const double r : {0.0, 0.5, 1.0})
        EXPECT_NEAR(trilinear_lookup(levels, {}, {1, 0.01, 0}, r).x, levels[0].at(0, 1, 1).x, 0.05);
}

// What bilinear interpolation misses of a smooth function falls with the square of the texel, but
// across the edges, where neighbours are bent and shifted by up to a texel along the edge, with its
// first power. The wrong face, or no blending, is off by 0.1 and more.
TEST(TrilinearLookup, MissesASmoothFunctionByTheSquareOfTheTexel) {
    const auto smooth = [](const Vec3d& d) { return Vec3(d.x + 2, d.y * d.z + 2, d.z + 2 * d.x); };
    const auto largest_error = [&](int size, double reach) {
        const std::vector<Cubemap> levels = {cubemap_of(size, smooth)};
        double largest = 0;
        for (double a = -reach; a < reach; a += 0.02)
            for (double b = -reach; b < reach; b += 0.02)
                for (const Vec3d& towards : {Vec3d(a, b, 1), Vec3d(-1, a, b), Vec3d(b, 1, a)}) {
                    const Vec3d d = normalize(towards);
                    const Vec3 error = trilinear_lookup(levels, {}, d, 0.5) - smooth(d);
                    largest = std::max(largest, double(length(error)));
                }
        return largest;
    };
    EXPECT_LT(largest_error(16, 0.8), 0.01);
    EXPECT_LT(largest_error(64, 0.8), largest_error(16, 0.8) / 12);  // 16 in the limit
    EXPECT_LT(largest_error(16, 3), 0.05);                           // measured 0.03
    EXPECT_LT(largest_error(64, 3), largest_error(16, 3) / 3);       // 4 in the limit
}

// Funk-Hecke: under light that is linear in the direction the exact answer is linear too, with a
// factor that a one-dimensional integral gives.
TEST(ReconstructionProbes, HoldTheExactIntegral) {
    const Environment sky =
        tests::environment_of(64, [](const Vec3d& d) { return Vec3(Vec3d(2) + d); });
    const ReconstructionProbes probes = probes_of(sky, 16);
    ASSERT_EQ(probes.bands.size(), 4u);
    for (const auto& band : probes.bands) {
        ASSERT_EQ(band.probes.size(), 16u);
        for (const auto& probe : band.probes) {
            const double r = probe.perceptual_roughness;
            EXPECT_GT(r, band.range.from);
            EXPECT_LT(r, band.range.to);
            EXPECT_NEAR(length(probe.towards), 1, 1e-12);
            const double factor = band_factors({LobeKind::ggx, r * r}, 2)[1];
            // The panorama holds the function in steps of 3 degrees.
            EXPECT_LT(length(Vec3d(probe.exact) - (Vec3d(2) + factor * probe.towards)), 0.05) << r;
        }
    }
}

TEST(ReconstructionProbes, CoverSphereAndBandEvenlyWhateverTheirNumber) {
    const ReconstructionProbes many = probes_of(tests::lopsided_sky(2), 500);
    const ReconstructionProbes few = probes_of(tests::lopsided_sky(2), 20);
    for (size_t b = 0; b < many.bands.size(); ++b) {
        Vec3d mean(0), squares(0);
        double r = 0;
        for (const auto& probe : many.bands[b].probes) {
            mean += probe.towards / 500.0;
            squares += probe.towards * probe.towards / 500.0;
            r += probe.perceptual_roughness / 500;
        }
        EXPECT_LT(length(mean), 0.02);
        EXPECT_LT(length(squares - Vec3d(1.0 / 3)), 0.02);
        const RoughnessBand& range = many.bands[b].range;
        EXPECT_NEAR(r, (range.from + range.to) / 2, 0.02 * (range.to - range.from));
        for (size_t i = 0; i < 20; ++i)
            EXPECT_EQ(few.bands[b].probes[i].exact, many.bands[b].probes[i].exact);
    }
}

std::vector<ReconstructionError> errors_of(const Environment& sky, int face_size, int levels,
                                           const Orientation& orientation,
                                           const ReconstructionProbes& probes) {
    LevelsPlan plan;
    plan.specular = SpecularPlan{.face_size = face_size, .levels = levels, .roughness = {}};
    plan.orientation = orientation;
    NoProgress progress;
    const auto made = filter_levels(sky, plan, progress);
    return reconstruction_error(made->specular, {}, probes);
}

TEST(ReconstructionError, FallsWithTexelsAndFindsAWrongTurn) {
    const Environment sky = tests::lopsided_sky(64);
    const Orientation orientation{40, true, "ktx"};
    const auto probes = probes_of(sky, 64, panorama_from_cube(orientation));
    const auto coarse = errors_of(sky, 16, 5, orientation, probes);
    const auto fine = errors_of(sky, 64, 7, orientation, probes);
    const auto turned = errors_of(sky, 64, 7, {60, true, "ktx"}, probes);
    ASSERT_EQ(fine.size(), 4u);
    for (size_t band = 0; band < 4; ++band) {
        EXPECT_EQ(fine[band].figures.texels, 64);
        EXPECT_LT(fine[band].figures.rel_rms, coarse[band].figures.rel_rms) << band;
        EXPECT_GT(turned[band].figures.rel_rms, 2 * fine[band].figures.rel_rms) << band;
    }
}

TEST(ReconstructionError, IsNothingUnderAConstantSky) {
    const Environment sky = tests::environment_of(8, [](const Vec3d&) { return Vec3(3, 1, 2); });
    for (const auto& error : errors_of(sky, 8, 3, {}, probes_of(sky, 5)))
        EXPECT_LT(error.figures.rel_rms, 1e-6);
    for (const auto& error : errors_of(sky, 8, 3, {}, probes_of(sky, 0)))
        EXPECT_EQ(error.figures.texels, 0);
}

}  // namespace
}  // namespace splitsum
