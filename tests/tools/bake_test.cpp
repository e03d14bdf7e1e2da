// splitsum-bake over one panorama and over a library.
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "support/temporary_folder.h"
#include "tools/programs.h"
#include "tools/textures.h"

namespace splitsum::tests {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr const char* tool = "splitsum-bake";
const std::string data = SPLITSUM_TEST_DATA;
const std::string lopsided = data + "/panoramas/lopsided.exr";
const std::string one_texel = data + "/panoramas/one_texel.exr";

ProgramResult bake(std::vector<std::string> panoramas, const fs::path& output,
                   std::vector<std::string> options = {}) {
    std::vector<std::string> arguments = std::move(panoramas);
    if (std::ranges::find(options, "--size") == options.end())
        options.insert(options.end(), {"--size", "16"});
    arguments.insert(arguments.end(), {"-o", output.string(), "--levels", "3", "--irradiance-size",
                                       "8", "--table-size", "16", "--probes", "8"});
    arguments.insert(arguments.end(), options.begin(), options.end());
    return run_tool(tool, arguments);
}

Json json_in(const fs::path& file) { return Json::parse(bytes_of(file)); }

std::vector<std::string> names_in(const fs::path& folder) {
    std::vector<std::string> names;
    for (const auto& [file, bytes] : snapshot_of(folder))
        names.push_back(fs::relative(file, folder).string());
    return names;
}

TEST(SplitsumBake, MakesWhatItsHelpSays) {
    const TemporaryFolder folder;
    const auto run = bake({lopsided}, folder / "a" / "b");
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const std::vector<std::string> expected = {"brdf.ktx2",
                                               "lopsided/.source",
                                               "lopsided/contact.png",
                                               "lopsided/harmonics.json",
                                               "lopsided/irradiance.ktx2",
                                               "lopsided/report.json",
                                               "lopsided/report.txt",
                                               "lopsided/specular.ktx2"};
    EXPECT_EQ(names_in(folder / "a" / "b"), expected);
    for (const std::string& name : expected) {
        if (fs::path(name).filename() == ".source") continue;  // ours, no result
        EXPECT_NE(run.out.find(fs::path(name).filename().string()), std::string::npos)
            << name << " is not in " << run.out;
    }
}

TEST(SplitsumBake, ItsJsonTellsTheSame) {
    const TemporaryFolder folder;
    const auto run = bake({lopsided, one_texel}, folder.path(), {"--json", "--no-picture"});
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const Json json = Json::parse(run.out);
    ASSERT_EQ(json["panoramas"].size(), 2u);
    EXPECT_EQ(json["panoramas"][1]["source"], "one_texel.exr");
    EXPECT_TRUE(json["failed"].empty());
    for (const Json& panorama : json["panoramas"]) {
        EXPECT_EQ(panorama["files"].size(), 3u);
        for (const std::string file : panorama["files"]) EXPECT_TRUE(fs::exists(file)) << file;
        EXPECT_TRUE(panorama["worst_rel_rms"].is_number());
    }
    EXPECT_TRUE(fs::exists(std::string(json["table"]["file"])));
}

// A library is baked over night: one bad panorama must not cost the others.
TEST(SplitsumBake, OneBadPanoramaCostsItselfOnly) {
    const TemporaryFolder folder;
    const auto run = bake(
        {lopsided, data + "/unusable/square.exr", one_texel, data + "/malformed/truncated.hdr"},
        folder.path());
    EXPECT_EQ(run.exit_code, 5);                // the kind of the first failure
    EXPECT_EQ(run.err_lines(), 3u) << run.err;  // a line each, and one that counts them
    for (const char* part :
         {"splitsum-bake: 2 of 4 panoramas failed", "square.exr", "truncated.hdr"})
        EXPECT_NE(run.err.find(part), std::string::npos) << part << " is not in " << run.err;
    for (const char* name : {"brdf.ktx2", "lopsided/report.json", "one_texel/report.json"})
        EXPECT_TRUE(fs::exists(folder / name)) << name;
    for (const char* name : {"square", "truncated"})
        EXPECT_FALSE(fs::exists(folder / name)) << name;

    const TemporaryFolder other;
    const auto reversed =
        bake({data + "/malformed/truncated.hdr", data + "/unusable/square.exr", lopsided},
             other.path(), {"--json"});
    EXPECT_EQ(reversed.exit_code, 3);
    EXPECT_EQ(Json::parse(reversed.out)["failed"].size(), 2u);
    EXPECT_TRUE(fs::exists(other / "brdf.ktx2"));
}

TEST(SplitsumBake, LeavesNothingWhereNothingCouldBeBaked) {
    const TemporaryFolder folder;
    const auto run =
        bake({data + "/unusable/square.exr", data + "/malformed/empty.hdr"}, folder / "new");
    EXPECT_EQ(run.exit_code, 5);
    EXPECT_FALSE(fs::exists(folder / "new"));
}

TEST(SplitsumBake, RefusesTwoPanoramasOfOneName) {
    const TemporaryFolder folder;
    fs::create_directory(folder / "other");
    fs::copy(lopsided, folder / "other" / "lopsided.exr");
    const auto run = bake({lopsided, (folder / "other" / "lopsided.exr").string()}, folder / "new");
    expect_failure(tool, run, 2);
    EXPECT_FALSE(fs::exists(folder / "new"));
}

TEST(SplitsumBake, AFailedBakeLeavesTheOlderResults) {
    const TemporaryFolder folder;
    fs::copy(lopsided, folder / "sky.exr");
    ASSERT_EQ(bake({(folder / "sky.exr").string()}, folder / "out").exit_code, 0);
    const auto before = snapshot_of(folder / "out");
    fs::copy(data + "/unusable/nan.exr", folder / "sky.exr", fs::copy_options::overwrite_existing);
    EXPECT_EQ(bake({(folder / "sky.exr").string()}, folder / "out").exit_code, 5);
    EXPECT_EQ(snapshot_of(folder / "out"), before);
}

TEST(SplitsumBake, CountsWhatItRepairs) {
    const TemporaryFolder folder;
    for (const char* name : {"nan", "inf", "negative"}) {
        const std::string input = data + "/unusable/" + name + ".exr";
        EXPECT_EQ(bake({input}, folder / "refused").exit_code, 5);
        const auto run = bake({input}, folder.path(), {"--repair"});
        ASSERT_EQ(run.exit_code, 0) << run.err;
        const Json report = json_in(folder / name / "report.json");
        const int repaired = report["source"]["repaired_texels"];
        EXPECT_GT(repaired, 0) << name;
        const std::string count = std::to_string(repaired);
        // The same count in the note, in the report for people and in both textures.
        EXPECT_NE(run.out.find("note: repaired pixels: " + count), std::string::npos) << run.out;
        EXPECT_NE(bytes_of(folder / name / "report.txt").find("repaired pixels: " + count),
                  std::string::npos);
        for (const char* file : {"specular.ktx2", "irradiance.ktx2"})
            EXPECT_EQ(read_texture(folder / name / file)->metadata.at("splitsum.repaired_texels"),
                      count);
        for (const Cubemap& level : levels_in(folder / name / "specular.ktx2"))
            for (const Vec3& texel : level.texels)
                ASSERT_TRUE(std::isfinite(texel.x + texel.y + texel.z) && texel.x >= 0);
    }
}

// sun.exr holds values above 65504: stored as that, and said so wherever figures are.
TEST(SplitsumBake, CountsWhatDoesNotFitTheFormat) {
    const TemporaryFolder folder;
    const std::string sun = data + "/panoramas/sun.exr";
    const auto saturated = [&](const char* format) {
        const auto run = bake({sun}, folder / format, {"--format", format, "--size", "128"});
        EXPECT_EQ(run.exit_code, 0) << run.err;
        return int(
            json_in(folder / format / "sun/report.json")["measured"]["specular"][0]["saturated"]);
    };
    EXPECT_EQ(saturated("rgba32f"), 0);
    EXPECT_GT(saturated("rgba16f"), 0);
    EXPECT_GT(saturated("b10g11r11"), 0);
    const std::string text = bytes_of(folder / "rgba16f/sun/report.txt");
    EXPECT_EQ(text.find("\n0 values were above"), std::string::npos) << text;
    float brightest = 0;
    const Cubemap mirror = levels_in(folder / "rgba16f/sun/specular.ktx2").at(0);
    for (const Vec3& texel : mirror.texels)
        brightest = std::max({brightest, texel.x, texel.y, texel.z});
    EXPECT_EQ(brightest, 65504);
}

// Every figure of the table for people stands in report.json.
TEST(SplitsumBake, ReportJsonHasEveryFigureOfReportText) {
    const TemporaryFolder folder;
    ASSERT_EQ(bake({lopsided}, folder.path(), {"--exposure", "1.5"}).exit_code, 0);
    const Json json = json_in(folder / "lopsided/report.json");
    std::istringstream lines(bytes_of(folder / "lopsided/report.txt"));
    int compared = 0;
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string name;
        size_t level = 0;
        words >> name;
        if (name != "specular" && name != "irradiance" && name != "harmonics") continue;
        if (name == "specular") words >> level;
        const Json& measured = json["measured"][name];
        const Json& entry = name == "specular" ? measured.at(level) : measured;
        double size, roughness, rel_rms, max_rel, bias, probes;
        ASSERT_TRUE(words >> size >> roughness >> rel_rms >> max_rel >> bias >> probes) << line;
        EXPECT_EQ(entry["face_size"], size);
        EXPECT_NEAR(entry["perceptual_roughness"], roughness, 1e-4);
        EXPECT_NEAR(entry["rel_rms"], rel_rms, 6e-3 * rel_rms);
        EXPECT_NEAR(entry["max_rel"], max_rel, 6e-3 * max_rel);
        EXPECT_NEAR(entry["bias"], bias, 6e-3 * std::abs(bias));
        EXPECT_EQ(entry["texels"], probes);
        ++compared;
    }
    EXPECT_EQ(compared, 5);
    EXPECT_EQ(json["source"]["exposure_stops"], 1.5);
    for (const Json& file : json["files"])
        EXPECT_EQ(fs::file_size(folder / "lopsided" / std::string(file["name"])), file["bytes"]);
}

