#include "run_merge.h"

#include <algorithm>
#include <iomanip>
#include <iostream>
#include <nlohmann/json.hpp>

#include "common/run_tool.h"
#include "splitsum/base/text.h"
#include "splitsum/library/merge.h"

namespace splitsum::tools {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

std::string folder_of(const JobList& list, size_t job, const fs::path& folder) {
    return (folder / list.jobs[job].panorama.name).string();
}

void print_json(const MergeCheck& check, const JobList& list, const fs::path& folder) {
    Json json = {{"complete", check.holds()},
                 {"panoramas", list.jobs.size()},
                 {"bytes", check.bytes},
                 {"problems", Json::array()}};
    for (const MergeProblem& problem : check.problems)
        json["problems"].push_back({{"file", list.jobs[problem.job].panorama.file.string()},
                                    {"folder", folder_of(list, problem.job, folder)},
                                    {"what", problem.what}});
    if (check.table_problem) json["table_problem"] = *check.table_problem;
    if (check.worst_rel_rms) json["worst_rel_rms"] = *check.worst_rel_rms;
    std::cout << json.dump(2, ' ', false, Json::error_handler_t::replace) << "\n";
}

void print_text(const MergeCheck& check, const JobList& list, const fs::path& folder) {
    std::cout << check.complete << " of " << list.jobs.size()
              << " panoramas are complete, and their certificates hold: " << std::fixed
              << std::setprecision(1) << double(check.bytes) / 1e6 << " MB\n";
    if (check.worst_rel_rms)
        std::cout << "worst rel_rms " << std::scientific << std::setprecision(2)
                  << *check.worst_rel_rms << " in " << folder_of(list, check.worst, folder)
                  << "/\n";
}

}  // namespace

Result<ExitCode> run_merge(const CLI::App& app, const BakeOptions& options, const JobList& list,
                           Progress& progress) {
    const fs::path folder = options.output.path();
    const LibraryTable table{options.table.plan(), options.asset.encoding.container()};
    const auto check = check_merged(list.jobs, table, folder, progress);
    if (!check) return check.error();
    options.telling.json ? print_json(*check, list, folder) : print_text(*check, list, folder);
    if (check->holds()) return ExitCode::done;

    std::cout << std::flush;
    const auto complain = [&](const std::string& what) {
        std::cerr << cat(app.get_name(), ": ", one_line(what), "\n");
    };
    for (const MergeProblem& problem : check->problems)
        complain(cat(folder_of(list, problem.job, folder), "/: ", problem.what));
    if (check->table_problem)
        complain(cat((folder / library_table_file).string(), ": ", *check->table_problem));
    complain(cat("the library is not complete; the same command without --merge bakes what is "
                 "missing, and what is damaged with --force"));
    return ExitCode::over_limit;
}

}  // namespace splitsum::tools
