// splitsum-preview --html as a user runs it; tests/page opens the pages in a browser.
#include <nlohmann/json.hpp>

#include "support/temporary_folder.h"
#include "tools/programs.h"

namespace splitsum::tests {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using Arguments = std::vector<std::string>;

const std::string panorama = std::string(SPLITSUM_TEST_DATA) + "/panoramas/lopsided.exr";

/// A small bake of a panorama with a name that means something to HTML.
class PreviewPage : public testing::Test {
protected:
    PreviewPage() {
        fs::copy_file(panorama, folder_ / "a<b> & c.exr");
        const ProgramResult run =
            run_tool("splitsum-bake", {(folder_ / "a<b> & c.exr").string(), "-o",
                                       (folder_ / "out").string(), "--size", "16", "--levels", "3",
                                       "--table-size", "16", "--probes", "2", "--no-picture"});
        EXPECT_EQ(run.exit_code, 0) << run.err;
    }

    std::string page() const { return (folder_ / "page.html").string(); }

    ProgramResult preview(const Arguments& more) const {
        Arguments arguments = {(folder_ / "out/a<b> & c").string(),
                               "-o",
                               (folder_ / "picture.png").string(),
                               "--html",
                               page(),
                               "--size",
                               "70x20"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return run_tool("splitsum-preview", arguments);
    }

    /// The facts that the page's script reads.
    Json facts() const {
        const std::string text = bytes_of(page());
        const std::string head = "id=\"facts\">";
        const size_t from = text.find(head) + head.size();
        return Json::parse(text.substr(from, text.find("</script>", from) - from), nullptr, false);
    }

    TemporaryFolder folder_;
};

TEST_F(PreviewPage, StandsBesideThePicture) {
    const ProgramResult run = preview({});
    ASSERT_EQ(run.exit_code, 0) << run.err;
    EXPECT_EQ(run.out, (folder_ / "picture.png").string() + "\n" + page() + "\n");
    EXPECT_NE(bytes_of(page()).find("<title>a&lt;b&gt; &amp; c.exr</title>"), std::string::npos);
    EXPECT_EQ(Json::parse(preview({"--json"}).out)["page"], page());
}

TEST_F(PreviewPage, BeginsWhereThePictureIs) {
    ASSERT_EQ(preview({"--yaw", "30", "--pitch", "-5", "--exposure", "2.5", "--view", "filmic",
                       "--no-background"})
                  .exit_code,
              0);
    const Json start = facts()["start"];
    EXPECT_EQ(start, Json({{"width", 70},
                           {"height", 20},
                           {"yaw", 30},
                           {"pitch", -5},
                           {"background", "none"},
                           {"exposure", 2.5},
                           {"view", "filmic"}}));
}

// What the file certifies, or what was measured now.
TEST_F(PreviewPage, ListsTheFigures) {
    ASSERT_EQ(preview({}).exit_code, 0);
    const auto tables_of = [&] {
        std::map<std::string, size_t> rows;
        const Json found = facts();
        for (const Json& table : found["tables"]) rows[table["heading"]] = table["rows"].size();
        return rows;
    };
    EXPECT_EQ(tables_of(), (std::map<std::string, size_t>{{"Error of the levels", 3}}));
    EXPECT_FALSE(facts().contains("truth"));
    ASSERT_EQ(
        preview({"--panorama", panorama, "--truth", "--noise", "0.3", "--probes", "2"}).exit_code,
        0);
    EXPECT_EQ(tables_of(), (std::map<std::string, size_t>{{"Error of the spheres", 14},
                                                          {"Error of the levels", 3},
                                                          {"Between texels and levels", 4}}));
    EXPECT_EQ(facts()["truth"]["width"], 70);
}

TEST_F(PreviewPage, IsTheSameForEveryNumberOfThreads) {
    std::string pages[2];
    for (const int many : {0, 1}) {
        ASSERT_EQ(preview({"--threads", many ? "7" : "1"}).exit_code, 0);
        pages[many] = bytes_of(page());
    }
    EXPECT_EQ(pages[0], pages[1]);
}

// Refused before anything is drawn.
TEST_F(PreviewPage, NeedsAFolderThatIsThere) {
    const auto before = snapshot_of(folder_.path());
    ProgramResult run = run_tool("splitsum-preview", {(folder_ / "out/a<b> & c").string(), "-o",
                                                      (folder_ / "picture.png").string(), "--html",
                                                      (folder_ / "nowhere/page.html").string()});
    expect_failure("splitsum-preview", run, 4);
    EXPECT_NE(run.err.find("nowhere"), std::string::npos) << run.err;
    EXPECT_EQ(snapshot_of(folder_.path()), before);
}

}  // namespace
}  // namespace splitsum::tests
