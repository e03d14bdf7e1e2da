// What valid manifests mean.
#include "splitsum/manifest/manifest.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>

#include "manifests.h"
#include "splitsum/base/text.h"

namespace splitsum {
namespace {

using tests::Manifests;

// Everything that the format has, in both notations.
const std::string full_toml = R"(# A library of skies.
include = ["more/studio.toml"]

[defaults]
size = 512
repair = true
roughness = [0, 0.3, 1]
threads = 4
table-size = "auto"

[[panoramas]]
file = "hdri/dusk.exr"
name = "dusk/red"
rotate = 90
exposure = -1.5
repair = false

[[panoramas]]
file = "hdri/dusk.exr"
name = "dusk/blue"
roughness = "filament"
ocio-config = "colour/config.ocio"

[[panoramas]]
file = "captures"
only = ["*.exr", "*.hdr"]
except = "*_ldr*"
)";
const std::string full_json = R"({
    "include": ["more/studio.json"],
    "defaults": {"size": 512, "repair": true, "roughness": [0, 0.3, 1], "threads": 4,
                 "table-size": "auto"},
    "panoramas": [
        {"file": "hdri/dusk.exr", "name": "dusk/red", "rotate": 90, "exposure": -1.5,
         "repair": false},
        {"file": "hdri/dusk.exr", "name": "dusk/blue", "roughness": "filament",
         "ocio-config": "colour/config.ocio"},
        {"file": "captures", "only": ["*.exr", "*.hdr"], "except": "*_ldr*"}
    ]
}
)";

class FullManifest : public testing::Test {
protected:
    FullManifest() {
        manifests_.write("more/studio.toml",
                         "panoramas = [\"studio.hdr\"]\n[defaults]\nsize = 64\nlayer = 'sky'\n");
        manifests_.write(
            "more/studio.json",
            R"({"panoramas": ["studio.hdr"], "defaults": {"size": 64, "layer": "sky"}})");
    }
    Manifests manifests_;
};

TEST_F(FullManifest, SaysWhatItsFormatPromises) {
    const auto manifest = manifests_.read("bake.toml", full_toml);
    ASSERT_TRUE(manifest) << manifest.error().message;
    EXPECT_EQ(manifests_.essence_of(*manifest),
              "run table-size=auto threads=4\n"
              "more/studio.hdr name=(none) only= except= layer=sky repair?=true roughness=0,0.3,1 "
              "size=64\n"
              "hdri/dusk.exr name=dusk/red only= except= exposure=-1.5 repair?=false "
              "rotate=90 roughness=0,0.3,1 size=512\n"
              "hdri/dusk.exr name=dusk/blue only= except= ocio-config=colour/config.ocio "
              "repair?=true roughness=filament size=512\n"
              "captures name=(none) only=*.exr;*.hdr; except=*_ldr*; repair?=true "
              "roughness=0,0.3,1 size=512\n");
}

TEST_F(FullManifest, IsTheSameInBothNotations) {
    const auto toml = manifests_.read("bake.toml", full_toml);
    const auto json = manifests_.read("bake.json", full_json);
    ASSERT_TRUE(toml) << toml.error().message;
    ASSERT_TRUE(json) << json.error().message;
    EXPECT_EQ(manifests_.essence_of(*toml), manifests_.essence_of(*json));
}

TEST_F(FullManifest, KnowsWhereEverythingStands) {
    const auto manifest = manifests_.read("bake.toml", full_toml);
    ASSERT_TRUE(manifest) << manifest.error().message;
    ASSERT_EQ(manifest->files.size(), 2u);
    EXPECT_EQ(manifest->files[0], manifests_ / "bake.toml");
    EXPECT_EQ(manifest->files[1], manifests_ / "more/studio.toml");
    const ManifestPanorama& studio = manifest->panoramas[0];
    const ManifestPanorama& red = manifest->panoramas[1];
    EXPECT_EQ(manifests_.shortened(place_of(studio)), "more/studio.toml:1");
    EXPECT_EQ(manifests_.shortened(place_of(red)), "bake.toml:11");
    std::string places;
    for (const Setting& setting : studio.settings)
        places += setting.option + " " + manifests_.shortened(place_of(setting)) + "\n";
    EXPECT_EQ(places,
              "layer more/studio.toml:4\n"
              "repair bake.toml:6\n"
              "roughness bake.toml:7\n"
              "size more/studio.toml:3\n");
}

