#pragma once

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstring>
#include <string>
#include <thread>
#include <vector>

namespace splitsum::tests {

/// How a program ended and what it printed.
struct ProgramResult {
    int exit_code = -1;      ///< 128 + the signal's number where a signal ended it, as shells do
    bool timed_out = false;  ///< killed because it took too long
    std::string out;         ///< all of stdout
    std::string err;         ///< all of stderr, or why the program could not be started

    /// The number of lines on stderr.
    size_t err_lines() const {
        size_t lines = 0;
        for (const char letter : err) lines += letter == '\n';
        return lines + (!err.empty() && err.back() != '\n');
    }
};

namespace run_program_detail {

/// A file in memory that takes what a program prints; unlike a pipe it never fills up.
class Capture {
public:
    Capture() : descriptor_(memfd_create("capture", MFD_CLOEXEC)) {}
    ~Capture() { close(descriptor_); }
    Capture(const Capture&) = delete;
    Capture& operator=(const Capture&) = delete;

    int descriptor() const { return descriptor_; }

    std::string text() const {
        std::string text(static_cast<size_t>(lseek(descriptor_, 0, SEEK_END)), '\0');
        if (pread(descriptor_, text.data(), text.size(), 0) < 0) return "cannot read the output";
        return text;
    }

private:
    int descriptor_;
};

/// Waits for a child; after `timeout` it is killed with all of its process group.
inline void wait_for(pid_t child, std::chrono::milliseconds timeout, ProgramResult& result) {
    const auto deadline = std::chrono::steady_clock::now() + timeout;
    int status = 0;
    while (waitpid(child, &status, WNOHANG) == 0) {
        if (!result.timed_out && std::chrono::steady_clock::now() > deadline) {
            result.timed_out = true;
            kill(-child, SIGKILL);
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    result.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace run_program_detail

/// Runs command[0], looked up in PATH, with an empty stdin and waits for its end.
inline ProgramResult run_program(const std::vector<std::string>& command,
                                 std::chrono::milliseconds timeout = std::chrono::seconds(120)) {
    std::vector<char*> arguments;
    for (const std::string& argument : command)
        arguments.push_back(const_cast<char*>(argument.c_str()));  // posix_spawn does not write
    arguments.push_back(nullptr);

    const run_program_detail::Capture out, err;
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&actions, out.descriptor(), STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions, err.descriptor(), STDERR_FILENO);
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);  // a group of its own

    ProgramResult result;
    pid_t child = 0;
    const int failure =
        posix_spawnp(&child, arguments[0], &actions, &attributes, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    posix_spawnattr_destroy(&attributes);
    if (failure != 0) {
        result.err = command[0] + ": " + std::strerror(failure);
        return result;
    }
    run_program_detail::wait_for(child, timeout, result);
    result.out = out.text();
    result.err = err.text();
    return result;
}

}  // namespace splitsum::tests
