#include "splitsum/chart/chart_page.h"

#include <iomanip>
#include <sstream>

#include "splitsum/base/base64.h"
#include "splitsum/base/html_text.h"
#include "splitsum/base/text.h"
#include "splitsum/base/version.h"
#include "splitsum/chart/plot_panel.h"

namespace splitsum {
namespace {

constexpr std::string_view style =
    "body{font:16px/1.5 system-ui,sans-serif;margin:0 auto;max-width:70rem;padding:1rem;color:#222;"
    "background:#fff}"
    "h1{font-size:1.5rem}h2{font-size:1.2rem;margin:2rem 0 .5rem}"
    ".panels{display:grid;grid-template-columns:repeat(auto-fit,minmax(min(100%,26rem),1fr));"
    "gap:1.5rem}"
    "figure{margin:0;min-width:0}img{width:100%;height:auto}"
    "figcaption,.note{color:#555;font-size:.9rem}"
    "summary{cursor:pointer;padding:.4rem 0}.wide{overflow-x:auto}"
    "table{border-collapse:collapse;font-size:.85rem;font-variant-numeric:tabular-nums}"
    "td,th{padding:.15rem .6rem;text-align:right;white-space:nowrap;border-bottom:1px solid #ddd}"
    "td:first-child,th:first-child{text-align:left}.front td{font-weight:600;background:#f2f2f2}"
    "dt{font-weight:600;margin-top:.5rem}dd{margin:0}";

std::string number(double value, int digits = 2) {
    std::ostringstream text;
    text << std::setprecision(digits) << value;
    return text.str();
}

std::string milliseconds(double value) {
    std::ostringstream text;
    text << std::fixed << std::setprecision(value < 10 ? 2 : value < 100 ? 1 : 0) << value;
    return text.str();
}

void add_conditions(std::ostream& out, const Chart& chart) {
    out << "<p>";
    for (const Chart::Source& source : chart.sources)
        out << html_text(source.file) << " (" << source.width << "&times;" << source.height
            << "). ";
    out << chart.threads << (chart.threads == 1 ? " thread" : " threads")
        << "; times are wall clock, the median of repeats after a run that warms up. Errors are "
           "against fp64 integration over every texel, at up to "
        << chart.probes << " probes a panel. Splitsum " << version
        << (chart.quick ? ", small ladders (--quick)." : ".") << "</p>\n";
    if (!chart.complete)
        out << "<p><strong>Interrupted: this is what was measured until then.</strong></p>\n";
}

void add_row(std::ostream& out, const Measurement& row) {
    const ErrorFigures& figures = row.figures;
    out << (row.on_front ? "<tr class=\"front\">" : "<tr>") << "<td>" << html_text(row.method)
        << "</td><td>"
        << (row.effort_name.empty() ? "" : cat(row.effort_name, " ", number(row.effort, 6)))
        << "</td><td>" << milliseconds(row.milliseconds) << "</td><td>" << number(figures.rel_rms)
        << "</td><td>" << number(figures.max_rel) << "</td><td>" << number(figures.max_abs)
        << "</td><td>" << number(figures.bias) << "</td></tr>\n";
}

void add_table(std::ostream& out, const MeasuredPanel& panel) {
    out << "<details><summary>All " << panel.rows.size()
        << " rows</summary><div class=\"wide\"><table>\n<tr><th>method</th><th>effort</th>"
           "<th>ms</th><th>rel_rms</th><th>max_rel</th><th>max_abs</th><th>bias</th></tr>\n";
    for (const Measurement& row : panel.rows) add_row(out, row);
    out << "</table></div></details>\n";
}

void add_picture(std::ostream& out, const InlinedPicture& picture) {
    out << "<img alt=\"" << html_text(picture.caption) << "\" src=\"data:image/svg+xml;base64,"
        << base64(picture.svg) << "\">\n";
}

void add_panels(std::ostream& out, const Chart& chart,
                const std::vector<InlinedPicture>& pictures) {
    out << "<h2>Speed against accuracy</h2>\n<p class=\"note\">Both axes are logarithmic: lower is "
           "nearer to the truth, left is faster. The grey steps join the rows that nothing beats; "
           "they are bold in the tables. A small number is the last effort of a line."
           "</p>\n<div class=\"panels\">\n";
    for (size_t i = 0; i < chart.panels.size(); ++i) {
        const MeasuredPanel& panel = chart.panels[i];
        out << "<figure>\n";
        if (i < pictures.size()) add_picture(out, pictures[i]);
        out << "<figcaption><strong>" << html_text(title_of(panel.facts)) << ".</strong> "
            << html_text(panel.facts.timed) << "</figcaption>\n";
        add_table(out, panel);
        out << "</figure>\n";
    }
    out << "</div>\n";
}

void add_chains(std::ostream& out, const Chart& chart) {
    out << "<details><summary>All " << chart.storage.size()
        << " chains</summary><div class=\"wide\"><table>\n<tr><th>panorama</th><th>format</th>"
           "<th>size</th><th>levels</th><th>bytes</th>";
    for (const ReconstructionError& error : chart.storage[0].errors)
        out << "<th>r " << error.range.from << "&ndash;" << error.range.to << "</th>";
    out << "</tr>\n";
    for (const StoredChain& chain : chart.storage) {
        out << "<tr><td>" << html_text(chain.panorama) << "</td><td>" << chain.format << "</td><td>"
            << chain.face_size << "&sup2;</td><td>" << chain.levels << "</td><td>" << chain.bytes
            << "</td>";
        for (const ReconstructionError& error : chain.errors)
            out << "<td>" << number(error.figures.rel_rms) << "</td>";
        out << "</tr>\n";
    }
    out << "</table></div></details>\n";
}

void add_storage(std::ostream& out, const Chart& chart,
                 const std::vector<InlinedPicture>& pictures) {
    if (chart.storage.empty()) return;
    out << "<h2>What an engine reads</h2>\n<p class=\"note\">Seamless trilinear lookups in the "
           "stored levels, at directions all over the sphere and roughness all over a band, beside "
           "the exact integral (relative RMS error). Where a line is flat, the format or the "
           "number "
           "of levels is the limit, not the size.</p>\n<div class=\"panels\">\n";
    for (size_t i = chart.panels.size(); i < pictures.size(); ++i) {
        out << "<figure>\n";
        add_picture(out, pictures[i]);
        out << "</figure>\n";
    }
    out << "</div>\n";
    add_chains(out, chart);
}

void add_notes(std::ostream& out, const Chart& chart) {
    out << "<h2>The methods</h2>\n<dl>\n";
    for (const MethodNote& note : chart.notes)
        out << "<dt>" << html_text(note.name) << "</dt><dd>" << html_text(note.sentence)
            << "</dd>\n";
    out << "</dl>\n";
}

}  // namespace

std::string chart_page(const Chart& chart, const std::vector<InlinedPicture>& pictures,
                       std::string_view missing) {
    std::ostringstream out;
    out << "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
           "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
           "<title>Speed against accuracy</title>\n<style>"
        << style << "</style>\n</head>\n<body>\n<h1>Baking light: speed against accuracy</h1>\n";
    add_conditions(out, chart);
    if (!missing.empty()) out << "<p><strong>" << html_text(missing) << "</strong></p>\n";
    add_panels(out, chart, pictures);
    add_storage(out, chart, pictures);
    add_notes(out, chart);
    out << "</body>\n</html>\n";
    return out.str();
}

}  // namespace splitsum