// A manifest that is cut off anywhere is refused or says less, and never anything else.
void expect_prefixes_to_be_refused_or_valid(const Manifests& manifests, const std::string& name,
                                            const std::string& text) {
    int refused = 0;
    for (size_t length = 0; length < text.size(); ++length) {
        const auto manifest = manifests.read(name, text.substr(0, length));
        if (manifest) {
            EXPECT_FALSE(manifest->panoramas.empty());
            continue;
        }
        ++refused;
        EXPECT_TRUE(manifests.shortened(manifest.error().message).starts_with(name + ":"))
            << manifest.error().message;
    }
    EXPECT_GT(refused, 0);
}

TEST_F(FullManifest, IsRefusedOrShorterWhereItIsCutOff) {
    expect_prefixes_to_be_refused_or_valid(manifests_, "bake.toml", full_toml);
}

TEST_F(FullManifest, InJsonHasNoPrefixThatIsValid) {
    expect_prefixes_to_be_refused_or_valid(manifests_, "bake.json", full_json);
    const size_t end = full_json.find_last_of('}');
    for (size_t length = 0; length < end; length += 7)
        EXPECT_FALSE(manifests_.read("bake.json", full_json.substr(0, length))) << length;
}

// A letter that is replaced, wherever it is, never does worse than an error with a line.
TEST_F(FullManifest, SurvivesEveryReplacedByte) {
    for (const std::string name : {"bake.toml", "bake.json"}) {
        const std::string& text = name == "bake.toml" ? full_toml : full_json;
        for (size_t at = 0; at < text.size(); at += 5)
            for (const char letter : {'"', '[', '\n', '\xFF'}) {
                std::string changed = text;
                changed[at] = letter;
                const auto manifest = manifests_.read(name, changed);
                if (manifest) continue;
                EXPECT_TRUE(manifests_.shortened(manifest.error().message).starts_with(name + ":"))
                    << manifest.error().message;
            }
    }
}

TEST(Manifest, PathsAreRelativeToTheManifestThatNamesThem) {
    const Manifests manifests;
    manifests.write("below/more.toml",
                    "[[panoramas]]\nfile = \"../sky.exr\"\nocio-config = \"/etc/config.ocio\"\n");
    const auto manifest = manifests.read("bake.toml",
                                         "include = [\"below/more.toml\"]\n"
                                         "panoramas = [\"/data/night.exr\", \"./a/../b.exr\"]\n"
                                         "[defaults]\noutput = \"out\"\n");
    ASSERT_TRUE(manifest) << manifest.error().message;
    EXPECT_EQ(manifest->panoramas[0].file, manifests / "sky.exr");
    EXPECT_EQ(manifest->panoramas[0].settings[0].value, "/etc/config.ocio");
    EXPECT_EQ(manifest->panoramas[1].file, "/data/night.exr");
    EXPECT_EQ(manifest->panoramas[2].file, manifests / "b.exr");
    EXPECT_EQ(manifest->run[0].value, (manifests / "out").string());
}

// Numbers arrive as they were meant, to the last bit, however they are written.
TEST(Manifest, NumbersReadBackAsTheSame) {
    const Manifests manifests;
    for (const double number :
         {0.1, -1.5, 1e-5, 2.5e-300, 1.7976931348623157e308, 1.0 / 3, 90.0, 0.0, 5e-324}) {
        char digits[40];
        snprintf(digits, sizeof digits, "%.17e", number);
        for (const std::string notation : {"toml", "json"}) {
            const std::string text =
                notation == "toml" ? cat("panoramas = ['a.exr']\n[defaults]\nexposure = ", digits)
                                   : cat("{\"panoramas\": [\"a.exr\"], \"defaults\": "
                                         "{\"exposure\": ",
                                         digits, "}}");
            const auto manifest = manifests.read("bake." + notation, text);
            ASSERT_TRUE(manifest) << manifest.error().message;
            EXPECT_EQ(strtod(manifest->panoramas[0].settings[0].value.c_str(), nullptr), number);
        }
    }
}

