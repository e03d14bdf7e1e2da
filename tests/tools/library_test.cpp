// splitsum-bake over a folder: what is up to date is left alone, and the rest is brought up to date.
#include "tools/library.h"

namespace splitsum::tests {
namespace {

namespace fs = std::filesystem;
using Outcomes = std::map<std::string, int>;

class Library : public testing::Test {
protected:
    Library() { write_skies(folder_ / "hdri", 4); }

    ProgramResult bake(std::vector<std::string> options = {}) {
        return bake_library({(folder_ / "hdri").string()}, folder_ / "out", options);
    }
    Outcomes outcomes(std::vector<std::string> options = {}) {
        options.push_back("--json");
        return outcomes_in(bake(options));
    }
    // When each file was last renamed into place or written.
    std::map<std::string, fs::file_time_type> times() const {
        std::map<std::string, fs::file_time_type> times;
        for (const auto& [file, bytes] : results_in(folder_ / "out"))
            times[file] = fs::last_write_time(folder_ / "out" / file);
        return times;
    }

    TemporaryFolder folder_;
};

TEST_F(Library, IsBakedOnce) {
    const auto first = bake();
    ASSERT_EQ(first.exit_code, 0) << first.err;
    EXPECT_EQ(results_in(folder_ / "out").size(), 4u * 5 + 1);
    const auto before = times();
    const auto second = bake();
    EXPECT_EQ(second.exit_code, 0) << second.err;
    EXPECT_NE(second.out.find("sky02/: up to date"), std::string::npos) << second.out;
    EXPECT_NE(second.out.find("up to date            4"), std::string::npos) << second.out;
    EXPECT_EQ(times(), before);
    EXPECT_EQ(outcomes(), (Outcomes{{"up_to_date", 4}}));
}

TEST_F(Library, IsNotBakedAgainForATouch) {
    ASSERT_EQ(bake().exit_code, 0);
    const auto before = times();
    for (const char* name : {"sky00.pfm", "sky03.pfm"})
        fs::last_write_time(folder_ / "hdri" / name, fs::file_time_type::clock::now());
    EXPECT_EQ(outcomes(), (Outcomes{{"up_to_date", 4}}));
    EXPECT_EQ(times(), before);
}

TEST_F(Library, IsBakedAgainWhereAPanoramaChanged) {
    ASSERT_EQ(bake().exit_code, 0);
    write_sky(folder_ / "hdri/sky01.pfm", 17);
    const auto asked = bake({"--dry-run"});
    EXPECT_NE(asked.out.find("sky01/: would be baked: "), std::string::npos) << asked.out;
    EXPECT_NE(asked.out.find("sky02/: up to date"), std::string::npos) << asked.out;
    EXPECT_EQ(outcomes(), (Outcomes{{"baked", 1}, {"up_to_date", 3}}));
    const TemporaryFolder other;
    ASSERT_EQ(bake_library({(folder_ / "hdri").string()}, other.path()).exit_code, 0);
    EXPECT_EQ(results_in(folder_ / "out"), results_in(other.path()));
}

TEST_F(Library, IsBakedAgainWithOtherOptions) {
    ASSERT_EQ(bake().exit_code, 0);
    const auto asked = bake({"--dry-run", "--exposure", "1"});
    EXPECT_NE(asked.out.find("exposure"), std::string::npos) << asked.out;
    EXPECT_EQ(outcomes({"--exposure", "1"}), (Outcomes{{"baked", 4}}));
    EXPECT_EQ(outcomes({"--exposure", "1"}), (Outcomes{{"up_to_date", 4}}));
    EXPECT_EQ(outcomes(), (Outcomes{{"baked", 4}}));
}

TEST_F(Library, IsMendedWhereAFileIsGone) {
    ASSERT_EQ(bake().exit_code, 0);
    const auto whole = results_in(folder_ / "out");
    fs::remove(folder_ / "out/sky01/harmonics.json");
    fs::remove(folder_ / "out/sky02/report.json");
    fs::remove(folder_ / "out/brdf.ktx2");
    EXPECT_EQ(outcomes(), (Outcomes{{"baked", 2}, {"up_to_date", 2}}));
    EXPECT_EQ(results_in(folder_ / "out"), whole);
}

TEST_F(Library, HasATableThatFitsItsOptions) {
    ASSERT_EQ(bake().exit_code, 0);
    const std::string eight = bytes_of(folder_ / "out/brdf.ktx2");
    std::string damaged = eight;
    damaged[damaged.size() - 3] ^= 1;
    write_bytes(folder_ / "out/brdf.ktx2", damaged);
    const auto mended = bake();
    EXPECT_EQ(mended.exit_code, 0) << mended.err;
    EXPECT_EQ(bytes_of(folder_ / "out/brdf.ktx2"), eight);

    const auto other = run_tool(
        "splitsum-bake", {(folder_ / "hdri").string(), "-o", (folder_ / "out").string(), "--size",
                          "8", "--levels", "2", "--irradiance-size", "4", "--probes", "2",
                          "--no-picture", "--table-size", "16", "--json"});
    EXPECT_EQ(outcomes_in(other), (Outcomes{{"up_to_date", 4}}));
    EXPECT_EQ(nlohmann::json::parse(other.out)["table"]["outcome"], "baked");
    EXPECT_NE(bytes_of(folder_ / "out/brdf.ktx2"), eight);
}

TEST_F(Library, IsBakedAgainByForce) {
    ASSERT_EQ(bake().exit_code, 0);
    const auto before = results_in(folder_ / "out");
    EXPECT_EQ(outcomes({"--force"}), (Outcomes{{"baked", 4}}));
    EXPECT_EQ(results_in(folder_ / "out"), before);
}

TEST_F(Library, DryRunsWriteNothing) {
    const auto before = snapshot_of(folder_.path());
    const std::vector<std::string> options = {
        "--dry-run",        "--depfile", folder_ / "out.d", "--events",
        folder_ / "events", "--cache",   folder_ / "cache"};
    const auto run = bake(options);
    EXPECT_EQ(run.exit_code, 0) << run.err;
    EXPECT_NE(run.out.find("sky00/: would be baked: "), std::string::npos) << run.out;
    EXPECT_NE(run.out.find("would be baked        4"), std::string::npos) << run.out;
    EXPECT_NE(run.out.find("brdf.ktx2: would be baked: "), std::string::npos) << run.out;
    EXPECT_EQ(snapshot_of(folder_.path()), before);
    EXPECT_FALSE(fs::exists(folder_ / "out"));
    EXPECT_FALSE(fs::exists(folder_ / "cache"));
    EXPECT_EQ(outcomes({"--dry-run"}), (Outcomes{{"would_bake", 4}}));

    ASSERT_EQ(bake().exit_code, 0);
    const auto baked = snapshot_of(folder_.path());
    fs::last_write_time(folder_ / "hdri/sky00.pfm", fs::file_time_type::clock::now());
    EXPECT_EQ(outcomes({"--dry-run"}), (Outcomes{{"up_to_date", 4}}));
    EXPECT_EQ(snapshot_of(folder_.path()), baked);
}

TEST_F(Library, TakesFromTheCacheWhatAnotherHasBaked) {
    const std::string cache = folder_ / "cache";
    EXPECT_EQ(outcomes({"--cache", cache}), (Outcomes{{"baked", 4}}));
    const std::string hdri = folder_ / "hdri";
    const auto other = bake_library({hdri}, folder_ / "other", {"--cache", cache, "--json"});
    EXPECT_EQ(outcomes_in(other), (Outcomes{{"from_cache", 4}})) << other.err;
    EXPECT_EQ(results_in(folder_ / "other"), results_in(folder_ / "out"));
    // And knows it from then on.
    EXPECT_EQ(outcomes_in(bake_library({hdri}, folder_ / "other", {"--json"})),
              (Outcomes{{"up_to_date", 4}}));
    // Other options have no part in it.
    EXPECT_EQ(outcomes({"--cache", cache, "--exposure", "2"}), (Outcomes{{"baked", 4}}));
}

TEST_F(Library, BakesWhereTheCacheCannotBeKept) {
    EXPECT_EQ(outcomes({"--cache", folder_ / "cache", "--cache-size", "1"}),
              (Outcomes{{"baked", 4}}));
    write_bytes(folder_ / "hdri.txt", "no cache");
    const auto refused = bake({"--cache", (folder_ / "hdri").string()});
    EXPECT_EQ(refused.exit_code, 2) << refused.err;  // a folder with other files in it
}

TEST_F(Library, BakesTheRestOfABadOne) {
    write_bytes(folder_ / "hdri/bad.hdr", "#?RADIANCE\n");
    write_bytes(folder_ / "hdri/sky99.exr", "");
    const auto run = bake();
    EXPECT_EQ(run.exit_code, 3);
    EXPECT_EQ(run.err_lines(), 3u) << run.err;
    for (const char* part : {"splitsum-bake: failed: ", "bad.hdr", "sky99.exr",
                             "splitsum-bake: 2 of 6 panoramas failed"})
        EXPECT_NE(run.err.find(part), std::string::npos) << part << " is not in " << run.err;
    EXPECT_EQ(results_in(folder_ / "out").size(), 4u * 5 + 1);
    EXPECT_EQ(outcomes(), (Outcomes{{"up_to_date", 4}, {"failed", 2}}));
}

// The next output could not be written either.
TEST_F(Library, StopsAtAnOutputThatCannotBeWritten) {
    fs::create_directory(folder_ / "out");
    write_bytes(folder_ / "out/sky00", "in the way");
    const auto run = bake({"--threads", "1"});
    EXPECT_EQ(run.exit_code, 4);
    EXPECT_NE(run.err.find("0 of 4 panoramas are done"), std::string::npos) << run.err;
    EXPECT_EQ(results_in(folder_ / "out").size(), 1u);
    fs::remove(folder_ / "out/sky00");
    EXPECT_EQ(outcomes(), (Outcomes{{"baked", 4}}));
}

TEST_F(Library, FailsWhatNeedsMoreMemoryThanThereIs) {
    write_sky(folder_ / "hdri/wide.pfm", 3, 2048);
    const auto run = bake({"--memory", "256M", "--method", "filtered"});
    EXPECT_EQ(run.exit_code, 2) << run.err;
    EXPECT_NE(run.err.find("wide.pfm may take "), std::string::npos) << run.err;
    EXPECT_TRUE(fs::exists(folder_ / "out/sky00/report.json"));
    EXPECT_FALSE(fs::exists(folder_ / "out/wide"));
}

TEST_F(Library, HasNamesFromItsFolders) {
    write_sky(folder_ / "hdri/dusk/sky00.pfm", 9);
    write_sky(folder_ / "hdri/dusk/old/sky00.pfm", 10);
    ASSERT_EQ(bake({"--exclude", "dusk/old/*"}).exit_code, 0);
    EXPECT_TRUE(fs::exists(folder_ / "out/dusk/sky00/report.json"));
    EXPECT_FALSE(fs::exists(folder_ / "out/dusk/old"));
    EXPECT_TRUE(fs::exists(folder_ / "out/sky00/report.json"));
    EXPECT_EQ(outcomes({"--include", "dusk/*"}), (Outcomes{{"up_to_date", 1}, {"baked", 1}}));
}

}  // namespace
}  // namespace splitsum::tests
