#include "splitsum/bake/bake.h"

#include <gtest/gtest.h>

#include <set>

#include "splitsum/bake/facts.h"
#include "splitsum/bake/recipe.h"
#include "splitsum/container/ktx2.h"
#include "splitsum/report/certificate.h"
#include "splitsum/report/harmonics_file.h"
#include "support/temporary_folder.h"

namespace splitsum {
namespace {

// Red to the right, green upwards, blue constant.
Panorama small_panorama() {
    Panorama panorama;
    panorama.pixels = Image(16, 8);
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 16; ++x) {
            float* pixel = panorama.pixels.row(y).data() + 3 * x;
            pixel[0] = float(x) / 16, pixel[1] = 1 - float(y) / 8, pixel[2] = 0.5f;
        }
    panorama.source = "small.exr";
    panorama.source_hash = "xxh3-128:00";
    panorama.color_space = "lin_rec709";
    panorama.exposure_stops = 2;
    panorama.notes = {"alpha was dropped"};
    return panorama;
}

BakePlan small_plan() {
    BakePlan plan;
    plan.specular = {.face_size = 8, .levels = 3, .roughness = {}};
    plan.irradiance.face_size = 4;
    plan.filter.samples = 64;
    plan.probes = 5;
    return plan;
}

std::set<std::string> names_in(const std::filesystem::path& folder) {
    std::set<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        names.insert(entry.path().filename().string());
    return names;
}

TEST(Bake, WritesWhatItReports) {
    const tests::TemporaryFolder folder;
    NoProgress progress;
    const auto report =
        bake(light_of(small_panorama()), small_plan(), folder / "made" / "new", progress);
    ASSERT_TRUE(report) << report.error().message;
    std::set<std::string> expected = {"report.json", "report.txt"};
    for (const WrittenFile& file : report->files) {
        expected.insert(file.name);
        EXPECT_EQ(int64_t(file_size(folder / "made/new" / file.name)), file.bytes) << file.name;
        EXPECT_FALSE(file.what.empty());
    }
    EXPECT_EQ(names_in(folder / "made/new"), expected);
    EXPECT_EQ(expected.size(), 6u);
    EXPECT_EQ(tests::bytes_of(folder / "made/new/report.json"), report_json(*report));
    EXPECT_EQ(tests::bytes_of(folder / "made/new/report.txt"), report_text(*report));
}

TEST(Bake, EveryFileKnowsItsSource) {
    const tests::TemporaryFolder folder;
    NoProgress progress;
    ASSERT_TRUE(bake(light_of(small_panorama()), small_plan(), folder.path(), progress));
    for (const char* name : {"specular.ktx2", "irradiance.ktx2"}) {
        const auto texture = read_ktx2(folder / name);
        ASSERT_TRUE(texture);
        EXPECT_EQ(texture->metadata.at("splitsum.source"), "small.exr");
        EXPECT_EQ(texture->metadata.at("splitsum.source_hash"), "xxh3-128:00");
        EXPECT_EQ(texture->metadata.at("splitsum.exposure_stops"), "2");
    }
    EXPECT_EQ(read_harmonics(folder / "harmonics.json")->facts.source.hash, "xxh3-128:00");
}

TEST(Bake, CertifiesWhatItReports) {
    const tests::TemporaryFolder folder;
    NoProgress progress;
    const auto report = bake(light_of(small_panorama()), small_plan(), folder.path(), progress);
    ASSERT_TRUE(report);
    const auto check = [&](const char* name, std::span<const LevelCheck> checks) {
        const auto texture = read_ktx2(folder / name);
        const auto certificate = certificate_of(texture->metadata);
        ASSERT_TRUE(certificate) << certificate.error().message;
        ASSERT_TRUE(*certificate) << name;
        EXPECT_EQ(contradictions(**certificate, *texture, checks), std::vector<std::string>());
        for (size_t i = 0; i < checks.size(); ++i) {
            EXPECT_EQ((*certificate)->levels.at(i).figures.texels, 5);
            EXPECT_FLOAT_EQ(float((*certificate)->levels[i].figures.rel_rms),
                            float(checks[i].figures.rel_rms));
        }
    };
    check("specular.ktx2", report->specular);
    check("irradiance.ktx2", {&report->irradiance, 1});
}

TEST(Bake, RecordsItsRecipe) {
    const tests::TemporaryFolder folder;
    NoProgress progress;
    Light light = light_of(small_panorama());
    light.reading.exposure_stops = 2;
    const auto report = bake(light, small_plan(), folder.path(), progress);
    ASSERT_TRUE(report);
    ConfigHashes configs;
    const auto recipe = recipe_of("small.exr", "xxh3-128:00", light.reading, small_plan(), configs);
    EXPECT_EQ(report->recipe, *recipe);
    for (const char* name : {"report.json", "report.txt"})
        EXPECT_NE(tests::bytes_of(folder / name).find(*recipe), std::string::npos) << name;

    const auto read = load_light(std::string(SPLITSUM_TEST_DATA) + "/panoramas/one_texel.exr",
                                 light.reading, light_use(small_plan(), light.tables), progress);
    ASSERT_TRUE(read);
    EXPECT_EQ(read->reading.exposure_stops, 2);
}

TEST(Bake, LeavesThePictureOutOnRequest) {
    const tests::TemporaryFolder folder;
    NoProgress progress;
    BakePlan plan = small_plan();
    plan.picture = false;
    ASSERT_TRUE(bake(light_of(small_panorama()), plan, folder.path(), progress));
    EXPECT_FALSE(exists(folder / "contact.png"));

    ASSERT_TRUE(bake(light_of(small_panorama()), small_plan(), folder.path(), progress));
    EXPECT_TRUE(exists(folder / "contact.png"));
    ASSERT_TRUE(bake(light_of(small_panorama()), plan, folder.path(), progress));
    EXPECT_FALSE(exists(folder / "contact.png")) << "a picture of something else";
}

TEST(Bake, WithoutProbesReportsNoFiguresButBounds) {
    const tests::TemporaryFolder folder;
    NoProgress progress;
    BakePlan plan = small_plan();
    plan.probes = 0;
    const auto report = bake(light_of(small_panorama()), plan, folder.path(), progress);
    ASSERT_TRUE(report);
    EXPECT_EQ(report_json(*report).find("rel_rms"), std::string::npos);
    EXPECT_NE(report_json(*report).find("error_bound"), std::string::npos);
    EXPECT_NE(report_text(*report).find(", bound "), std::string::npos);
}

TEST(Bake, WritesNothingForAPlanThatCannotWork) {
    const tests::TemporaryFolder folder;
    NoProgress progress;
    BakePlan plans[4] = {small_plan(), small_plan(), small_plan(), small_plan()};
    plans[0].probes = -1;
    plans[1].specular.levels = 9;
    plans[2].filter.method = "guess";
    plans[3].format = PixelFormat::rg16f;
    for (const BakePlan& plan : plans) {
        const auto report = bake(light_of(small_panorama()), plan, folder / "new", progress);
        ASSERT_FALSE(report);
        EXPECT_EQ(report.error().kind, ErrorKind::bad_argument) << report.error().message;
        EXPECT_TRUE(names_in(folder.path()).empty());
    }
}

// Cancels after a number of steps, wherever that is.
class CancelAfter final : public Progress {
public:
    explicit CancelAfter(int steps) : left_(steps) {}
    void begin(std::string_view, int) override {}
    void advance(int steps) override { left_ -= steps; }
    bool cancelled() const override { return left_ <= 0; }

private:
    std::atomic<int> left_;
};

TEST(Bake, WritesNothingWhenCancelled) {
    const tests::TemporaryFolder folder;
    for (const int steps : {0, 1, 50, 100}) {
        CancelAfter progress(steps);
        const auto report =
            bake(light_of(small_panorama()), small_plan(), folder / "new", progress);
        ASSERT_FALSE(report) << steps;
        EXPECT_EQ(report.error().kind, ErrorKind::interrupted);
        EXPECT_TRUE(names_in(folder.path()).empty());
    }
}

TEST(SourceFacts, CountRepairedTexelsOnlyWhereTheyWereRepaired) {
    Panorama panorama = small_panorama();
    panorama.found.nan.count = 2;
    panorama.found.negative.count = 5;
    panorama.found.infinite.count = 1;
    EXPECT_EQ(source_facts(panorama).repaired_texels, 0);
    panorama.repaired = true;
    EXPECT_EQ(source_facts(panorama).repaired_texels, 8);
}

}  // namespace
}  // namespace splitsum
