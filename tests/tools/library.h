#pragma once

#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "support/temporary_folder.h"
#include "tools/programs.h"

namespace splitsum::tests {

/// Writes a small sky, another for each seed, as a .pfm file: a lopsided gradient and a lamp.
inline void write_sky(const std::filesystem::path& file, int seed, int height = 8) {
    std::filesystem::create_directories(file.parent_path());
    const int width = 2 * height;
    std::ostringstream text;
    text << "PF\n" << width << " " << height << "\n-1.0\n";
    std::string bytes = text.str();
    for (int row = 0; row < height; ++row)
        for (int column = 0; column < width; ++column) {
            const float u = float(column) / float(width), v = float(row) / float(height);
            const bool lamp = row == height / 3 && column == (3 + 5 * seed) % width;
            const float rgb[3] = {0.2f + u + (lamp ? 20.f : 0.f), 0.3f + v * float(1 + seed % 3),
                                  0.1f + u * v};
            bytes.append(reinterpret_cast<const char*>(rgb), sizeof rgb);
        }
    write_bytes(file, bytes);
}

/// A folder of skies sky00.pfm, sky01.pfm, ...
inline void write_skies(const std::filesystem::path& folder, int count, int height = 8) {
    for (int i = 0; i < count; ++i)
        write_sky(folder / ("sky" + std::string(i < 10 ? "0" : "") + std::to_string(i) + ".pfm"), i,
                  height);
}

/// Options that make a bake as quick as it gets.
inline std::vector<std::string> quick_options() {
    return {"--size",       "8", "--levels", "2", "--irradiance-size", "4",
            "--table-size", "8", "--probes", "2", "--no-picture"};
}

/// The arguments of such a bake.
inline std::vector<std::string> bake_arguments(std::vector<std::string> inputs,
                                               const std::filesystem::path& output,
                                               const std::vector<std::string>& options = {}) {
    std::vector<std::string> arguments = std::move(inputs);
    arguments.insert(arguments.end(), {"-o", output.string()});
    for (const std::string& option : quick_options()) arguments.push_back(option);
    arguments.insert(arguments.end(), options.begin(), options.end());
    return arguments;
}

inline ProgramResult bake_library(std::vector<std::string> inputs,
                                  const std::filesystem::path& output,
                                  const std::vector<std::string>& options = {}) {
    return run_tool("splitsum-bake", bake_arguments(std::move(inputs), output, options));
}

/// The results of a library by their paths below `folder`: all files but notes about sources, which
/// hold times.
inline std::map<std::string, std::string> results_in(const std::filesystem::path& folder) {
    std::map<std::string, std::string> results;
    for (const auto& [file, bytes] : snapshot_of(folder))
        if (std::filesystem::path(file).filename() != ".source")
            results[std::filesystem::relative(file, folder).string()] = bytes;
    return results;
}

/// How often each outcome occurs in what --json printed.
inline std::map<std::string, int> outcomes_in(const ProgramResult& run) {
    std::map<std::string, int> outcomes;
    const auto json = nlohmann::json::parse(run.out, nullptr, false);
    if (json.is_discarded()) return {{"no JSON: " + run.out + run.err, 1}};
    for (const auto& panorama : json["panoramas"]) ++outcomes[panorama["outcome"]];
    if (!json["failed"].empty()) outcomes["failed"] = int(json["failed"].size());
    return outcomes;
}

}  // namespace splitsum::tests
