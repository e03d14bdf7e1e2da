#include "plotter.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <string>

#include "splitsum/base/text.h"

namespace splitsum::tools {
namespace {

constexpr const char* complaints = "gnuplot.log";

// How a child is started: in `folder`, silent but for a file of complaints, in a group of its own.
class Launch {
public:
    explicit Launch(const std::filesystem::path& folder) {
        posix_spawn_file_actions_init(&actions_);
        posix_spawn_file_actions_addchdir_np(&actions_, folder.c_str());
        posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
        posix_spawn_file_actions_addopen(&actions_, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
        posix_spawn_file_actions_addopen(&actions_, STDERR_FILENO, complaints,
                                         O_WRONLY | O_CREAT | O_TRUNC, 0600);
        posix_spawnattr_init(&attributes_);
        posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETPGROUP);
    }
    ~Launch() {
        posix_spawn_file_actions_destroy(&actions_);
        posix_spawnattr_destroy(&attributes_);
    }
    Launch(const Launch&) = delete;

    /// 0, or the error number.
    int operator()(pid_t& child, char* const* arguments) const {
        return posix_spawnp(&child, arguments[0], &actions_, &attributes_, arguments, environ);
    }

private:
    posix_spawn_file_actions_t actions_;
    posix_spawnattr_t attributes_;
};

// What a program said last, its own words being better than ours; the file goes.
std::string take_last_line(const std::filesystem::path& file) {
    std::ifstream in(file);
    std::string last;
    for (std::string line; std::getline(in, line);)
        if (line.find_first_not_of(' ') != std::string::npos) last = line;
    in.close();
    std::error_code ignored;
    std::filesystem::remove(file, ignored);
    return last;
}

int wait_for(pid_t child) {
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    return status;
}

}  // namespace

Status run_gnuplot(const std::filesystem::path& script, const std::filesystem::path& folder) {
    std::string program = "gnuplot", argument = script.string();
    char* arguments[] = {program.data(), argument.data(), nullptr};
    pid_t child = 0;
    const int failure = Launch(folder)(child, arguments);
    const int status = failure == 0 ? wait_for(child) : 0;
    const std::string complaint = take_last_line(folder / complaints);
    if (failure == ENOENT)
        return Error{ErrorKind::internal,
                     "no pictures: gnuplot is not installed (Debian: apt-get install gnuplot-nox); "
                     "the tables are complete"};
    if (failure != 0)
        return Error{ErrorKind::internal,
                     cat("no pictures: gnuplot cannot be started: ", std::strerror(failure))};
    if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return ok;
    return Error{ErrorKind::internal, cat("no pictures: gnuplot failed: ", complaint)};
}

}  // namespace splitsum::tools
