#pragma once

#include <filesystem>
#include <span>
#include <string_view>

#include "splitsum/base/result.h"
#include "splitsum/container/ktx2.h"
#include "splitsum/texture/texture_asset.h"

namespace splitsum {

/// What the containers can be told; each reads its own part.
struct ContainerOptions {
    Ktx2Options ktx2;
};

/// One kind of file that holds a texture.
struct Container {
    std::string_view extension;  ///< with its dot, in lower case
    std::string_view summary;    ///< one line for --help
    bool keeps_metadata;         ///< or drops TextureAsset::metadata when writing
    Status (*write)(const TextureAsset& texture, const std::filesystem::path& path,
                    const ContainerOptions& options);
    Result<TextureAsset> (*read)(const std::filesystem::path& path);
    /// Whether it can hold such a cubemap, asked before the work. Fails with bad_argument.
    Status (*check_cube)(const CubeShape& shape);
};

/// Every container; one line each.
std::span<const Container> containers();

/// The container of a path, found by its extension in upper or lower case. Fails with bad_argument,
/// listing what works.
Result<Container> container_of(const std::filesystem::path& path);

/// Writes the texture to `path`, whole or not at all, in the container of its extension.
Status write_texture(const TextureAsset& texture, const std::filesystem::path& path,
                     const ContainerOptions& options = {});

/// Reads a texture in the container of the path's extension.
Result<TextureAsset> read_texture(const std::filesystem::path& path);

}  // namespace splitsum
