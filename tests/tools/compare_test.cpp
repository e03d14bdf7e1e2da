// splitsum-compare as a user and as a build script runs it.
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "splitsum/report/certificate.h"
#include "support/temporary_folder.h"
#include "tools/programs.h"
#include "tools/textures.h"

namespace splitsum::tests {
namespace {

using Json = nlohmann::json;

constexpr const char* tool = "splitsum-compare";
const std::string data = SPLITSUM_TEST_DATA;
const std::string lopsided = data + "/panoramas/lopsided.exr";

class SplitsumCompare : public testing::Test {
protected:
    /// The asset of that name, made the first time a test asks for it; other names are only paths.
    std::string path(const std::string& name) {
        const std::string file = (folder_ / name).string();
        if (std::filesystem::exists(file)) return file;
        if (name == "older.ktx2") strip_metadata("chain.ktx2", file, "splitsum.certificate.");
        if (name == "foreign.ktx2") strip_metadata("chain.ktx2", file);
        if (name == "foreign_diffuse.ktx2") strip_metadata("diffuse.ktx2", file);
        for (const Recipe& recipe : recipes()) {
            if (name != recipe.name) continue;
            std::vector<std::string> arguments = recipe.arguments;
            if (recipe.tool != std::string("splitsum-brdf")) arguments.push_back(lopsided);
            arguments.insert(arguments.end(), {"-o", file});
            EXPECT_EQ(run_tool(recipe.tool, arguments).exit_code, 0) << name;
        }
        return file;
    }

    struct Recipe {
        const char* name;
        const char* tool;
        std::vector<std::string> arguments;
    };

    static std::vector<Recipe> recipes() {
        const char* specular = "splitsum-specular";
        const char* irradiance = "splitsum-irradiance";
        const char* brdf = "splitsum-brdf";
        return {
            {"chain.ktx2", specular, {"--size", "16", "--levels", "4"}},
            {"chain.exr", specular, {"--size", "16", "--levels", "4"}},
            {"quick.ktx2", specular, {"--size", "16", "--levels", "4", "--no-verify"}},
            {"zstd.ktx2", specular, {"--size", "16", "--levels", "2", "--zstd"}},
            {"rough.ktx2",
             specular,
             {"--size", "16", "--levels", "4", "--method", "importance", "--samples", "4"}},
            {"small.ktx2", specular, {"--size", "8", "--levels", "4"}},
            {"diffuse.ktx2", irradiance, {"--size", "8"}},
            {"e.ktx2", irradiance, {"--size", "8", "--store-e"}},
            {"series.json", irradiance, {}},
            {"long.json", irradiance, {"--order", "9"}},
            {"table.ktx2", brdf, {"--size", "32"}},
            {"table.exr", brdf, {"--size", "32"}},
            {"other.ktx2", brdf, {"--size", "32", "--geometry", "schlick-half"}},
            {"large.ktx2", brdf, {"--size", "33"}},
        };
    }

    /// The same texture as a tool that says less would have written it: without keys that begin so.
    void strip_metadata(const std::string& from, const std::string& to,
                        const std::string& prefix = "") {
        auto texture = read_texture(path(from));
        ASSERT_TRUE(texture);
        std::erase_if(texture->metadata,
                      [&](const auto& entry) { return entry.first.starts_with(prefix); });
        ASSERT_TRUE(write_texture(*texture, to));
    }

    static ProgramResult compare(std::vector<std::string> arguments) {
        const ProgramResult run = run_tool(tool, std::move(arguments));
        EXPECT_FALSE(run.timed_out);
        return run;
    }

