#include "splitsum/library/baked_report.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "splitsum/base/text.h"

namespace splitsum {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

void take_error(const Json& level, std::optional<double>& worst) {
    const auto figure = level.find("rel_rms");
    if (figure == level.end()) return;
    worst = std::max(worst.value_or(0), figure->get<double>());
}

// Level 0 is left out where it is a mirror image: its error is that of texels, not of a filter.
std::optional<double> worst_rel_rms(const Json& measured) {
    std::optional<double> worst;
    for (const Json& level : measured.at("specular"))
        if (level.at("perceptual_roughness").get<double>() > 0) take_error(level, worst);
    take_error(measured.at("irradiance"), worst);
    return worst;
}

BakedReport report_from(const Json& json) {
    BakedReport report;
    report.algorithm = json.at("algorithm").get<int>();
    report.recipe = json.at("recipe").get<std::string>();
    for (const auto& [name, value] : json.at("settings").items())
        report.settings.emplace_back(name, value.get<std::string>());
    report.source_name = json.at("source").at("name").get<std::string>();
    report.source_hash = json.at("source").at("hash").get<std::string>();
    for (const Json& file : json.at("files"))
        report.files.push_back({file.at("name").get<std::string>(), file.at("bytes").get<int64_t>(),
                                file.at("hash").get<std::string>()});
    report.worst_rel_rms = worst_rel_rms(json.at("measured"));
    return report;
}

}  // namespace

Result<BakedReport> read_baked_report(const fs::path& folder) {
    const fs::path path = folder / "report.json";
    std::ifstream file(path, std::ios::binary);
    if (!file)
        return Error{ErrorKind::unreadable_input, cat("there is no ", path.string(), " yet")};
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    try {
        const Json json = Json::parse(text);
        if (json.is_object() && json.contains("splitsum") && !json.contains("recipe"))
            return Error{ErrorKind::unreadable_input,
                         cat(path.string(), " is of a version that recorded no recipe")};
        return report_from(json);
    } catch (const Json::exception&) {
        return Error{ErrorKind::unreadable_input,
                     cat(path.string(), " cannot be read as the report of a bake")};
    }
}

}  // namespace splitsum
