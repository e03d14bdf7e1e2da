#pragma once

#include <CLI/CLI.hpp>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "common/options.h"
#include "plan_options.h"
#include "splitsum/library/shard.h"

namespace splitsum::tools {

/// Which panoramas: PANORAMA, --include, --exclude, --manifest, --shard.
struct SourceOptions {
    explicit SourceOptions(CLI::App& app);
    SourceOptions(const SourceOptions&) = delete;

    std::vector<std::string> inputs;  ///< files and folders
    std::vector<std::string> include;
    std::vector<std::string> exclude;
    std::string manifest;  ///< "" if there is none
    Shard shard;
};

/// What is redone, and what is spent on it: --force, --dry-run, --merge, --memory, --cache,
/// --cache-size.
struct EffortOptions {
    explicit EffortOptions(CLI::App& app);
    EffortOptions(const EffortOptions&) = delete;

    bool force = false;
    bool dry_run = false;
    bool merge = false;
    std::optional<int64_t> memory;  ///< bytes of the whole process
    std::string cache;              ///< "" if there is none
    int64_t cache_bytes = int64_t(10) << 30;
};

/// What is told to other programs: --json, --events, --depfile, --depfile-target.
struct TellingOptions {
    explicit TellingOptions(CLI::App& app);
    TellingOptions(const TellingOptions&) = delete;

    bool json = false;
    std::string events;   ///< "" for none
    std::string depfile;  ///< "" for none
    std::string depfile_target;
};

/// Every option of splitsum-bake but those that all programs have.
struct BakeOptions {
    explicit BakeOptions(CLI::App& app);
    BakeOptions(const BakeOptions&) = delete;

    SourceOptions source;
    OutputOptions output;
    EffortOptions effort;
    TellingOptions telling;
    PlanOptions asset;
    TableOptions table;
};

/// Whether the options make sense together. Fails with bad_argument.
Status check_together(const BakeOptions& options);

}  // namespace splitsum::tools
