#include "splitsum/chart/gnuplot_script.h"

#include <sstream>

#include "splitsum/base/text.h"
#include "splitsum/chart/plot_grid.h"
#include "splitsum/chart/plot_panel.h"
#include "splitsum/chart/plot_storage.h"
#include "splitsum/chart/plot_text.h"

namespace splitsum {
namespace {

struct Terminal {
    std::string_view ending;
    std::string_view settings;  // without the size
};

constexpr Terminal svg = {"svg",
                          "svg dynamic enhanced background '#ffffff' "
                          "font 'Helvetica,Arial,DejaVu Sans,sans-serif,14'"};
constexpr Terminal png = {"png", "pngcairo enhanced background '#ffffff' font 'DejaVu Sans,11'"};

void open(std::ostream& out, const Terminal& terminal, const std::string& name, int width,
          int height) {
    out << "set terminal " << terminal.settings << " size " << width << "," << height
        << "\nset output '" << name << "." << terminal.ending << "'\n";
}

std::string heading(const Chart& chart) {
    const std::string lights = join(chart.sources, ", ", [](const auto& s) { return s.name; });
    return cat("Speed against accuracy", lights.empty() ? "" : ": ", lights, " (", chart.threads,
               chart.threads == 1 ? " thread" : " threads", chart.complete ? "" : ", interrupted",
               ")");
}

void draw_all(std::ostream& out, const Terminal& terminal, const Chart& chart) {
    const PlotGrid grid(int(chart.panels.size()), {3, 460, 360, 50, 150});
    open(out, terminal, "chart", grid.width(), grid.height());
    out << "set multiplot title " << gnuplot_string(heading(chart)) << " noenhanced font ',18'\n";
    for (size_t i = 0; i < chart.panels.size(); ++i) {
        out << grid.place(int(i)) << "unset key\n";
        draw_panel(out, chart, i, PanelDetail::overview);
    }
    out << grid.legend();
    draw_legend(out, chart);
    out << "unset multiplot\nset output\n";
}

void draw_storage(std::ostream& out, const Terminal& terminal, const Chart& chart) {
    const std::vector<StoragePanel> panels = storage_panels(chart);
    if (panels.empty()) return;
    const PlotGrid grid(int(panels.size()), {4, 400, 360, 50, 60});
    open(out, terminal, "storage", grid.width(), grid.height());
    out << "set multiplot title " << gnuplot_string("What an engine reads from the stored levels")
        << " noenhanced font ',18'\n";
    for (size_t i = 0; i < panels.size(); ++i) {
        out << grid.place(int(i)) << "unset key\n";
        draw_storage_panel(out, i, panels[i]);
    }
    out << grid.legend();
    draw_storage_legend(out, panels[0]);
    out << "unset multiplot\nset output\n";
}

// A picture of one panel with a key of so many lines below.
void open_single(std::ostream& out, size_t picture, size_t entries) {
    const PlotGrid grid(1, {.heading = 15, .legend = 20 + 10 * int(entries + 1)});
    open(out, svg, cat("panel-", picture), grid.width(), grid.height());
    out << grid.place(0) << grid.key(int(entries));
}

void draw_singles(std::ostream& out, const Chart& chart) {
    size_t picture = 0;
    for (size_t i = 0; i < chart.panels.size(); ++i) {
        open_single(out, picture++, legend_entries(chart, i));
        draw_panel(out, chart, i, PanelDetail::alone);
        out << "set output\n";
    }
    const std::vector<StoragePanel> panels = storage_panels(chart);
    for (size_t i = 0; i < panels.size(); ++i) {
        open_single(out, picture++, panels[i].lines.size());
        draw_storage_panel(out, i, panels[i]);
        out << "set output\n";
    }
}

}  // namespace

std::vector<PanelPicture> panel_pictures(const Chart& chart) {
    std::vector<PanelPicture> pictures;
    const auto add = [&](const std::string& caption) {
        pictures.push_back({cat("panel-", pictures.size(), ".svg"), caption});
    };
    for (const MeasuredPanel& panel : chart.panels) add(title_of(panel.facts));
    for (const StoragePanel& panel : storage_panels(chart)) add(panel.title);
    return pictures;
}

std::string gnuplot_script(const Chart& chart) {
    std::ostringstream out;
    out << "# Writes chart.svg, chart.png, storage.svg, storage.png and panel-*.svg: gnuplot "
           "chart.gnuplot\nset encoding utf8\nset logscale xy\nset format x '%g'\n"
           "set format y '10^{%L}'\nset grid xtics ytics lc rgb '#dddddd' lw 1\n"
           "set border 3 lc rgb '#666666'\nset tics nomirror\nset mxtics 1\nset mytics 1\n";
    add_panel_data(out, chart);
    add_storage_data(out, storage_panels(chart));
    draw_singles(out, chart);
    for (const Terminal& terminal : {svg, png}) {
        draw_all(out, terminal, chart);
        draw_storage(out, terminal, chart);
    }
    return out.str();
}

}  // namespace splitsum
