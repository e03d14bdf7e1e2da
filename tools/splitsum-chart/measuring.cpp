#include "measuring.h"

#include <iostream>

#include "atlas_option.h"
#include "chart_files.h"
#include "common/values.h"
#include "splitsum/base/staged_folder.h"
#include "splitsum/base/text.h"
#include "splitsum/chart/chart.h"

namespace splitsum::tools {
namespace {

ChartJob job_of(const ChartOptions& options) {
    ChartJob job;
    for (const std::string& panorama : options.panoramas) job.panoramas.emplace_back(panorama);
    job.reading = options.reading.plan();
    job.quick = options.quick;
    job.plan = options.quick ? quick_chart_plan() : full_chart_plan();
    return job;
}

// Asked before minutes of work: made now, and taken back if nothing comes of it.
Status check_folder(const std::filesystem::path& folder) {
    const auto staged = StagedFolder::create(folder);
    if (!staged) return staged.error();
    return ok;
}

size_t rows_of(const Chart& chart) {
    size_t rows = 0;
    for (const MeasuredPanel& panel : chart.panels) rows += panel.rows.size();
    return rows;
}

}  // namespace

ChartOptions::ChartOptions(CLI::App& app)
    : reading(app), output(app, "DIR", "folder for the chart (required)") {
    app.add_option("PANORAMA", panoramas, "2:1 lat-long images: .exr, .hdr, .tif, .pfm, ...")
        ->option_text("...")
        ->check(not_empty());
    app.add_flag("--atlas", atlas,
                 "instead, without panoramas: the cases at which methods fail, what each\n"
                 "method makes of them and what the tools do about them, as atlas.html,\n"
                 "atlas.json and atlas.csv; half a minute, for example: --atlas -o atlas");
    app.add_flag("--quick", quick, "smaller ladders and assets: half a minute a panorama");
}

Result<ExitCode> run_chart(const ChartOptions& options, Progress& progress) {
    if (options.atlas) return run_atlas_option(options, progress);
    if (options.panoramas.empty())
        return Error{
            ErrorKind::bad_argument,
            "PANORAMA is required: a 2:1 image, for example test_data/panoramas/sunset.exr"};
    const std::filesystem::path folder = options.output.path();
    if (const Status possible = check_folder(folder); !possible) return possible.error();
    const auto chart = measure_chart(job_of(options), progress);
    if (!chart) return chart.error();
    const auto missing = write_chart_files(*chart, folder);
    if (!missing) return missing.error();
    if (!missing->empty()) std::cout << "note: " << *missing << "\n";
    std::cout << (folder / "chart.html").string() << "\n";
    if (!chart->complete)
        return Error{ErrorKind::interrupted,
                     cat("interrupted; ", folder.string(), " has the ", rows_of(*chart),
                         " rows that were measured until then")};
    return ExitCode::done;
}

}  // namespace splitsum::tools
