#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "splitsum/manifest/known_option.h"
#include "splitsum/manifest/problems_detail.h"
#include "splitsum/manifest/setting.h"
#include "splitsum/manifest/value_detail.h"

namespace splitsum {

/// Reads keys as settings, against the options that there are.
class SettingReader {
public:
    /// Where a key stands decides which options it may name.
    enum class Table { defaults, panorama };

    /// Of the manifest `file`. All arguments must outlive the reader; `other_keys` are what tables
    /// of panoramas may hold beside settings, for suggestions.
    SettingReader(std::span<const KnownOption> options, std::span<const std::string> other_keys,
                  const std::filesystem::path& file, Problems& problems);

    /// Adds the setting that `member` makes to `settings`, or what is wrong to the problems.
    void read(const ManifestValue& member, Table table, std::vector<Setting>& settings) const;

    /// Whether an option holds for the whole run.
    bool is_for_run(const Setting& setting) const;

private:
    const KnownOption* find(const std::string& name) const;
    std::string unknown_key(const std::string& key, Table table) const;
    std::string wrong_place(const KnownOption& option, Table table) const;

    std::span<const KnownOption> options_;
    std::span<const std::string> other_keys_;
    const std::filesystem::path& file_;
    Problems& problems_;
};

/// "there is no 'sise' here; did you mean size?", or what there is.
std::string no_such_key(const std::string& key, std::span<const std::string> names);

}  // namespace splitsum
