#include "splitsum/bake/recipe.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <map>
#include <set>

#include "support/temporary_folder.h"

namespace splitsum {
namespace {

struct Options {
    PanoramaOptions reading;
    BakePlan plan;
};

std::string recipe_for(const Options& options) {
    ConfigHashes configs;
    const auto recipe = recipe_of("a.hdr", "xxh3-128:00", options.reading, options.plan, configs);
    EXPECT_TRUE(recipe) << recipe.error().message;
    return *recipe;
}

// One change of each field; that none is missing in the recipe is up to the compiler (recipe.cpp).
const std::vector<std::pair<const char*, std::function<void(Options&)>>> changes = {
    {"colorspace", [](Options& o) { o.reading.color_space = "ACEScg"; }},
    {"layer", [](Options& o) { o.reading.layer = "ACEScg"; }},
    {"exposure", [](Options& o) { o.reading.exposure_stops = 1e-300; }},
    {"repair", [](Options& o) { o.reading.repair = true; }},
    {"size", [](Options& o) { o.plan.specular.face_size = 255; }},
    {"levels", [](Options& o) { o.plan.specular.levels = 6; }},
    {"roughness",
     [](Options& o) { o.plan.specular.roughness.kind = RoughnessCurve::Kind::filament; }},
    {"roughness",
     [](Options& o) {
         o.plan.specular.roughness = {RoughnessCurve::Kind::list, {0, 0.1, 1}};
     }},
    {"roughness",
     [](Options& o) {
         o.plan.specular.roughness = {RoughnessCurve::Kind::list, {0, std::nextafter(0.1, 1), 1}};
     }},
    {"irradiance-size", [](Options& o) { o.plan.irradiance.face_size = 255; }},
    {"irradiance-order", [](Options& o) { o.plan.irradiance.harmonics_order = 6; }},
    {"irradiance-window", [](Options& o) { o.plan.irradiance.windowed = true; }},
    {"irradiance-store-e", [](Options& o) { o.plan.irradiance.store_irradiance = true; }},
    {"method", [](Options& o) { o.plan.filter.method = "spectral"; }},
    {"samples", [](Options& o) { o.plan.filter.samples = 255; }},
    {"accuracy", [](Options& o) { o.plan.filter.accuracy = std::nextafter(3e-4, 1); }},
    {"rotate-samples", [](Options& o) { o.plan.filter.rotate_samples = true; }},
    {"seed", [](Options& o) { o.plan.filter.seed = 255; }},
    {"sequence", [](Options& o) { o.plan.filter.sequence = PointSequence::random; }},
    {"heuristic", [](Options& o) { o.plan.filter.heuristic = MisHeuristic::balance; }},
    {"rotate", [](Options& o) { o.plan.orientation.rotate_degrees = 6; }},
    {"mirror", [](Options& o) { o.plan.orientation.mirror = true; }},
    {"convention", [](Options& o) { o.plan.orientation.convention = "cmgen"; }},
    {"format", [](Options& o) { o.plan.format = PixelFormat::rgb9e5; }},
    {"zstd", [](Options& o) { o.plan.container.ktx2.zstd = true; }},
    {"zstd-level", [](Options& o) { o.plan.container.ktx2.zstd_level = 6; }},
    {"probes", [](Options& o) { o.plan.probes = 8; }},
    {"probes", [](Options& o) { o.plan.probes = 0; }},
    {"picture", [](Options& o) { o.plan.picture = false; }},
};

TEST(Recipe, ChangesWithEveryOptionAndDiffersForEach) {
    std::map<std::string, const char*> recipes = {{recipe_for(Options{}), "none"}};
    for (const auto& [name, change] : changes) {
        Options options;
        change(options);
        const auto [other, is_new] = recipes.emplace(recipe_for(options), name);
        EXPECT_TRUE(is_new) << name << " has the recipe of " << other->second;
    }
}

TEST(Recipe, NamesTheOptionThatChanged) {
    ConfigHashes configs;
    const auto before = *settings_of({}, {}, configs);
    std::set<std::string> changed{"ocio-config"};
    for (const auto& [name, change] : changes) {
        Options options;
        change(options);
        const auto after = *settings_of(options.reading, options.plan, configs);
        ASSERT_EQ(after.size(), before.size());
        for (size_t i = 0; i < after.size(); ++i)
            EXPECT_EQ(after[i] == before[i], after[i].first != name) << name;
        changed.insert(name);
    }
    EXPECT_EQ(changed.size(), before.size()) << "an option is not in the list of this test";
}

TEST(Recipe, ChangesWithTheSource) {
    const Settings settings = {{"size", "1"}};
    const std::set<std::string> recipes = {
        recipe_of("a.hdr", "h", settings),        recipe_of("b.hdr", "h", settings),
        recipe_of("a.hdr", "i", settings),        recipe_of("a.hdrh", "", settings),
        recipe_of("a.hdr", "h", {{"size", "2"}}), recipe_of("a.hdr", "h", {{"siz", "e1"}}),
        recipe_of("a.hdr", "hsize", {{"", "1"}}), recipe_of("a.hdr", "h", {}),
    };
    EXPECT_EQ(recipes.size(), 8u);
    EXPECT_TRUE(recipes.begin()->starts_with("xxh3-128:"));
    EXPECT_EQ(recipes.begin()->size(), 41u);
}

TEST(Recipe, GoesByWhatAConfigSays) {
    const tests::TemporaryFolder folder;
    const std::string text =
        "ocio_profile_version: 2\nroles:\n  default: base\n  scene_linear: base\n"
        "displays:\n  screen:\n    - !<View> {name: Raw, colorspace: base}\n"
        "colorspaces:\n  - !<ColorSpace>\n    name: base\n";
    tests::write_bytes(folder / "one.ocio", text);
    tests::write_bytes(folder / "same.ocio", text);
    tests::write_bytes(folder / "other.ocio", text + "  - !<ColorSpace>\n    name: more\n");
    const auto with = [&](const char* name) {
        Options options;
        options.reading.ocio_config = folder / name;
        return recipe_for(options);
    };
    EXPECT_EQ(with("one.ocio"), with("same.ocio"));
    EXPECT_NE(with("one.ocio"), with("other.ocio"));
    EXPECT_NE(with("one.ocio"), recipe_for(Options{}));

    ConfigHashes configs;
    PanoramaOptions gone;
    gone.ocio_config = folder / "gone.ocio";
    const auto settings = settings_of(gone, {}, configs);
    ASSERT_FALSE(settings);
    EXPECT_EQ(settings.error().kind, ErrorKind::unreadable_input);
}

}  // namespace
}  // namespace splitsum
