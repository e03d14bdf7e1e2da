#include "splitsum/imageio/channel_choice_detail.h"

#include <gtest/gtest.h>

namespace splitsum {
namespace {

using Names = std::vector<std::string>;

std::array<int, 3> chosen(const Names& names, const std::string& layer = {}) {
    const auto choice = choose_channels(names, layer);
    EXPECT_TRUE(choice) << choice.error().message;
    return choice ? choice->rgb : std::array{-1, -1, -1};
}

ErrorKind refused(const Names& names, const std::string& layer = {}) {
    const auto choice = choose_channels(names, layer);
    EXPECT_FALSE(choice);
    return choice ? ErrorKind::internal : choice.error().kind;
}

using Rgb = std::array<int, 3>;

TEST(ChannelChoice, FindsColoursByNameInAnyOrder) {
    EXPECT_EQ(chosen({"A", "B", "G", "R"}), (Rgb{3, 2, 1}));
    EXPECT_EQ(chosen({"red", "green", "blue"}), (Rgb{0, 1, 2}));
    EXPECT_EQ(chosen({"id", "r", "g", "b"}), (Rgb{1, 2, 3}));
}

TEST(ChannelChoice, PrefersTheDefaultLayer) {
    const Names names = {"a.R", "a.G", "a.B", "R", "G", "B"};
    EXPECT_EQ(chosen(names), (Rgb{3, 4, 5}));
    EXPECT_EQ(chosen(names, "a"), (Rgb{0, 1, 2}));
}

TEST(ChannelChoice, TakesTheOnlyLayer) {
    EXPECT_EQ(chosen({"depth.Z", "view.left.R", "view.left.G", "view.left.B"}), (Rgb{1, 2, 3}));
}

TEST(ChannelChoice, AsksWhichOfSeveralLayers) {
    const Names names = {"a.R", "a.G", "a.B", "b.R", "b.G", "b.B"};
    EXPECT_EQ(refused(names), ErrorKind::unusable_input);
    EXPECT_EQ(refused(names, "c"), ErrorKind::bad_argument);
    EXPECT_NE(choose_channels(names, "c").error().message.find("a, b"), std::string::npos);
}

TEST(ChannelChoice, ReadsOneChannelAsGrey) {
    EXPECT_EQ(chosen({"Y"}), (Rgb{0, 0, 0}));
    EXPECT_EQ(chosen({"anything"}), (Rgb{0, 0, 0}));
    EXPECT_EQ(chosen({"A", "Y"}), (Rgb{1, 1, 1}));
    EXPECT_EQ(chosen({"I", "A"}), (Rgb{0, 0, 0}));
}

TEST(ChannelChoice, RefusesWhatIsNoColour) {
    EXPECT_EQ(refused({"Z"}), ErrorKind::unusable_input);
    EXPECT_EQ(refused({"N.x", "N.y", "N.z"}), ErrorKind::unusable_input);
    EXPECT_EQ(refused({"X", "Y", "Z"}), ErrorKind::unusable_input);
    EXPECT_EQ(refused({"Y", "RY", "BY"}), ErrorKind::unusable_input);
    EXPECT_EQ(refused({"R", "G"}), ErrorKind::unusable_input);
    EXPECT_EQ(refused({}), ErrorKind::unusable_input);
}

TEST(ChannelChoice, SaysWhatItDropped) {
    const auto choice = choose_channels({"R", "G", "B", "A", "Z", "a.R"}, "");
    ASSERT_TRUE(choice);
    ASSERT_EQ(choice->notes.size(), 2u);
    EXPECT_NE(choice->notes[0].find("alpha"), std::string::npos);
    EXPECT_NE(choice->notes[1].find("Z, a.R"), std::string::npos);
    EXPECT_TRUE(choose_channels({"R", "G", "B"}, "")->notes.empty());
}

}  // namespace
}  // namespace splitsum
