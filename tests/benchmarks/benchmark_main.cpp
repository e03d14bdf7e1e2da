#include "benchmark_main.h"

#include <benchmark/benchmark.h>
#include <unistd.h>

#include <vector>

namespace {

using splitsum::benchmarks::ForEachFile;

std::vector<ForEachFile::Register>& registrations() {
    static std::vector<ForEachFile::Register> list;
    return list;
}

// The console as ever, and a note of whether a benchmark found its own result wrong: Google
// Benchmark prints such errors and exits with 0 all the same.
class StrictReporter final : public benchmark::ConsoleReporter {
public:
    StrictReporter() : ConsoleReporter(isatty(STDOUT_FILENO) ? OO_ColorTabular : OO_Tabular) {}

    void ReportRuns(const std::vector<Run>& runs) override {
        for (const Run& run : runs) failed_ = failed_ || run.error_occurred;
        ConsoleReporter::ReportRuns(runs);
    }
    bool failed() const { return failed_; }

private:
    bool failed_ = false;
};

}  // namespace

ForEachFile::ForEachFile(Register register_benchmarks) {
    registrations().push_back(register_benchmarks);
}

int main(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    if (registrations().empty() && benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
    for (int i = 1; i < argc; ++i)
        for (const auto register_benchmarks : registrations()) register_benchmarks(argv[i]);
    StrictReporter reporter;
    const size_t run_count = benchmark::RunSpecifiedBenchmarks(&reporter);
    benchmark::Shutdown();
    return reporter.failed() || run_count == 0 ? 1 : 0;
}
