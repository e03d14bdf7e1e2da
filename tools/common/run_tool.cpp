#include "common/run_tool.h"

#include <atomic>
#include <csignal>
#include <exception>
#include <iostream>
#include <new>
#include <string>

#include "common/progress_line.h"
#include "common/usage_error.h"
#include "common/values.h"
#include "splitsum/base/parallel.h"
#include "splitsum/base/text.h"
#include "splitsum/base/version.h"

namespace splitsum::tools {
namespace {

using Body = std::function<Result<ExitCode>(Progress&)>;

// A signal handler can reach nothing but a global, and set nothing but a lock-free one.
std::atomic<bool> interrupted = false;
static_assert(std::atomic<bool>::is_always_lock_free);

extern "C" void remember_signal(int) { interrupted = true; }

void watch_signals() {
    struct sigaction action {};
    action.sa_handler = remember_signal;
    action.sa_flags = SA_RESTART | static_cast<int>(SA_RESETHAND);
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
    // A file over the process's size limit is an error of write(), which is reported, not a death.
    std::signal(SIGXFSZ, SIG_IGN);
}

struct CommonOptions {
    explicit CommonOptions(CLI::App& app) {
        app.add_option("--threads", threads,
                       "use at most this many threads; 0, the default: all cores")
            ->option_text("COUNT")
            ->check(whole_number(0, 1024));
        app.add_flag("--quiet", quiet, "show no progress");
    }

    int threads = 0;
    bool quiet = false;
};

void complete_help(CLI::App& app) {
    app.set_version_flag("--version", cat(app.get_name(), " ", version), "print the version");
    const std::string example = app.get_footer();
    app.footer(cat(example, example.empty() ? "" : "\n\n", exit_code_help()));
}

int complain(const CLI::App& app, const std::string& message, ExitCode code) {
    std::cerr << cat(app.get_name(), ": ", one_line(message), "\n") << std::flush;
    return static_cast<int>(code);
}

// Results that could not be printed, say to a full disk, are not done.
int finish(const CLI::App& app, ExitCode code) {
    std::cout.flush();
    if (!std::cout)
        return complain(app, "cannot write to the standard output", ExitCode::unwritable_output);
    return static_cast<int>(code);
}

Result<ExitCode> run_guarded(const CommonOptions& common, const Body& body) {
    try {
        const ThreadLimit limit(common.threads);
        ProgressLine progress(progress_style(common.quiet), interrupted);
        return body(progress);
    } catch (const std::bad_alloc&) {
        return Error{ErrorKind::internal,
                     "out of memory; smaller outputs or fewer threads need less of it"};
    } catch (const std::exception& failure) {
        return Error{ErrorKind::internal, cat("a fault of the program: ", failure.what())};
    }
}

}  // namespace

std::string one_line(std::string text) {
    while (!text.empty() && (text.back() == '\n' || text.back() == ' ')) text.pop_back();
    for (size_t i = text.find('\n'); i != std::string::npos; i = text.find('\n', i))
        text.replace(i, 1, "; ");
    return text;
}

int run_tool(CLI::App& app, int argc, char** argv, const Body& body) {
    const CommonOptions common(app);
    complete_help(app);
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& request) {  // --help and --version
        app.exit(request);
        return finish(app, ExitCode::done);
    } catch (const CLI::ParseError& error) {
        return complain(app, usage_message(app, error), ExitCode::bad_arguments);
    }
    watch_signals();
    const Result<ExitCode> result = run_guarded(common, body);
    if (!result) return complain(app, result.error().message, exit_code_of(result.error().kind));
    return finish(app, *result);
}

int run_tool(CLI::App& app, int argc, char** argv, const std::function<Status(Progress&)>& body) {
    return run_tool(app, argc, argv, Body([&](Progress& progress) -> Result<ExitCode> {
                        const Status status = body(progress);
                        if (!status) return status.error();
                        return ExitCode::done;
                    }));
}

}  // namespace splitsum::tools
