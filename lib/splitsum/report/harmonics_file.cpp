#include "splitsum/report/harmonics_file.h"

#include <fstream>
#include <iomanip>
#include <nlohmann/json.hpp>
#include <sstream>

#include "splitsum/base/atomic_file.h"
#include "splitsum/base/text.h"
#include "splitsum/math/harmonics.h"
#include "splitsum/report/harmonics_glsl_detail.h"

namespace splitsum {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* basis =
    "real orthonormal spherical harmonics, index l (l + 1) + m, no Condon-Shortley phase: "
    "Y_00 = 0.282095, (Y_1-1, Y_10, Y_11) = 0.488603 (y, z, x); axes of the KTX cubemap, +y up";

std::string as_json(const IrradianceHarmonics& harmonics, const AssetFacts& facts) {
    Json file;
    file["asset"] = "irradiance harmonics";
    file["value"] = "E(n) / pi = sum of coefficients[i] * Y_i(n)";
    file["basis"] = basis;
    file["order"] = harmonics.order;
    file["window_lambda"] = harmonics.window_lambda;
    file["lowest_share_of_mean"] = harmonics.lowest;
    file["coefficients"] = Json::array();
    for (const Vec3d& c : harmonics.coefficients) file["coefficients"].push_back({c.x, c.y, c.z});
    AssetFacts series_facts = facts;
    series_facts.stores_irradiance = false;  // that is the cubemap's; the series is E / pi always
    file["metadata"] = metadata_of(series_facts);
    return file.dump(2) + "\n";
}

std::string as_text(const IrradianceHarmonics& harmonics) {
    std::ostringstream text;
    text << "# E(n) / pi, red green blue a line; " << basis << "\n"
         << std::scientific << std::setprecision(17);
    for (const Vec3d& c : harmonics.coefficients) text << c.x << ' ' << c.y << ' ' << c.z << '\n';
    return text.str();
}

Error unusable(const std::filesystem::path& path, const std::string& what) {
    return {ErrorKind::unusable_input,
            cat(path.string(), " is not a harmonics file of splitsum: ", what)};
}

// May throw nlohmann's exceptions for members of other types.
Result<HarmonicsFile> parse(const Json& json, const std::filesystem::path& path) {
    HarmonicsFile file;
    file.harmonics.order = json.at("order").get<int>();
    file.harmonics.window_lambda = json.at("window_lambda").get<double>();
    file.harmonics.lowest = json.at("lowest_share_of_mean").get<double>();
    for (const Json& c : json.at("coefficients"))
        file.harmonics.coefficients.emplace_back(c.at(0).get<double>(), c.at(1).get<double>(),
                                                 c.at(2).get<double>());
    const bool sensible = file.harmonics.order >= 0 && file.harmonics.order <= 1000;
    if (!sensible || file.harmonics.coefficients.size() != harmonic_count(file.harmonics.order))
        return unusable(path, cat("order ", file.harmonics.order, " with ",
                                  file.harmonics.coefficients.size(), " coefficients"));
    const auto facts = facts_of(json.at("metadata").get<std::map<std::string, std::string>>());
    if (!facts) return unusable(path, facts.error().message);
    file.facts = *facts;
    return file;
}

}  // namespace

Status write_harmonics(const IrradianceHarmonics& harmonics, const AssetFacts& facts,
                       const std::filesystem::path& path) {
    const std::string ending = path.extension().string();
    if (ending == ".json") return write_text_whole(path, as_json(harmonics, facts));
    if (ending == ".txt") return write_text_whole(path, as_text(harmonics));
    if (ending != ".glsl")
        return Error{ErrorKind::bad_argument,
                     cat("harmonics cannot be written as '", ending, "' (", path.string(),
                         "); there are: .json, .txt, .glsl")};
    if (harmonics.order > highest_glsl_order)
        return Error{ErrorKind::bad_argument,
                     cat("GLSL of harmonics goes up to order ", highest_glsl_order, ", got ",
                         harmonics.order, "; .json and .txt take any")};
    return write_text_whole(path, harmonics_glsl(harmonics));
}

Result<HarmonicsFile> read_harmonics(const std::filesystem::path& path) {
    std::ifstream stream(path);
    if (!stream) return Error{ErrorKind::unreadable_input, cat("cannot read ", path.string())};
    const Json json = Json::parse(stream, nullptr, /*allow_exceptions=*/false);
    if (json.is_discarded())
        return Error{ErrorKind::unreadable_input, cat(path.string(), " is not valid JSON")};
    try {
        return parse(json, path);
    } catch (const Json::exception& exception) {
        return unusable(path, exception.what());
    }
}

}  // namespace splitsum
