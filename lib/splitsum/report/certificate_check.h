#pragma once

#include <span>
#include <string>
#include <vector>

#include "splitsum/report/asset_facts.h"
#include "splitsum/report/certificate.h"
#include "splitsum/sphere/cubemap.h"
#include "splitsum/texture/texture_asset.h"
#include "splitsum/verify/check_levels.h"

namespace splitsum {

/// The figures of a specular chain or an irradiance cubemap beside the exact texels of its levels;
/// of none if `exact` is empty, where mean radiances are all that is found.
std::vector<LevelCheck> check_asset(std::span<const Cubemap> levels, const AssetFacts& facts,
                                    std::span<const ExactTexels> exact);

/// What keeps a cubemap from being what it was certified to be, found in the texture alone: a
/// sentence each, none where the certificate holds. A cubemap without certificate, facts or
/// readable texels does not hold. Cost: decodes and hashes the texels.
std::vector<std::string> broken_certificate(const TextureAsset& texture);

}  // namespace splitsum
