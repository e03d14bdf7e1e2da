// A panel is measured by its own rules, whatever the asset: planted values, planted times.
#include "splitsum/chart/measure_panel.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <thread>

namespace splitsum {
namespace {

using Values = Result<std::vector<float>>;

Contestant contestant(std::string name, std::vector<float> values, int milliseconds = 0) {
    return {std::move(name), "samples", 1, [=](Progress&) -> Values {
                std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
                return values;
            }};
}

Panel panel_of(std::vector<Contestant> contestants) {
    Panel panel;
    panel.facts.asset = "specular";
    panel.contestants = std::move(contestants);
    panel.reference = [](Progress&) -> Values { return std::vector<float>{1, 2, 3, 4, 5, 6}; };
    return panel;
}

// Cancels after so many steps.
class Impatient final : public Progress {
public:
    explicit Impatient(int steps) : left_(steps) {}
    void begin(std::string_view, int) override {}
    void advance(int steps) override { left_ -= steps; }
    bool cancelled() const override { return left_ <= 0; }

private:
    int left_;
};

TEST(MeasurePanel, GivesEveryContestantItsErrorAndItsTime) {
    const Panel panel = panel_of({contestant("exact", {1, 2, 3, 4, 5, 6}, 1),
                                  contestant("high", {1.1f, 2.2f, 3.3f, 4.4f, 5.5f, 6.6f}, 20)});
    MeasuredPanel measured;
    NoProgress progress;
    ASSERT_TRUE(measure_panel(panel, {.most_repeats = 3, .seconds = 1}, measured, progress));
    ASSERT_EQ(measured.rows.size(), 2u);
    EXPECT_EQ(measured.rows[0].figures.rel_rms, 0);
    EXPECT_NEAR(measured.rows[1].figures.rel_rms, 0.1, 1e-6);
    EXPECT_NEAR(measured.rows[1].figures.bias, 0.1, 1e-6);
    EXPECT_EQ(measured.rows[1].figures.texels, 2);
    EXPECT_EQ(measured.rows[1].repeats, 3);
    EXPECT_GE(measured.rows[1].milliseconds, 20);  // one run, not the sum of three
    EXPECT_LT(measured.rows[0].milliseconds, measured.rows[1].milliseconds);
}

TEST(MeasurePanel, RepeatsSlowOnesLessOftenButNeverNotAtAll) {
    const Panel panel = panel_of({contestant("slow", {1, 2, 3, 4, 5, 6}, 30)});
    MeasuredPanel measured;
    NoProgress progress;
    ASSERT_TRUE(measure_panel(panel, {.most_repeats = 50, .seconds = 0.01}, measured, progress));
    EXPECT_EQ(measured.rows[0].repeats, 1);
}

TEST(MeasurePanel, CountsAFirstRunThatIsLong) {
    int runs = 0;
    Panel panel = panel_of({});
    panel.contestants.push_back({"long", "samples", 1, [&](Progress&) -> Values {
                                     ++runs;
                                     std::this_thread::sleep_for(std::chrono::milliseconds(20));
                                     return std::vector<float>{1, 2, 3, 4, 5, 6};
                                 }});
    MeasuredPanel measured;
    NoProgress progress;
    ASSERT_TRUE(measure_panel(panel, {.long_run = 0.01}, measured, progress));
    EXPECT_EQ(runs, 1);
    EXPECT_GE(measured.rows[0].milliseconds, 20);
}

TEST(MeasurePanel, TimesTheReferenceForTheWholeAsset) {
    Panel panel = panel_of({});
    panel.whole_over_probes = 100;
    panel.reference = [](Progress&) -> Values {
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
        return std::vector<float>{1, 2, 3};
    };
    MeasuredPanel measured;
    NoProgress progress;
    ASSERT_TRUE(measure_panel(panel, {}, measured, progress));
    ASSERT_EQ(measured.rows.size(), 1u);
    EXPECT_EQ(measured.rows[0].method, "reference");
    EXPECT_GE(measured.rows[0].milliseconds, 500);
    EXPECT_EQ(measured.rows[0].figures.rel_rms, 0);
}

TEST(MeasurePanel, KeepsWhatWasMeasuredWhenItIsInterrupted) {
    const Panel panel =
        panel_of({contestant("a", {1, 2, 3, 4, 5, 6}), contestant("b", {1, 2, 3, 4, 5, 7}),
                  contestant("c", {1, 2, 3, 4, 5, 8})});
    MeasuredPanel measured;
    Impatient progress(2);
    const Status done = measure_panel(panel, {}, measured, progress);
    ASSERT_FALSE(done);
    EXPECT_EQ(done.error().kind, ErrorKind::interrupted);
    ASSERT_EQ(measured.rows.size(), 2u);
    EXPECT_EQ(measured.rows[1].method, "b");
    EXPECT_GT(measured.rows[1].repeats, 0);
}

Measurement row(double milliseconds, double error) {
    Measurement made{"m", "", 0, milliseconds, 1, {}, true};
    made.figures.rel_rms = error;
    made.figures.max_abs = 1 / error;
    return made;
}

std::vector<bool> front_of(MeasuredPanel& panel) {
    mark_front(panel);
    std::vector<bool> front;
    for (const Measurement& each : panel.rows) front.push_back(each.on_front);
    return front;
}

TEST(Front, HoldsExactlyWhatNothingBeats) {
    MeasuredPanel panel;
    panel.rows = {row(5, 0.1), row(1, 0.5), row(2, 0.6), row(9, 0.1), row(3, 0.2), row(3, 0.3)};
    EXPECT_EQ(front_of(panel), (std::vector<bool>{true, true, false, false, true, false}));
    // By definition, row by row: on the front where no other is at least as good in both.
    for (size_t i = 0; i < panel.rows.size(); ++i) {
        bool beaten = false;
        for (size_t j = 0; j < panel.rows.size(); ++j) {
            const auto &a = panel.rows[j], &b = panel.rows[i];
            beaten |= i != j && a.milliseconds <= b.milliseconds &&
                      a.figures.rel_rms <= b.figures.rel_rms;
        }
        EXPECT_EQ(panel.rows[i].on_front, !beaten) << i;
    }
}

TEST(Front, GoesByTheFigureThatIsDrawn) {
    MeasuredPanel panel;
    panel.facts.figure = "max_abs";  // the inverse here: the first row is the better one
    panel.rows = {row(1, 0.5), row(2, 0.1)};
    EXPECT_EQ(front_of(panel), (std::vector<bool>{true, false}));
}

TEST(Front, LeavesOutWhatHasNoErrorOrNone) {
    MeasuredPanel panel;
    panel.rows = {row(1, 0), row(2, std::nan("")), row(3, 0.5), row(1, 1e300 * 1e300)};
    EXPECT_EQ(front_of(panel), (std::vector<bool>{false, false, true, false}));
}

}  // namespace
}  // namespace splitsum
