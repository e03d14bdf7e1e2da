#include "splitsum/base/edit_distance.h"

#include <gtest/gtest.h>

#include <vector>

namespace splitsum {
namespace {

TEST(EditDistance, IsAMetricOnWords) {
    EXPECT_EQ(edit_distance("--size", "--size"), 0u);
    EXPECT_EQ(edit_distance("--sise", "--size"), 1u);
    EXPECT_EQ(edit_distance("kitten", "sitting"), 3u);
    EXPECT_EQ(edit_distance("", "abc"), 3u);
    EXPECT_EQ(edit_distance("abc", ""), 3u);
    const char* words[] = {"--size", "--samples", "--seed", "-o", "--method"};
    for (const char* a : words)
        for (const char* b : words) {
            EXPECT_EQ(edit_distance(a, b), edit_distance(b, a));
            for (const char* c : words)
                EXPECT_LE(edit_distance(a, c), edit_distance(a, b) + edit_distance(b, c));
        }
}

TEST(NearestName, IsWhatWasMeantOrNothing) {
    const std::vector<std::string> names = {"size", "samples", "seed", "method"};
    EXPECT_EQ(nearest_name("sise", names), "size");
    EXPECT_EQ(nearest_name("sample", names), "samples");
    EXPECT_EQ(nearest_name("colour", names), std::nullopt);
    EXPECT_EQ(nearest_name("", names), std::nullopt);
    EXPECT_EQ(nearest_name("size", {}), std::nullopt);
    EXPECT_EQ(nearest_name("sezd", names), "seed");
    const std::vector<std::string> as_near = {"abc", "abd"};
    EXPECT_EQ(nearest_name("abx", as_near), "abc");
}

// One more wrong letter than a third of them and one is too many.
TEST(NearestName, HasALimit) {
    const std::vector<std::string> names = {"abcdef"};
    EXPECT_EQ(nearest_name("abcxyz", names), "abcdef");
    EXPECT_EQ(nearest_name("abwxyz", names), std::nullopt);
}

TEST(NearestName, LosesNoTimeOnVeryLongText) {
    const std::vector<std::string> names(1000, "size");
    EXPECT_EQ(nearest_name(std::string(10'000'000, 's'), names), std::nullopt);
}

TEST(NamesInstead, BeginsWithAGuessIfThereIsOne) {
    const std::vector<std::string> names = {"size", "levels"};
    EXPECT_EQ(names_instead("sise", names), "; did you mean size? There are: size, levels");
    EXPECT_EQ(names_instead("colour", names), "; there are: size, levels");
}

}  // namespace
}  // namespace splitsum
