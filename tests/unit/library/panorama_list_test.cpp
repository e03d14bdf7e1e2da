#include "splitsum/library/panorama_list.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "support/temporary_folder.h"

namespace splitsum {
namespace {

namespace fs = std::filesystem;
using Names = std::vector<std::string>;

class PanoramaList : public testing::Test {
protected:
    void make(const Names& files) {
        for (const std::string& file : files) {
            fs::create_directories((folder_ / file).parent_path());
            tests::write_bytes(folder_ / file, file);
        }
    }

    /// The names, or the error's kind and message where there is one.
    Names names(const std::vector<fs::path>& inputs, const ListOptions& options = {}) {
        const auto listed = list_panoramas(inputs, options);
        if (!listed) return {"error", listed.error().message};
        Names names;
        for (const ListedPanorama& panorama : *listed) names.push_back(panorama.name);
        return names;
    }

    ErrorKind kind_of_failure(const std::vector<fs::path>& inputs,
                              const ListOptions& options = {}) {
        const auto listed = list_panoramas(inputs, options);
        EXPECT_FALSE(listed);
        return listed ? ErrorKind::internal : listed.error().kind;
    }

    tests::TemporaryFolder folder_;
};

TEST_F(PanoramaList, AFolderGivesItsPanoramasSortedAndNamedByTheirPaths) {
    make({"b.hdr", "a.EXR", "notes.txt", "dusk/z.pfm", "dusk/deep/q.v2.tiff", ".hidden.hdr",
          ".git/x.hdr", "dawn/c.rgbe", "picture.png"});
    EXPECT_EQ(names({folder_.path()}), Names({"a", "b", "dawn/c", "dusk/deep/q.v2", "dusk/z"}));
    const auto listed = list_panoramas({folder_.path()}, {});
    EXPECT_EQ((*listed)[2].file, folder_ / "dawn/c.rgbe");
}

TEST_F(PanoramaList, FilesAreTakenAsGivenInTheirOrder) {
    make({"b.hdr", "a.png"});
    EXPECT_EQ(names({folder_ / "b.hdr", folder_ / "a.png"}), Names({"b", "a"}));
}

// It fails when it is read; the others are baked.
TEST_F(PanoramaList, AMissingFileIsListed) {
    make({"b.hdr"});
    fs::create_symlink("nowhere.hdr", folder_ / "link.hdr");
    EXPECT_EQ(names({folder_ / "gone.hdr", folder_.path()}), Names({"gone", "b", "link"}));
}

TEST_F(PanoramaList, PatternsWithoutSlashAreOfNamesWithOneOfPaths) {
    make({"a.hdr", "b.hdr", "b.png", "dusk/a.hdr", "dusk/old/a.hdr", "dusk/old/b.hdr"});
    const auto with = [&](Names include, Names exclude) {
        return names({folder_.path()}, {std::move(include), std::move(exclude), {}});
    };
    EXPECT_EQ(with({"a.*"}, {}), Names({"a", "dusk/a", "dusk/old/a"}));
    EXPECT_EQ(with({"*.png", "dusk/*"}, {}), Names({"b", "dusk/a", "dusk/old/a", "dusk/old/b"}));
    EXPECT_EQ(with({}, {"old"}), Names({"a", "b", "dusk/a"}));
    EXPECT_EQ(with({}, {"dusk/old/[b-z]*"}), Names({"a", "b", "dusk/a", "dusk/old/a"}));
    EXPECT_EQ(with({"?.hdr"}, {"dusk"}), Names({"a", "b"}));
    EXPECT_EQ(with({"*.HDR", "b.*"}, {})[0], "error");  // letter case counts in patterns
}

TEST_F(PanoramaList, SaysWhatMatchesNothing) {
    make({"a.hdr", "empty/notes.txt"});
    EXPECT_EQ(kind_of_failure({folder_.path()}, {{"a*", "dsuk/*"}, {}, {}}),
              ErrorKind::bad_argument);
    EXPECT_NE(names({folder_.path()}, {{"a*", "dsuk/*"}, {}, {}})[1].find("'dsuk/*'"),
              std::string::npos);
    EXPECT_EQ(kind_of_failure({folder_ / "empty"}), ErrorKind::unusable_input);
    EXPECT_EQ(kind_of_failure({folder_ / "a.hdr"}, {{"*.hdr"}, {}, {}}), ErrorKind::bad_argument);
}

TEST_F(PanoramaList, TheOutputIsNotSearched) {
    make({"a.hdr", "out/b.hdr", "out/sub/c.hdr"});
    EXPECT_EQ(names({folder_.path()}, {{}, {}, folder_ / "." / "out"}), Names({"a"}));
    EXPECT_EQ(names({folder_.path()}, {{}, {}, folder_ / "not there yet"}).size(), 3u);
    EXPECT_EQ(names({folder_ / "out" / "sub"}, {{}, {}, folder_ / "out"}), Names({"c"}));
    EXPECT_EQ(kind_of_failure({folder_ / "out"}, {{}, {}, folder_ / "out"}),
              ErrorKind::bad_argument);
}

TEST_F(PanoramaList, LinksAreFollowedButNotInCircles) {
    make({"real/a.hdr", "library/b.hdr"});
    fs::create_directory_symlink(folder_ / "real", folder_ / "library" / "linked");
    fs::create_directory_symlink(folder_ / "library", folder_ / "real" / "round");
    fs::create_directory_symlink(".", folder_ / "library" / "self");
    EXPECT_EQ(names({folder_ / "library"}), Names({"b", "linked/a"}));
}

TEST_F(PanoramaList, WhatIsNoFileIsNoPanorama) {
    make({"a.hdr"});
    ASSERT_EQ(mkfifo((folder_ / "pipe.hdr").c_str(), 0600), 0);
    EXPECT_EQ(names({folder_.path()}), Names({"a"}));
}

// The error's message, "" where the names can be used.
std::string problem(const std::vector<ListedPanorama>& panoramas) {
    const Status checked = check_names(panoramas);
    if (checked) return "";
    EXPECT_EQ(checked.error().kind, ErrorKind::bad_argument);
    return checked.error().message;
}

TEST(CheckNames, AcceptsALibrary) {
    EXPECT_EQ(problem({{"a.hdr", "a"}, {"x/a.hdr", "x/a"}, {"a/b.hdr", "a/b"}, {"é.hdr", "é"}}),
              "");
    EXPECT_EQ(problem({{"r.hdr", "report.json"}, {"x.hdr", "x/brdf.ktx2"}, {".h.hdr", ".h"}}), "");
}

TEST(CheckNames, NamesBothThatWouldMeet) {
    const std::string message = problem({{"x/a.hdr", "a"}, {"c.hdr", "c"}, {"y/a.exr", "a"}});
    for (const char* part : {"x/a.hdr", "y/a.exr", "'a'"})
        EXPECT_NE(message.find(part), std::string::npos) << message;
    EXPECT_NE(problem({{"A.hdr", "Venice"}, {"b.hdr", "venice"}}).find("case"), std::string::npos);
}

TEST(CheckNames, RecognisesOneFileGivenTwice) {
    const tests::TemporaryFolder folder;
    tests::write_bytes(folder / "a.hdr", "x");
    const std::string message =
        problem({{folder / "a.hdr", "a"}, {folder.path() / "." / "a.hdr", "a"}});
    EXPECT_NE(message.find("given twice"), std::string::npos) << message;
}

TEST(CheckNames, RefusesPlacesOfOtherResults) {
    EXPECT_NE(problem({{"brdf.ktx2.hdr", "brdf.ktx2"}}), "");
    EXPECT_NE(problem({{"brdf.ktx2/a.hdr", "brdf.ktx2/a"}}), "");
    EXPECT_NE(problem({{"a/specular.ktx2.hdr", "a/specular.ktx2"}, {"a.hdr", "a"}}), "");
    EXPECT_NE(problem({{"a.hdr", "a"}, {"x.hdr", "a/Report.json/x"}}), "");
    EXPECT_NE(problem({{"a.hdr", "b/a"}, {"x.hdr", "b/a/contact.png"}}), "");
    EXPECT_EQ(problem({{"a.hdr", "a"}, {"x.hdr", "b/specular.ktx2"}}), "");
}

TEST(CheckNames, RefusesWhatIsNoPlaceBelowTheOutput) {
    for (const char* name : {"", "/a", "a/", "a//b", "..", "../a", "a/../b", ".", "a/./b",
                             "a/.source", ".splitsum-0123456789abcdef.part"})
        EXPECT_NE(problem({{"a.hdr", name}}), "") << name;
}

}  // namespace
}  // namespace splitsum