// Each level of report.txt: where its light is, and what was cut off.
TEST(SplitsumBake, ReportsWhatEnginesReadBetweenTexelsAndLevelsAsCompareFindsIt) {
    const TemporaryFolder folder;
    ASSERT_EQ(bake({lopsided}, folder.path()).exit_code, 0);
    const Json bands =
        json_in(folder / "lopsided/report.json")["measured"]["between_texels_and_levels"];
    ASSERT_EQ(bands.size(), 4u);
    const auto compared =
        run_tool("splitsum-compare", {(folder / "lopsided/specular.ktx2").string(), "--panorama",
                                      lopsided, "--probes", "8", "--json", "--quiet"});
    ASSERT_EQ(compared.exit_code, 0) << compared.err;
    EXPECT_EQ(Json::parse(compared.out)["between_texels_and_levels"], bands);

    std::istringstream lines(bytes_of(folder / "lopsided/report.txt"));
    size_t band = 0;
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string name, to;
        double from, until, rel_rms, max_rel, bias;
        int probes;
        if (!(words >> name) || name != "between") continue;
        ASSERT_TRUE(words >> from >> to >> until >> rel_rms >> max_rel >> bias >> probes) << line;
        const Json& entry = bands.at(band++);
        EXPECT_EQ(entry["from"], from);
        EXPECT_EQ(entry["to"], until);
        EXPECT_NEAR(entry["rel_rms"], rel_rms, 6e-3 * rel_rms);
        EXPECT_NEAR(entry["max_rel"], max_rel, 6e-3 * max_rel);
        EXPECT_NEAR(entry["bias"], bias, 6e-3 * std::abs(bias));
        EXPECT_EQ(entry["texels"], probes);
        EXPECT_GT(rel_rms, 1e-4);  // far above that of the texels themselves
    }
    EXPECT_EQ(band, 4u);
}

