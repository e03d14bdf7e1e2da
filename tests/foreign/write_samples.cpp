// Writes the files that the tests beside this program read: write_samples FOLDER.

#include <cstdio>
#include <filesystem>
#include <string>

#include "splitsum/base/atomic_file.h"
#include "splitsum/base/text.h"
#include "splitsum/container/containers.h"
#include "unit/container/sample_textures.h"

namespace splitsum {
namespace {

// The colour of a texel is the direction of its centre, brought to [1, 2].
TextureAsset direction_cube(int face_size, int level_count) {
    std::vector<Cubemap> levels;
    for (int level = 0; level < level_count; ++level) {
        Cubemap& sky = levels.emplace_back(face_size >> level);
        for (int face = 0; face < face_count; ++face)
            for (int y = 0; y < sky.face_size; ++y)
                for (int x = 0; x < sky.face_size; ++x)
                    sky.at(face, x, y) =
                        Vec3(1.5 + 0.5 * direction_of_texel(face, x, y, sky.face_size));
    }
    std::vector<EncodeCounts> counts;
    return texture_from_cubemaps(levels, PixelFormat::rgba16f, counts);
}

Status write_ktx2_samples(const std::filesystem::path& folder) {
    for (const PixelFormatInfo& info : pixel_formats()) {
        const bool cube = holds_colours(info);
        const TextureAsset texture = cube ? sample_cube(info.format) : sample_table(info.format);
        const std::string name = cat(cube ? "cube_" : "table_", info.name);
        Status plain = write_texture(texture, folder / (name + ".ktx2"));
        if (!plain) return plain;
        Status zstd =
            write_texture(texture, folder / (name + ".zstd.ktx2"), {.ktx2 = {.zstd = true}});
        if (!zstd) return zstd;
    }
    return ok;
}

Status write_exr_samples(const std::filesystem::path& folder) {
    for (const auto format : {PixelFormat::rgba16f, PixelFormat::rgba32f}) {
        Status status =
            write_texture(sample_cube(format), folder / cat("cube_", info_of(format).name, ".exr"));
        if (!status) return status;
    }
    if (Status status = write_texture(direction_cube(64, 5), folder / "direction.exr"); !status)
        return status;
    return write_texture(sample_table(PixelFormat::rg16f), folder / "table_rg16f.exr");
}

Status write_samples(const std::filesystem::path& folder) {
    if (Status made = make_folder(folder); !made) return made;
    if (Status written = write_ktx2_samples(folder); !written) return written;
    return write_exr_samples(folder);
}

}  // namespace
}  // namespace splitsum

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fprintf(stderr, "usage: write_samples FOLDER\n");
        return 2;
    }
    const splitsum::Status status = splitsum::write_samples(argv[1]);
    if (status) return 0;
    std::fprintf(stderr, "write_samples: %s\n", status.error().message.c_str());
    return 4;
}
