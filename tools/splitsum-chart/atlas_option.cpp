#include "atlas_option.h"

#include <iostream>

#include "splitsum/atlas/make_atlas.h"
#include "splitsum/base/text.h"

namespace splitsum::tools {

Result<ExitCode> run_atlas_option(const ChartOptions& options, Progress& progress) {
    if (!options.panoramas.empty())
        return Error{ErrorKind::bad_argument,
                     cat("--atlas makes its own panoramas, but ", options.panoramas.front(),
                         " was named; leave one of the two out")};
    AtlasPlan plan;
    if (options.quick) {
        plan.sky_rows = 16;
        plan.face_size = 4;
        plan.many_rows = 512;
    }
    const std::filesystem::path folder = options.output.path();
    const auto atlas = make_atlas(plan, folder, progress);
    if (!atlas) return atlas.error();
    std::cout << (folder / "atlas.html").string() << "\n";
    return ExitCode::done;
}

}  // namespace splitsum::tools
