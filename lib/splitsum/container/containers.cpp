#include "splitsum/container/containers.h"

#include <algorithm>
#include <string>

#include "splitsum/base/text.h"
#include "splitsum/container/dds.h"
#include "splitsum/container/exr.h"
#include "splitsum/container/exr_cube.h"

namespace splitsum {
namespace {

constexpr Container table[] = {
    {".ktx2", "KTX 2: any format, as engines load it", true,
     [](const TextureAsset& texture, const std::filesystem::path& path,
        const ContainerOptions& options) { return write_ktx2(texture, path, options.ktx2); },
     read_ktx2, [](const CubeShape&) -> Status { return ok; }},
    {".exr", "OpenEXR: cube-face environment maps with MIP levels, tables; half floats and floats",
     true,
     [](const TextureAsset& texture, const std::filesystem::path& path, const ContainerOptions&) {
         return write_exr(texture, path);
     },
     read_exr, check_exr_cube},
    {".dds", "DDS: any format, for engines that read no KTX 2; keeps no metadata", false,
     [](const TextureAsset& texture, const std::filesystem::path& path, const ContainerOptions&) {
         return write_dds(texture, path);
     },
     read_dds, [](const CubeShape&) -> Status { return ok; }},
};

std::string lower_case(std::string text) {
    std::ranges::transform(text, text.begin(), [](char letter) {
        return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
    });
    return text;
}

}  // namespace

std::span<const Container> containers() { return table; }

Result<Container> container_of(const std::filesystem::path& path) {
    const auto found =
        std::ranges::find(table, lower_case(path.extension().string()), &Container::extension);
    if (found != std::end(table)) return *found;
    return Error{ErrorKind::bad_argument,
                 cat("no kind of texture file ends as ", path.string(), " does; there are: ",
                     join(table, ", ", [](const Container& known) { return known.extension; }))};
}

Status write_texture(const TextureAsset& texture, const std::filesystem::path& path,
                     const ContainerOptions& options) {
    const auto container = container_of(path);
    if (!container) return container.error();
    return container->write(texture, path, options);
}

Result<TextureAsset> read_texture(const std::filesystem::path& path) {
    const auto container = container_of(path);
    if (!container) return container.error();
    return container->read(path);
}

}  // namespace splitsum
