// A whole chart of a small panorama: what is in it, that it repeats, and that it stops in time.
#include "splitsum/chart/chart.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "splitsum/base/parallel.h"
#include "splitsum/chart/chart_csv.h"
#include "splitsum/chart/chart_json.h"
#include "splitsum/chart/chart_page.h"
#include "splitsum/chart/filter_ladder.h"
#include "splitsum/chart/gnuplot_script.h"
#include "splitsum/filter/methods.h"
#include "splitsum/table/split_sum.h"

namespace splitsum {
namespace {

ChartJob small_job() {
    ChartJob job;
    job.panoramas = {std::string(SPLITSUM_TEST_DATA) + "/panoramas/lopsided.exr"};
    job.quick = true;
    job.plan = quick_chart_plan();
    job.plan.perceptual_roughness = {0.3, 1};
    job.plan.level_size = 4;
    job.plan.bake_size = 8;
    job.plan.table_size = 8;
    job.plan.probes = 12;
    job.plan.samples = {16, 256};
    job.plan.bake_samples = {16};
    job.plan.accuracies = {1e-2, 1e-4};
    job.plan.table_sizes = {8, 16};
    job.plan.table_samples = {16, 256};
    job.plan.table_accuracies = {1e-3, 1e-6};
    job.plan.storage_sizes = {8, 32};
    job.plan.storage_probes = 8;
    job.plan.timing.most_repeats = 1;
    return job;
}

const Chart& small_chart() {
    static const Chart chart = [] {
        NoProgress progress;
        return *measure_chart(small_job(), progress);
    }();
    return chart;
}

const MeasuredPanel& panel_named(const Chart& chart, const std::string& asset) {
    for (const MeasuredPanel& panel : chart.panels)
        if (panel.facts.asset == asset) return panel;
    throw std::runtime_error("no panel " + asset);
}

std::set<std::string> methods_in(const MeasuredPanel& panel) {
    std::set<std::string> methods;
    for (const Measurement& row : panel.rows) methods.insert(row.method);
    return methods;
}

// The errors of a method in the order of its efforts.
std::vector<double> errors_of(const MeasuredPanel& panel, const std::string& method) {
    std::vector<double> errors;
    for (const Measurement& row : panel.rows)
        if (row.method == method) errors.push_back(shown_error(panel.facts, row.figures));
    return errors;
}

TEST(Chart, HasEveryMethodOfEveryRegistry) {
    const Chart& chart = small_chart();
    const auto specular = methods_in(panel_named(chart, "specular"));
    const auto diffuse = methods_in(panel_named(chart, "diffuse"));
    for (const FilterMethod& method : filter_methods()) {
        if (method.name == "auto") continue;
        EXPECT_EQ(specular.contains(std::string(method.name)), method.filters_ggx) << method.name;
        EXPECT_EQ(diffuse.contains(std::string(method.name)), method.filters_cosine) << method.name;
    }
    for (const char* more : {"harmonics", "harmonics (windowed)", "spherical Gaussians"})
        EXPECT_TRUE(diffuse.contains(more)) << more;
    EXPECT_TRUE(methods_in(panel_named(chart, "bake")).contains("auto"));
    for (const SplitSumMethod& method : split_sum_methods())
        EXPECT_TRUE(methods_in(panel_named(chart, "table")).contains(std::string(method.name)));
}

TEST(Chart, FindsMoreEffortNearerToTheTruth) {
    const Chart& chart = small_chart();
    for (const char* asset : {"specular", "diffuse", "bake"}) {
        const MeasuredPanel& panel = panel_named(chart, asset);
        const std::string method = std::string(asset) == "bake" ? "auto" : "spectral";
        const auto errors = errors_of(panel, method);
        ASSERT_EQ(errors.size(), 2u) << asset;
        EXPECT_LT(errors[0], 1e-2) << asset;  // what was asked for
        EXPECT_LT(errors[1], 1e-4) << asset;
    }
    const auto table = errors_of(panel_named(chart, "table"), "quadrature");
    EXPECT_LT(table[1], 1e-6);
    const auto between = errors_of(panel_named(chart, "table-between"), "quadrature");
    EXPECT_LT(between[1], between[0]);
    const auto series = errors_of(panel_named(chart, "diffuse"), "harmonics");
    ASSERT_EQ(series.size(), 3u);
    EXPECT_LT(series[2], series[0]);
}

TEST(Chart, ComparesAtAsManyProbesAsItSays) {
    for (const MeasuredPanel& panel : small_chart().panels)
        for (const Measurement& row : panel.rows) {
            EXPECT_GE(row.figures.texels, 6) << panel.facts.title << " " << row.method;
            EXPECT_TRUE(std::isfinite(row.figures.rel_rms)) << row.method;
            EXPECT_GT(row.milliseconds, 0) << row.method;
        }
}

TEST(Chart, ShowsWhatEnginesReadForBytes) {
    const Chart& chart = small_chart();
    ASSERT_EQ(chart.storage.size(), 6u);  // two sizes, three formats
    for (const StoredChain& chain : chart.storage) {
        ASSERT_EQ(chain.errors.size(), 4u);
        int64_t texels = 0;
        for (int level = 0; level < chain.levels; ++level)
            texels += 6 * (chain.face_size >> level) * (chain.face_size >> level);
        EXPECT_EQ(chain.bytes, texels * (chain.format == "rgba16f" ? 8 : 4));
    }
    EXPECT_EQ(chart.storage[0].format, chart.storage[3].format);
    EXPECT_LT(chart.storage[3].errors[1].figures.rel_rms,
              chart.storage[0].errors[1].figures.rel_rms);
}

// Everything but times and fronts, which follow from them.
std::string without_times(Chart chart) {
    for (MeasuredPanel& panel : chart.panels)
        for (Measurement& row : panel.rows) {
            row.milliseconds = 0;
            row.repeats = 0;
            row.on_front = false;
        }
    chart.threads = 0;
    return chart_csv(chart) + storage_csv(chart) + chart_json(chart);
}

TEST(Chart, IsTheSameInEveryRunButForTimes) {
    const ThreadLimit limit(1);
    NoProgress progress;
    const auto again = measure_chart(small_job(), progress);
    ASSERT_TRUE(again);
    EXPECT_EQ(again->threads, 1);
    EXPECT_EQ(without_times(*again), without_times(small_chart()));
}

class StopInStage final : public Progress {
public:
    explicit StopInStage(int stage) : stage_(stage) {}
    void begin(std::string_view, int) override { begun_ = begun_ + 1; }
    void advance(int) override {}
    bool cancelled() const override { return begun_ >= stage_; }

private:
    int stage_;
    std::atomic<int> begun_ = 0;
};

TEST(Chart, KeepsWholePanelsWhenItIsInterrupted) {
    StopInStage progress(4);  // after reading and two panels of reflections
    const auto chart = measure_chart(small_job(), progress);
    ASSERT_TRUE(chart) << chart.error().message;
    EXPECT_FALSE(chart->complete);
    ASSERT_EQ(chart->panels.size(), 2u);
    EXPECT_EQ(chart->panels[1].rows.size(), small_chart().panels[1].rows.size());
    EXPECT_NE(chart_json(*chart).find("\"complete\": false"), std::string::npos);
    EXPECT_NE(chart_page(*chart, {}, "").find("Interrupted"), std::string::npos);
    EXPECT_FALSE(gnuplot_script(*chart).empty());
}

TEST(Chart, HasNothingToKeepWhenItIsInterruptedAtOnce) {
    StopInStage progress(1);
    const auto chart = measure_chart(small_job(), progress);
    ASSERT_FALSE(chart);
    EXPECT_EQ(chart.error().kind, ErrorKind::interrupted);
}

TEST(Chart, RefusesAMissingPanoramaBeforeAnyWork) {
    ChartJob job = small_job();
    job.panoramas.push_back("nowhere.exr");
    NoProgress progress;
    const auto chart = measure_chart(job, progress);
    ASSERT_FALSE(chart);
    EXPECT_EQ(chart.error().kind, ErrorKind::unreadable_input);
}

TEST(ChartFiles, HoldEveryRow) {
    const Chart& chart = small_chart();
    size_t rows = 0;
    for (const MeasuredPanel& panel : chart.panels) rows += panel.rows.size();
    std::istringstream csv(chart_csv(chart));
    std::string line;
    size_t lines = 0, fields = 0;
    while (std::getline(csv, line)) {
        const auto commas = size_t(std::ranges::count(line, ','));
        if (lines++ == 0) fields = commas;
        EXPECT_EQ(commas, fields) << line;
    }
    EXPECT_EQ(lines, rows + 1);

    const auto json = nlohmann::json::parse(chart_json(chart));
    size_t in_json = 0;
    for (const auto& panel : json["panels"]) in_json += panel["rows"].size();
    EXPECT_EQ(in_json, rows);
    for (const MethodNote& note : chart.notes) {
        EXPECT_FALSE(note.sentence.empty()) << note.name;
        EXPECT_EQ(json["methods"][note.name], note.sentence);
    }
}

TEST(ChartFiles, PageStandsAlone) {
    Chart chart = small_chart();
    chart.sources[0].file = "<script>&.exr";
    std::vector<InlinedPicture> pictures;
    for (const PanelPicture& picture : panel_pictures(chart))
        pictures.push_back({"<svg/>", picture.caption});
    ASSERT_EQ(pictures.size(), chart.panels.size() + 4);
    const std::string page = chart_page(chart, pictures, "");
    size_t images = 0;
    for (size_t at = page.find("<img"); at != std::string::npos; at = page.find("<img", at + 1))
        ++images;
    EXPECT_EQ(images, pictures.size());
    EXPECT_NE(page.find("base64,PHN2Zy8+"), std::string::npos);  // <svg/>
    EXPECT_EQ(page.find("<script"), std::string::npos);
    EXPECT_EQ(page.find("http"), std::string::npos);
    EXPECT_NE(page.find("width=device-width"), std::string::npos);
}

TEST(ChartFiles, QuoteWhatIsSpecial) {
    Chart chart = small_chart();
    chart.panels.resize(1);
    chart.panels[0].facts.panorama = "a,\"b\"";
    EXPECT_NE(chart_csv(chart).find("\n\"a,\"\"b\"\"\",specular"), std::string::npos);
    chart.panels[0].facts.panorama = "a\"\nsystem 'x'";
    chart.sources.push_back(chart.sources[0]);  // titles name the panorama then
    EXPECT_NE(gnuplot_script(chart).find("\"a\\\" system 'x'"), std::string::npos);
}

// gnuplot keeps what was set for the key of a single panel: with its rows the legend runs off the sheet.
TEST(ChartFiles, DrawTheLegendWithAKeyOfItsOwn) {
    const std::string script = gnuplot_script(small_chart());
    const std::string legend = "set key center center";
    size_t legends = 0;
    for (size_t at = script.find(legend); at != std::string::npos;
         at = script.find(legend, at + 1)) {
        ++legends;
        EXPECT_EQ(script.substr(at - 16, 16), "set key default\n");
    }
    EXPECT_GE(legends, 2u);
}

TEST(FilterLadder, NamesEveryLineOnceAtEachEffort) {
    const int samples[] = {16, 1 << 20};
    const double accuracies[] = {1e-3};
    std::set<std::pair<std::string, double>> seen;
    for (const FilterRung& rung : filter_ladder(LobeKind::ggx, samples, accuracies)) {
        EXPECT_TRUE(seen.insert({rung.name, rung.effort}).second) << rung.name;
        EXPECT_TRUE(validate(rung.plan)) << rung.name;
        EXPECT_EQ(rung.plan.method, rung.method.name);
        if (rung.effort_name == "samples") {
            EXPECT_EQ(rung.plan.samples, rung.effort);
        }
    }
    EXPECT_TRUE(seen.contains({"importance", 1 << 20}));
    EXPECT_FALSE(seen.contains({"mis", 1 << 20}));  // minutes
}

}  // namespace
}  // namespace splitsum
