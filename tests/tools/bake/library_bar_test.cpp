// The line of progress: as much as fits, and never more.
#include "splitsum-bake/library_bar.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace splitsum::tools {
namespace {

LibraryState some_state() {
    return {.settled = 12,
            .of = 100,
            .part = 0.415,
            .panoramas_a_minute = 43.4,
            .seconds_left = 83,
            .at = {"dusk/venice_sunset_8k", "studio"}};
}

TEST(LibraryBar, FitsEveryWidth) {
    for (int width = 0; width < 200; ++width)
        EXPECT_LT(int(library_bar(some_state(), width).size()), std::max(width, 1)) << width;
}

TEST(LibraryBar, ShowsAllWhereThereIsRoom) {
    EXPECT_EQ(library_bar(some_state(), 120),
              "12/100  41 %  1:23 left  43/min  [#########...............]  dusk/venice_sunset_8k "
              "+1");
}

// What tells most is there first.
TEST(LibraryBar, DropsTheLeastFirst) {
    EXPECT_EQ(library_bar(some_state(), 7), "12/100");
    EXPECT_EQ(library_bar(some_state(), 13), "12/100  41 %");
    EXPECT_EQ(library_bar(some_state(), 24), "12/100  41 %  1:23 left");
    size_t before = 0;
    for (int width = 0; width < 150; ++width) {
        const size_t now = library_bar(some_state(), width).size();
        EXPECT_GE(now, before);
        before = now;
    }
}

TEST(LibraryBar, SaysNothingThatItDoesNotKnow) {
    EXPECT_EQ(library_line({.settled = 0, .of = 3}), "0/3, 0 %");
    LibraryState state = some_state();
    EXPECT_EQ(library_line(state), "12/100, 41 %, 1:23 left, 43/min, at dusk/venice_sunset_8k +1");
}

// Letters of UTF-8 are not cut, and nothing moves the cursor.
TEST(LibraryBar, PrintsNamesAsTheyAre) {
    LibraryState state = {.settled = 0, .of = 1};
    state.at = {"d\xc3\xa4mmerung\x1b[2J\n"};
    for (int width = 10; width < 60; ++width) {
        const std::string bar = library_bar(state, width);
        EXPECT_EQ(bar.find_first_of("\x1b\n"), std::string::npos);
        EXPECT_NE(static_cast<unsigned char>(bar.back()), 0xc3);
    }
    EXPECT_NE(library_bar(state, 100).find("d\xc3\xa4mmerung?[2J?"), std::string::npos);
}

TEST(ClockText, CountsAsClocksDo) {
    EXPECT_EQ(clock_text(0), "0:00");
    EXPECT_EQ(clock_text(6.2), "0:07");
    EXPECT_EQ(clock_text(600), "10:00");
    EXPECT_EQ(clock_text(3599.5), "1:00:00");
    EXPECT_EQ(clock_text(7384), "2:03:04");
    EXPECT_EQ(clock_text(-5), "0:00");
}

}  // namespace
}  // namespace splitsum::tools
