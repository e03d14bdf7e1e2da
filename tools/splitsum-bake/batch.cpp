#include "batch.h"

#include <chrono>
#include <iomanip>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>

#include "light/cubemap_tool.h"
#include "splitsum/assets/table_asset.h"
#include "splitsum/base/staged_folder.h"
#include "splitsum/base/text.h"

namespace splitsum::tools {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

class Stopwatch {
public:
    double seconds() const {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    }

private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

// Two panoramas of one name would write the same files.
Status check_names(const std::vector<std::string>& panoramas) {
    std::map<std::string, std::string> first_with_stem;
    for (const std::string& panorama : panoramas) {
        const std::string stem = fs::path(panorama).stem().string();
        if (stem.empty())
            return Error{ErrorKind::bad_argument,
                         cat("'", panorama, "' is not the name of a file")};
        const auto [other, is_new] = first_with_stem.emplace(stem, panorama);
        if (!is_new)
            return Error{ErrorKind::bad_argument,
                         cat(panorama, " and ", other->second, " would both be baked into '", stem,
                             "'; bake them into folders of their own")};
    }
    return ok;
}

// How the table is stored. Fails with bad_argument for a plan that makes no texture.
Result<PixelFormat> table_format(const TablePlan& plan) {
    if (const Status valid = validate(plan); !valid) return valid.error();
    const auto kind = kind_of(plan);
    if (!kind) return kind.error();
    if (kind->is_closed_form())
        return Error{ErrorKind::bad_argument,
                     cat("'", kind->name, "' is a formula, no texture; splitsum-brdf writes it")};
    return default_format(*kind);
}

struct BakedTable {
    fs::path path;
    double max_abs;
};

Result<BakedTable> write_table(const BatchOptions& options, const fs::path& folder,
                               Progress& progress) {
    const TablePlan plan = options.table.plan();
    const auto asset = bake_table(plan, *table_format(plan), progress);
    if (!asset) return asset.error();
    const fs::path path = folder / "brdf.ktx2";
    if (const Status written = write_texture(asset->texture, path, options.asset.encoding.container());
        !written)
        return written.error();
    return BakedTable{path, asset->check.at_texels};
}

// Of the levels that were measured; nothing if none was.
std::optional<double> worst_rel_rms(const BakeReport& report) {
    if (report.probes == 0) return std::nullopt;
    double worst = report.irradiance.figures.rel_rms;
    for (const LevelCheck& check : report.specular)
        if (check.perceptual_roughness > 0) worst = std::max(worst, check.figures.rel_rms);
    return worst;
}

// Prints the results as they come, or collects them for one JSON object at the end.
class Results {
public:
    explicit Results(bool json) : json_(json) {}

    void add(const fs::path& folder, const BakeReport& report, double seconds) {
        Json entry = {{"source", report.source.name}, {"folder", folder.string()}};
        const auto worst = worst_rel_rms(report);
        if (worst) entry["worst_rel_rms"] = *worst;
        entry["seconds"] = seconds;
        for (const WrittenFile& file : report.files)
            entry["files"].push_back((folder / file.name).string());
        panoramas_.push_back(entry);
        if (json_) return;
        std::cout << folder.string()
                  << "/: " << join(report.files, ", ", [](const auto& file) { return file.name; })
                  << ", report.json, report.txt\n  " << std::setprecision(2) << std::scientific;
        if (worst)
            std::cout << "worst rel_rms beyond the mirror level " << *worst << ", ";
        else
            std::cout << "not measured (--no-verify), error bounds in report.txt, ";
        std::cout << std::fixed << seconds << " s\n";
        for (const std::string& note : report.notes) std::cout << "  note: " << note << "\n";
        std::cout << std::flush;
    }

    void fail(const std::string& panorama, const Error& error) {
        failures_.push_back(panorama);
        if (!first_) first_ = error;
        messages_ += (messages_.empty() ? "" : "; ") + error.message;
    }

    Result<ExitCode> finish(const std::optional<BakedTable>& table, size_t asked) const {
        if (json_) {
            Json json = {{"panoramas", panoramas_}, {"failed", failures_}};
            if (table)
                json["table"] = {{"file", table->path.string()}, {"max_abs", table->max_abs}};
            std::cout << json.dump(2) << "\n";
        } else if (table) {
            std::cout << table->path.string() << ": max_abs " << std::setprecision(2)
                      << std::scientific << table->max_abs << "\n";
        }
        if (!first_) return ExitCode::done;
        if (asked == 1) return *first_;
        return Error{first_->kind, cat(failures_.size(), " of ", asked,
                                       " panoramas failed, the others are baked: ", messages_)};
    }

private:
    bool json_;
    Json panoramas_ = Json::array();
    std::vector<std::string> failures_;
    std::optional<Error> first_;
    std::string messages_;
};

Result<BakeReport> bake_file(const std::string& file, const BatchOptions& options,
                             const BakePlan& plan, const std::shared_ptr<FilterTables>& tables,
                             const fs::path& folder, Progress& progress) {
    const auto light = load_light(file, options.asset.reading.plan(), light_use(plan, tables), progress);
    if (!light) return light.error();
    return bake(*light, plan, folder, progress);
}

}  // namespace

BatchOptions::BatchOptions(CLI::App& app)
    : output(app, "DIR", "the folder of the results, made if it is missing"),
      asset(app),
      table(app, "table-"),
      json(app) {
    app.add_option("PANORAMA", panoramas, "a 2:1 lat-long image: .exr, .hdr, .tif, .pfm, ...")
        ->option_text("...")
        ->required()
        ->check(not_empty());
}

Result<ExitCode> run_batch(const BatchOptions& options, Progress& progress) {
    const auto plan = options.asset.plan();
    if (!plan) return plan.error();
    if (const auto format = table_format(options.table.plan()); !format) return format.error();
    const std::vector<std::string>& panoramas = options.panoramas;
    if (const Status distinct = check_names(panoramas); !distinct) return distinct.error();
    const fs::path folder = options.output.path();
    // Asked before the work; what was made for the question goes again.
    if (const auto possible = StagedFolder::create(folder); !possible) return possible.error();

    Results results(options.json.json);
    std::optional<BakedTable> table;
    const auto tables = std::make_shared<FilterTables>();
    for (const std::string& file : panoramas) {
        const Stopwatch stopwatch;
        const fs::path target = folder / fs::path(file).stem();
        const auto report = bake_file(file, options, *plan, tables, target, progress);
        if (report)
            results.add(target, *report, stopwatch.seconds());
        else if (report.error().kind == ErrorKind::interrupted)
            return report.error();
        else
            results.fail(file, report.error());
        if (!report || table) continue;
        // After the first success, so that a call that can make nothing leaves nothing behind.
        const auto written = write_table(options, folder, progress);
        if (!written) return written.error();
        table = *written;
    }
    return results.finish(table, panoramas.size());
}

}  // namespace splitsum::tools
