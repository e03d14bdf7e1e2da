#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <vector>

#include "splitsum/base/result.h"
#include "splitsum/texture/texture_asset.h"

namespace splitsum {

// Cubemaps as OpenEXR's own environment maps (ImfEnvmap.h, ENVMAP_CUBE): the faces +X -X +Y -Y +Z -Z
// stacked in one image, as OpenEXR turns them, in tiles with real MIP levels. Its side faces are
// mirrored left to right against the KTX layout and its +Y and -Y faces top to bottom; texels are
// moved, never resampled, so that a direction finds the same texel through either library.
//
// Two things to know:
// - OpenEXR places the outermost texel centres of a face on the cube's edges, the KTX layout half a
//   texel inside. Stored texels are samples at the KTX layout's directions; a reader that follows
//   OpenEXR's positions looks up to half a texel beside them.
// - MIP levels halve the width and the height of the stack, so they are cubemaps only while the face
//   size is a power of two, and they end with an image of 1x1 rather than with six texels. Several
//   levels therefore need a power of two; the levels behind the texture's last one, which the format
//   requires, hold plain averages of it. The attribute "splitsum.exr.levels" says how many are ours.
//   A texture with a single level has any size.

/// The bytes of an EXR file with the cubemap: R, G and B as half floats for rgba16f, as floats for
/// rgba32f, ZIP compression, the metadata as text attributes (keys of the KTX format excepted).
/// Fails with bad_argument: not a cubemap, another format, several levels of a size that is not a
/// power of two, a metadata key that OpenEXR uses itself.
Result<std::vector<std::byte>> encode_exr_cube(const TextureAsset& texture);

/// The cubemap in an EXR file, in the KTX layout; rgba16f when R, G and B are half floats, otherwise
/// rgba32f. Other tools' files are read too, with as many levels as hold six whole faces.
/// Fails with unreadable_input or, for an EXR file of another kind, with unusable_input.
Result<TextureAsset> decode_exr_cube(std::span<const std::byte> file);

/// encode_exr_cube into a file, which appears complete or not at all.
Status write_exr_cube(const TextureAsset& texture, const std::filesystem::path& path);

/// decode_exr_cube of a file; messages begin with its path.
Result<TextureAsset> read_exr_cube(const std::filesystem::path& path);

/// Whether a cubemap of that shape can be stored, asked before it is made. Fails with bad_argument.
Status check_exr_cube(const CubeShape& shape);

}  // namespace splitsum
