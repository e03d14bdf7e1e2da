// A depfile means to Make and Ninja what it was written for, whatever the files are called.
#include "splitsum-bake/depfile.h"

#include <gtest/gtest.h>

#include "support/run_program.h"
#include "support/temporary_folder.h"

namespace splitsum::tools {
namespace {

namespace fs = std::filesystem;
using tests::run_program;
using tests::TemporaryFolder;
using tests::write_bytes;

// Names that Make, Ninja or a shell would take apart.
const std::vector<std::string> odd_names = {
    "plain.hdr",    "two words.hdr", "a#b.hdr",     "cost$5.hdr",          "back\\slash.hdr",
    "tail\\ x.hdr", "12:30.hdr",     "(a)[1]!.hdr", "d\xc3\xa4mmerung.hdr"};

// A build in a folder: the target `out` from odd names, by `rules` that include the depfile.
class Build {
public:
    explicit Build(const std::string& file, const std::string& rules) {
        for (const std::string& name : odd_names) write_bytes(folder_ / name, "1"), change(name);
        const auto text = depfile_text(std::vector<std::string>{"out"}, odd_names);
        EXPECT_TRUE(text);
        write_bytes(folder_ / "made.d", *text);
        write_bytes(folder_ / file, rules);
    }

    // Whether the build ran its command.
    bool runs(const std::vector<std::string>& command) {
        const auto before = made();
        std::vector<std::string> all = {"/bin/sh", "-c", R"(cd "$0" && exec "$@")",
                                        folder_.path().string()};
        all.insert(all.end(), command.begin(), command.end());
        const auto run = run_program(all);
        EXPECT_EQ(run.exit_code, 0) << run.out << run.err;
        return made() != before;
    }
    // All times are in the past, where no clock matters: each change is a second after the last.
    void change(const std::string& name) {
        fs::last_write_time(folder_ / name, start_ + std::chrono::seconds(++changes_));
    }
    void remove(const std::string& name) { fs::remove(folder_ / name); }

private:
    size_t made() const { return tests::bytes_of(folder_ / "log").size(); }

    TemporaryFolder folder_;
    const fs::file_time_type start_ = fs::file_time_type::clock::now() - std::chrono::hours(24);
    int changes_ = 0;
};

bool have(const std::string& program) {
    return run_program({"/bin/sh", "-c", "command -v " + program}).exit_code == 0;
}

TEST(Depfile, IsReadByMake) {
    ASSERT_TRUE(have("make"));
    // The output is dated by the youngest input.
    Build build("Makefile",
                "out:\n\techo x >>log; touch -r plain.hdr out; for f in *.hdr; do test \"$$f\" -nt "
                "out && touch "
                "-r \"$$f\" out; done; true\n-include made.d\n");
    EXPECT_TRUE(build.runs({"make", "-s"}));
    EXPECT_FALSE(build.runs({"make", "-s"}));
    for (const std::string& name : odd_names) {
        build.change(name);
        EXPECT_TRUE(build.runs({"make", "-s"})) << name;
        EXPECT_FALSE(build.runs({"make", "-s"})) << name;
    }
    build.remove(odd_names[1]);
    EXPECT_TRUE(build.runs({"make", "-s"}));
}

TEST(Depfile, IsReadByNinja) {
    ASSERT_TRUE(have("ninja"));
    // Ninja reads the depfile after the command, and takes it away.
    Build build("build.ninja",
                "rule bake\n command = echo x >>log; cp made.d now.d; touch -r plain.hdr out; for "
                "f in *.hdr; do "
                "test \"$$f\" -nt out && touch -r \"$$f\" out; done; true\n depfile = now.d\n"
                " deps = gcc\nbuild out: bake\n");
    EXPECT_TRUE(build.runs({"ninja", "-v"}));
    EXPECT_FALSE(build.runs({"ninja", "-v"}));
    for (const std::string& name : odd_names) {
        build.change(name);
        EXPECT_TRUE(build.runs({"ninja", "-v"})) << name;
        EXPECT_FALSE(build.runs({"ninja", "-v"})) << name;
    }
}

TEST(Depfile, RefusesWhatItCannotHold) {
    for (const std::string name : {"two\nlines.hdr", "tab\there.hdr", "a;b.hdr", "ev=2.hdr",
                                   "Peter's.hdr", "a*.hdr", "\\#.hdr", "c\\:.hdr"}) {
        const std::vector<std::string> out = {"out"}, sources = {name};
        const auto text = depfile_text(out, sources);
        ASSERT_FALSE(text) << name;
        EXPECT_EQ(text.error().kind, ErrorKind::bad_argument);
    }
}

}  // namespace
}  // namespace splitsum::tools