TEST(SplitsumBake, ReportTextTellsWhatBecameOfTheLight) {
    const TemporaryFolder folder;
    ASSERT_EQ(bake({data + "/panoramas/sun.exr"}, folder.path()).exit_code, 0);
    const Json json = json_in(folder / "sun/report.json");
    const Json& source = json["source"]["mean_radiance"];
    std::istringstream lines(bytes_of(folder / "sun/report.txt"));
    size_t compared = 0;
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string name, level;
        words >> name >> level;
        if (name != "light") continue;
        const Json& entry = level == "diff." ? json["measured"]["irradiance"]
                                             : json["measured"]["specular"].at(std::stoul(level));
        double red, green, blue, gained;
        int64_t clamped, saturated;
        ASSERT_TRUE(words >> red >> green >> blue >> gained >> clamped >> saturated) << line;
        const Json& mean = entry["mean_radiance"];
        EXPECT_NEAR(red, mean[0], 1e-5 * red);
        EXPECT_NEAR(green, mean[1], 1e-5 * green);
        EXPECT_NEAR(blue, mean[2], 1e-5 * blue);
        const double in = double(source[0]) + double(source[1]) + double(source[2]);
        EXPECT_NEAR(gained, (double(mean[0]) + double(mean[1]) + double(mean[2])) / in - 1,
                    6e-3 * std::abs(gained) + 1e-9);
        EXPECT_EQ(entry["clamped_negative"], clamped);
        EXPECT_EQ(entry["saturated"], saturated);
        ++compared;
    }
    EXPECT_EQ(compared, 4u);
}

