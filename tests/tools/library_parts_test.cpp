// A library baked in parts, by several processes, and checked as a whole.
#include <signal.h>

#include <fstream>
#include <set>

#include "tools/library.h"

namespace splitsum::tests {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

// A program that runs beside the test; killed with it.
class Running {
public:
    explicit Running(const std::vector<std::string>& command) {
        std::vector<char*> arguments;
        for (const std::string& argument : command)
            arguments.push_back(const_cast<char*>(argument.c_str()));  // posix_spawn does not write
        arguments.push_back(nullptr);
        EXPECT_EQ(posix_spawnp(&child_, arguments[0], nullptr, nullptr, arguments.data(), environ),
                  0);
    }
    ~Running() {
        if (child_ > 0) kill(child_, SIGKILL), wait();
    }
    Running(const Running&) = delete;
    Running& operator=(const Running&) = delete;

    void signal(int number) const { kill(child_, number); }

    int wait() {
        int status = 0;
        waitpid(child_, &status, 0);
        child_ = 0;
        return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    }

private:
    pid_t child_ = 0;
};

std::vector<std::string> bake_command(const std::vector<std::string>& inputs, const fs::path& out,
                                      const std::vector<std::string>& options) {
    std::vector<std::string> command = bake_arguments(inputs, out, options);
    command.insert(command.begin(), std::string(SPLITSUM_BIN) + "/splitsum-bake");
    command.push_back("--quiet");
    return command;
}

int events_named(const fs::path& file, const std::string& name) {
    std::ifstream lines(file);
    int count = 0;
    for (std::string line; std::getline(lines, line);)
        count += line.find("\"" + name + "\"") != std::string::npos;
    return count;
}

class LibraryParts : public testing::Test {
protected:
    void write(int skies, int height = 8) { write_skies(folder_ / "hdri", skies, height); }

    ProgramResult bake(const std::string& output, std::vector<std::string> options = {}) {
        return bake_library({(folder_ / "hdri").string()}, folder_ / output, options);
    }

