#pragma once

#include <filesystem>

#include "splitsum/base/result.h"
#include "splitsum/filter/irradiance_harmonics.h"
#include "splitsum/report/asset_facts.h"

namespace splitsum {

/// Writes the coefficients in the form that the ending of `path` asks for:
/// .json: everything, with the basis and where the light came from;
/// .txt:  a line of red, green, blue for each coefficient, after a comment that names the basis;
/// .glsl: a function `vec3 splitsum_irradiance(vec3 n)` with the constants of the basis folded in
///        (bands up to 4, written as polynomials of x, y, z).
/// The file appears whole or not at all. Fails with bad_argument for other endings and for a
/// .glsl of an order above 4, and with unwritable_output.
Status write_harmonics(const IrradianceHarmonics& harmonics, const AssetFacts& facts,
                       const std::filesystem::path& path);

struct HarmonicsFile {
    IrradianceHarmonics harmonics;
    AssetFacts facts;
};

/// Reads the .json form. Fails with unreadable_input or unusable_input.
Result<HarmonicsFile> read_harmonics(const std::filesystem::path& path);

}  // namespace splitsum
