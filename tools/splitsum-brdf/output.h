#pragma once

#include <CLI/CLI.hpp>

#include <filesystem>
#include <string>

#include "common/options.h"
#include "splitsum/assets/table_asset.h"

namespace splitsum::tools {

/// The endings that a table can be written with: ".ktx2, .exr, .dds, .hpp, .glsl or .json".
std::string table_endings();

/// --preview.
struct PreviewOption {
    explicit PreviewOption(CLI::App& app);
    PreviewOption(const PreviewOption&) = delete;

    std::filesystem::path path() const { return path_; }

private:
    std::string path_;
};

/// Where a table goes: a texture container or source, and perhaps a picture.
struct TableOutput {
    std::filesystem::path path;
    std::filesystem::path preview;  ///< none if empty
    const EncodingOptions& encoding;

    /// What can be known before the work. Fails with bad_argument or unwritable_output.
    Status check(const TablePlan& plan) const;

    /// How texels are stored: --format, else floats for source, else half floats.
    PixelFormat format(const TablePlan& plan) const;

    Status write(const TableAsset& asset) const;
};

/// One line for people, or a JSON object.
void print_table(const TableAsset& asset, const TableOutput& output, bool json);

}  // namespace splitsum::tools
