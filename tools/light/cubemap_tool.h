#pragma once

#include <CLI/CLI.hpp>

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "common/options.h"
#include "light/verify_options.h"
#include "splitsum/assets/cubemap_asset.h"
#include "splitsum/bake/light.h"
#include "splitsum/brdf/lobe.h"
#include "splitsum/container/containers.h"
#include "splitsum/filter/asset_levels.h"
#include "splitsum/panorama/panorama.h"
#include "splitsum/sphere/environment.h"
#include "splitsum/verify/check_levels.h"
#include "splitsum/verify/reconstruction.h"

// What the tools that turn a panorama into one cubemap have in common.

namespace splitsum::tools {

/// The rows of filter_methods() that filter such a lobe, for --method.
std::vector<Choice> methods_for(LobeKind kind);

/// --output, --verify, --probes, --json of a tool whose output is a cubemap.
class CubemapOutputOptions {
public:
    CubemapOutputOptions(CLI::App& app, const std::string& what);
    CubemapOutputOptions(const CubemapOutputOptions&) = delete;

    const std::filesystem::path& path() const { return path_; }

    /// Whether such a cubemap can be written, asked before the work. Fails with bad_argument (unknown
    /// ending, a shape that this kind of file cannot hold) or unwritable_output.
    Status check(const CubeShape& shape) const;

    /// Measures what will be stored, certifies it in the file's metadata, writes the file and prints
    /// the figures. The asset is one that `plan` makes of the light.
    Status measure_and_write(CubemapAsset asset, const std::vector<LevelAccount>& accounts,
                             const Light& light, const LevelsPlan& plan,
                             const ContainerOptions& container, Progress& progress) const;

    /// Prints notes, figures and where the file is, as text or as JSON.
    void print(const std::vector<LevelCheck>& checks, const std::vector<LevelAccount>& accounts,
               const std::vector<EncodeCounts>& counts, const Light& light) const;

    /// Texels a level to measure, if that was asked.
    std::optional<int> probes() const { return verify_.probes(); }

private:
    std::filesystem::path path_;
    VerifyOptions verify_;
    bool json_ = false;
};

/// check_asset at probes of the environment that the asset was made from; of none for 0 probes.
Result<std::vector<LevelCheck>> check_cubemap_asset(const std::vector<Cubemap>& levels,
                                                    const AssetFacts& facts,
                                                    const Environment& environment, int probes,
                                                    Progress& progress);

/// What an engine reads between texels and levels of a chain, against exact integration at `probes`
/// places in each of roughness_bands(); nothing of other assets. Fails only when cancelled.
Result<std::vector<ReconstructionError>> check_readings(const std::vector<Cubemap>& levels,
                                                        const AssetFacts& facts,
                                                        const Environment& environment, int probes,
                                                        Progress& progress);

}  // namespace splitsum::tools
