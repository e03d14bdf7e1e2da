#include "splitsum/report/bake_report.h"

#include <algorithm>
#include <iomanip>
#include <nlohmann/json.hpp>
#include <sstream>

#include "splitsum/base/text.h"
#include "splitsum/base/version.h"
#include "splitsum/report/figures_json.h"
#include "splitsum/report/figures_text.h"

namespace splitsum {
namespace {

using Json = nlohmann::ordered_json;

Json rgb_json(const Vec3d& rgb) { return {rgb.x, rgb.y, rgb.z}; }

Json source_json(const BakeReport& report) {
    return {{"name", report.source.name},
            {"hash", report.source.hash},
            {"width", report.source_width},
            {"height", report.source_height},
            {"color_space", report.source.color_space},
            {"exposure_stops", report.source.exposure_stops},
            {"repaired_texels", report.source.repaired_texels},
            {"mean_radiance", rgb_json(report.source_mean_radiance)},
            {"notes", report.notes}};
}

Json settings_json(const BakeReport& report) {
    Json settings = Json::object();
    for (const auto& [name, value] : report.settings) settings[name] = value;
    return settings;
}

Json asked_json(const BakeReport& report) {
    return {{"format", info_of(report.format).name},
            {"specular", metadata_of(report.specular_facts)},
            {"irradiance", metadata_of(report.irradiance_facts)}};
}

Json files_json(const BakeReport& report) {
    Json files = Json::array();
    for (const WrittenFile& file : report.files)
        files.push_back(
            {{"name", file.name}, {"bytes", file.bytes}, {"hash", file.hash}, {"what", file.what}});
    return files;
}

Json stored_json(const LevelCheck& check, const EncodeCounts& counts, const LevelAccount& account) {
    Json json = check_json(check);
    json.update(account_json(account));
    json["saturated"] = counts.saturated;
    json["negative"] = counts.negative;
    return json;
}

Json measured_json(const BakeReport& report) {
    Json specular = Json::array();
    for (size_t level = 0; level < report.specular.size(); ++level)
        specular.push_back(stored_json(report.specular[level], report.specular_counts[level],
                                       report.accounts[level]));
    Json harmonics = check_json(report.harmonics);
    harmonics["lowest_share_of_mean"] = report.harmonics_lowest;
    return {{"against", "method reference, fp64, on the stored texels"},
            {"probes_per_level", report.probes},
            {"specular", specular},
            {"between_texels_and_levels", readings_json(report.between)},
            {"irradiance",
             stored_json(report.irradiance, report.irradiance_counts, report.accounts.back())},
            {"harmonics", harmonics}};
}

std::string rgb_text(const Vec3d& rgb) {
    std::ostringstream text;
    text << std::setprecision(6) << rgb.x << ' ' << rgb.y << ' ' << rgb.z;
    return text.str();
}

std::string saturation_text(const BakeReport& report) {
    EncodeCounts total = report.irradiance_counts;
    for (const EncodeCounts& counts : report.specular_counts) total += counts;
    const PixelFormatInfo& format = info_of(report.format);
    std::string text =
        cat(total.saturated, " values were above the largest that ", format.name, " holds (",
            *std::ranges::min_element(format.largest), "), and are stored as that");
    if (total.negative > 0)
        text += cat("\n", total.negative, " values were below 0 and are stored as 0");
    return text;
}

// A line for each level: how much of the panorama's light it holds, and what was cut off.
std::string light_line(const std::string& what, const LevelCheck& check,
                       const LevelAccount& account, const EncodeCounts& counts,
                       const Vec3d& source) {
    const Vec3d& mean = check.mean_radiance;
    std::ostringstream line;
    line << std::left << std::setw(12) << what << std::right << std::setprecision(6);
    for (const double channel : {mean.x, mean.y, mean.z}) line << std::setw(13) << channel;
    const double in = source.x + source.y + source.z, out = mean.x + mean.y + mean.z;
    line << std::scientific << std::setprecision(2) << std::setw(12)
         << (in > 0 ? out / in - 1 : out) << std::setw(11) << account.clamped_negative
         << std::setw(11) << counts.saturated << "\n";
    return line.str();
}

std::string light_table(const BakeReport& report) {
    const Vec3d& source = report.source_mean_radiance;
    std::ostringstream text;
    text << std::setw(12) << "";
    for (const char* name : {"mean red", "green", "blue"}) text << std::setw(13) << name;
    text << std::setw(12) << "gained" << std::setw(11) << "clamped" << std::setw(11) << "saturated"
         << "\n";
    for (size_t level = 0; level < report.specular.size(); ++level)
        text << light_line(cat("light ", level), report.specular[level], report.accounts[level],
                           report.specular_counts[level], source);
    text << light_line("light diff.", report.irradiance, report.accounts.back(),
                       report.irradiance_counts, source);
    return text.str();
}

std::string clamped_text(const BakeReport& report) {
    int64_t clamped = 0;
    for (const LevelAccount& account : report.accounts) clamped += account.clamped_negative;
    return cat(clamped, " values came out below 0 and are stored as 0");
}

}  // namespace

std::string report_json(const BakeReport& report) {
    const Json json = {{"splitsum", version},           {"algorithm", algorithm_version},
                       {"recipe", report.recipe},       {"settings", settings_json(report)},
                       {"source", source_json(report)}, {"asked", asked_json(report)},
                       {"files", files_json(report)},   {"measured", measured_json(report)}};
    return json.dump(2) + "\n";
}

std::string report_text(const BakeReport& report) {
    std::ostringstream text;
    text << report.source.name << "  " << report.source_width << " x " << report.source_height
         << ", " << report.source.color_space << ", " << report.source.hash << "\n";
    for (const std::string& note : report.notes) text << "note: " << note << "\n";
    text << "mean radiance " << rgb_text(report.source_mean_radiance) << ", exposure "
         << report.source.exposure_stops << " stops\n\n"
         << "method " << report.specular_facts.filter.method << ", accuracy "
         << report.specular_facts.filter.accuracy << ", " << report.specular_facts.filter.samples
         << " samples, convention " << report.specular_facts.orientation.convention << ", "
         << info_of(report.format).name << "\nalgorithm " << algorithm_version << ", recipe "
         << report.recipe << "\n\nError of the stored texels against exact integration:\n"
         << figures_heading(true);
    for (const LevelCheck& check : report.specular)
        text << figures_line(cat("specular ", check.level), check,
                             &report.accounts[size_t(check.level)]);
    text << figures_line("irradiance", report.irradiance, &report.accounts.back())
         << figures_line("harmonics", report.harmonics)
         << "\nWhat an engine reads between texels and levels, against exact integration there:\n"
         << readings_text(report.between)
         << "\nLight of the stored levels, beside the panorama's mean radiance:\n"
         << light_table(report) << "\n"
         << saturation_text(report) << "\n"
         << clamped_text(report) << "\n"
         << report.source.repaired_texels << " texels of the panorama were repaired\n\nFiles:\n";
    for (const WrittenFile& file : report.files)
        text << "  " << file.name << "  " << file.bytes << " bytes: " << file.what << "\n";
    return text.str();
}

}  // namespace splitsum
