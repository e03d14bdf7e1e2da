#pragma once

#include <CLI/CLI.hpp>

#include <filesystem>
#include <string>

#include "common/options.h"
#include "results.h"
#include "splitsum/base/result.h"
#include "splitsum/preview/baked_files.h"
#include "splitsum/preview/page.h"

namespace splitsum::tools {

/// --html.
struct PageOption {
    explicit PageOption(CLI::App& app);
    PageOption(const PageOption&) = delete;

    std::string file;  ///< "" for no page
};

/// A page of the light: its figures are those that `results` measured, or else those that the chain's
/// file certifies. What is drawn (scene, viewpoint, exposure, view, truth) is left to the caller.
Page page_of(const BakedAssets& baked, const PreviewResults& results);

}  // namespace splitsum::tools
