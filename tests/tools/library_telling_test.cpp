// What splitsum-bake tells of a library: events, depfiles, and progress on terminals and in logs.
#include <pty.h>

#include <array>
#include <fstream>
#include <regex>

#include "tools/library.h"

namespace splitsum::tests {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

std::vector<Json> events_in(const fs::path& file) {
    std::vector<Json> events;
    std::ifstream lines(file);
    for (std::string line; std::getline(lines, line);) {
        events.push_back(Json::parse(line, nullptr, false));
        EXPECT_TRUE(events.back().is_object()) << line;
    }
    return events;
}

std::vector<Json> named(const std::vector<Json>& events, const std::string& name) {
    std::vector<Json> found;
    for (const Json& event : events)
        if (event["event"] == name) found.push_back(event);
    return found;
}

class Telling : public testing::Test {
protected:
    Telling() {
        write_skies(folder_ / "hdri", 3);
        write_bytes(folder_ / "hdri/bad.exr", "");
    }
    ProgramResult bake(const std::vector<std::string>& options) {
        return bake_library({folder_ / "hdri"}, folder_ / "out", options);
    }
    TemporaryFolder folder_;
};

TEST_F(Telling, EventsAreJsonLines) {
    const fs::path file = folder_ / "events.jsonl";
    EXPECT_EQ(bake({"--events", file.string()}).exit_code, 3);
    const auto events = events_in(file);
    ASSERT_FALSE(events.empty());
    EXPECT_EQ(events.front()["event"], "run_started");
    EXPECT_EQ(events.front()["panoramas"], 4);
    EXPECT_EQ(events.back()["event"], "run_finished");
    EXPECT_EQ(events.back()["baked"], 3);
    EXPECT_EQ(events.back()["failed"], 1);
    EXPECT_EQ(events.back()["exit_code"], 3);
    const std::regex utc(R"(\d{4}-\d\d-\d\dT\d\d:\d\d:\d\d\.\d{3}Z)");
    for (const Json& event : events)
        EXPECT_TRUE(std::regex_match(std::string(event["time"]), utc)) << event;
    EXPECT_EQ(named(events, "panorama_started").size(), 3u);
    const auto finished = named(events, "panorama_finished");
    ASSERT_EQ(finished.size(), 4u);
    for (const Json& event : finished) {
        if (event["name"] == "bad") {
            EXPECT_EQ(event["outcome"], "failed");
            EXPECT_EQ(event["error"]["kind"], "unreadable_input");
            continue;
        }
        EXPECT_EQ(event["outcome"], "baked");
        EXPECT_GT(event["bytes"], 100);
        EXPECT_TRUE(event["worst_rel_rms"].is_number());
        EXPECT_TRUE(event["seconds"].is_number());
        EXPECT_FALSE(std::string(event["why"]).empty());
    }
    // A second run adds its own.
    EXPECT_EQ(bake({"--events", file.string()}).exit_code, 3);
    const auto more = events_in(file);
    EXPECT_EQ(named(more, "run_finished").size(), 2u);
    EXPECT_EQ(more.back()["up_to_date"], 3);
}

TEST_F(Telling, EventsThatCannotBeWrittenAreAFailure) {
    EXPECT_EQ(bake({"--events", "/proc/events"}).exit_code, 4);
    EXPECT_FALSE(fs::exists(folder_ / "out"));
    fs::remove(folder_ / "hdri/bad.exr");
    const auto full = bake({"--events", "/dev/full"});
    EXPECT_EQ(full.exit_code, 4) << full.err;
    EXPECT_TRUE(fs::exists(folder_ / "out/sky00/report.json"));
}

TEST_F(Telling, EventsOnStderrStandAlone) {
    const auto run = run_program([&] {
        auto command = bake_arguments({folder_ / "hdri"}, folder_ / "out", {"--events", "-"});
        command.insert(command.begin(), std::string(SPLITSUM_BIN) + "/splitsum-bake");
        return command;
    }());
    size_t events = 0;
    std::istringstream lines(run.err);
    for (std::string line; std::getline(lines, line);) events += line.starts_with("{\"event\"");
    EXPECT_EQ(events, run.err_lines() - 2) << run.err;  // the failure, and the count of failures
}

// The depfile lets a build call the program again when, and only when, it has something to do.
TEST_F(Telling, DepfilesHoldInputsAndFolders) {
    fs::remove(folder_ / "hdri/bad.exr");
    write_sky(folder_ / "hdri/dusk/a b.pfm", 5);
    const fs::path depfile = folder_ / "out.d";
    ASSERT_EQ(bake({"--depfile", depfile.string(), "--depfile-target", "stamp"}).exit_code, 0);
    const std::string text = bytes_of(depfile);
    EXPECT_TRUE(text.starts_with("stamp: "));
    for (const std::string source : {"hdri/sky00.pfm", "hdri/dusk/a\\ b.pfm", "hdri/dusk", "hdri"})
        EXPECT_TRUE(std::regex_search(
            text, std::regex("\n  " +
                             std::regex_replace((folder_ / source).string(), std::regex(R"([\\.])"),
                                                R"(\$&)") +
                             "( \\\\)?\n")))
            << source << " is not in " << text;
    ASSERT_EQ(bake({"--depfile", depfile.string()}).exit_code, 0);
    EXPECT_TRUE(
        bytes_of(depfile).starts_with((folder_ / "out/dusk/a\\ b/report.json").string() + " \\\n"))
        << bytes_of(depfile);
    EXPECT_EQ(bake({"--depfile-target", "stamp"}).exit_code, 2);
    write_bytes(folder_ / "hdri/bad.exr", "");
    const std::string before = bytes_of(depfile);
    EXPECT_EQ(bake({"--depfile", depfile.string()}).exit_code, 3);
    EXPECT_EQ(bytes_of(depfile), before);  // what did not succeed has not told all
}

// Runs splitsum-bake on a terminal of so many columns and gives what it showed there.
std::string shown_on_terminal(const std::vector<std::string>& arguments, unsigned short columns) {
    winsize size{};
    size.ws_row = 24;
    size.ws_col = columns;
    int terminal = -1;
    const pid_t child = forkpty(&terminal, nullptr, nullptr, &size);
    if (child == 0) {
        setenv("TERM", "xterm", 1);
        std::vector<std::string> command = arguments;
        command.insert(command.begin(), std::string(SPLITSUM_BIN) + "/splitsum-bake");
        std::vector<char*> pointers;
        for (std::string& argument : command) pointers.push_back(argument.data());
        pointers.push_back(nullptr);
        execv(pointers[0], pointers.data());
        _exit(127);
    }
    std::string shown;
    char buffer[4096];
    for (ssize_t count; (count = read(terminal, buffer, sizeof buffer)) > 0;)
        shown.append(buffer, static_cast<size_t>(count));
    close(terminal);
    waitpid(child, nullptr, 0);
    return shown;
}

TEST_F(Telling, ABarFollowsTheTerminal) {
    write_skies(folder_ / "hdri", 12, 64);
    for (const unsigned short columns : std::array<unsigned short, 3>{20, 50, 120}) {
        fs::remove_all(folder_ / "out");
        const std::string shown = shown_on_terminal(
            bake_arguments({folder_ / "hdri"}, folder_ / "out", {"--threads", "1"}), columns);
        // Each redrawing starts at the left and erases what it does not cover.
        const std::regex redrawn("\r([^\r\n]*)\x1b\\[K");
        size_t lines = 0;
        bool counts = false;
        for (std::sregex_iterator line(shown.begin(), shown.end(), redrawn), end; line != end;
             ++line) {
            ++lines;
            EXPECT_LT(line->str(1).size(), columns) << line->str(1);
            counts |= line->str(1).find("/13") != std::string::npos;
        }
        EXPECT_GT(lines, 2u) << shown;
        EXPECT_TRUE(counts) << shown;
        // Results begin on lines of their own: the bar is wiped before.
        const size_t result = shown.find("/sky05/: ");
        ASSERT_NE(result, std::string::npos) << shown;
        const std::string start = shown.substr(0, result);
        const size_t wiped = start.rfind("\x1b[K"), ended = start.rfind('\n');
        EXPECT_EQ(start.find_first_of("%[]", std::max(wiped + 3, ended)), std::string::npos);
    }
}

TEST_F(Telling, LogsGetLines) {
    auto command = bake_arguments({folder_ / "hdri"}, folder_ / "out");
    command.insert(command.begin(), std::string(SPLITSUM_BIN) + "/splitsum-bake");
    const auto run = run_program(command);
    EXPECT_NE(run.err.find("looking at 4 panoramas\n"), std::string::npos) << run.err;
    EXPECT_EQ(run.err.find_first_of("\r\x1b"), std::string::npos);
    command.push_back("--quiet");
    EXPECT_EQ(run_program(command).err_lines(), 2u);  // the failure, and the count of failures
}

TEST_F(Telling, CountsStandAtTheEnd) {
    write_skies(folder_ / "hdri", 25);
    const auto run = bake({});
    for (const char* part :
         {"baked                25", "failed                1", "panoramas/min", "worst rel_rms "})
        EXPECT_NE(run.out.find(part), std::string::npos) << part << " is not in " << run.out;
    // A line for each of that many, none for what is up to date.
    EXPECT_EQ(run.out.find("\n  worst"), std::string::npos);
    EXPECT_EQ(bake({}).out.find("sky03"), std::string::npos);
}

}  // namespace
}  // namespace splitsum::tests
