#include <benchmark/benchmark.h>
#include <unistd.h>

namespace {

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

int main(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
    StrictReporter reporter;
    const size_t run_count = benchmark::RunSpecifiedBenchmarks(&reporter);
    benchmark::Shutdown();
    return reporter.failed() || run_count == 0 ? 1 : 0;
}
