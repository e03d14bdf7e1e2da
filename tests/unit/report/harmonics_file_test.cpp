#include "splitsum/report/harmonics_file.h"

#include <gtest/gtest.h>

#include <sstream>

#include "splitsum/math/harmonics.h"
#include "support/temporary_folder.h"

namespace splitsum {
namespace {

IrradianceHarmonics some_harmonics(int order) {
    IrradianceHarmonics harmonics;
    harmonics.order = order;
    for (size_t i = 0; i < harmonic_count(order); ++i)
        harmonics.coefficients.emplace_back(1.0 / (3 + double(i)), -0.1 * double(i), 1e-9 / 7);
    harmonics.window_lambda = 1 / 3.0;
    harmonics.lowest = -0.1;
    return harmonics;
}

AssetFacts some_facts() {
    AssetFacts facts;
    facts.kind = AssetFacts::Kind::irradiance;
    facts.source.name = "sky \"quoted\".exr";
    facts.filter.method = "filtered";
    return facts;
}

TEST(HarmonicsFile, JsonReadsBackToTheLastBit) {
    const tests::TemporaryFolder folder;
    for (const int order : {0, 2, 7}) {
        const auto path = folder / "harmonics.json";
        ASSERT_TRUE(write_harmonics(some_harmonics(order), some_facts(), path));
        const auto read = read_harmonics(path);
        ASSERT_TRUE(read) << read.error().message;
        EXPECT_EQ(read->harmonics.order, order);
        EXPECT_EQ(read->harmonics.coefficients, some_harmonics(order).coefficients);
        EXPECT_EQ(read->harmonics.window_lambda, 1 / 3.0);
        EXPECT_EQ(read->harmonics.lowest, -0.1);
        EXPECT_EQ(metadata_of(read->facts), metadata_of(some_facts()));
    }
}

// The series always is E / pi, whatever the cubemap beside it holds.
TEST(HarmonicsFile, NeverSaysThatItHoldsE) {
    const tests::TemporaryFolder folder;
    AssetFacts facts = some_facts();
    facts.stores_irradiance = true;
    ASSERT_TRUE(write_harmonics(some_harmonics(2), facts, folder / "h.json"));
    EXPECT_FALSE(read_harmonics(folder / "h.json")->facts.stores_irradiance);
}

TEST(HarmonicsFile, TextHasTheSameNumbers) {
    const tests::TemporaryFolder folder;
    ASSERT_TRUE(write_harmonics(some_harmonics(3), some_facts(), folder / "h.txt"));
    std::istringstream text(tests::bytes_of(folder / "h.txt"));
    std::string comment;
    std::getline(text, comment);
    EXPECT_EQ(comment[0], '#');
    for (const Vec3d& c : some_harmonics(3).coefficients) {
        Vec3d read;
        ASSERT_TRUE(text >> read.x >> read.y >> read.z);
        EXPECT_EQ(read, c);
    }
    std::string rest;
    EXPECT_FALSE(text >> rest);
}

TEST(HarmonicsFile, RefusesOtherEndingsAndLongGlsl) {
    const tests::TemporaryFolder folder;
    const std::pair<const char*, int> calls[] = {{"h.png", 2}, {"h", 2}, {"h.glsl", 5}};
    for (const auto& [name, order] : calls) {
        const auto path = folder / name;
        const Status written = write_harmonics(some_harmonics(order), some_facts(), path);
        ASSERT_FALSE(written) << name;
        EXPECT_EQ(written.error().kind, ErrorKind::bad_argument);
        EXPECT_FALSE(exists(path));
    }
    EXPECT_TRUE(write_harmonics(some_harmonics(4), some_facts(), folder / "h.glsl"));
}

TEST(HarmonicsFile, EveryTruncationIsRefused) {
    const tests::TemporaryFolder folder;
    const auto path = folder / "h.json";
    ASSERT_TRUE(write_harmonics(some_harmonics(1), some_facts(), path));
    const std::string whole = tests::bytes_of(path);
    for (size_t length = 0; length + 2 < whole.size(); ++length) {
        tests::write_bytes(path, whole.substr(0, length));
        const auto read = read_harmonics(path);
        ASSERT_FALSE(read) << length;
        ASSERT_EQ(read.error().kind, ErrorKind::unreadable_input) << length;
    }
}

TEST(HarmonicsFile, RefusesWhatIsNoHarmonicsFile) {
    const tests::TemporaryFolder folder;
    const auto path = folder / "h.json";
    for (const char* text : {"{}", "[]", "3", "\"order\"", R"({"order": "two"})",
                             R"({"order": -1, "window_lambda": 0, "lowest_share_of_mean": 0,
                                 "coefficients": [], "metadata": {}})",
                             R"({"order": 1000000, "window_lambda": 0, "lowest_share_of_mean": 0,
                                 "coefficients": [[1, 2, 3]], "metadata": {}})",
                             R"({"order": 0, "window_lambda": 0, "lowest_share_of_mean": 0,
                                 "coefficients": [[1, 2]], "metadata": {}})",
                             R"({"order": 0, "window_lambda": 0, "lowest_share_of_mean": 0,
                                 "coefficients": [[1, 2, 3]], "metadata": {}})"}) {
        tests::write_bytes(path, text);
        const auto read = read_harmonics(path);
        ASSERT_FALSE(read) << text;
        EXPECT_EQ(read.error().kind, ErrorKind::unusable_input) << text;
        EXPECT_NE(read.error().message.find("h.json"), std::string::npos);
    }
    EXPECT_EQ(read_harmonics(folder / "none.json").error().kind, ErrorKind::unreadable_input);
}

}  // namespace
}  // namespace splitsum
