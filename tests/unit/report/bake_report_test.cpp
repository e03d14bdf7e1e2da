#include "splitsum/report/bake_report.h"

#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

namespace splitsum {
namespace {

using Json = nlohmann::ordered_json;

LevelCheck check_of(int level, double figure) {
    LevelCheck check;
    check.level = level;
    check.face_size = 64 >> level;
    check.perceptual_roughness = 0.5 * level;
    check.figures = {figure, 2 * figure, 3 * figure, -figure, 64};
    check.mean_radiance = {0.25, 0.5, 0.75};
    return check;
}

BakeReport some_report() {
    BakeReport report;
    report.source = {"sky \"quoted\"\n.exr", "xxh3-128:abc", "ACEScg", 1.5, 3};
    report.source_width = 1024;
    report.source_height = 512;
    report.source_mean_radiance = {0.125, 0.25, 0.5};
    report.notes = {"alpha was ignored", "repaired pixels: 3 NaN"};
    report.irradiance_facts.kind = AssetFacts::Kind::irradiance;
    report.files = {{"specular.ktx2", 1234, "radiance", "xxh3-128:12"},
                    {"irradiance.ktx2", 56, "E / pi", "xxh3-128:34"}};
    report.probes = 64;
    report.specular = {check_of(0, 1.25e-3), check_of(1, 2.5e-3)};
    report.specular_counts = {{7, 0}, {5, 0}};
    report.accounts.resize(3);  // two levels and the irradiance
    report.irradiance = check_of(0, 3.5e-3);
    report.irradiance_counts = {1, 2};
    report.harmonics = check_of(0, 4.5e-3);
    report.harmonics_lowest = -0.04;
    return report;
}

TEST(BakeReport, JsonHasEveryFigure) {
    const BakeReport report = some_report();
    const Json json = Json::parse(report_json(report));
    EXPECT_EQ(json["source"]["name"], report.source.name);
    EXPECT_EQ(json["source"]["hash"], "xxh3-128:abc");
    EXPECT_EQ(json["source"]["width"], 1024);
    EXPECT_EQ(json["source"]["exposure_stops"], 1.5);
    EXPECT_EQ(json["source"]["repaired_texels"], 3);
    EXPECT_EQ(json["source"]["notes"].size(), 2u);
    EXPECT_EQ(json["source"]["mean_radiance"][2], 0.5);
    EXPECT_EQ(json["asked"]["format"], "rgba16f");
    EXPECT_EQ(json["asked"]["specular"].size(), metadata_of(report.specular_facts).size());
    EXPECT_EQ(json["files"][1]["bytes"], 56);
    const Json& measured = json["measured"];
    EXPECT_EQ(measured["probes_per_level"], 64);
    ASSERT_EQ(measured["specular"].size(), 2u);
    const Json& level = measured["specular"][1];
    EXPECT_EQ(level["level"], 1);
    EXPECT_EQ(level["face_size"], 32);
    EXPECT_EQ(level["perceptual_roughness"], 0.5);
    EXPECT_EQ(level["rel_rms"], 2.5e-3);
    EXPECT_EQ(level["max_rel"], 5e-3);
    EXPECT_EQ(level["max_abs"], 7.5e-3);
    EXPECT_EQ(level["bias"], -2.5e-3);
    EXPECT_EQ(level["texels"], 64);
    EXPECT_EQ(level["saturated"], 5);
    EXPECT_EQ(measured["irradiance"]["rel_rms"], 3.5e-3);
    EXPECT_EQ(measured["irradiance"]["saturated"], 1);
    EXPECT_EQ(measured["irradiance"]["negative"], 2);
    EXPECT_EQ(measured["harmonics"]["rel_rms"], 4.5e-3);
    EXPECT_EQ(measured["harmonics"]["lowest_share_of_mean"], -0.04);
}

TEST(BakeReport, TextHasTheFiguresNotesFilesAndWhatDidNotFit) {
    const std::string text = report_text(some_report());
    for (const char* part :
         {"1024 x 512", "xxh3-128:abc", "note: alpha was ignored", "note: repaired pixels: 3 NaN",
          "1.5 stops", "1.25e-03", "2.50e-03", "3.50e-03", "4.50e-03", "-1.25e-03",
          "specular.ktx2  1234 bytes", "13 values were above", "2 values were below 0"})
        EXPECT_NE(text.find(part), std::string::npos) << part << " is not in\n" << text;
}

// JSON has no word for NaN; null cannot be taken for a good figure.
TEST(BakeReport, FiguresThatAreNotNumbersAreNull) {
    BakeReport report = some_report();
    report.specular[0].figures.rel_rms = std::numeric_limits<double>::quiet_NaN();
    report.specular[0].figures.bias = std::numeric_limits<double>::infinity();
    const Json level = Json::parse(report_json(report))["measured"]["specular"][0];
    EXPECT_TRUE(level["rel_rms"].is_null());
    EXPECT_TRUE(level["bias"].is_null());
    EXPECT_FALSE(level["max_rel"].is_null());
}

TEST(BakeReport, EqualReportsAreEqualTexts) {
    EXPECT_EQ(report_json(some_report()), report_json(some_report()));
    EXPECT_EQ(report_text(some_report()), report_text(some_report()));
}

}  // namespace
}  // namespace splitsum
