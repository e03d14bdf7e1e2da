#include "splitsum/chart/plot_panel.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "splitsum/base/text.h"
#include "splitsum/chart/plot_text.h"

namespace splitsum {
namespace {

constexpr const char* front_style = "with steps lc rgb '#bbbbbb' lw 7";
constexpr const char* reference_style = "lc rgb '#000000' lw 1.5 dt 3";

bool can_be_drawn(const PanelFacts& facts, const Measurement& row) {
    const double error = shown_error(facts, row.figures);
    return error > 0 && std::isfinite(error) && row.milliseconds > 0;
}

// The methods of a panel that have something to draw, as places among the notes.
std::vector<size_t> lines_of(const Chart& chart, const MeasuredPanel& panel) {
    std::vector<size_t> places;
    for (const Measurement& row : panel.rows) {
        const size_t place = place_of(chart.notes, row.method);
        if (can_be_drawn(panel.facts, row) && std::ranges::find(places, place) == places.end())
            places.push_back(place);
    }
    return places;
}

void add_point(std::ostream& out, const PanelFacts& facts, const Measurement& row) {
    out << row.milliseconds << ' ' << shown_error(facts, row.figures) << ' '
        << gnuplot_string(cat(row.effort)) << '\n';
}

void add_front(std::ostream& out, const MeasuredPanel& panel, size_t index) {
    std::vector<Measurement> front;
    for (const Measurement& row : panel.rows)
        if (row.on_front) front.push_back(row);
    std::ranges::sort(front, {}, &Measurement::milliseconds);
    out << "$front" << index << " << END\n";
    for (const Measurement& row : front) add_point(out, panel.facts, row);
    out << "END\n";
}

// Both axes with room around what is drawn, the time of the reference included.
struct Ranges {
    LogRange time{1, 10};
    LogRange error{1e-4, 1};
};

Ranges ranges_of(const MeasuredPanel& panel) {
    double times[2] = {1e300, 0}, errors[2] = {1e300, 0};
    for (const Measurement& row : panel.rows) {
        times[0] = std::min(times[0], row.milliseconds);
        times[1] = std::max(times[1], row.milliseconds);
        if (!can_be_drawn(panel.facts, row)) continue;
        const double error = shown_error(panel.facts, row.figures);
        errors[0] = std::min(errors[0], error);
        errors[1] = std::max(errors[1], error);
    }
    Ranges ranges;
    if (times[1] > 0) ranges.time = range_around(std::max(times[0], 1e-6), times[1]);
    if (errors[1] > 0) ranges.error = range_around(errors[0], errors[1]);
    return ranges;
}

const Measurement* reference_of(const MeasuredPanel& panel) {
    const auto found = std::ranges::find(panel.rows, "reference", &Measurement::method);
    return found == panel.rows.end() ? nullptr : &*found;
}

// The last effort of every line, beside its last point.
void add_efforts(std::ostream& out, const Chart& chart, size_t index) {
    for (const size_t place : lines_of(chart, chart.panels[index])) {
        const std::string block = cat("$panel", index, "_", place);
        const std::string last = cat("(|", block, "|-1)");
        out << ", \\\n  " << block << " every ::" << last << "::" << last
            << " using 1:2:3 with labels offset 0,0.8 font ',10' tc rgb '#555555' notitle";
    }
}

}  // namespace

std::string title_of(const PanelFacts& facts) {
    return cat(facts.panorama, facts.panorama.empty() ? "" : ": ", facts.title);
}

void add_panel_data(std::ostream& out, const Chart& chart) {
    for (size_t index = 0; index < chart.panels.size(); ++index) {
        const MeasuredPanel& panel = chart.panels[index];
        for (const size_t place : lines_of(chart, panel)) {
            out << "$panel" << index << "_" << place << " << END\n";
            for (const Measurement& row : panel.rows)
                if (can_be_drawn(panel.facts, row) && row.method == chart.notes[place].name)
                    add_point(out, panel.facts, row);
            out << "END\n";
        }
        add_front(out, panel, index);
    }
}

size_t legend_entries(const Chart& chart, size_t index) {
    const MeasuredPanel& panel = chart.panels[index];
    return lines_of(chart, panel).size() + (reference_of(panel) ? 2 : 1);  // the front is one
}

void draw_panel(std::ostream& out, const Chart& chart, size_t index, PanelDetail detail) {
    const MeasuredPanel& panel = chart.panels[index];
    const bool alone = detail == PanelDetail::alone;
    const Ranges ranges = ranges_of(panel);
    out << "set title "
        << gnuplot_string(alone || chart.sources.size() > 1 ? title_of(panel.facts)
                                                            : panel.facts.title)
        << " noenhanced\nset xlabel 'milliseconds'\nset ylabel 'error ("
        << (panel.facts.figure == "max_abs" ? "largest, absolute" : "relative RMS") << ")'\n"
        << "unset arrow\nset xrange " << to_string(ranges.time) << "\nset yrange "
        << to_string(ranges.error) << "\n";
    if (const Measurement* reference = reference_of(panel))
        out << "set arrow from " << reference->milliseconds << ", graph 0 to "
            << reference->milliseconds << ", graph 1 nohead " << reference_style << "\n";
    out << "plot $front" << index << " using 1:2 " << front_style << " title 'nothing beats these'";
    for (const size_t place : lines_of(chart, panel))
        out << ", \\\n  $panel" << index << "_" << place << " using 1:2 with linespoints "
            << line_style(place) << " title " << gnuplot_string(chart.notes[place].name);
    if (reference_of(panel)) out << ", \\\n  NaN " << reference_style << " title 'reference'";
    if (alone) add_efforts(out, chart, index);
    out << "\n";
}

void draw_legend(std::ostream& out, const Chart& chart) {
    out << "unset title\nunset xlabel\nunset ylabel\nunset arrow\nunset tics\nunset border\n"
           "unset grid\nset xrange [1:10]\nset yrange [1:10]\n"
           "set key default\nset key center center maxcols 4 noenhanced samplen 4 width 2 font "
           "',13'\n"
        << "plot NaN " << front_style << " title 'nothing beats these'";
    for (size_t place = 0; place < chart.notes.size(); ++place) {
        const std::string& name = chart.notes[place].name;
        if (name == "reference") continue;
        out << ", \\\n  NaN with linespoints " << line_style(place) << " title "
            << gnuplot_string(name);
    }
    out << ", \\\n  NaN with lines " << reference_style << " title 'reference (error 0)'\n"
        << "set tics\nset border 3 lc rgb '#666666'\nset tics nomirror\n"
           "set grid xtics ytics lc rgb '#dddddd' lw 1\n";
}

}  // namespace splitsum
