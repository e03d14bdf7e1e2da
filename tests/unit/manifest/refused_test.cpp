// What is refused, with the line where it stands.
#include <gtest/gtest.h>

#include <algorithm>

#include "manifests.h"
#include "splitsum/base/text.h"

namespace splitsum {
namespace {

using tests::Manifests;

struct Refused {
    const char* what;
    std::string text;
    std::string message;  // begins like this
};

std::ostream& operator<<(std::ostream& stream, const Refused& refused) {
    return stream << refused.what;
}

class RefusedToml : public testing::TestWithParam<Refused> {};
class RefusedJson : public testing::TestWithParam<Refused> {};

std::string name_of(const testing::TestParamInfo<Refused>& info) { return info.param.what; }

TEST_P(RefusedToml, WithItsLine) {
    const Manifests manifests;
    const std::string message = manifests.message_of("a.toml", GetParam().text);
    EXPECT_EQ(message.substr(0, GetParam().message.size()), GetParam().message) << message;
}

TEST_P(RefusedJson, WithItsLine) {
    const Manifests manifests;
    const std::string message = manifests.message_of("a.json", GetParam().text);
    EXPECT_EQ(message.substr(0, GetParam().message.size()), GetParam().message) << message;
}

const std::string list = "panoramas = ['a.exr']\n";

INSTANTIATE_TEST_SUITE_P(
    Manifest, RefusedToml,
    testing::Values(
        Refused{"Syntax", "\n\nsize = = 3", "a.toml:3: "},
        Refused{"Unfinished", "panoramas = [\n'a'\n", "a.toml:"},
        Refused{"DuplicateKey", "[defaults]\nsize = 1\nsize = 2\n", "a.toml:3: "},
        Refused{"DuplicateTable", "[defaults]\n[defaults]\n", "a.toml:2: "},
        Refused{"Empty", "", "a.toml:1: names no panorama"},
        Refused{"EmptyList", "panoramas = []", "a.toml:1: names no panorama"},
        Refused{"DefaultsAlone", "[defaults]\nsize = 3\n", "a.toml:1: names no panorama"},
        Refused{"MisspeltTopKey", "\npanorama = ['a']",
                "a.toml:2: there is no 'panorama' here; did you mean panoramas?"},
        Refused{"UnknownTopKey", list + "colours = 3",
                "a.toml:2: there is no 'colours' here; there are: include, defaults, panoramas"},
        Refused{"SettingOnTop", "size = 3\n" + list,
                "a.toml:1: size is a setting; it belongs into the defaults or to a panorama"},
        Refused{"MisspeltSetting", "[[panoramas]]\nfile = 'a'\nsise = 3",
                "a.toml:3: there is no 'sise' here; did you mean size?"},
        Refused{"Underscore", list + "[defaults]\nocio_config = 'c'",
                "a.toml:3: there is no 'ocio_config' here; did you mean ocio-config?"},
        Refused{"UnknownSetting", "[[panoramas]]\nfile = 'a'\ngamut-mapping = 3",
                "a.toml:3: there is no 'gamut-mapping' here; there are: file, name, only, except, "
                "size, exposure, rotate, repair, verify, layer, roughness, ocio-config"},
        Refused{"RunOptionsAreNotSuggestedForPanoramas", "[[panoramas]]\nfile = 'a'\nthread = 3",
                "a.toml:3: there is no 'thread' here; there are: file"},
        Refused{"FileAmongDefaults", list + "[defaults]\nfile = 'a'",
                "a.toml:3: there is no 'file'"},
        Refused{"NegatedFlag", list + "[defaults]\nno-verify = true",
                "a.toml:3: there is no setting 'no-verify'; write verify = false"},
        Refused{"RunOptionOfAPanorama", "[[panoramas]]\nfile = 'a'\nthreads = 3",
                "a.toml:3: threads holds for the whole run, not for one panorama; move it to the "
                "defaults"},
        Refused{"CommandLineOption", list + "[defaults]\nforce = true",
                "a.toml:3: force cannot be set in a manifest; give --force on the command line"},
        Refused{"FlagOfText", list + "[defaults]\nrepair = 'yes'",
                "a.toml:3: repair: found 'yes'; it takes true or false"},
        Refused{"FlagOfNumber", list + "[defaults]\nrepair = 1",
                "a.toml:3: repair: found 1; it takes true or false"},
        Refused{"NumberOfText", list + "[defaults]\nsize = '512'",
                "a.toml:3: size: found '512'; it takes a number, without quotes"},
        Refused{"NumberOfTable", list + "[defaults.size]\na = 3",
                "a.toml:2: size: found a table; "},
        Refused{"NumberOfFlag", list + "[defaults]\nsize = true", "a.toml:3: size: found true; "},
        Refused{"TextOfNumber", list + "[defaults]\nlayer = 3", "a.toml:3: layer: found 3; "},
        Refused{"EmptyText", list + "[defaults]\nlayer = ''",
                "a.toml:3: layer: found empty text; it takes text in quotes"},
        Refused{"EmptyNumbers", list + "[defaults]\nroughness = []",
                "a.toml:3: roughness: found an empty list; "},
        Refused{"TextAmongNumbers", list + "[defaults]\nroughness = [0, 'a']",
                "a.toml:3: roughness: found a list; it takes a list of numbers"},
        Refused{"NaN", list + "[defaults]\nexposure = nan",
                "a.toml:3: exposure: found nan, not a number"},
        Refused{"Infinity", list + "[defaults]\nexposure = -inf", "a.toml:3: exposure: found -inf"},
        Refused{"InfinityInAList", list + "[defaults]\nroughness = [0, inf]",
                "a.toml:3: roughness: found a list"},
        Refused{"Beyond2To53", list + "[defaults]\nsize = 9007199254740993",
                "a.toml:3: size: found 9007199254740993, a whole number beyond 2^53"},
        Refused{"Beyond64Bits", list + "[defaults]\nsize = 9223372036854775808", "a.toml:3: "},
        Refused{"Date", list + "[defaults]\nsize = 2024-05-27",
                "a.toml:3: size: found a date or time"},
        Refused{"FileOfNumber", "[[panoramas]]\nfile = 3",
                "a.toml:2: file: found 3; it takes the name of a panorama or a folder, in quotes"},
        Refused{"NoFile", list + "[[defaults]]\n", "a.toml:2: defaults: found a list"},
        Refused{"PanoramaWithoutFile", "\n[[panoramas]]\nname = 'a'",
                "a.toml:2: this panorama has no file"},
        Refused{"PanoramaOfNumber", "panoramas = ['a',\n3]",
                "a.toml:2: found 3 where a panorama should be"},
        Refused{"PanoramasOfTable", "[panoramas]\nfile = 'a'",
                "a.toml:1: panoramas: found a table; it is a list: [[panoramas]] in TOML"},
        Refused{"PatternOfNumber", "[[panoramas]]\nfile = 'a'\nonly = 3",
                "a.toml:3: only: found 3"},
        Refused{"IncludeOfText", "include = 'a'\n" + list,
                "a.toml:1: include: found 'a'; it is a list of manifests"},
        Refused{"IncludeOfNumber", "include = [3]\n" + list, "a.toml:1: include: found 3"},
        Refused{"Nul", list + std::string("#\0\n", 3), "a.toml:2: byte 23 is a control character"},
        Refused{"Latin1", list + "# \xE9t\xE9\n", "a.toml:2: byte 24 is not UTF-8"},
        Refused{"Surrogate", "# \xED\xA0\x80", "a.toml:1: byte 2 is not UTF-8"},
        Refused{"Overlong", "# \xC0\xAF", "a.toml:1: byte 2 is not UTF-8"},
        Refused{"Utf16", std::string("\xFF\xFEp\0a\0", 6), "a.toml:1: byte 0 is not UTF-8"},
        Refused{"EscapedNul", "[[panoramas]]\nfile = \"a\\u0000b\"",
                "a.toml:2: file: found text with control characters"},
        Refused{"EscapedNewline", "[[panoramas]]\nfile = \"a\\nb\"", "a.toml:2: file: found text"}),
    name_of);

INSTANTIATE_TEST_SUITE_P(
    Manifest, RefusedJson,
    testing::Values(
        Refused{"Syntax", "{\n\"panoramas\": [\n}", "a.json:3: "},
        Refused{"Empty", "", "a.json:1: "},
        Refused{"List", "[]", "a.json:1: a manifest is an object"},
        Refused{"Behind", "{\"panoramas\": [\"a\"]}\nx", "a.json:2: "},
        Refused{"Comment", "{\n// a\n\"panoramas\": [\"a\"]}", "a.json:2: JSON has no comments"},
        Refused{"CommentInAList", "{\"panoramas\": [\"a/b\",\n/* c */ \"a\"]}", "a.json:2: "},
        Refused{"TrailingComma", "{\"panoramas\": [\"a\"\n,]}", "a.json:2: "},
        Refused{"SingleQuotes", "{'panoramas': ['a']}", "a.json:1: "},
        Refused{"DuplicateKey", "{\"panoramas\": [\"a\"],\n\"panoramas\": [\"a\"]}",
                "a.json:2: Duplicate key: 'panoramas'"},
        Refused{"MisspeltTopKey", "{\n\"panorama\": []}",
                "a.json:2: there is no 'panorama' here; did you mean panoramas?"},
        Refused{"MisspeltSetting", "{\"panoramas\": [\n{\"file\": \"a\",\n\"sise\": 3}]}",
                "a.json:3: there is no 'sise' here; did you mean size?"},
        Refused{"Null", "{\"panoramas\": [{\"file\": \"a\",\n\"size\": null}]}",
                "a.json:2: size: found null"},
        Refused{"LeadingZero", "{\"panoramas\": [{\"file\": \"a\",\n\"size\": 012}]}",
                "a.json:2: size: found 012, which is not how JSON writes numbers"},
        Refused{"TrailingPoint", "{\"panoramas\": [{\"file\": \"a\",\n\"size\": 1.}]}",
                "a.json:2: size: found 1."},
        Refused{"Plus", "{\"panoramas\": [{\"file\": \"a\",\n\"size\": +1}]}",
                "a.json:2: size: found +1"},
        Refused{"MinusAlone", "{\"panoramas\": [{\"file\": \"a\",\n\"size\": -}]}", "a.json:2: "},
        Refused{"TooLarge", "{\"panoramas\": [{\"file\": \"a\",\n\"size\": 1e400}]}", "a.json:2: "},
        Refused{"NaN", "{\"panoramas\": [{\"file\": \"a\",\n\"size\": NaN}]}", "a.json:2: "},
        Refused{"Beyond2To53", "{\"panoramas\": [{\"file\": \"a\",\n\"size\": -9007199254740993}]}",
                "a.json:2: size: found -9007199254740993, a whole number beyond 2^53"},
        Refused{"Beyond64Bits",
                "{\"panoramas\": [{\"file\": \"a\",\n\"size\": 99999999999999999999}]}",
                "a.json:2: size: found 99999999999999999999, a whole number beyond 2^53"},
        Refused{"EscapedNul", "{\"panoramas\": [\n\"a\\u0000b\"]}",
                "a.json:2: found text with control characters where a panorama should be"},
        Refused{"LoneSurrogate", "{\"panoramas\": [\n\"\\udc00\"]}",
                "a.json:2: found text with control characters where a panorama should be"},
        Refused{"NewlineInText", "{\"panoramas\": [\n\"a\nb\"]}",
                "a.json:2: found text with control characters where a panorama should be"},
        Refused{"FlagOfText", "{\"panoramas\": [{\"file\": \"a\",\n\"repair\": \"yes\"}]}",
                "a.json:2: repair: found 'yes'"}),
    name_of);

TEST(RefusedName, LeavesTheOutputFolderOrHides) {
    const Manifests manifests;
    for (const std::string name : {"..", "../a", "a/../../b", "a/..", "/a", "a//b", "a/", ".a",
                                   "a/.source", ".", "a\\\\b", ""}) {
        const std::string message =
            manifests.message_of("a.toml", cat("[[panoramas]]\nfile = 'a'\nname = \"", name, "\""));
        EXPECT_TRUE(message.starts_with("a.toml:3: name: ")) << name << ": " << message;
    }
    for (const std::string name : {"a", "a/b/c", "a..b", "Süd/1.0"})
        EXPECT_EQ(
            manifests.message_of("a.toml", cat("[[panoramas]]\nfile = 'a'\nname = \"", name, "\"")),
            "");
}

TEST(RefusedNames, AreThoseThatWriteTheSameFiles) {
    const Manifests manifests;
    EXPECT_EQ(manifests.message_of("a.toml", "panoramas = ['a/sky.exr',\n'b/sky.hdr']"),
              "a.toml:2: the results would be written over those of a.toml:1, as both are named "
              "'sky'; give one of them another name, such as name = \"other/sky\"");
    EXPECT_TRUE(manifests.message_of("a.toml", "panoramas = ['a.exr',\n'a.exr']")
                    .starts_with("a.toml:2: the results"));
    EXPECT_TRUE(
        manifests.message_of("a.toml", "panoramas = ['a.exr', \n{file = 'b.exr', name = 'a'}]")
            .starts_with("a.toml:2: the results"));
    // Across manifests too.
    manifests.write("b.toml", "\npanoramas = ['sky.hdr']");
    EXPECT_TRUE(manifests.message_of("a.toml", "include = ['b.toml']\npanoramas = ['sky.exr']")
                    .starts_with("a.toml:2: the results would be written over those of b.toml:2"));
}

TEST(RefusedInclude, OfACircleShowsIt) {
    const Manifests manifests;
    manifests.write("b.toml", "include = ['c.json']\n");
    manifests.write("c.json", "{\n\"include\": [\"./sub/../a.toml\"]}");
    std::filesystem::create_directories(manifests / "sub");
    EXPECT_EQ(manifests.message_of("a.toml", "include = ['b.toml']\n" + list),
              "c.json:2: manifests include each other in a circle: a.toml -> b.toml -> c.json -> "
              "a.toml; leave one of these includes out");
    EXPECT_TRUE(manifests.message_of("d.toml", "\ninclude = ['d.toml']\n" + list)
                    .starts_with("d.toml:2: manifests include each other in a circle: d.toml -> "
                                 "d.toml"));
    std::filesystem::create_symlink(manifests / "e.toml", manifests / "link.toml");
    EXPECT_TRUE(manifests.message_of("e.toml", "include = ['link.toml']\n" + list)
                    .starts_with("e.toml:1: manifests include each other in a circle"));
}

TEST(RefusedInclude, OfOneFileTwiceNamesBothPlaces) {
    const Manifests manifests;
    manifests.write("c.toml", "panoramas = ['c.exr']");
    manifests.write("b.toml", "\ninclude = ['c.toml']");
    EXPECT_EQ(manifests.message_of("a.toml", "include = ['b.toml', 'c.toml']\n" + list),
              "a.toml:1: c.toml is included already, at b.toml:2; once is enough");
}

TEST(RefusedInclude, OfWhatIsNoManifest) {
    const Manifests manifests;
    manifests.write("empty.toml", "\n");
    manifests.write("run.toml", list + "[defaults]\nthreads = 2\n");
    manifests.write("list.txt", list);
    std::filesystem::create_directories(manifests / "folder.toml");
    const auto message = [&](const std::string& name) {
        return manifests.message_of("a.toml", cat("include = ['", name, "']\n"));
    };
    EXPECT_EQ(message("missing.toml"),
              "a.toml:1: missing.toml cannot be read: No such file or directory");
    EXPECT_TRUE(message("folder.toml").starts_with("a.toml:1: folder.toml is a folder"));
    EXPECT_TRUE(message("list.txt").starts_with("a.toml:1: list.txt is no manifest by its name"));
    EXPECT_TRUE(message("empty.toml").starts_with("empty.toml:1: names no panorama"));
    EXPECT_TRUE(message("run.toml")
                    .starts_with("run.toml:3: threads holds for the whole run, and "
                                 "a.toml includes this manifest; move it there"));
}

TEST(RefusedInclude, OfAnEndlessChain) {
    const Manifests manifests;
    for (int i = 0; i < 100; ++i)
        manifests.write(cat(i, ".toml"),
                        cat("include = ['", i + 1, ".toml']\npanoramas = ['", i, ".exr']"));
    EXPECT_NE(manifests.message_of("a.toml", "include = ['0.toml']").find("more than 32 manifests"),
              std::string::npos);
}

TEST(RefusedFile, IsNamed) {
    const Manifests manifests;
    const auto missing = read_manifest(manifests / "none.toml", tests::some_options());
    ASSERT_FALSE(missing);
    EXPECT_EQ(missing.error().kind, ErrorKind::unreadable_input);
    EXPECT_EQ(manifests.shortened(missing.error().message),
              "none.toml: cannot be read: No such file or directory");
    EXPECT_TRUE(manifests.message_of("bake.yaml", list)
                    .starts_with("bake.yaml: is no manifest by its name; that ends in .toml or"));
    EXPECT_TRUE(manifests.message_of("a.toml", std::string((16 << 20) + 1, '\n'))
                    .starts_with("a.toml: is larger than 16 MiB"));
}

TEST(RefusedKinds, SayWhetherAFileOrItsMeaningIsWrong) {
    const Manifests manifests;
    EXPECT_EQ(manifests.read("a.toml", "a = = 3").error().kind, ErrorKind::unreadable_input);
    EXPECT_EQ(manifests.read("a.toml", "a = 3").error().kind, ErrorKind::bad_argument);
}

// Parsers call themselves for every level, and so do those that take the results down.
TEST(RefusedNesting, DoesNotExhaustTheStack) {
    const Manifests manifests;
    std::string dots = "a", dots_in_quotes = "\"=\"", spaced = "a", opened, tables;
    for (int i = 0; i < 1'000'000; ++i) {
        dots += ".a";
        dots_in_quotes += ".\"=\"";
        spaced += " . a";
        opened += "[";
        tables += "{\"a\":";
    }
    for (const std::string& text :
         {list + dots + " = 1", list + dots_in_quotes + " = 1", list + spaced + " = 1",
          list + "[" + dots + "]", list + "b = {" + dots + " = 1}", list + "b = " + opened})
        EXPECT_EQ(manifests.message_of("a.toml", text),
                  "a.toml:2: is nested deeper than any manifest needs to be");
    for (const std::string& text : {"{\n\"a\": " + opened, "{\n\"a\": " + tables})
        EXPECT_EQ(manifests.message_of("a.json", text),
                  "a.json:2: is nested deeper than any manifest needs to be");
    // In JSON these are no quotes and no comment: what follows them must be no deeper either.
    for (const std::string before : {"'", "#"})
        EXPECT_NE(manifests.message_of("a.json", "{\"a\": " + before + opened), "");
}

TEST(RefusedNesting, LeavesDotsAndBracketsInTextAlone) {
    const Manifests manifests;
    const std::string many(100, '.');
    const std::string brackets(100, '[');
    EXPECT_EQ(manifests.message_of(
                  "a.toml", cat("panoramas = ['a", many, "', \"b", brackets, "\\\"", brackets,
                                "\", '''c", brackets, "'''] # ", brackets, "\n")),
              "");
    std::string numbers = "0.0";
    for (int i = 1; i < 100; ++i) numbers += cat(", 0.", i);
    EXPECT_EQ(manifests.message_of("a.toml", cat(list, "[defaults]\nroughness = [", numbers, "]")),
              "");
}

TEST(Problems, AreAllToldUpToTen) {
    const Manifests manifests;
    manifests.write("b.toml", "x = 1\npanoramas = ['b.exr']\n[defaults]\nsize = 'a'\n");
    EXPECT_EQ(manifests.message_of("a.toml",
                                   "include = ['b.toml']\n[[panoramas]]\nname = '..'\n"
                                   "[defaults]\nsize = true\nsise = 3\n"),
              "a.toml:2: this panorama has no file; add file = \"sky.exr\"\n"
              "a.toml:3: name: '..' leads out of it; it names a folder below the output folder, "
              "such as \"dusk/red\"\n"
              "a.toml:5: size: found true; it takes a number, without quotes\n"
              "a.toml:6: there is no 'sise' here; did you mean size?\n"
              "b.toml:1: there is no 'x' here; there are: include, defaults, panoramas\n"
              "b.toml:4: size: found 'a'; it takes a number, without quotes");
    std::string many = list + "[defaults]\n";
    for (int i = 0; i < 23; ++i) many += cat("unknown-", i, " = 1\n");
    const std::string message = manifests.message_of("a.toml", many);
    EXPECT_EQ(std::ranges::count(message, '\n'), 10);
    EXPECT_TRUE(message.starts_with("a.toml:3: "));
    EXPECT_TRUE(message.ends_with("\nand 13 more problems"));
}

// A message stays one line however odd the text that it repeats.
TEST(Problems, RepeatTextInShortAndWithoutControlCharacters) {
    const Manifests manifests;
    const std::string long_key(100'000, 'k');
    const std::string message = manifests.message_of("a.toml", long_key + " = 1\n" + list);
    EXPECT_LT(message.size(), 300u);
    EXPECT_EQ(manifests.message_of("a.toml", "\"a\\nb\" = 1\n" + list),
              "a.toml:1: there is no 'a?b' here; there are: include, defaults, panoramas");
}

}  // namespace
}  // namespace splitsum
