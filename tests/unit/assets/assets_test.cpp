#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "splitsum/assets/cubemap_asset.h"
#include "splitsum/assets/table_asset.h"
#include "splitsum/assets/table_asset_preview.h"
#include "splitsum/math/quadrature.h"
#include "splitsum/report/asset_facts.h"
#include "splitsum/table/bilinear.h"
#include "splitsum/table/split_sum_exact.h"

namespace splitsum {
namespace {

std::vector<Cubemap> chain() {
    std::vector<Cubemap> levels = {Cubemap(4), Cubemap(2)};
    float value = 0.1f;
    for (Cubemap& level : levels)
        for (Vec3& texel : level.texels) texel = Vec3(value, 2 * value, 3 * value), value *= 1.07f;
    return levels;
}

TEST(CubemapAsset, HoldsWhatAnEngineReadsBack) {
    for (const PixelFormatInfo& format : pixel_formats()) {
        const auto asset = cubemap_asset(chain(), format.format, {});
        if (!holds_colours(format)) {
            ASSERT_FALSE(asset);
            EXPECT_EQ(asset.error().kind, ErrorKind::bad_argument);
            continue;
        }
        ASSERT_TRUE(asset);
        EXPECT_EQ(asset->texture.format, format.format);
        EXPECT_EQ(asset->texture.metadata, metadata_of({}));
        ASSERT_EQ(asset->levels.size(), 2u);
        const auto decoded = cubemaps_of(asset->texture);
        for (size_t level = 0; level < 2; ++level) {
            EXPECT_EQ(asset->levels[level].texels, (*decoded)[level].texels) << format.name;
            for (size_t i = 0; i < asset->levels[level].texels.size(); ++i)
                EXPECT_LT(length(asset->levels[level].texels[i] - chain()[level].texels[i]),
                          0.02f * length(chain()[level].texels[i]))
                    << format.name;
        }
    }
}

TEST(CubemapAsset, CountsWhatDidNotFitLevelByLevel) {
    for (const PixelFormatInfo& format : pixel_formats()) {
        if (!holds_colours(format)) continue;
        auto levels = chain();
        levels[0].at(1, 2, 3) = Vec3(1e5f, 1, 2e5f);
        levels[1].at(5, 0, 1) = Vec3(0, 1e6f, 0);
        const auto asset = cubemap_asset(levels, format.format, {});
        ASSERT_EQ(asset->counts.size(), 2u);
        const bool holds = format.largest[0] > 1e6f;
        EXPECT_EQ(asset->counts[0].saturated, holds ? 0 : 2) << format.name;
        EXPECT_EQ(asset->counts[1].saturated, holds ? 0 : 1) << format.name;
        EXPECT_EQ(asset->levels[0].at(1, 2, 3).z, holds ? 2e5f : format.largest[2]) << format.name;
    }
}

TablePlan plan_of(std::string kind, int size) {
    TablePlan plan;
    plan.kind = std::move(kind);
    plan.size = size;
    return plan;
}

TableAsset baked(const TablePlan& plan, PixelFormat format) {
    NoProgress progress;
    auto asset = bake_table(plan, format, progress);
    EXPECT_TRUE(asset) << asset.error().message;
    return *asset;
}

Error refusal(const TablePlan& plan, PixelFormat format = PixelFormat::rg16f) {
    NoProgress progress;
    const auto asset = bake_table(plan, format, progress);
    EXPECT_FALSE(asset);
    return asset ? Error{} : asset.error();
}

// The largest error of the stored table over all of its texels.
double worst_of(const TableAsset& asset) {
    const auto table = table_of(asset.texture);
    double worst = 0;
    for (int y = 0; y < table->height; ++y)
        for (int x = 0; x < table->width; ++x) {
            const double r = (y + 0.5) / table->height;
            const SplitSum exact =
                split_sum_exact(SmithTerm::height_correlated, (x + 0.5) / table->width, r * r);
            const auto stored = table->texel(x, y);
            worst = std::max({worst, std::abs(double(stored[0]) - exact.a),
                              std::abs(double(stored[1]) - exact.b)});
        }
    return worst;
}

TEST(TableAsset, MeasuresWhatIsStored) {
    const struct {
        PixelFormat format;
        double limit;
    } formats[] = {{PixelFormat::rg16f, 3e-4},
                   {PixelFormat::rgba16f, 3e-4},
                   {PixelFormat::rg16unorm, 8e-6},
                   {PixelFormat::rg32f, 2e-7},
                   {PixelFormat::rgba32f, 2e-7}};
    for (const int size : {1, 2, 9, 24})
        for (const auto& [format, limit] : formats) {
            const TableAsset asset = baked(plan_of("ggx", size), format);
            EXPECT_GT(asset.check.texels, 64);
            const double worst = worst_of(asset);
            EXPECT_LE(asset.check.at_texels, worst * (1 + 1e-6) + 1e-9) << size;
            EXPECT_GE(asset.check.at_texels, 0.5 * worst) << size;  // the probes find what counts
            EXPECT_LT(worst, limit) << info_of(format).name << " " << size;
        }
}

TEST(TableAsset, NoticesATableOfTooFewSamples) {
    TablePlan plan = plan_of("ggx", 16);
    plan.method = "vndf";
    plan.samples = 1;
    EXPECT_GT(baked(plan, PixelFormat::rg32f).check.at_texels, 1e-2);
}

// Every arrangement of axes holds the same table, and a renderer that reads it as the metadata say
// finds the same values: the self-check does, through texture coordinates.
TEST(TableAsset, EveryArrangementReadsTheSame) {
    for (const auto& layout : texel_layouts())
        for (const auto& axes : table_axes())
            for (const auto& unit : roughness_axes())
                for (const bool flip : {false, true}) {
                    TablePlan plan = plan_of("ggx", 48);
                    plan.layout = layout.value;
                    plan.axes = axes.value;
                    plan.roughness_axis = unit.value;
                    plan.flip = flip;
                    const TableAsset asset = baked(plan, PixelFormat::rg32f);
                    EXPECT_LT(asset.check.at_texels, 2e-7) << layout.name << axes.name << unit.name;
                    EXPECT_LT(asset.check.between, 0.06) << layout.name << axes.name << unit.name;
                    EXPECT_EQ(asset.check.in_rim > 0, plan.layout == TexelLayout::centre);
                    const auto facts = facts_of(asset.texture.metadata);
                    ASSERT_TRUE(facts) << facts.error().message;
                    EXPECT_EQ(facts->table.plan.axes, plan.axes);
                    EXPECT_EQ(facts->table.plan.layout, plan.layout);
                    EXPECT_EQ(facts->table.plan.roughness_axis, plan.roughness_axis);
                    EXPECT_EQ(facts->table.plan.flip, plan.flip);
                    // The texel that stands for n·v = r = alpha = 1 is rough and seen from above.
                    const int last = 47;
                    const auto rough = asset.table.texel(last, flip ? 0 : last);
                    EXPECT_NEAR(rough[0], 0.31, 0.02) << layout.name << axes.name << unit.name;
                }
}

// A square of texels seen from straight above and smooth goes where the axes say.
TEST(TableAsset, AxesGoWhereTheySay) {
    TablePlan plan = plan_of("ggx", 8);
    plan.layout = TexelLayout::edge;
    const auto b_at = [&](int x, int y) {
        return baked(plan, PixelFormat::rg32f).table.texel(x, y)[1];
    };
    EXPECT_EQ(b_at(0, 0), 1);  // edge on, mirror
    EXPECT_EQ(b_at(7, 0), 0);  // from above, mirror
    plan.axes = TableAxes::roughness_nv;
    EXPECT_EQ(b_at(0, 7), 0);
    plan.flip = true;
    EXPECT_EQ(b_at(0, 7), 1);
    EXPECT_EQ(b_at(0, 0), 0);
}

TEST(TableAsset, AutomaticSizeIsTheSmallestThatMeetsTheAccuracy) {
    TablePlan plan = plan_of("ggx", TablePlan::automatic_size);
    plan.layout = TexelLayout::edge;
    plan.accuracy = 0.01;
    const TableAsset asset = baked(plan, PixelFormat::rg32f);
    EXPECT_LE(asset.check.between, 0.01);
    EXPECT_LE(asset.check.at_texels, 0.01);
    EXPECT_EQ(asset.texture.width, asset.plan.size);
    ASSERT_GT(asset.plan.size, smallest_automatic_size);
    TablePlan smaller = plan_of("ggx", asset.plan.size / 2);
    smaller.layout = TexelLayout::edge;
    NoProgress progress;
    TableProbes probes;
    probes.points = 512;
    const TableAsset half = baked(smaller, PixelFormat::rg32f);
    EXPECT_GT(check_table(half.kind, half.plan, half.table, probes).between, 0.01);
}

TEST(TableAsset, SaysWhatWouldMeetAnAccuracyThatWasMissed) {
    TablePlan plan = plan_of("ggx", TablePlan::automatic_size);
    plan.accuracy = 1e-6;
    const Error none = refusal(plan);
    EXPECT_EQ(none.kind, ErrorKind::bad_argument);
    for (const char* part : {"8 to 1024", "1e-06", "reaches", "--layout edge", "rg32f"})
        EXPECT_NE(none.message.find(part), std::string::npos) << none.message;
    plan.size = 16;
    EXPECT_NE(refusal(plan).message.find("rg32f"), std::string::npos);
    EXPECT_TRUE(baked(plan, PixelFormat::rg32f).check.at_texels < 1e-6);
    plan.method = "importance";
    EXPECT_NE(refusal(plan, PixelFormat::rg32f).message.find("--method quadrature"),
              std::string::npos);
}

TEST(TableAsset, RefusesWhatDoesNotExistOrFit) {
    EXPECT_NE(refusal(plan_of("gxx", 16)).message.find("ggx-multiscatter"), std::string::npos);
    TablePlan plan = plan_of("ggx", 16);
    plan.method = "guess";
    EXPECT_NE(refusal(plan).message.find("quadrature"), std::string::npos);
    plan = plan_of("ggx-fit", 16);
    plan.method = "vndf";
    EXPECT_NE(refusal(plan).message.find("vndf"), std::string::npos);
    EXPECT_NE(refusal(plan_of("ggx", 16), PixelFormat::rgb9e5).message.find("rgba16f"),
              std::string::npos);
}

// A perfect reflector with multiple scattering (Kulla & Conty 2017) gives a white furnace back: the
// second lobe is integrated over what is read from the table, bilinearly, as a renderer reads it.
TEST(TableAsset, EnergyGivesAWhiteFurnaceBack) {
    TablePlan plan = plan_of("energy", 256);
    plan.layout = TexelLayout::edge;
    const TableAsset asset = baked(plan, PixelFormat::rg32f);
    EXPECT_LT(asset.check.at_texels, 1e-6);
    const auto read = [&](double n_dot_v, double r) {
        std::array<double, 2> pair{};
        read_bilinear(asset.table, texture_coordinates(plan, 256, ViewAxis::cosine, n_dot_v, r),
                      pair);
        return pair;
    };
    const QuadratureRule rule = gauss_legendre(64);
    for (const double r : {0.0, 0.05, 0.2, 0.37, 0.5, 0.81, 1.0})
        for (const double n_dot_v : {0.0, 0.01, 0.1, 0.43, 0.77, 1.0}) {
            const auto [albedo, average] = read(n_dot_v, r);
            const double spread =
                2 * integrate(rule, 0, 1, [&](double mu) { return mu * (1 - read(mu, r)[0]); });
            const double lost = 1 - albedo;
            const double back = average < 1 ? lost * spread / (1 - average) : lost;
            const double exact = [&] {
                const SplitSum sum = split_sum_exact(SmithTerm::height_correlated, n_dot_v, r * r);
                return sum.a + sum.b;
            }();
            EXPECT_NEAR(albedo + back, 1, 1e-3) << r << " " << n_dot_v;
            EXPECT_LE(albedo, 1 + 1e-6);
            if (r >= 0.2 || n_dot_v >= 0.1) {
                EXPECT_NEAR(albedo, exact, 2e-3) << r << " " << n_dot_v;
            }
        }
}

TEST(TableAsset, PreviewShowsEveryChannelOfEveryLayer) {
    Table table = blank_table(4, 4, 2, 2);
    table.texel(0, 0, 0)[0] = 1;
    table.texel(3, 0, 1)[1] = 2;  // beyond 1: the range stretches
    const Preview preview = preview_of(table);
    EXPECT_EQ(preview.width, 8 + 3 * (256 + 8));
    EXPECT_EQ(preview.height, 8 + 2 * (256 + 8));
    const auto red_at = [&](int x, int y) {
        return preview.rgb[size_t(3 * (y * preview.width + x))];
    };
    EXPECT_EQ(red_at(8, 8), 255);                    // colour tile, layer 0
    EXPECT_EQ(red_at(8 + 264, 8), 255);              // channel 0
    EXPECT_EQ(red_at(8 + 528, 8), 0);                // channel 1
    EXPECT_EQ(red_at(8 + 528 + 255, 264 + 8), 255);  // channel 1 of layer 1
}

}  // namespace
}  // namespace splitsum
