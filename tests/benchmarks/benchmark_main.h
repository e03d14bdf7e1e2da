#pragma once

namespace splitsum::benchmarks {

/// A static object of this class has benchmark_main call `register_benchmarks` for each file that is
/// named on the command line, before the benchmarks run.
struct ForEachFile {
    using Register = void (*)(const char* path);
    explicit ForEachFile(Register register_benchmarks);
};

}  // namespace splitsum::benchmarks
