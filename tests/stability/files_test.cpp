// Rows 6 and 16: what files hold. Every readable file of test_data gives light; every unusable one is
// refused with a count and a place, or repaired and counted.
#include <filesystem>

#include "splitsum/panorama/panorama.h"
#include "stability/levels.h"

namespace splitsum::tests {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> files_in(const std::string& folder) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(std::string(SPLITSUM_TEST_DATA) + "/" + folder))
        files.push_back(entry.path());
    EXPECT_GE(files.size(), 5u) << folder;
    return files;
}

Result<Panorama> read(const fs::path& path, bool repair = false) {
    NoProgress progress;
    PanoramaOptions options;
    options.repair = repair;
    if (path.filename() == "two_layers.exr") options.layer = "fill";
    return read_panorama(path, options, progress);
}

TEST(Files, OfEveryKindThatIsReadGiveLight) {
    int usable = 0;
    std::vector<std::string> refused;
    for (const char* folder : {"panoramas", "reading"})
        for (const fs::path& path : files_in(folder)) {
            const auto panorama = read(path);
            if (!panorama) {
                EXPECT_EQ(panorama.error().kind, ErrorKind::unusable_input)
                    << panorama.error().message;
                refused.push_back(path.filename().string());
                continue;
            }
            ++usable;
            SCOPED_TRACE(path.filename());
            ASSERT_EQ(panorama->pixels.width, 2 * panorama->pixels.height);
            expect_light(levels_by("filtered", Environment(panorama->pixels), {0.5}, 4)[0]);
        }
    EXPECT_GE(usable, 20);
    // Subsampled chroma is no light yet; the message says what to save instead.
    EXPECT_EQ(refused, std::vector<std::string>{"luminance_chroma.exr"});
}

TEST(Files, ThatAreNoLightAreRefusedOrRepairedAndCounted) {
    for (const char* name : {"nan.exr", "inf.exr", "negative.exr", "half_overflow.exr"}) {
        const fs::path path = std::string(SPLITSUM_TEST_DATA) + "/unusable/" + name;
        const auto refused = read(path);
        ASSERT_FALSE(refused) << name;
        EXPECT_EQ(refused.error().kind, ErrorKind::unusable_input);
        EXPECT_NE(refused.error().message.find("first at x "), std::string::npos)
            << refused.error().message;
        const auto repaired = read(path, true);
        ASSERT_TRUE(repaired) << repaired.error().message;
        EXPECT_TRUE(repaired->repaired);
        EXPECT_FALSE(repaired->found.clean());
        EXPECT_TRUE(take_census(repaired->pixels).clean());
    }
}

TEST(Files, OfAnotherShapeAreRefused) {
    for (const char* name : {"square.exr", "1x1.exr", "no_colors.exr"}) {
        const auto refused = read(std::string(SPLITSUM_TEST_DATA) + "/unusable/" + name, true);
        ASSERT_FALSE(refused) << name;
        EXPECT_EQ(refused.error().kind, ErrorKind::unusable_input);
    }
}

TEST(Files, ThatAreDamagedAreRefused) {
    for (const fs::path& path : files_in("malformed")) {
        const auto refused = read(path, true);
        ASSERT_FALSE(refused) << path;
        EXPECT_EQ(refused.error().kind, ErrorKind::unreadable_input) << refused.error().message;
    }
}

}  // namespace
}  // namespace splitsum::tests
