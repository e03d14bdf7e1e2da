#include "library_text.h"

#include <cmath>
#include <iomanip>
#include <map>
#include <sstream>

#include "splitsum/base/text.h"

namespace splitsum::tools {
namespace {

namespace fs = std::filesystem;

std::string scientific(double value) { return cat(std::setprecision(2), std::scientific, value); }

std::string fixed(double value, int digits) {
    return cat(std::setprecision(digits), std::fixed, value);
}

std::string error_text(const BakedFacts& facts) {
    if (!facts.worst_rel_rms) return "not measured (--no-verify), error bounds in report.txt";
    return cat("worst rel_rms beyond the mirror level ", scientific(*facts.worst_rel_rms));
}

std::string result_text(const LibraryItem& item, const fs::path& folder, bool briefly) {
    const bool cached = item.outcome == Outcome::from_cache;
    const std::string error = item.facts ? error_text(*item.facts) : "";
    const std::string seconds = fixed(item.seconds, 2) + " s\n";
    if (briefly)
        return cat(folder.string(), "/: ", cached ? "from the cache, " : "", error, ", ", seconds);
    std::string text = cat(
        folder.string(),
        "/: ", join(item.facts->files, ", ", [](const auto& file) { return file.name; }),
        ", report.json, report.txt\n  ", cached ? "from the cache, " : "", error, ", ", seconds);
    for (const std::string& note : item.notes) text += cat("  note: ", note, "\n");
    return text;
}

// A line of the counts: what, how many, megabytes if any.
std::string count_line(const std::string& what, size_t count, int64_t bytes) {
    if (count == 0) return "";
    std::string line = cat(std::left, std::setw(16), what, std::right, std::setw(7), count);
    if (bytes > 0) line += cat(std::setw(12), fixed(double(bytes) / 1e6, 1), " MB");
    return line + "\n";
}

std::string time_text(const LibrarySummary& summary, size_t made) {
    std::string text = fixed(summary.seconds, 1) + " s";
    if (made > 0 && summary.seconds > 0)
        text += cat(", ", std::lround(60 * double(made) / summary.seconds), " panoramas/min");
    return text;
}

// The worst of all that is in the folder now, and where it is.
std::string worst_text(const LibrarySummary& summary, std::span<const LibraryJob> jobs,
                       const fs::path& folder) {
    const LibraryItem* worst = nullptr;
    for (const LibraryItem& item : summary.items)
        if (item.facts && item.facts->worst_rel_rms &&
            (!worst || *item.facts->worst_rel_rms > *worst->facts->worst_rel_rms))
            worst = &item;
    if (!worst) return "";
    return cat("worst rel_rms ", scientific(*worst->facts->worst_rel_rms), " in ",
               (folder / jobs[worst->job].panorama.name).string(), "/\n");
}

}  // namespace

std::string item_text(const LibraryItem& item, const fs::path& folder, bool briefly, bool dry_run) {
    switch (item.outcome) {
        case Outcome::baked:
        case Outcome::from_cache: return result_text(item, folder, briefly);
        case Outcome::up_to_date: return briefly ? "" : cat(folder.string(), "/: up to date\n");
        case Outcome::not_begun:
            return dry_run ? cat(folder.string(), "/: would be baked: ", item.why, "\n") : "";
        case Outcome::failed: return "";
    }
    return "";
}

std::string table_text(const TableResult& table, bool dry_run) {
    const std::string file = table.file.string();
    switch (table.outcome) {
        case Outcome::baked: return cat(file, ": max_abs ", scientific(table.max_abs), "\n");
        case Outcome::up_to_date: return cat(file, ": up to date\n");
        default: return dry_run ? cat(file, ": would be baked: ", table.why, "\n") : "";
    }
}

std::string counts_text(const LibrarySummary& summary, std::span<const LibraryJob> jobs,
                        const fs::path& folder, bool dry_run) {
    std::map<Outcome, size_t> count;
    std::map<Outcome, int64_t> bytes;
    for (const LibraryItem& item : summary.items) {
        ++count[item.outcome];
        if (item.facts) bytes[item.outcome] += bytes_of(*item.facts);
    }
    const size_t made = count[Outcome::baked] + count[Outcome::from_cache];
    return cat(count_line("baked", count[Outcome::baked], bytes[Outcome::baked]),
               count_line("from the cache", count[Outcome::from_cache], bytes[Outcome::from_cache]),
               count_line("up to date", count[Outcome::up_to_date], 0),
               count_line(dry_run ? "would be baked" : "not begun", count[Outcome::not_begun], 0),
               count_line("failed", count[Outcome::failed], 0), time_text(summary, made), "\n",
               worst_text(summary, jobs, folder));
}

}  // namespace splitsum::tools
