// batch [--threads COUNT...] [--memory MEGABYTES] [--rounds COUNT] PANORAMA...
//
// Bakes all of the panoramas, many at a time, with each number of threads in turn: panoramas a
// second, how near that is to so many times the rate of the first number (as a rule 1), and the
// most memory that was ever resident. The results go to a folder that is removed.

#include <sys/resource.h>
#include <unistd.h>

#include <charconv>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <mutex>
#include <string>
#include <vector>

#include "splitsum/bake/bake.h"
#include "splitsum/base/parallel.h"
#include "splitsum/base/text.h"
#include "splitsum/library/memory_of_bake.h"
#include "splitsum/schedule/schedule.h"

namespace {

namespace fs = std::filesystem;
using namespace splitsum;

struct Batch {
    std::vector<int> threads = {1, ThreadLimit::available()};
    std::optional<int64_t> memory;  // bytes of the whole process
    int rounds = 1;
    std::vector<std::string> panoramas;
};

// A line of /proc/self/status in bytes, 0 where there is no such file.
int64_t status_bytes(const char* name) {
    int64_t kilobytes = 0;
    char line[256];
    std::FILE* const status = std::fopen("/proc/self/status", "r");
    while (status && std::fgets(line, sizeof line, status))
        if (std::strncmp(line, name, std::strlen(name)) == 0)
            kilobytes = std::atoll(line + std::strlen(name) + 1);
    if (status) std::fclose(status);
    return kilobytes * 1024;
}

void forget_peak() {
    if (std::FILE* const file = std::fopen("/proc/self/clear_refs", "w")) {
        std::fputs("5", file);
        std::fclose(file);
    }
}

double cpu_seconds() {
    rusage used{};
    getrusage(RUSAGE_SELF, &used);
    const auto seconds = [](const timeval& time) {
        return double(time.tv_sec) + 1e-6 * double(time.tv_usec);
    };
    return seconds(used.ru_utime) + seconds(used.ru_stime);
}

// What all bakes together may allocate.
std::optional<int64_t> budget_of(const Batch& batch) {
    if (!batch.memory) return std::nullopt;
    return *batch.memory - status_bytes("VmRSS") - memory_of_shared_tables;
}

// The message if the panorama cannot be baked.
std::string bake_one(const std::string& panorama, const std::shared_ptr<FilterTables>& tables,
                     const fs::path& folder) {
    NoProgress quiet;
    const BakePlan plan;
    const auto light = load_light(panorama, {}, light_use(plan, tables), quiet);
    if (!light) return light.error().message;
    const auto report = bake(*light, plan, folder, quiet);
    return report ? "" : report.error().message;
}

// Bakes them all; the messages of those that failed.
std::vector<std::string> bake_all(const Batch& batch, int threads, const fs::path& folder) {
    const auto tables = std::make_shared<FilterTables>();
    std::mutex mutex;
    std::vector<std::string> failures;
    std::vector<Job> jobs;
    for (size_t i = 0; i < batch.panoramas.size(); ++i) {
        const std::string& panorama = batch.panoramas[i];
        const auto size = panorama_size(panorama, {});
        const int64_t bytes = size ? memory_of_bake(*size, {}, threads) : 0;
        jobs.push_back({bytes, [&, i] {
                            const std::string failure =
                                bake_one(panorama, tables, folder / std::to_string(i));
                            const std::lock_guard lock(mutex);
                            if (!failure.empty()) failures.push_back(failure);
                        }});
    }
    const Status run = run_jobs(std::move(jobs), {threads, budget_of(batch)}, NoProgress());
    if (!run) failures.push_back(run.error().message);
    return failures;
}

// Panoramas a second.
double measure(const Batch& batch, int threads, double first_rate) {
    const fs::path folder = fs::temp_directory_path() / cat("splitsum_batch_", getpid());
    const ThreadLimit limit(threads);
    forget_peak();
    const double cpu_before = cpu_seconds();
    const auto start = std::chrono::steady_clock::now();
    const auto failures = bake_all(batch, threads, folder);
    const double seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    fs::remove_all(folder);
    for (const std::string& failure : failures)
        std::fprintf(stderr, "batch: %s\n", failure.c_str());
    if (!failures.empty()) return 0;
    const double rate = double(batch.panoramas.size()) / seconds;
    std::printf("%3d threads  %7.2f s  %6.2f cpu s  %7.3f panoramas/s", threads, seconds,
                cpu_seconds() - cpu_before, rate);
    if (first_rate > 0)
        std::printf("  %5.2f of the ideal", rate * batch.threads[0] / (threads * first_rate));
    std::printf("  %6.0f MiB\n", double(status_bytes("VmHWM")) / (1 << 20));
    std::fflush(stdout);
    return rate;
}

int number(const char* text) {
    int value = 0;
    std::from_chars(text, text + std::strlen(text), value);
    return value;
}

Batch parsed(int argc, char** argv) {
    Batch batch;
    for (int i = 1; i < argc; ++i) {
        const std::string argument = argv[i];
        const bool has_value = i + 1 < argc;
        if (argument == "--rounds" && has_value)
            batch.rounds = number(argv[++i]);
        else if (argument == "--memory" && has_value)
            batch.memory = int64_t{number(argv[++i])} << 20;
        else if (argument == "--threads" && has_value)
            for (batch.threads.clear(); i + 1 < argc && number(argv[i + 1]) > 0;)
                batch.threads.push_back(number(argv[++i]));
        else
            batch.panoramas.push_back(argument);
    }
    return batch;
}

}  // namespace

int main(int argc, char** argv) {
    const Batch batch = parsed(argc, argv);
    if (batch.panoramas.empty() || batch.threads.empty()) {
        std::fprintf(stderr,
                     "usage: batch [--threads COUNT...] [--memory MEGABYTES] "
                     "[--rounds COUNT] PANORAMA...\n");
        return 2;
    }
    for (int round = 0; round < batch.rounds; ++round) {
        double first_rate = 0;
        for (const int threads : batch.threads) {
            const double rate = measure(batch, threads, first_rate);
            if (rate == 0) return 1;
            if (first_rate == 0) first_rate = rate;
        }
    }
    return 0;
}