// A tenth of a bake is what a few probes cost; without them there are bounds, and no figures.
TEST(SplitsumBake, MeasuresUnlessToldNotTo) {
    const TemporaryFolder folder;
    const auto run = [&](std::vector<std::string> options) {
        std::vector<std::string> arguments = {
            lopsided, "-o",     folder.path().string(), "--size", "16",           "--levels",
            "3",      "--json", "--irradiance-size",    "8",      "--table-size", "8"};
        arguments.insert(arguments.end(), options.begin(), options.end());
        EXPECT_EQ(run_tool(tool, arguments).exit_code, 0);
        return json_in(folder / "lopsided/report.json")["measured"];
    };
    EXPECT_EQ(run({})["probes_per_level"], 8);
    EXPECT_EQ(run({"--verify"})["specular"][0]["texels"], 8);
    EXPECT_EQ(run({"--verify", "--probes", "3"})["specular"][1]["texels"], 3);
    const Json unmeasured = run({"--no-verify"});
    EXPECT_EQ(unmeasured["probes_per_level"], 0);
    EXPECT_FALSE(unmeasured["specular"][1].contains("rel_rms"));
    EXPECT_TRUE(unmeasured["specular"][1].contains("error_bound"));
    EXPECT_TRUE(unmeasured["specular"][1].contains("mean_radiance"));
}

// An asset's figures are those that splitsum-compare finds in the file.
TEST(SplitsumBake, ReportsWhatCompareFinds) {
    const TemporaryFolder folder;
    ASSERT_EQ(bake({lopsided}, folder.path(), {"--format", "rgb9e5"}).exit_code, 0);
    const Json report = json_in(folder / "lopsided/report.json")["measured"];
    const auto figures_of = [&](const char* name) {
        const auto run =
            run_tool("splitsum-compare", {(folder / "lopsided" / name).string(), "--panorama",
                                          lopsided, "--probes", "8", "--json"});
        EXPECT_EQ(run.exit_code, 0) << run.err;
        return Json::parse(run.out)["levels"];
    };
    const Json specular = figures_of("specular.ktx2");
    ASSERT_EQ(specular.size(), 3u);
    for (size_t level = 0; level < 3; ++level)
        EXPECT_EQ(specular[level]["rel_rms"], report["specular"][level]["rel_rms"]);
    EXPECT_EQ(figures_of("irradiance.ktx2")[0]["rel_rms"], report["irradiance"]["rel_rms"]);
    EXPECT_EQ(figures_of("harmonics.json")[0]["rel_rms"], report["harmonics"]["rel_rms"]);
}

}  // namespace
}  // namespace splitsum::tests
