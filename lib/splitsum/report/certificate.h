#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "splitsum/base/result.h"
#include "splitsum/filter/methods.h"
#include "splitsum/texture/texture_asset.h"
#include "splitsum/verify/check_levels.h"

namespace splitsum {

/// What a cubemap's file promises of one level.
struct CertifiedLevel {
    double error_bound = 0;        ///< of rel_rms, by theory; 0 where theory has none
    int64_t clamped_negative = 0;  ///< channel values below 0 that were set to 0
    int64_t saturated = 0;         ///< channel values above what the format holds
    Vec3d mean_radiance{0};        ///< over the stored level
    ErrorFigures figures;          ///< at `figures.texels` probes; of 0 texels if not measured
};

/// A summary of the report that travels in the file, under the keys splitsum.certificate.*: one key
/// a figure, in it one number a level, level 0 first. lib/README.md lists them.
struct Certificate {
    Vec3d source_mean_radiance{0};  ///< of the panorama
    std::vector<CertifiedLevel> levels;
    std::string hash;  ///< as certificate_hash
};

/// What is to be promised of levels that were made, encoded and measured so; without a hash.
Certificate certificate_from(std::span<const LevelAccount> accounts,
                             std::span<const EncodeCounts> counts,
                             std::span<const LevelCheck> checks, const Vec3d& source_mean_radiance);

/// "xxh3-128:" and the hash of the texels as they are stored (decompressed, level 0 first, as
/// TextureAsset::levels), then of every other "splitsum." key and its value, in order, each ending
/// with a NUL. It is the same in every container.
std::string certificate_hash(const TextureAsset& texture);

/// Writes the certificate into the texture's metadata, sealed by its hash. To be called last.
void certify(TextureAsset& texture, const Certificate& certificate);

/// The certificate in the metadata; nothing where the file has none. Fails with unusable_input where
/// a key is missing or cannot be read.
Result<std::optional<Certificate>> certificate_of(
    const std::map<std::string, std::string>& metadata);

/// Whether the certificate is true of the texture, a sentence for each thing that is not: its hash;
/// the mean radiance of each level to 1e-6; and the figures to 1e-3 of them and 1e-6, where `found`
/// has as many probes as were certified (instruction sets differ by less).
std::vector<std::string> contradictions(const Certificate& certificate, const TextureAsset& texture,
                                        std::span<const LevelCheck> found);

}  // namespace splitsum
