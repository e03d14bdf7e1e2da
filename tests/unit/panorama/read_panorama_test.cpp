#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "splitsum/base/file_hash.h"
#include "splitsum/base/parallel.h"
#include "splitsum/panorama/panorama.h"
#include "splitsum/png/write_png.h"

namespace splitsum {
namespace {

namespace fs = std::filesystem;

const fs::path test_data = SPLITSUM_TEST_DATA;

Result<Panorama> read(const std::string& file, const PanoramaOptions& options = {}) {
    NoProgress progress;
    return read_panorama(test_data / file, options, progress);
}

PanoramaOptions repairing() {
    PanoramaOptions options;
    options.repair = true;
    return options;
}

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

bool has_note(const Panorama& panorama, const std::string& part) {
    return std::ranges::any_of(panorama.notes,
                               [&](const std::string& note) { return contains(note, part); });
}

std::vector<float> pixel(const Panorama& panorama, int x, int y) {
    const auto rgb = panorama.pixels.row(y).subspan(3 * static_cast<size_t>(x), 3);
    return {rgb.begin(), rgb.end()};
}

Error refusal(const std::string& file, const PanoramaOptions& options = {}) {
    const auto panorama = read(file, options);
    EXPECT_FALSE(panorama) << file;
    return panorama ? Error{ErrorKind::internal, ""} : panorama.error();
}

TEST(ReadPanorama, DescribesWhereItCameFrom) {
    const auto panorama = read("panoramas/lopsided.exr");
    ASSERT_TRUE(panorama) << panorama.error().message;
    EXPECT_EQ(panorama->pixels.width, 128);
    EXPECT_EQ(panorama->pixels.height, 64);
    EXPECT_EQ(panorama->source, "lopsided.exr");
    const auto hash = hash_of_file(test_data / "panoramas/lopsided.exr");
    EXPECT_EQ(panorama->source_hash, "xxh3-128:" + *hash);
    EXPECT_EQ(panorama->color_space, "lin_rec709");
    EXPECT_TRUE(panorama->found.clean());
    EXPECT_FALSE(panorama->repaired);
    EXPECT_TRUE(panorama->notes.empty());
}

// Red grows along +x (right of the middle), green up, blue towards the middle.
TEST(ReadPanorama, PutsDirectionsWhereTheyBelong) {
    const auto sky = read("panoramas/lopsided.exr");
    ASSERT_TRUE(sky);
    EXPECT_GT(pixel(*sky, 96, 32)[0], pixel(*sky, 32, 32)[0] + 0.5f);
    EXPECT_GT(pixel(*sky, 64, 1)[1], pixel(*sky, 64, 62)[1] + 0.5f);
    EXPECT_GT(pixel(*sky, 64, 32)[2], pixel(*sky, 0, 32)[2] + 0.5f);
}

TEST(ReadPanorama, KeepsTheSun) {
    const auto sky = read("panoramas/sun.exr");
    ASSERT_TRUE(sky);
    EXPECT_EQ(*std::ranges::max_element(sky->pixels.rgb), 1e5f);
    EXPECT_EQ(pixel(*sky, 89, 21), (std::vector<float>{1e5f, 0.92e5f, 0.8e5f}));
}

TEST(ReadPanorama, TakesTheSmallest) { EXPECT_TRUE(read("reading/2x1.exr")); }

TEST(ReadPanorama, RefusesOtherShapes) {
    for (const char* file : {"unusable/square.exr", "unusable/1x1.exr"}) {
        const Error error = refusal(file);
        EXPECT_EQ(error.kind, ErrorKind::unusable_input);
        EXPECT_TRUE(contains(error.message, "twice as wide as high"));
    }
    EXPECT_TRUE(contains(refusal("unusable/square.exr").message, "16x16"));
}

TEST(ReadPanorama, NamesDefectsAndTheWayOut) {
    const auto expect = [](const char* file, const char* found) {
        const Error error = refusal(file);
        EXPECT_EQ(error.kind, ErrorKind::unusable_input);
        EXPECT_TRUE(contains(error.message, found)) << error.message;
        EXPECT_TRUE(contains(error.message, "--repair")) << error.message;
    };
    expect("unusable/nan.exr", "1 NaN (first at x 17, y 4)");
    expect("unusable/inf.exr", "1 infinite (first at x 31, y 0)");
    expect("unusable/half_overflow.exr", "1 infinite (first at x 9, y 15)");
    expect("unusable/negative.exr", "1 negative (first at x 0, y 7)");
    expect("unusable/out_of_gamut.exr", "1 negative (first at x 3, y 2)");
}

TEST(ReadPanorama, RepairsOnRequestAndSaysSo) {
    const auto sound = read("reading/half_zip.exr");
    ASSERT_TRUE(sound);
    for (const char* file : {"unusable/nan.exr", "unusable/inf.exr", "unusable/negative.exr"}) {
        const auto panorama = read(file, repairing());
        ASSERT_TRUE(panorama) << panorama.error().message;
        EXPECT_TRUE(panorama->repaired);
        EXPECT_FALSE(panorama->found.clean());
        EXPECT_TRUE(has_note(*panorama, "repaired"));
        EXPECT_TRUE(take_census(panorama->pixels).clean());
        int changed = 0;
        for (size_t i = 0; i < sound->pixels.rgb.size(); i += 3)
            changed += !std::equal(&sound->pixels.rgb[i], &sound->pixels.rgb[i] + 3,
                                   &panorama->pixels.rgb[i]);
        EXPECT_LE(changed, 1) << file;
    }
}

TEST(ReadPanorama, CountsColoursOutsideTheGamut) {
    const auto panorama = read("unusable/out_of_gamut.exr", repairing());
    ASSERT_TRUE(panorama) << panorama.error().message;
    EXPECT_EQ(panorama->out_of_gamut, 1);
    EXPECT_TRUE(panorama->found.clean());
    EXPECT_TRUE(panorama->repaired);
    EXPECT_EQ(pixel(*panorama, 3, 2)[0], 0);
    EXPECT_GT(pixel(*panorama, 3, 2)[1], 40);
}

TEST(ReadPanorama, ConvertsWhatTheChromaticitiesSay) {
    const auto tagged = read("reading/acescg.exr");
    ASSERT_TRUE(tagged) << tagged.error().message;
    EXPECT_EQ(tagged->color_space, "ACEScg");
    PanoramaOptions options;
    options.color_space = "acescg";
    const auto named = read("reading/half_zip.exr", options);
    ASSERT_TRUE(named);
    EXPECT_EQ(tagged->pixels.rgb, named->pixels.rgb);
    EXPECT_NE(named->pixels.rgb, read("reading/half_zip.exr")->pixels.rgb);
}

TEST(ReadPanorama, TheOptionOverrulesTheFile) {
    PanoramaOptions options;
    options.color_space = "lin_rec709";
    const auto panorama = read("reading/acescg.exr", options);
    ASSERT_TRUE(panorama);
    EXPECT_EQ(panorama->pixels.rgb, read("reading/half_zip.exr")->pixels.rgb);
}

TEST(ReadPanorama, DecodesSrgb) {
    const fs::path path = fs::path(testing::TempDir()) / "srgb_panorama.png";
    ASSERT_TRUE(write_png(path, 2, 1, std::vector<uint8_t>{0, 51, 255, 128, 188, 10}));
    NoProgress progress;
    const auto panorama = read_panorama(path, {}, progress);
    ASSERT_TRUE(panorama) << panorama.error().message;
    EXPECT_EQ(panorama->color_space, "sRGB");
    EXPECT_NEAR(panorama->pixels.rgb[1], 0.0331f, 1e-4f);
    EXPECT_NEAR(panorama->pixels.rgb[3], 0.2159f, 1e-4f);
}

// OpenImageIO says Rec709 for every file of the PNM family.
TEST(ReadPanorama, TakesFloatMapsAsLinear) {
    const auto panorama = read("reading/float.pfm");
    ASSERT_TRUE(panorama);
    EXPECT_EQ(panorama->pixels.rgb, read("reading/float.exr")->pixels.rgb);
}

TEST(ReadPanorama, NotesIntegersOfUnknownSpace) {
    const auto panorama = read("reading/uint16.tif");
    ASSERT_TRUE(panorama);
    EXPECT_EQ(panorama->color_space, "lin_rec709");
    EXPECT_TRUE(has_note(*panorama, "integers"));
}

TEST(ReadPanorama, ExposesInStops) {
    PanoramaOptions options;
    options.exposure_stops = -1.5;
    const auto plain = read("reading/float.exr");
    const auto darker = read("reading/float.exr", options);
    ASSERT_TRUE(plain && darker);
    EXPECT_EQ(darker->exposure_stops, -1.5);
    for (size_t i = 0; i < plain->pixels.rgb.size(); ++i)
        EXPECT_FLOAT_EQ(darker->pixels.rgb[i], plain->pixels.rgb[i] / std::sqrt(8.0f));
}

TEST(ReadPanorama, RefusesImpossibleExposures) {
    PanoramaOptions options;
    for (const double stops : {std::nan(""), std::numeric_limits<double>::infinity(), 1e4}) {
        options.exposure_stops = stops;
        EXPECT_EQ(refusal("reading/float.exr", options).kind, ErrorKind::bad_argument);
    }
    options.exposure_stops = 120;
    EXPECT_EQ(refusal("panoramas/sun.exr", options).kind, ErrorKind::unusable_input);
}

TEST(ReadPanorama, RefusesUnknownNames) {
    PanoramaOptions options;
    options.color_space = "nonsense";
    EXPECT_EQ(refusal("reading/float.exr", options).kind, ErrorKind::bad_argument);
    options = {};
    options.layer = "nonsense";
    EXPECT_EQ(refusal("reading/float.exr", options).kind, ErrorKind::bad_argument);
    options = {};
    options.ocio_config = "no/such/config.ocio";
    EXPECT_EQ(refusal("reading/float.exr", options).kind, ErrorKind::unreadable_input);
}

TEST(ReadPanorama, HandsOnWhatTheReaderSays) {
    EXPECT_EQ(refusal("malformed/truncated.hdr").kind, ErrorKind::unreadable_input);
    EXPECT_EQ(refusal("malformed/large_claim.hdr").kind, ErrorKind::unreadable_input);
    EXPECT_TRUE(has_note(*read("reading/cropped.exr"), "data window"));
}

class Recorder final : public Progress {
public:
    void begin(std::string_view stage, int steps) override {
        stages.push_back(std::string(stage));
        total = steps;
    }
    void advance(int steps) override { done += steps; }
    bool cancelled() const override { return done >= stop_after; }