    TemporaryFolder folder_;
};

TEST_F(SplitsumCompare, MeasuresEveryKindOfAssetAgainstItsPanorama) {
    for (const char* asset : {"chain.ktx2", "chain.exr", "diffuse.ktx2", "e.ktx2", "long.json"}) {
        const auto run = compare({path(asset), "--panorama", lopsided, "--limit", "rel_rms=0.02"});
        EXPECT_EQ(run.exit_code, 0) << asset << "\n" << run.out << run.err;
        EXPECT_EQ(run.err, "");
        EXPECT_EQ(run.out.find("note: the asset says"), std::string::npos) << run.out;
    }
}

TEST_F(SplitsumCompare, ExitsWithOneOverALimitAndNamesTheFigure) {
    for (const char* limit :
         {"rel_rms=1e-4", "max_rel=1e-4", "max_abs=1e-4", "bias=1e-9", "1e-4"}) {
        const auto run = compare({path("rough.ktx2"), "--panorama", lopsided, "--limit", limit});
        EXPECT_EQ(run.exit_code, 1) << limit << run.err;
        EXPECT_EQ(run.err, "");
        const std::string name = std::string(limit) == "1e-4" ? "rel_rms" : limit;
        EXPECT_NE(run.out.find(": " + name.substr(0, name.find('=')) + " "), std::string::npos)
            << run.out;
    }
    // One of several is enough.
    EXPECT_EQ(compare({path("rough.ktx2"), "--panorama", lopsided, "--limit", "max_abs=1e9",
                       "--limit", "rel_rms=1e-4"})
                  .exit_code,
              1);
    EXPECT_EQ(compare({path("rough.ktx2"), "--panorama", lopsided}).exit_code, 0);
}

// Every number of the table for people is in the JSON, level by level.
TEST_F(SplitsumCompare, JsonIsAsCompleteAsTheText) {
    const std::vector<std::string> call = {path("rough.ktx2"), "--panorama", lopsided, "--limit",
                                           "rel_rms=1e-4"};
    auto json_call = call;
    json_call.push_back("--json");
    const auto text = compare(call), json_run = compare(json_call);
    EXPECT_EQ(json_run.exit_code, 1);
    const Json json = Json::parse(json_run.out);
    std::istringstream lines(text.out);
    size_t level = 0, over = 0;
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string name, number;
        int size = 0, probes = 0;
        double roughness, rel_rms, max_rel, bias;
        words >> name >> number;
        if (name != "level") continue;
        if (number.back() == ':') {
            EXPECT_EQ(json["over_limit"].at(over++), line);
            continue;
        }
        ASSERT_TRUE(words >> size >> roughness >> rel_rms >> max_rel >> bias >> probes) << line;
        const Json& entry = json["levels"].at(level++);
        EXPECT_EQ(std::to_string(int(entry["level"])), number);
        EXPECT_EQ(entry["face_size"], size);
        EXPECT_EQ(entry["texels"], probes);
        EXPECT_NEAR(entry["perceptual_roughness"], roughness, 1e-4);
        EXPECT_NEAR(entry["rel_rms"], rel_rms, 6e-3 * rel_rms);
        EXPECT_NEAR(entry["max_rel"], max_rel, 6e-3 * max_rel);
        EXPECT_NEAR(entry["bias"], bias, 6e-3 * std::abs(bias));
        EXPECT_TRUE(entry["max_abs"].is_number());
        EXPECT_EQ(entry["mean_radiance"].size(), 3u);
    }
    EXPECT_EQ(level, 4u);
    EXPECT_EQ(over, json["over_limit"].size());
    EXPECT_GE(over, 3u);
    EXPECT_EQ(json["notes"].size(), 0u);
}

TEST_F(SplitsumCompare, ComparesAssetsWithAssets) {
    const auto json_of = [](const ProgramResult& run) { return Json::parse(run.out)["levels"]; };
    const std::pair<const char*, const char*> same[] = {{"chain.ktx2", "chain.exr"},
                                                        {"chain.ktx2", "chain.ktx2"},
                                                        {"table.ktx2", "table.exr"},
                                                        {"series.json", "series.json"}};
    for (const auto& [a, b] : same) {
        const auto run = compare({path(a), path(b), "--limit", "max_abs=0", "--json"});
        EXPECT_EQ(run.exit_code, 0) << a << " " << b << run.out << run.err;
        EXPECT_EQ(json_of(run)[0]["rel_rms"], 0);
        EXPECT_GT(json_of(run)[0]["texels"], 0);
    }
    EXPECT_EQ(json_of(compare({path("chain.ktx2"), path("chain.exr"), "--json"})).size(), 4u);
    const auto differ = compare({path("rough.ktx2"), path("chain.ktx2"), "--limit", "0.001"});
    EXPECT_EQ(differ.exit_code, 1) << differ.out;
    EXPECT_EQ(
        compare({path("other.ktx2"), path("table.ktx2"), "--limit", "max_abs=0.01"}).exit_code, 1);
}

// E is pi times E / pi, and the file that holds E says so.
TEST_F(SplitsumCompare, KnowsWhatAnIrradianceCubemapHolds) {
    const auto ratio = levels_in(path("e.ktx2"))[0].at(1, 2, 3).x /
                       levels_in(path("diffuse.ktx2"))[0].at(1, 2, 3).x;
    EXPECT_NEAR(ratio, 3.14159265, 4e-3);
}

TEST_F(SplitsumCompare, NeedsToBeToldWhatAForeignFileHolds) {
    const auto silent = compare({path("foreign.ktx2"), "--panorama", lopsided});
    expect_failure(tool, silent, 5);
    EXPECT_NE(silent.err.find("--as"), std::string::npos) << silent.err;
    for (const auto& [name, kind] :
         {std::pair{"foreign.ktx2", "specular"}, {"foreign_diffuse.ktx2", "irradiance"}}) {
        const auto told =
            compare({path(name), "--as", kind, "--panorama", lopsided, "--limit", "0.02"});
        EXPECT_EQ(told.exit_code, 0) << told.out << told.err;
    }
    const auto wrong = compare({path("foreign_diffuse.ktx2"), "--as", "specular", "--panorama",
                                lopsided, "--limit", "0.02"});
    EXPECT_EQ(wrong.exit_code, 1) << wrong.out;  // a diffuse cubemap is no mirror image
    // Another curve of roughness than the chain was made with shows.
    const auto curve = compare({path("foreign.ktx2"), "--as", "specular", "--roughness", "filament",
                                "--panorama", lopsided, "--limit", "0.02"});
    EXPECT_EQ(curve.exit_code, 1) << curve.out;
}

TEST_F(SplitsumCompare, NotesAnotherPanorama) {
    const auto run = compare({path("chain.ktx2"), "--panorama", data + "/panoramas/studio.exr"});
    EXPECT_EQ(run.exit_code, 0);
    EXPECT_NE(run.out.find("note: the asset says it was made from lopsided.exr"), std::string::npos)
        << run.out;
}

TEST_F(SplitsumCompare, FindsThatCertificatesHold) {
    for (const char* asset : {"chain.ktx2", "chain.exr", "zstd.ktx2", "quick.ktx2", "rough.ktx2",
                              "diffuse.ktx2", "e.ktx2"}) {
        const auto alone = compare({path(asset)});
        EXPECT_EQ(alone.exit_code, 0) << asset << "\n" << alone.out << alone.err;
        EXPECT_NE(alone.out.find("certificate: holds"), std::string::npos) << alone.out;
        const auto measured = compare({path(asset), "--panorama", lopsided, "--json"});
        EXPECT_EQ(measured.exit_code, 0) << asset << "\n" << measured.out << measured.err;
        const Json certificate = Json::parse(measured.out)["certificate"];
        EXPECT_EQ(certificate["holds"], true);
        EXPECT_EQ(certificate["measured"], true);
    }
}

TEST_F(SplitsumCompare, NoticesTexelsAndKeysThatWereTamperedWith) {
    for (const char* ending : {".ktx2", ".exr"}) {
        const auto original = read_texture(path(std::string("chain") + ending));
        ASSERT_TRUE(original);
        auto texels = *original, keys = *original;
        texels.levels[1][8] ^= std::byte{1};  // the last bit of a red half float
        keys.metadata["splitsum.perceptual_roughness"] = "0 0.3 0.6 1";
        for (const TextureAsset& changed : {texels, keys}) {
            const std::string file = (folder_ / (std::string("changed") + ending)).string();
            ASSERT_TRUE(write_texture(changed, file));
            const auto run = compare({file});
            EXPECT_EQ(run.exit_code, 1) << run.out;
            EXPECT_EQ(run.err, "");
            EXPECT_NE(run.out.find("certificate: the texels or keys are not those"),
                      std::string::npos)
                << run.out;
        }
    }
}

// Only who has the panorama can tell a sealed lie; the file alone looks well.
TEST_F(SplitsumCompare, MeasuresWhetherCertifiedFiguresAreTrue) {
    auto texture = read_texture(path("rough.ktx2"));
    ASSERT_TRUE(texture);
    texture->metadata["splitsum.certificate.rel_rms"] = "0.0001 0.0001 0.0001 0.0001";
    texture->metadata["splitsum.certificate.hash"] = certificate_hash(*texture);
    const std::string file = (folder_ / "liar.ktx2").string();
    ASSERT_TRUE(write_texture(*texture, file));
    EXPECT_EQ(compare({file}).exit_code, 0);
    const auto run = compare({file, "--panorama", lopsided, "--json"});
    EXPECT_EQ(run.exit_code, 1) << run.out;
    const Json certificate = Json::parse(run.out)["certificate"];
    EXPECT_EQ(certificate["holds"], false);
    EXPECT_GE(certificate["contradictions"].size(), 3u);
    // Another panorama has other figures; what was certified is not about it.
    const auto other = compare({file, "--panorama", data + "/panoramas/studio.exr"});
    EXPECT_EQ(other.exit_code, 0);
    EXPECT_NE(other.out.find("were not measured again"), std::string::npos) << other.out;
}

TEST_F(SplitsumCompare, SaysPlainlyThatThereIsNoCertificate) {
    const auto alone = compare({path("older.ktx2")});
    expect_failure(tool, alone, 5);
    EXPECT_NE(alone.err.find("carries no certificate"), std::string::npos) << alone.err;
    const auto measured = compare({path("older.ktx2"), "--panorama", lopsided});
    EXPECT_EQ(measured.exit_code, 0);
    EXPECT_NE(measured.out.find("note: the asset carries no certificate"), std::string::npos)
        << measured.out;
}

TEST_F(SplitsumCompare, RefusesWhatCannotBeCompared) {
    const struct {
        std::vector<std::string> arguments;
        int exit_code;
    } calls[] = {
        {{path("chain.ktx2"), path("chain.exr"), "--panorama", lopsided}, 2},
        {{path("chain.ktx2"), "--panorama", lopsided, "--limit", "rms=1"}, 2},
        {{path("chain.ktx2"), "--panorama", lopsided, "--limit", "rel_rms=small"}, 2},
        {{path("chain.ktx2"), "--panorama", lopsided, "--limit", "rel_rms=-1"}, 2},
        {{path("chain.ktx2"), "--panorama", lopsided, "--limit", "nan"}, 2},
        {{path("chain.ktx2"), "--panorama", lopsided, "--as", "sound"}, 2},
        {{path("chain.ktx2"), "--panorama", lopsided, "--probes", "0"}, 2},
        {{path("chain.ktx2"), "--panorama", lopsided, "--roughness", "round"}, 2},
        {{path("chain.ktx2"), "--panorama", lopsided, "--roughness", "0,1"}, 5},
        {{path("none.ktx2"), "--panorama", lopsided}, 3},
        {{path("table.ktx2")}, 5},
        {{path("series.json")}, 5},
        {{path("foreign.ktx2")}, 5},
        {{path("foreign.ktx2"), "--as", "specular"}, 5},
        {{path("chain.ktx2"), "--panorama", path("none.exr")}, 3},
        {{data + "/malformed/truncated.exr", "--panorama", lopsided}, 3},
        {{path("chain.ktx2"), path("none.ktx2")}, 3},
        {{path("chain.ktx2"), "--panorama", data + "/unusable/nan.exr"}, 5},
        {{path("chain.ktx2"), path("table.ktx2")}, 5},
        {{path("chain.ktx2"), path("small.ktx2")}, 5},
        {{path("table.ktx2"), path("large.ktx2")}, 5},
        {{path("series.json"), path("long.json")}, 5},
        // Once these compared nothing and passed.
        {{path("table.ktx2"), "--panorama", lopsided, "--limit", "0"}, 5},
        {{path("table.ktx2"), "--panorama", lopsided, "--as", "specular"}, 5},
        {{path("table.ktx2"), "--panorama", lopsided, "--as", "irradiance"}, 5},
    };
    for (const auto& [arguments, exit_code] : calls) {
        std::string call;
        for (const std::string& argument : arguments) call += argument + " ";
        SCOPED_TRACE(call);
        expect_failure(tool, compare(arguments), exit_code);
    }
}

}  // namespace
}  // namespace splitsum::tests
