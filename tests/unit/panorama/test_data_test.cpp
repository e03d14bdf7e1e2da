#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>

#include "splitsum/base/text.h"
#include "splitsum/imageio/image_file.h"

namespace splitsum {
namespace {

namespace fs = std::filesystem;

const fs::path stored = SPLITSUM_TEST_DATA;

std::set<std::string> images_in(const fs::path& folder) {
    std::set<std::string> names;
    for (const char* group : {"panoramas", "reading", "unusable", "malformed"})
        for (const auto& entry : fs::directory_iterator(folder / group))
            names.insert(cat(group, "/", entry.path().filename().string()));
    return names;
}

std::string bytes_of(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

std::vector<float> pixels_of(const fs::path& path) {
    std::vector<float> pixels;
    auto reader = ImageReader::open(path);
    if (!reader) return pixels;
    const Status read = reader->read_rows([&](int, int, std::span<const float> rgb) -> Status {
        pixels.insert(pixels.end(), rgb.begin(), rgb.end());
        return ok;
    });
    EXPECT_TRUE(read) << read.error().message;
    return pixels;
}

// One unit in the last place of a half float or of an RGBE mantissa: another compression library or
// another processor's sine may move a file's bytes, but not by more.
void expect_same_pixels(const std::string& name, const fs::path& fresh) {
    const auto old_pixels = pixels_of(stored / name), new_pixels = pixels_of(fresh / name);
    ASSERT_FALSE(old_pixels.empty()) << name;
    ASSERT_EQ(old_pixels.size(), new_pixels.size()) << name;
    for (size_t i = 0; i < old_pixels.size(); ++i) {
        if (std::isnan(old_pixels[i]) && std::isnan(new_pixels[i])) continue;
        if (old_pixels[i] == new_pixels[i]) continue;
        ASSERT_NEAR(old_pixels[i], new_pixels[i], 0.01f * std::abs(old_pixels[i]) + 1e-4f)
            << name << ", value " << i;
    }
}

TEST(TestData, IsWhatItsGeneratorWrites) {
    const fs::path fresh = fs::path(testing::TempDir()) / "splitsum_test_data";
    fs::remove_all(fresh);
    fs::create_directories(fresh);
    const std::string command = cat(SPLITSUM_BIN, "/make_test_data '", fresh.string(), "'");
    ASSERT_EQ(std::system(command.c_str()), 0) << command;
    EXPECT_EQ(images_in(fresh), images_in(stored));
    for (const std::string& name : images_in(stored)) {
        if (bytes_of(stored / name) == bytes_of(fresh / name)) continue;
        if (name.starts_with("malformed"))
            ADD_FAILURE() << name << " has other bytes";
        else
            expect_same_pixels(name, fresh);
    }
    fs::remove_all(fresh);
}

TEST(TestData, StaysSmall) {
    uintmax_t total = 0;
    for (const std::string& name : images_in(stored)) total += fs::file_size(stored / name);
    EXPECT_LT(total, 3'000'000u);
}

}  // namespace
}  // namespace splitsum