    TemporaryFolder folder_;
};

TEST_F(LibraryParts, MakeTheWhole) {
    write(7);
    write_sky(folder_ / "hdri/wide.pfm", 7, 64);
    ASSERT_EQ(bake("whole").exit_code, 0);
    std::multiset<std::string> sources;
    for (const char* part : {"1/3", "2/3", "3/3"}) {
        const auto run = bake("parts", {"--shard", part, "--json"});
        ASSERT_EQ(run.exit_code, 0) << run.err;
        const Json json = Json::parse(run.out);
        for (const Json& panorama : json["panoramas"])
            sources.insert(std::string(panorama["source"]));
    }
    EXPECT_EQ(sources.size(), 8u);
    EXPECT_EQ(std::set(sources.begin(), sources.end()).size(), 8u);
    EXPECT_EQ(results_in(folder_ / "parts"), results_in(folder_ / "whole"));
    for (const char* none : {"0/3", "4/3", "3", "a/b", "1/0", "1/3x"})
        EXPECT_EQ(bake("parts", {"--shard", none}).exit_code, 2) << none;
}

TEST_F(LibraryParts, AreMissedOneByOne) {
    write(4);
    ASSERT_EQ(bake("out", {"--shard", "1/2"}).exit_code, 0);
    const auto before = snapshot_of(folder_ / "out");
    const auto run = bake("out", {"--merge"});
    EXPECT_EQ(run.exit_code, 1);
    EXPECT_EQ(snapshot_of(folder_ / "out"), before);
    EXPECT_NE(run.out.find("2 of 4 panoramas are complete"), std::string::npos) << run.out;
    EXPECT_EQ(run.err_lines(), 3u) << run.err;
    // The command that bakes the rest does.
    const std::string command = run.err.substr(run.err.find("baked by: ") + 10);
    EXPECT_EQ(command.find("--merge"), std::string::npos);
    ASSERT_EQ(run_program({"/bin/sh", "-c", command}).exit_code, 0) << command;
    const auto whole = bake("out", {"--merge"});
    EXPECT_EQ(whole.exit_code, 0) << whole.err;
    EXPECT_EQ(whole.err, "");
    const auto json = Json::parse(bake("out", {"--merge", "--json"}).out);
    EXPECT_EQ(json["complete"], true);
    EXPECT_TRUE(json["worst_rel_rms"].is_number());
}

TEST_F(LibraryParts, AreNotBelievedWhereTheyWereTamperedWith) {
    write(2);
    ASSERT_EQ(bake("out").exit_code, 0);
    const auto tampered = [&](const std::string& name) {
        const fs::path file = folder_ / "out" / name;
        const std::string bytes = bytes_of(file);
        std::string other = bytes;
        other[other.size() - 5] ^= 1;
        write_bytes(file, other);
        const auto run = bake("out", {"--merge"});
        EXPECT_EQ(run.exit_code, 1) << name;
        EXPECT_NE(run.err.find(fs::path(name).filename()), std::string::npos) << run.err;
        write_bytes(file, bytes);
    };
    for (const char* name :
         {"sky00/specular.ktx2", "sky01/irradiance.ktx2", "sky01/harmonics.json", "brdf.ktx2"})
        tampered(name);
    EXPECT_EQ(bake("out", {"--merge"}).exit_code, 0);
    EXPECT_EQ(bake("out", {"--merge", "--exposure", "1"}).exit_code, 1);
    fs::remove(folder_ / "out/brdf.ktx2");
    EXPECT_EQ(bake("out", {"--merge"}).exit_code, 1);
    EXPECT_FALSE(fs::exists(folder_ / "out/brdf.ktx2"));
    EXPECT_EQ(bake("out", {"--merge", "--force"}).exit_code, 2);
}

// Ctrl-C: what runs is dropped, what is done stays, and the same call goes on.
TEST_F(LibraryParts, GoOnAfterAnInterruption) {
    write(24, 64);
    const std::vector<std::string> options = {"--threads", "1", "--size", "32"};
    const std::string hdri = folder_ / "hdri";
    const auto run_in = [&](const std::string& output) {
        std::vector<std::string> all = {hdri,       "-o",       folder_ / output,
                                        "--levels", "4",        "--table-size",
                                        "8",        "--events", folder_ / "events"};
        all.insert(all.end(), options.begin(), options.end());
        return all;
    };
    ASSERT_EQ(run_tool("splitsum-bake", run_in("whole")).exit_code, 0);
    fs::remove(folder_ / "events");

    std::vector<std::string> command = {"/bin/sh",
                                        "-c",
                                        R"(exec "$@" >/dev/null 2>&1)",
                                        "sh",
                                        std::string(SPLITSUM_BIN) + "/splitsum-bake",
                                        "--quiet"};
    for (const std::string& argument : run_in("out")) command.push_back(argument);
    Running baking(command);
    for (int wait = 0; events_named(folder_ / "events", "panorama_finished") < 3 && wait < 60'000;
         ++wait)
        usleep(1000);
    baking.signal(SIGINT);
    ASSERT_EQ(baking.wait(), 130);
    for (const auto& [name, bytes] : results_in(folder_ / "out"))
        EXPECT_EQ(name.find(".part"), std::string::npos) << name;
    EXPECT_LT(results_in(folder_ / "out").size(), results_in(folder_ / "whole").size());

    const auto rest = run_tool("splitsum-bake", run_in("out"));
    EXPECT_EQ(rest.exit_code, 0) << rest.err;
    EXPECT_NE(rest.out.find("up to date"), std::string::npos) << rest.out;
    EXPECT_EQ(results_in(folder_ / "out"), results_in(folder_ / "whole"));
}

TEST_F(LibraryParts, MayBeBakedTwiceAtOnce) {
    write(6, 16);
    ASSERT_EQ(bake("whole").exit_code, 0);
    for (int round = 0; round < 3; ++round) {
        fs::remove_all(folder_ / "out");
        const auto command =
            bake_command({(folder_ / "hdri").string()}, folder_ / "out",
                         {"--cache", folder_ / "cache", "--events", folder_ / "events"});
        const std::vector<std::string> silent = {"/bin/sh", "-c", R"(exec "$@" >/dev/null)", "sh"};
        auto first = silent, second = silent;
        first.insert(first.end(), command.begin(), command.end());
        second.insert(second.end(), command.begin(), command.end());
        Running one(first), other(second);
        EXPECT_EQ(one.wait(), 0);
        EXPECT_EQ(other.wait(), 0);
        EXPECT_EQ(results_in(folder_ / "out"), results_in(folder_ / "whole"));
    }
    EXPECT_EQ(events_named(folder_ / "events", "run_finished"), 6);
}

}  // namespace
}  // namespace splitsum::tests
