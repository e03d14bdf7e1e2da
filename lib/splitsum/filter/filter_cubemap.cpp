#include "splitsum/filter/filter_cubemap.h"

#include <vector>

#include "splitsum/base/parallel.h"

namespace splitsum {

int64_t clamp_negative(std::span<Vec3> texels) {
    int64_t clamped = 0;
    for (Vec3& texel : texels)
        for (int c = 0; c < 3; ++c)
            if (texel[c] < 0) {
                texel[c] = 0;
                ++clamped;
            }
    return clamped;
}

Result<FilteredCubemap> filter_cubemap(const PreparedFilter& filter, size_t lobe_index,
                                       int face_size, const Mat3d& panorama_from_cube,
                                       uint32_t first_key, Progress& progress) {
    FilteredCubemap result{Cubemap(face_size), filter.account(lobe_index)};
    result.account.clamped_negative = ordered_sum(face_count * face_size, [&](int row) -> int64_t {
        if (progress.cancelled()) return 0;
        const int face = row / face_size, y = row % face_size;
        std::vector<Vec3d> towards;
        for (int x = 0; x < face_size; ++x)
            towards.push_back(panorama_from_cube * direction_of_texel(face, x, y, face_size));
        const uint32_t key = first_key + uint32_t(row) * uint32_t(face_size);
        const auto texels = result.cubemap.row(face, y);
        filter.evaluate(lobe_index, {towards, key}, texels);
        progress.advance(1);
        return clamp_negative(texels);
    });
    if (progress.cancelled()) return Error{ErrorKind::interrupted, "interrupted while filtering"};
    return result;
}

}  // namespace splitsum
