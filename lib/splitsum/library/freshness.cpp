#include "splitsum/library/freshness.h"

#include <algorithm>
#include <cstdint>

#include "splitsum/base/text.h"
#include "splitsum/base/version.h"

namespace splitsum {
namespace {

namespace fs = std::filesystem;

const std::string* value_of(const Settings& settings, const std::string& name) {
    const auto setting = std::ranges::find(settings, name, &Settings::value_type::first);
    return setting == settings.end() ? nullptr : &setting->second;
}

std::string shown(const std::string* value) {
    return value == nullptr ? "unknown" : value->empty() ? "none" : *value;
}

// "accuracy 0.0003 -> 0.0001, size 256 -> 512", "" where nothing differs.
std::string difference(const Settings& then, const Settings& now) {
    std::vector<std::string> changes;
    for (const auto& [name, value] : now) {
        const std::string* before = value_of(then, name);
        if (before == nullptr || *before != value)
            changes.push_back(cat(name, ' ', shown(before), " -> ", shown(&value)));
    }
    return join(changes, ", ");
}

// What is wrong with the files beside the report, "" if nothing.
std::string missing_files(const fs::path& folder, const std::vector<BakedReport::File>& files) {
    std::error_code failure;
    for (const BakedReport::File& file : files) {
        const auto bytes = fs::file_size(folder / file.name, failure);
        if (failure) return cat(file.name, " is missing");
        if (int64_t(bytes) != file.bytes)
            return cat(file.name, " has ", bytes, " bytes, and had ", file.bytes,
                       " when it was baked");
    }
    return fs::exists(folder / "report.txt", failure) ? "" : "report.txt is missing";
}

// Everything that can be seen without the source's bytes; "" where all of that agrees.
std::string why_without_source(const BakedReport& baked, const std::string& source_name,
                               const Settings& settings, const fs::path& folder) {
    if (baked.algorithm != algorithm_version)
        return cat("it was made by version ", baked.algorithm, " of the algorithm, this one is ",
                   algorithm_version);
    if (const std::string changes = difference(baked.settings, settings); !changes.empty())
        return "the options changed: " + changes;
    if (baked.source_name != source_name) return cat("the panorama was called ", baked.source_name);
    return missing_files(folder, baked.files);
}

}  // namespace

Result<Freshness> check_freshness(const fs::path& source, const PanoramaOptions& reading,
                                  const BakePlan& plan, const fs::path& folder,
                                  ConfigHashes& configs) {
    if (const auto readable = stamp_of(source); !readable) return readable.error();
    const auto settings = settings_of(reading, plan, configs);
    if (!settings) return settings.error();

    Freshness freshness;
    auto baked = read_baked_report(folder);
    if (!baked) {
        freshness.why = baked.error().message;
        return freshness;
    }
    freshness.baked = std::move(*baked);
    const std::string name = source.filename().string();
    freshness.why = why_without_source(*freshness.baked, name, *settings, folder);
    if (!freshness.why.empty()) return freshness;

    auto hash = hash_of_source(source, folder);
    if (!hash) return hash.error();
    freshness.source = std::move(*hash);
    if (freshness.source->hash != freshness.baked->source_hash)
        freshness.why = "the panorama changed";
    else if (recipe_of(name, freshness.source->hash, *settings) != freshness.baked->recipe)
        freshness.why = "report.json contradicts itself";
    freshness.up_to_date = freshness.why.empty();
    return freshness;
}

}  // namespace splitsum