TEST(Manifest, WholeNumbersKeepAllTheirDigits) {
    const Manifests manifests;
    const std::string largest = "9007199254740992";  // 2^53
    for (const std::string& number : {largest, "-" + largest, std::string("4294967295")})
        for (const std::string& text :
             {cat("{\"panoramas\": [{\"file\": \"a\", \"size\": ", number, "}]}"),
              cat("panoramas = [{file = 'a', size = ", number, "}]")}) {
            const auto manifest = manifests.read(text[0] == '{' ? "a.json" : "a.toml", text);
            ASSERT_TRUE(manifest) << manifest.error().message;
            EXPECT_EQ(manifest->panoramas[0].settings[0].value, number);
        }
}

TEST(Manifest, LineEndsAndAByteOrderMarkChangeNothing) {
    const Manifests manifests;
    const std::string text = "[defaults]\nsize = 64\n\n[[panoramas]]\nfile = \"a.exr\"\n";
    std::string with_returns = "\xEF\xBB\xBF";
    for (const char c : text) with_returns += c == '\n' ? "\r\n" : std::string(1, c);
    const auto plain = manifests.read("bake.toml", text);
    const auto other = manifests.read("bake.toml", with_returns);
    ASSERT_TRUE(plain && other);
    EXPECT_EQ(manifests.essence_of(*plain), manifests.essence_of(*other));
    EXPECT_EQ(plain->panoramas[0].line, other->panoramas[0].line);
    EXPECT_EQ(plain->panoramas[0].settings[0].line, other->panoramas[0].settings[0].line);
    EXPECT_TRUE(manifests.read("bake.json", "\xEF\xBB\xBF{\r\n\"panoramas\": [\"a\"]\r\n}"));
}

TEST(Manifest, OnePanoramaMayBeBakedUnderSeveralNames) {
    const Manifests manifests;
    const auto manifest =
        manifests.read("bake.toml",
                       "panoramas = [\n'a.exr',\n{file = 'a.exr', name = 'turned', rotate = 90},\n"
                       "{file = 'b/a.exr', name = 'b/a'}]");
    ASSERT_TRUE(manifest) << manifest.error().message;
    EXPECT_EQ(manifest->panoramas.size(), 3u);
}

// A folder may be listed with several patterns; what they match is not this module's business.
TEST(Manifest, AFolderMayBeListedTwice) {
    const Manifests manifests;
    std::filesystem::create_directories(manifests / "skies");
    const auto manifest = manifests.read("bake.toml",
                                         "[[panoramas]]\nfile = 'skies'\nonly = 'a*'\n"
                                         "[[panoramas]]\nfile = 'skies'\nexcept = 'a*'\n");
    EXPECT_TRUE(manifest) << manifest.error().message;
}

TEST(Manifest, DefaultsOfTheNearestManifestWin) {
    const Manifests manifests;
    manifests.write("c.toml", "panoramas = ['c.exr']\n[defaults]\nrotate = 3\n");
    manifests.write("b.toml",
                    "include = ['c.toml']\npanoramas = ['b.exr']\n[defaults]\nsize = 2\n"
                    "rotate = 2\n");
    const auto manifest = manifests.read("a.toml",
                                         "include = ['b.toml']\npanoramas = ['a.exr']\n[defaults]\n"
                                         "size = 1\nrotate = 1\nexposure = 1\n");
    ASSERT_TRUE(manifest) << manifest.error().message;
    EXPECT_EQ(manifests.essence_of(*manifest),
              "run\n"
              "c.exr name=(none) only= except= exposure=1 rotate=3 size=2\n"
              "b.exr name=(none) only= except= exposure=1 rotate=2 size=2\n"
              "a.exr name=(none) only= except= exposure=1 rotate=1 size=1\n");
}

TEST(Manifest, TenThousandPanoramasAreReadWhole) {
    const Manifests manifests;
    std::string toml = "[defaults]\nsize = 128\n";
    for (int i = 0; i < 10'000; ++i)
        toml += cat("[[panoramas]]\nfile = \"hdri/", i, ".exr\"\nexposure = ", i, ".5\n");
    const auto manifest = manifests.read("bake.toml", toml);
    ASSERT_TRUE(manifest) << manifest.error().message;
    ASSERT_EQ(manifest->panoramas.size(), 10'000u);
    for (size_t i = 0; i < 10'000; ++i) {
        EXPECT_EQ(manifest->panoramas[i].file, manifests / cat("hdri/", i, ".exr"));
        EXPECT_EQ(manifest->panoramas[i].settings[0].value, cat(i, ".5"));
        EXPECT_EQ(manifest->panoramas[i].line, static_cast<int>(3 * i + 3));
    }
}

}  // namespace
}  // namespace splitsum
