// splitsum-bake with a manifest, as a user runs it.
#include "tools/library.h"

namespace splitsum::tests {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr const char* quick_defaults =
    "[defaults]\nsize = 8\nlevels = 2\nirradiance-size = 4\ntable-size = 8\nprobes = 2\n"
    "no-picture = true\n";

class ManifestRun : public testing::Test {
protected:
    ManifestRun() {
        write_skies(folder_ / "hdri", 2);
        write_sky(folder_ / "hdri/dusk/sky00.pfm", 5);
    }
    ProgramResult bake(const std::string& panoramas, std::vector<std::string> options = {}) {
        write_bytes(folder_ / "bake.toml", quick_defaults + panoramas);
        std::vector<std::string> arguments = {"--manifest", folder_ / "bake.toml"};
        if (std::ranges::find(options, "-o") == options.end())
            options.insert(options.end(), {"-o", folder_ / "out"});
        arguments.insert(arguments.end(), options.begin(), options.end());
        return run_tool("splitsum-bake", arguments);
    }
    Json report(const std::string& name) const {
        return Json::parse(bytes_of(folder_ / "out" / name / "report.json"), nullptr, false);
    }
    TemporaryFolder folder_;
};

TEST_F(ManifestRun, GivesEachPanoramaItsOptions) {
    const auto run = bake(
        "[[panoramas]]\nfile = \"hdri/sky00.pfm\"\nexposure = 1.5\n"
        "[[panoramas]]\nfile = \"hdri/sky00.pfm\"\nname = \"turned/sky\"\nrotate = 90\n"
        "[[panoramas]]\nfile = \"hdri/dusk\"\nname = \"evening\"\n",
        {"--json"});
    ASSERT_EQ(run.exit_code, 0) << run.err;
    EXPECT_EQ(report("sky00")["source"]["exposure_stops"], 1.5);
    EXPECT_EQ(report("turned/sky")["source"]["exposure_stops"], 0);
    EXPECT_NE(bytes_of(folder_ / "out/turned/sky/specular.ktx2"),
              bytes_of(folder_ / "out/sky00/specular.ktx2"));
    EXPECT_TRUE(fs::exists(folder_ / "out/evening/sky00/report.json"));
    EXPECT_EQ(outcomes_in(run), (std::map<std::string, int>{{"baked", 3}}));
}

TEST_F(ManifestRun, IsASourceOfTheDepfile) {
    const std::string depfile = folder_ / "out.d";
    ASSERT_EQ(bake("[[panoramas]]\nfile = \"hdri/sky00.pfm\"\n", {"--depfile", depfile}).exit_code,
              0);
    EXPECT_NE(bytes_of(depfile).find((folder_ / "bake.toml").string()), std::string::npos);
}

TEST_F(ManifestRun, SaysWhatHoldsForTheRun) {
    const auto run = run_tool("splitsum-bake",
                              {"--manifest", [&] {
                                   write_bytes(folder_ / "all.toml",
                                               std::string(quick_defaults) +
                                                   "output = \"here\"\nthreads = 1\n"
                                                   "[[panoramas]]\nfile = \"hdri/sky01.pfm\"\n");
                                   return std::string(folder_ / "all.toml");
                               }()});
    EXPECT_EQ(run.exit_code, 0) << run.err;
    EXPECT_TRUE(fs::exists(folder_ / "here/sky01/report.json"));
}

TEST_F(ManifestRun, IsRefusedBeforeAnythingIsBaked) {
    const std::pair<const char*, const char*> wrong[] = {
        {"[[panoramas]]\nfile = \"hdri/sky00.pfm\"\nrotat = 90\n", "rotate"},
        {"[[panoramas]]\nfile = \"hdri/sky00.pfm\"\nrotate = \"east\"\n", "bake.toml:10"},
        {"[[panoramas]]\nfile = \"hdri/sky00.pfm\"\n[[panoramas]]\nfile = "
         "\"hdri/dusk/sky00.pfm\"\n",
         "sky00"},
        {"[[panoramas]]\nfile = \"hdri\"\n[[panoramas]]\nfile = \"hdri/sky00.pfm\"\n", "sky00"},
        {"include = [\"bake.toml\"]\n", "bake.toml"},
    };
    for (const auto& [text, part] : wrong) {
        const auto run = bake(text);
        expect_failure("splitsum-bake", run, 2);
        EXPECT_NE(run.err.find(part), std::string::npos) << run.err;
        EXPECT_FALSE(fs::exists(folder_ / "out"));
    }
    const auto missing =
        run_tool("splitsum-bake", {"--manifest", folder_ / "no.toml", "-o", folder_ / "out"});
    expect_failure("splitsum-bake", missing, 3);
    const auto both = bake("[[panoramas]]\nfile = \"hdri/sky00.pfm\"\n", {folder_ / "hdri"});
    expect_failure("splitsum-bake", both, 2);
}

}  // namespace
}  // namespace splitsum::tests
