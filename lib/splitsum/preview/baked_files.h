#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "splitsum/base/result.h"
#include "splitsum/preview/baked_light.h"
#include "splitsum/report/asset_facts.h"
#include "splitsum/report/certificate.h"

namespace splitsum {

/// The files that light is looked up in.
struct BakedFiles {
    std::filesystem::path specular;
    std::filesystem::path irradiance;  ///< a cubemap, or harmonics as .json
    std::filesystem::path table;
};

/// Those of a folder that splitsum-bake wrote: specular.ktx2, irradiance.ktx2, and the nearest
/// brdf.ktx2 in the folder or up to four above it. Nothing is opened; what is not there keeps the
/// name that it should have.
BakedFiles files_of_bake(const std::filesystem::path& folder);

/// The assets in them, as an engine holds them.
struct BakedAssets {
    BakedLight light;
    AssetFacts facts;                        ///< of the specular chain
    std::optional<Certificate> certificate;  ///< of the specular chain, where it has one
    std::vector<std::string> notes;          ///< what people should know, a sentence each
};

/// Reads the files in any container and format; the stored conventions come from their metadata.
/// Irradiance stored as E is divided by pi, harmonics are evaluated at the texels of a 64² cubemap. Tables
/// `ggx` and `ggx-multiscatter` are brought into the arrangement that look_up() reads where that
/// changes no value between texels: texels at centres, perceptual roughness.
///
/// Fails with unreadable_input, or with unusable_input where a file is not what it should be or does
/// not say what it is; the message says what would work.
Result<BakedAssets> read_baked(const BakedFiles& files);

}  // namespace splitsum
