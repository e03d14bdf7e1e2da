#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "splitsum/base/result.h"
#include "splitsum/image/image.h"
#include "splitsum/preview/baked_light.h"
#include "splitsum/preview/camera.h"
#include "splitsum/preview/picture.h"
#include "splitsum/preview/scene.h"
#include "splitsum/preview/view.h"

namespace splitsum {

/// Figures that a page lists. All of it is plain text.
struct PageTable {
    std::string heading;
    std::string note;                            ///< one or two sentences below the heading
    std::vector<std::string> columns;            ///< the first names the row
    std::vector<std::vector<std::string>> rows;  ///< each as long as `columns`
};

/// The same spheres by exact integration.
struct PageTruth {
    const Image* picture = nullptr;  ///< scene-linear, of the page's scene and viewpoint
    double least_luminance = 0;      ///< as in difference.h
    std::string note;                ///< how it was made and how noisy it is
};

/// What a page shows. Names may hold any characters.
struct Page {
    std::string title;
    const BakedLight* light = nullptr;
    Scene scene;
    std::string scene_note;  ///< what the spheres are, in a sentence
    Viewpoint viewpoint;     ///< where it begins; its shape is that of the picture
    Background background = Background::light;  ///< where it begins, as the next two
    double exposure_stops = 0;
    std::string view;                 ///< of views(), or the name of `more_view`
    const View* more_view = nullptr;  ///< beside those of views()
    std::optional<PageTruth> truth;   ///< to be compared with
    std::string no_truth;             ///< else why not, and what would help; a sentence
    std::vector<PageTable> tables;
    std::vector<std::string> notes;
};

/// One HTML file that shows the light as shaders/runtime/image_based_light.frag does, in WebGL 2: it opens
/// from disk, loads nothing, and works without a network. Orbit, objects, exposure, views, levels and
/// the table, and baked light beside the truth; page/README.md has all of it.
///
/// Texels travel as page_texels.h says, so the text has about 1.4 times the bytes of what was stored:
/// 5.6 MB for 256² in half floats with a table of 512², and 4.2 MB more for a truth of 1024 x 512.
///
/// Fails as View::find does.
Result<std::string> page_text(const Page& page);

/// Writes it, whole or not at all. Fails with unwritable_output too.
Status write_page(const Page& page, const std::filesystem::path& path);

}  // namespace splitsum
