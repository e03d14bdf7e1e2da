#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "splitsum/assets/cubemap_asset.h"
#include "splitsum/assets/table_asset.h"
#include "splitsum/assets/table_asset_preview.h"
#include "splitsum/base/parallel.h"
#include "splitsum/math/low_discrepancy.h"
#include "splitsum/math/quadrature.h"
#include "splitsum/report/asset_facts.h"
#include "splitsum/table/bilinear.h"
#include "splitsum/table/split_sum_exact.h"
#include "splitsum/table/split_sum_lookup.h"

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

// What a renderer reads of a table `energy` or `energy-lost`, bilinearly.
class EnergyRead {
public:
    explicit EnergyRead(const TableAsset& asset)
        : asset_(asset), lost_(asset.kind.name == "energy-lost") {}

    double albedo(double n_dot_v, double r) const {
        const double red = at(n_dot_v, r)[0];
        return lost_ ? 1 - red : red;
    }

    // What a white furnace gives back, with the second lobe integrated over what is read for the
    // light: linear between texel centres, so two points in each interval are exact.
    double furnace(double n_dot_v, double r) const {
        const auto [view, average] = at(n_dot_v, r);
        const auto scattered = lost_ ? multiple_scattering_of_lost : multiple_scattering;
        const QuadratureRule rule = gauss_legendre(2);
        const int size = asset_.plan.size;
        double second = 0;
        for (int i = 0; i <= size; ++i) {
            const double from = std::max(0.0, (i - 0.5) / size);
            const double to = std::min(1.0, (i + 0.5) / size);
            second += integrate(rule, from, to, [&](double mu) {
                return 2 * std::numbers::pi * mu * scattered(view, at(mu, r)[0], average);
            });
        }
        return albedo(n_dot_v, r) + second;
    }

private:
    std::array<double, 2> at(double n_dot_v, double r) const {
        std::array<double, 2> pair{};
        read_bilinear(
            asset_.table,
            texture_coordinates(asset_.plan, asset_.plan.size, ViewAxis::cosine, n_dot_v, r), pair);
        return pair;
    }

    const TableAsset& asset_;
    bool lost_;
};

// Views and roughness at which energy was ever lost: both ends, tiny ones, and points on no grid.
double worst_furnace(const TableAsset& asset, double smoothest) {
    std::vector<Vec2d> points;
    for (const double r : {0.0, 1e-3, 0.003, 0.01, 0.015, 0.02, 0.03, 0.05, 0.1, 0.81, 0.9995, 1.0})
        for (const double n_dot_v : {0.0, 1e-4, 0.001, 0.003, 0.01, 0.1, 0.43, 0.77, 1.0})
            if (r >= smoothest) points.push_back({n_dot_v, r});
    for (uint32_t i = 0; i < 300; ++i) {
        const Vec2d point = hammersley(i, 300);
        points.push_back({point.x, smoothest + (1 - smoothest) * point.y});
    }
    std::vector<double> errors(points.size());
    const EnergyRead read(asset);
    parallel_rows(static_cast<int>(points.size()), [&](int i) {
        const Vec2d& at = points[static_cast<size_t>(i)];
        errors[static_cast<size_t>(i)] = std::abs(read.furnace(at.x, at.y) - 1);
    });
    return *std::ranges::max_element(errors);
}

TableAsset energy_of(std::string kind, SmithTerm term, int size, PixelFormat format) {
    TablePlan plan = plan_of(std::move(kind), size);
    plan.geometry = term;
    return baked(plan, format);
}

// A perfect reflector with multiple scattering (Kulla & Conty 2017) gives a white furnace back to
// 1e-3 at every view and roughness, from the table as it is written when nothing else is asked for,
// and from small ones.
TEST(TableAsset, EnergyLostGivesAWhiteFurnaceBack) {
    const TableKind kind = *kind_of({.kind = "energy-lost"});
    EXPECT_EQ(default_format(kind), PixelFormat::rg32f);
    for (const SmithTermInfo& info : smith_terms())
        for (const int size : {default_plan(kind).size, 64, 9}) {
            const TableAsset asset = energy_of("energy-lost", info.term, size, PixelFormat::rg32f);
            EXPECT_LT(worst_furnace(asset, 0), 1e-5) << info.name << " " << size;
        }
    // Halves keep to it from roughness 0.02 on.
    const TableAsset halves =
        energy_of("energy-lost", SmithTerm::height_correlated, 512, PixelFormat::rg16f);
    EXPECT_LT(worst_furnace(halves, 0.02), 1e-3);
}

// 1 - E is below the steps of floats near 1 on smooth surfaces, and views as grazing as their lobes
// are wide lie between texels: E itself keeps to 1e-3 from roughness 0.04 on, in half floats from 0.3.
TEST(TableAsset, EnergyGivesAWhiteFurnaceBackUnlessSmooth) {
    const TableKind kind = *kind_of({.kind = "energy"});
    EXPECT_EQ(default_format(kind), PixelFormat::rg32f);
    for (const SmithTermInfo& info : smith_terms()) {
        const TableAsset asset = energy_of("energy", info.term, 512, PixelFormat::rg32f);
        EXPECT_LT(worst_furnace(asset, 0.04), 1e-3) << info.name;
    }
    const TableAsset asset =
        energy_of("energy", SmithTerm::height_correlated, 512, PixelFormat::rg32f);
    EXPECT_GT(worst_furnace(asset, 0), 1e-3);
    const TableAsset halves =
        energy_of("energy", SmithTerm::height_correlated, 512, PixelFormat::rg16f);
    RecordProperty("halves", std::to_string(worst_furnace(halves, 0.3)));
    EXPECT_GT(worst_furnace(halves, 0), 1e-2);
}

TEST(TableAsset, EnergyHoldsTheAlbedo) {
    for (const char* kind : {"energy", "energy-lost"}) {
        const TableAsset asset =
            energy_of(kind, SmithTerm::height_correlated, 512, PixelFormat::rg32f);
        EXPECT_LT(asset.check.at_texels, kind == std::string("energy") ? 1e-6 : 5e-5);
        const EnergyRead read(asset);
        for (const double r : {0.0, 0.2, 0.37, 0.81, 1.0})
            for (const double n_dot_v : {0.1, 0.43, 0.77, 1.0}) {
                const SplitSum sum = split_sum_exact(SmithTerm::height_correlated, n_dot_v, r * r);
                EXPECT_NEAR(read.albedo(n_dot_v, r), sum.a + sum.b, 2e-3) << r << " " << n_dot_v;
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
