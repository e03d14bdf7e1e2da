#include "splitsum/chart/table_panels.h"

#include "splitsum/base/parallel.h"
#include "splitsum/base/text.h"
#include "splitsum/math/low_discrepancy.h"
#include "splitsum/table/bilinear.h"
#include "splitsum/table/kinds.h"
#include "splitsum/table/split_sum.h"
#include "splitsum/table/split_sum_exact.h"

namespace splitsum {
namespace {

using Values = Result<std::vector<float>>;

struct Point {
    double n_dot_v;
    double perceptual_roughness;
};

std::vector<Point> points_between(int count) {
    std::vector<Point> points;
    for (int i = 0; i < count; ++i) {
        const Vec2d point = hammersley(uint32_t(i), uint32_t(count));
        points.push_back({point.x, point.y});
    }
    return points;
}

std::vector<Point> points_at_texels(const TablePlan& plan, int count) {
    const TableGrid grid = grid_of(plan, ViewAxis::cosine);
    std::vector<Point> points;
    for (const Point& point : points_between(count))
        points.push_back(
            {grid.n_dot_v[size_t(point.n_dot_v * plan.size)],
             grid.perceptual_roughness[size_t(point.perceptual_roughness * plan.size)]});
    return points;
}

Values exact_values(const std::vector<Point>& points, Progress& progress) {
    std::vector<float> values(2 * points.size());
    parallel_rows(int(points.size()), [&](int i) {
        if (progress.cancelled()) return;
        const Point& point = points[size_t(i)];
        const double r = point.perceptual_roughness;
        const SplitSum exact = split_sum_exact(TablePlan{}.geometry, point.n_dot_v, r * r);
        values[2 * size_t(i)] = float(exact.a);
        values[2 * size_t(i) + 1] = float(exact.b);
    });
    if (progress.cancelled()) return Error{ErrorKind::interrupted, "interrupted"};
    return values;
}

// Bakes the table and reads it as a renderer does.
Values read_table(const TablePlan& plan, const std::vector<Point>& points, Progress& progress) {
    const auto kind = kind_of(plan);
    if (!kind) return kind.error();
    const auto table = kind->bake(plan, grid_of(plan, kind->view_axis), progress);
    if (!table) return table.error();
    const Table stored = arranged(*table, plan);
    std::vector<float> values;
    for (const Point& point : points) {
        double read[2];
        read_bilinear(stored,
                      texture_coordinates(plan, plan.size, kind->view_axis, point.n_dot_v,
                                          point.perceptual_roughness),
                      read);
        values.insert(values.end(), {float(read[0]), float(read[1])});
    }
    return values;
}

Contestant contestant_of(std::string method, std::string effort_name, double effort,
                         const TablePlan& plan, const std::vector<Point>& points) {
    const auto make = [plan, points](Progress& progress) {
        return read_table(plan, points, progress);
    };
    return {std::move(method), std::move(effort_name), effort, make};
}

Panel panel_about(const std::string& asset, const std::string& title,
                  const std::vector<Point>& points) {
    Panel panel;
    panel.facts.asset = asset;
    panel.facts.title = title;
    panel.facts.channels = 2;
    panel.facts.figure = "max_abs";
    panel.reference = [points](Progress& progress) { return exact_values(points, progress); };
    return panel;
}

void add_sizes(const std::string& name, TablePlan plan, const ChartPlan& chart,
               const std::vector<Point>& points, Panel& panel) {
    for (const int size : chart.table_sizes) {
        plan.size = size;
        panel.contestants.push_back(contestant_of(name, "size", size, plan, points));
    }
}

}  // namespace

Panel table_panel(const ChartPlan& chart) {
    TablePlan plan;
    plan.size = chart.table_size;
    const auto points = points_at_texels(plan, chart.probes);
    Panel panel = panel_about("table", "split-sum table, at texels", points);
    panel.facts.size = chart.table_size;
    panel.facts.timed = cat("Time: computing a table of ", chart.table_size, "² texels.");
    for (const SplitSumMethod& method : split_sum_methods()) {
        plan = {.method = std::string(method.name), .size = chart.table_size};
        const auto add = [&](const char* effort_name, double effort) {
            panel.contestants.push_back(
                contestant_of(plan.method, effort_name, effort, plan, points));
        };
        if (method.samples)
            for (const int samples : chart.table_samples) {
                plan.samples = samples;
                add("samples", samples);
            }
        else
            for (const double accuracy : chart.table_accuracies) {
                plan.accuracy = accuracy;
                add("accuracy", accuracy);
            }
    }
    return panel;
}

Panel table_between_panel(const ChartPlan& chart) {
    const auto points = points_between(chart.probes);
    Panel panel = panel_about("table-between", "split-sum table, between texels", points);
    panel.facts.timed = "Time: computing the table; the larger, the nearer to the truth.";
    add_sizes("quadrature", {}, chart, points, panel);
    add_sizes("quadrature (texels at edges)", {.layout = TexelLayout::edge}, chart, points, panel);
    add_sizes("importance (1024 samples)", {.method = "importance", .samples = 1024}, chart, points,
              panel);
    return panel;
}

}  // namespace splitsum
