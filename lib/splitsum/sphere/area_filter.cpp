#include "splitsum/sphere/area_filter.h"

#include <algorithm>

#include "splitsum/sphere/area_filter_builder.h"

namespace splitsum {

Result<Cubemap> area_filtered_cubemap(const Environment& environment, int face_size,
                                      const Mat3d& panorama_from_cube, Progress& progress) {
    return area_filtered_cubemap(
        environment,
        std::make_shared<const AreaGeometry>(environment.height(), face_size, panorama_from_cube),
        progress);
}

Result<Cubemap> area_filtered_cubemap(const Environment& environment,
                                      std::shared_ptr<const AreaGeometry> geometry,
                                      Progress& progress) {
    constexpr int band = 64;  // rows between two looks at `progress`
    const int height = environment.height(), steps = face_count * geometry->face_size();
    const size_t row_size = 4 * size_t(environment.width());
    AreaFilterBuilder builder(std::move(geometry));
    int reported = 0;
    for (int row = 0; row < height; row += band) {
        if (progress.cancelled())
            return Error{ErrorKind::interrupted, "interrupted in the mirror level"};
        const int end = std::min(height, row + band);
        builder.add_rows(end - row, environment.texels().data() + size_t(row) * row_size, 4);
        const int done = int(int64_t(steps) * end / height);
        progress.advance(done - reported);
        reported = done;
    }
    return std::move(builder).finish();
}

}  // namespace splitsum
