#include "splitsum/chart/plot_storage.h"

#include <algorithm>
#include <cmath>

#include "splitsum/base/text.h"
#include "splitsum/chart/plot_text.h"

namespace splitsum {
namespace {

StoragePanel::Line& line_of(StoragePanel& panel, const std::string& format) {
    for (StoragePanel::Line& line : panel.lines)
        if (line.format == format) return line;
    panel.lines.push_back({format, {}});
    return panel.lines.back();
}

StoragePanel panel_of(const Chart& chart, const std::string& panorama, size_t band) {
    StoragePanel panel;
    for (const StoredChain& chain : chart.storage) {
        if (chain.panorama != panorama) continue;
        const ReconstructionError& error = chain.errors[band];
        panel.title = cat(chart.sources.size() > 1 ? panorama + ": " : "", "roughness ",
                          error.range.from, " to ", error.range.to);
        line_of(panel, chain.format)
            .points.push_back({chain.face_size, chain.bytes, error.figures.rel_rms});
    }
    return panel;
}

}  // namespace

std::vector<StoragePanel> storage_panels(const Chart& chart) {
    std::vector<StoragePanel> panels;
    for (const Chart::Source& source : chart.sources) {
        const auto first = std::ranges::find(chart.storage, source.name, &StoredChain::panorama);
        if (first == chart.storage.end()) continue;
        for (size_t band = 0; band < first->errors.size(); ++band)
            panels.push_back(panel_of(chart, source.name, band));
    }
    return panels;
}

void add_storage_data(std::ostream& out, const std::vector<StoragePanel>& panels) {
    for (size_t index = 0; index < panels.size(); ++index)
        for (size_t line = 0; line < panels[index].lines.size(); ++line) {
            out << "$storage" << index << "_" << line << " << END\n";
            for (const StoragePanel::Point& point : panels[index].lines[line].points)
                if (point.error > 0 && std::isfinite(point.error))
                    out << double(point.bytes) / 1024 << ' ' << point.error << ' '
                        << gnuplot_string(cat(point.face_size, "²")) << '\n';
            out << "END\n";
        }
}

void draw_storage_panel(std::ostream& out, size_t index, const StoragePanel& panel) {
    out << "set title " << gnuplot_string(panel.title)
        << " noenhanced\nset xlabel 'KiB of texels'\nset ylabel 'error (relative RMS)'\n"
           "unset arrow\nset xrange [*:*]\nset yrange [*:*]\nplot ";
    for (size_t line = 0; line < panel.lines.size(); ++line) {
        const std::string block = cat("$storage", index, "_", line);
        out << block << " using 1:2 with linespoints " << line_style(line) << " title "
            << gnuplot_string(panel.lines[line].format) << ", \\\n  ";
    }
    out << "$storage" << index
        << "_0 using 1:2:3 with labels offset 2.2,0.6 font ',10' "
           "tc rgb '#555555' notitle\n";
}

void draw_storage_legend(std::ostream& out, const StoragePanel& panel) {
    out << "unset title\nunset xlabel\nunset ylabel\nunset tics\nunset border\nunset grid\n"
           "set xrange [1:10]\nset yrange [1:10]\n"
           "set key default\nset key center center maxcols 4 noenhanced samplen 4 width 2 font "
           "',13'\nplot ";
    for (size_t line = 0; line < panel.lines.size(); ++line)
        out << (line == 0 ? "" : ", \\\n  ") << "NaN with linespoints " << line_style(line)
            << " title " << gnuplot_string(panel.lines[line].format);
    out << "\nset tics\nset border 3 lc rgb '#666666'\nset tics nomirror\n"
           "set grid xtics ytics lc rgb '#dddddd' lw 1\n";
}

}  // namespace splitsum
