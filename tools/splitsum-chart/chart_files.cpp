#include "chart_files.h"

#include <fstream>
#include <iterator>
#include <utility>
#include <vector>

#include "plotter.h"
#include "splitsum/base/atomic_file.h"
#include "splitsum/base/staged_folder.h"
#include "splitsum/chart/chart_csv.h"
#include "splitsum/chart/chart_json.h"
#include "splitsum/chart/chart_page.h"
#include "splitsum/chart/gnuplot_script.h"

namespace splitsum::tools {
namespace {

namespace fs = std::filesystem;

Status write_tables(const Chart& chart, const fs::path& folder) {
    for (const auto& [name, text] :
         {std::pair("chart.csv", chart_csv(chart)), std::pair("storage.csv", storage_csv(chart)),
          std::pair("chart.json", chart_json(chart)),
          std::pair("chart.gnuplot", gnuplot_script(chart))})
        if (const Status written = write_text_whole(folder / name, text); !written) return written;
    return ok;
}

// Takes the pictures of single panels out of the folder: the page carries them, and without all of
// them it carries none.
std::vector<InlinedPicture> take_pictures(const Chart& chart, const fs::path& folder,
                                          bool complete) {
    std::vector<InlinedPicture> pictures;
    for (const PanelPicture& picture : panel_pictures(chart)) {
        std::ifstream file(folder / picture.file, std::ios::binary);
        pictures.push_back({{std::istreambuf_iterator<char>(file), {}}, picture.caption});
        file.close();
        std::error_code ignored;
        fs::remove(folder / picture.file, ignored);
    }
    if (!complete) pictures.clear();
    return pictures;
}

}  // namespace

Result<std::string> write_chart_files(const Chart& chart, const fs::path& folder) {
    auto staged = StagedFolder::create(folder);
    if (!staged) return staged.error();
    if (const Status written = write_tables(chart, staged->path()); !written)
        return written.error();
    const Status plotted = run_gnuplot("chart.gnuplot", staged->path());
    const std::string missing = plotted ? "" : plotted.error().message;
    const auto pictures = take_pictures(chart, staged->path(), bool(plotted));
    const Status written =
        write_text_whole(staged->path() / "chart.html", chart_page(chart, pictures, missing));
    if (!written) return written.error();
    if (const Status published = staged->publish("chart.html"); !published)
        return published.error();
    return missing;
}

}  // namespace splitsum::tools
