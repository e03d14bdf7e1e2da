#include "library_json.h"

#include <nlohmann/json.hpp>

namespace splitsum::tools {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

std::string outcome_name(Outcome outcome, bool dry_run) {
    if (dry_run && outcome == Outcome::not_begun) return "would_bake";
    return std::string(name_of(outcome));
}

Json panorama_json(const LibraryItem& item, const ListedPanorama& panorama, const fs::path& folder,
                   bool dry_run) {
    Json entry = {{"source", panorama.file.filename().string()},
                  {"folder", (folder / panorama.name).string()},
                  {"outcome", outcome_name(item.outcome, dry_run)}};
    if (!item.why.empty()) entry["why"] = item.why;
    entry["seconds"] = item.seconds;
    if (!item.facts) return entry;
    if (item.facts->worst_rel_rms) entry["worst_rel_rms"] = *item.facts->worst_rel_rms;
    entry["bytes"] = bytes_of(*item.facts);
    entry["files"] = Json::array();
    for (const auto& file : item.facts->files)
        entry["files"].push_back((folder / panorama.name / file.name).string());
    return entry;
}

Json failure_json(const LibraryItem& item, const ListedPanorama& panorama) {
    return {{"file", panorama.file.string()},
            {"kind", name_of(item.error->kind)},
            {"message", item.error->message}};
}

Json table_json(const TableResult& table, bool dry_run) {
    Json entry = {{"file", table.file.string()}, {"outcome", outcome_name(table.outcome, dry_run)}};
    if (!table.why.empty()) entry["why"] = table.why;
    if (table.max_abs > 0) entry["max_abs"] = table.max_abs;
    return entry;
}

}  // namespace

std::string library_json(const LibrarySummary& summary, std::span<const LibraryJob> jobs,
                         const fs::path& folder, bool dry_run) {
    Json json = {{"panoramas", Json::array()},
                 {"failed", Json::array()},
                 {"failures", Json::array()},
                 {"seconds", summary.seconds}};
    for (const LibraryItem& item : summary.items) {
        const ListedPanorama& panorama = jobs[item.job].panorama;
        if (item.outcome != Outcome::failed) {
            json["panoramas"].push_back(panorama_json(item, panorama, folder, dry_run));
            continue;
        }
        json["failed"].push_back(panorama.file.string());
        json["failures"].push_back(failure_json(item, panorama));
    }
    if (summary.table) json["table"] = table_json(*summary.table, dry_run);
    // File names need not be UTF-8; JSON must be.
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace splitsum::tools
