#pragma once

#include <CLI/CLI.hpp>

#include <optional>

namespace splitsum::tools {

/// --verify, --no-verify and --probes: whether stored texels are measured, and how many.
struct VerifyOptions {
    explicit VerifyOptions(CLI::App& app);
    VerifyOptions(const VerifyOptions&) = delete;

    /// Texels a level: 0 for none, nothing where the light decides (default_probes).
    std::optional<int> probes() const;

private:
    bool verify_ = true;
    std::optional<int> probes_;
};

}  // namespace splitsum::tools
