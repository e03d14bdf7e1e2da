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

void complain(const std::string& what) {
    std::cerr << cat("splitsum-bake: ", one_line(what), "\n");
}

std::string quoted(const std::string& argument) {
    constexpr const char* plain =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789%+,-./:=@_";
    if (!argument.empty() && argument.find_first_not_of(plain) == std::string::npos)
        return argument;
    std::string text = "'";
    for (const char letter : argument) text += letter == '\'' ? "'\\''" : std::string(1, letter);
    return text + "'";
}

}  // namespace

std::string shell_text(std::span<const std::string> arguments) {
    return join(arguments, " ", quoted);
}

Result<ExitCode> run_merge(std::span<const std::string> command, const BakeOptions& options,
                           const JobList& list, Progress& progress) {
    const fs::path folder = options.output.path();
    const LibraryTable table{options.table.plan(), options.asset.encoding.container()};
    const auto check = check_merged(list.jobs, table, folder, progress);
    if (!check) return check.error();
    options.telling.json ? print_json(*check, list, folder) : print_text(*check, list, folder);
    if (check->holds()) return ExitCode::done;

    std::cout << std::flush;
    for (const MergeProblem& problem : check->problems)
        complain(cat(folder_of(list, problem.job, folder), "/: ", problem.what));
    if (check->table_problem)
        complain(cat((folder / library_table_file).string(), ": ", *check->table_problem));
    std::vector<std::string> baking(command.begin(), command.end());
    std::erase(baking, "--merge");
    complain(cat(check->problems.size(), " of ", list.jobs.size(),
                 " panoramas are not complete; what is missing is baked by: ", shell_text(baking)));
    if (check->damaged > 0)
        complain("of what is damaged, remove report.json first, so that it is baked again");
    return ExitCode::over_limit;
}

}  // namespace splitsum::tools
