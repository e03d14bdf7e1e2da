#include "splitsum/filter/filter_cubemap.h"

#include <vector>

#include "splitsum/base/parallel.h"

namespace splitsum {

Result<Cubemap> filter_cubemap(const PreparedFilter& filter, size_t lobe_index, int face_size,
                               const Mat3d& panorama_from_cube, uint32_t first_key,
                               Progress& progress) {
    Cubemap cubemap(face_size);
    parallel_rows(face_count * face_size, [&](int row) {
        if (progress.cancelled()) return;
        const int face = row / face_size, y = row % face_size;
        std::vector<Vec3d> towards;
        for (int x = 0; x < face_size; ++x)
            towards.push_back(panorama_from_cube * direction_of_texel(face, x, y, face_size));
        const uint32_t key = first_key + uint32_t(row) * uint32_t(face_size);
        filter.evaluate(lobe_index, {towards, key}, cubemap.row(face, y));
        progress.advance(1);
    });
    if (progress.cancelled()) return Error{ErrorKind::interrupted, "interrupted while filtering"};
    return cubemap;
}

}  // namespace splitsum
