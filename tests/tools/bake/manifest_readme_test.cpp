// The example that the format is explained with.
#include <gtest/gtest.h>

#include "splitsum-bake/manifest_options.h"
#include "splitsum-bake/plan_options.h"
#include "support/temporary_folder.h"

namespace splitsum::tools {
namespace {

// The first block of the README in this notation.
std::string example_in(const std::string& notation) {
    const std::string readme =
        tests::bytes_of(SPLITSUM_TEST_DATA "/../lib/splitsum/manifest/README.md");
    const std::string fence = "```" + notation + "\n";
    const size_t begin = readme.find(fence) + fence.size();
    return readme.substr(begin, readme.find("```", begin) - begin);
}

// Reads the example as a program that has the options it names.
class Example {
public:
    explicit Example(const std::string& notation) {
        app.add_option("--threads", threads);
        tests::write_bytes(folder_ / "studio.toml", "panoramas = ['studio.exr']\n");
        tests::write_bytes(folder_ / "studio.json", "{\"panoramas\": [\"studio.exr\"]}\n");
        const std::string name = "bake." + notation;
        tests::write_bytes(folder_ / name, example_in(notation));
        const auto read = read_manifest(folder_ / name, options_of_manifests(app));
        EXPECT_TRUE(read) << read.error().message;
        if (read) manifest = *read;
        const auto made = plans_of_manifest(manifest.panoramas, app);
        EXPECT_TRUE(made) << made.error().message;
        if (made) plans = *made;
        EXPECT_TRUE(apply_run_settings(app, manifest.run));
    }

    CLI::App app;
    PlanOptions asset{app};
    int threads = 0;
    Manifest manifest;
    std::vector<PanoramaPlan> plans;

private:
    tests::TemporaryFolder folder_;
};

TEST(ReadmeOfManifests, ShowsWhatWorksInBothNotations) {
    for (const char* notation : {"toml", "json"}) {
        const Example example(notation);
        EXPECT_EQ(example.threads, 4);
        ASSERT_EQ(example.plans.size(), 4u);
        for (const PanoramaPlan& plan : example.plans) EXPECT_EQ(plan.plan.specular.face_size, 512);
        EXPECT_EQ(example.manifest.panoramas[0].file.filename(), "studio.exr");
        EXPECT_EQ(example.manifest.panoramas[1].name, "dusk/red");
        EXPECT_EQ(example.plans[1].plan.orientation.rotate_degrees, 90);
        EXPECT_EQ(example.plans[1].reading.exposure_stops, -1.5);
        EXPECT_TRUE(example.plans[1].reading.repair);
        EXPECT_FALSE(example.plans[2].reading.repair);
        EXPECT_EQ(example.manifest.panoramas[3].only.size(), 2u);
        EXPECT_EQ(example.manifest.panoramas[3].except, std::vector<std::string>{"*_ldr*"});
    }
}

}  // namespace
}  // namespace splitsum::tools
