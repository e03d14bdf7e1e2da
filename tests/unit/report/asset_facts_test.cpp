#include "splitsum/report/asset_facts.h"

#include <gtest/gtest.h>

#include <tuple>

namespace splitsum {
namespace {

AssetFacts cubemap_facts(AssetFacts::Kind kind) {
    AssetFacts facts;
    facts.kind = kind;
    facts.source = {"a name = with spaces.exr", "xxh3-128:0123456789abcdef", "ACEScg", -1.1, 17};
    facts.orientation = {0.1 + 0.2, true, "cmgen"};
    facts.filter.method = "mis";
    facts.filter.sequence = PointSequence::random;
    facts.filter.heuristic = MisHeuristic::balance;
    facts.filter.samples = 4097;
    facts.filter.rotate_samples = true;
    facts.filter.seed = 4294967295U;
    if (kind == AssetFacts::Kind::irradiance) facts.stores_irradiance = true;
    if (kind == AssetFacts::Kind::specular) {
        facts.curve = {RoughnessCurve::Kind::filament, {}};
        facts.perceptual_roughness = {0, 1 / 3.0, 1};
    }
    return facts;
}

AssetFacts table_facts() {
    AssetFacts facts;
    facts.kind = AssetFacts::Kind::table;
    TablePlan& plan = facts.table.plan;
    plan.kind = "energy";
    plan.method = "importance";
    plan.geometry = SmithTerm::schlick_sqrt;
    plan.samples = 99;
    plan.layout = TexelLayout::edge;
    plan.axes = TableAxes::roughness_nv;
    plan.roughness_axis = RoughnessAxis::alpha;
    plan.flip = true;
    facts.table.value = "something else";
    facts.table.view_axis = "sqrt(1 - n.v)";
    facts.table.max_abs = 1.25e-7;
    facts.table.max_abs_between = 0.00325;
    facts.table.max_abs_in_rim = 0.5;
    return facts;
}

std::vector<AssetFacts> all_kinds() {
    return {cubemap_facts(AssetFacts::Kind::specular), cubemap_facts(AssetFacts::Kind::irradiance),
            table_facts()};
}

TEST(AssetFacts, SurviveTheRoundTripToTheLastBit) {
    for (const AssetFacts& facts : all_kinds()) {
        const auto read = facts_of(metadata_of(facts));
        ASSERT_TRUE(read) << read.error().message;
        EXPECT_EQ(read->kind, facts.kind);
        EXPECT_EQ(read->source.name, facts.source.name);
        EXPECT_EQ(read->source.hash, facts.source.hash);
        EXPECT_EQ(read->source.color_space, facts.source.color_space);
        EXPECT_EQ(read->source.exposure_stops, facts.source.exposure_stops);
        EXPECT_EQ(read->source.repaired_texels, facts.source.repaired_texels);
        EXPECT_EQ(read->orientation.rotate_degrees, facts.orientation.rotate_degrees);
        EXPECT_EQ(read->orientation.mirror, facts.orientation.mirror);
        EXPECT_EQ(read->orientation.convention, facts.orientation.convention);
        EXPECT_EQ(read->filter.method, facts.filter.method);
        if (facts.kind != AssetFacts::Kind::table) {
            EXPECT_EQ(read->filter.samples, facts.filter.samples);
        }
        EXPECT_EQ(read->filter.rotate_samples, facts.filter.rotate_samples);
        EXPECT_EQ(read->filter.seed, facts.filter.seed);
        EXPECT_EQ(read->filter.sequence, facts.filter.sequence);
        EXPECT_EQ(read->filter.heuristic, facts.filter.heuristic);
        EXPECT_EQ(read->curve.kind, facts.curve.kind);
        EXPECT_EQ(read->perceptual_roughness, facts.perceptual_roughness);
        EXPECT_EQ(read->stores_irradiance, facts.stores_irradiance);
        const TablePlan &found = read->table.plan, &plan = facts.table.plan;
        EXPECT_EQ(found.kind, plan.kind);
        EXPECT_EQ(found.method, plan.method);
        EXPECT_EQ(found.geometry, plan.geometry);
        EXPECT_EQ(found.layout, plan.layout);
        EXPECT_EQ(found.axes, plan.axes);
        EXPECT_EQ(found.roughness_axis, plan.roughness_axis);
        EXPECT_EQ(found.flip, plan.flip);
        EXPECT_EQ(read->table.max_abs, facts.table.max_abs);
        EXPECT_EQ(read->table.max_abs_between, facts.table.max_abs_between);
        EXPECT_EQ(read->table.max_abs_in_rim, facts.table.max_abs_in_rim);
        EXPECT_EQ(metadata_of(*read), metadata_of(facts));
    }
}

TEST(AssetFacts, SayHowPointsWereDrawnWhereTheMethodDrawsThem) {
    AssetFacts facts = cubemap_facts(AssetFacts::Kind::specular);
    for (const auto& [method, draws, weighs] : {std::tuple("mis", true, true),
                                                {"importance", true, false},
                                                {"filtered", true, false},
                                                {"riemann", false, false},
                                                {"spectral", false, false},
                                                {"auto", false, false}}) {
        facts.filter.method = method;
        const auto metadata = metadata_of(facts);
        EXPECT_EQ(metadata.contains("splitsum.sequence"), draws) << method;
        EXPECT_EQ(metadata.contains("splitsum.heuristic"), weighs) << method;
        const auto read = facts_of(metadata);
        ASSERT_TRUE(read) << read.error().message;
        const FilterPlan silent;
        EXPECT_EQ(read->filter.sequence, draws ? facts.filter.sequence : silent.sequence);
        EXPECT_EQ(read->filter.heuristic, weighs ? facts.filter.heuristic : silent.heuristic);
    }
}

TEST(AssetFacts, RefuseASequenceThatNobodyKnows) {
    auto metadata = metadata_of(cubemap_facts(AssetFacts::Kind::specular));
    metadata["splitsum.sequence"] = "sobol";
    const auto read = facts_of(metadata);
    ASSERT_FALSE(read);
    EXPECT_NE(read.error().message.find("splitsum.sequence"), std::string::npos);
    EXPECT_NE(read.error().message.find("hammersley"), std::string::npos);
}

TEST(AssetFacts, KeepAListOfRoughness) {
    AssetFacts facts = cubemap_facts(AssetFacts::Kind::specular);
    facts.curve = {RoughnessCurve::Kind::list, facts.perceptual_roughness};
    const auto read = facts_of(metadata_of(facts));
    ASSERT_TRUE(read);
    EXPECT_EQ(read->curve.kind, RoughnessCurve::Kind::list);
    EXPECT_EQ(read->curve.list, facts.perceptual_roughness);
}

// What only tells people something; everything else is needed.
bool is_for_people(const std::string& key, AssetFacts::Kind kind) {
    return key == "splitsum.version" || key == "splitsum.color_space" || key == "splitsum.axes" ||
           (key == "splitsum.value" && kind == AssetFacts::Kind::specular) ||
           key == "splitsum.geometry";  // of tables that have one
}

// Files of methods that draw no points do not have them, nor do those of older programs.
bool has_a_default(const std::string& key) {
    return key == "splitsum.sequence" || key == "splitsum.heuristic";
}

TEST(AssetFacts, NameTheKeyThatIsMissing) {
    for (const AssetFacts& facts : all_kinds()) {
        const auto metadata = metadata_of(facts);
        for (const auto& [key, value] : metadata) {
            auto shorter = metadata;
            shorter.erase(key);
            const auto read = facts_of(shorter);
            ASSERT_EQ(bool(read), is_for_people(key, facts.kind) || has_a_default(key)) << key;
            if (read) continue;
            EXPECT_EQ(read.error().kind, ErrorKind::unusable_input);
            EXPECT_NE(read.error().message.find(key), std::string::npos) << read.error().message;
        }
    }
}

TEST(AssetFacts, NameTheValueThatIsNoNumber) {
    const auto metadata = metadata_of(cubemap_facts(AssetFacts::Kind::specular));
    for (const char* key :
         {"splitsum.samples", "splitsum.seed", "splitsum.rotate_degrees", "splitsum.exposure_stops",
          "splitsum.repaired_texels", "splitsum.perceptual_roughness"})
        for (const char* value : {"", "many", "12px"}) {
            if (key == std::string("splitsum.perceptual_roughness") && *value == 0) continue;
            auto spoilt = metadata;
            spoilt[key] = value;
            const auto read = facts_of(spoilt);
            ASSERT_FALSE(read) << key << "=" << value;
            EXPECT_NE(read.error().message.find(key), std::string::npos) << read.error().message;
        }
}

TEST(AssetFacts, RefuseAnUnknownKind) {
    const auto read = facts_of({{"splitsum.asset", "sound"}});
    ASSERT_FALSE(read);
    EXPECT_NE(read.error().message.find("sound"), std::string::npos);
    EXPECT_FALSE(facts_of({}));
}

}  // namespace
}  // namespace splitsum