    std::vector<std::string> stages;
    int total = 0;
    int done = 0;
    int stop_after = std::numeric_limits<int>::max();
};

TEST(ReadPanorama, ReportsEveryRow) {
    Recorder progress;
    ASSERT_TRUE(read_panorama(test_data / "panoramas/sunset.exr", {}, progress));
    EXPECT_EQ(progress.stages, std::vector<std::string>{"read"});
    EXPECT_EQ(progress.total, 256);
    EXPECT_EQ(progress.done, 256);
}

TEST(ReadPanorama, StopsWhenAsked) {
    Recorder progress;
    progress.stop_after = 64;
    const auto panorama = read_panorama(test_data / "panoramas/sunset.exr", {}, progress);
    ASSERT_FALSE(panorama);
    EXPECT_EQ(panorama.error().kind, ErrorKind::interrupted);
    EXPECT_LT(progress.done, 256);
}

TEST(ReadPanorama, GivesTheSameBitsForAnyNumberOfThreads) {
    const auto pixels = [](int threads) {
        const ThreadLimit limit(threads);
        PanoramaOptions options = repairing();
        options.color_space = "ACEScg";
        options.exposure_stops = 0.3;
        return read("panoramas/sunset.exr", options)->pixels.rgb;
    };
    EXPECT_EQ(pixels(1), pixels(4));
}

}  // namespace
}  // namespace splitsum
