#include "splitsum/atlas/page.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <ostream>
#include <sstream>

#include "splitsum/atlas/page_style_detail.h"
#include "splitsum/base/base64.h"
#include "splitsum/base/html_text.h"
#include "splitsum/base/text.h"
#include "splitsum/base/version.h"

namespace splitsum {
namespace {

void print_image(std::ostream& out, const std::string& png, const std::string& of,
                 const char* attributes) {
    if (png.empty()) return;
    out << "<img " << attributes << " alt=\"" << html_text(of) << "\" src=\"data:image/png;base64,"
        << base64(png) << "\">";
}

std::string_view sign_of(Verdict verdict) {
    switch (verdict) {
        case Verdict::meets: return "✓";
        case Verdict::near: return "≈";
        case Verdict::fails: return "✗";
        case Verdict::refuses: return "–";
    }
    return "✗";
}

// Two digits, which is as much as anyone compares.
std::string short_number(double value) {
    if (value == 0) return "0";
    if (!std::isfinite(value)) return std::isnan(value) ? "NaN" : "∞";
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.1e", value);
    return text.data();
}

void print_cell(std::ostream& out, const AtlasCell& cell, const std::string& of) {
    out << "<td class=" << name_of(cell.verdict) << '>';
    print_image(out, cell.png, of, "loading=lazy");
    out << sign_of(cell.verdict) << ' ';
    if (!cell.figures) {
        out << html_text(cell.text) << "</td>";
        return;
    }
    out << short_number(cell.figures->rel_rms) << "<small>max "
        << short_number(cell.figures->max_rel) << "</small><small>energy "
        << (cell.figures->bias > 0 ? "+" : "") << short_number(cell.figures->bias)
        << "</small><small>" << html_text(cell.text) << "</small></td>";
}

void print_table(std::ostream& out, const AtlasEntry& entry) {
    const AtlasTable& table = entry.table;
    out << "<div class=scroll><table class=" << entry.id << "><thead><tr><th>" << table.row_kind
        << "</th>";
    for (const std::string& column : table.columns) out << "<th>" << html_text(column) << "</th>";
    out << "</tr></thead><tbody>\n";
    for (const AtlasRow& row : table.rows) {
        out << "<tr><th>" << html_text(row.label) << "</th>";
        for (size_t i = 0; i < row.cells.size(); ++i)
            print_cell(out, row.cells[i], cat(row.label, ", ", table.columns[i]));
        out << "</tr>\n";
    }
    out << "</tbody></table></div>\n";
}

void print_entry(std::ostream& out, const AtlasEntry& entry) {
    out << "<section id=" << entry.id << "><h2>" << html_text(entry.title) << "</h2>\n";
    print_image(out, entry.png, cat("the panorama of ", entry.id), "class=sky");
    out << "<p><b>What goes wrong.</b> " << html_text(entry.problem)
        << "</p>\n<p><b>What happens here.</b> " << html_text(entry.conduct) << "</p>\n";
    print_table(out, entry);
    out << "</section>\n";
}

// The worst of each row, for the cases whose rows are methods of filtering.
void print_overview(std::ostream& out, const Atlas& atlas) {
    out << "<div class=scroll><table class=overview><thead><tr><th>worst of each case</th>";
    for (const FilterMethod& method : atlas.plan.methods) out << "<th>" << method.name << "</th>";
    out << "</tr></thead><tbody>\n";
    for (const AtlasEntry& entry : atlas.entries) {
        if (entry.table.rows.size() != atlas.plan.methods.size() ||
            entry.table.rows.front().label != atlas.plan.methods.front().name)
            continue;
        out << "<tr><th><a href=\"#" << entry.id << "\">" << html_text(entry.title) << "</a></th>";
        for (const AtlasRow& row : entry.table.rows) {
            const Verdict worst = worst_of(row);
            out << "<td class=" << name_of(worst) << '>' << sign_of(worst) << ' ' << name_of(worst)
                << "</td>";
        }
        out << "</tr>\n";
    }
    out << "</tbody></table></div>\n";
}

void print_methods(std::ostream& out, const Atlas& atlas) {
    out << "<h2>The methods</h2>\n<div class=scroll><table><tbody>\n";
    for (const FilterMethod& method : atlas.plan.methods)
        out << "<tr><th>" << method.name << "</th><td>" << html_text(method.summary)
            << "</td></tr>\n";
    out << "</tbody></table></div>\n";
}

void print_introduction(std::ostream& out, const AtlasPlan& plan) {
    out << "<h1>Where methods fail</h1>\n<p>Generated panoramas that some way of filtering light "
           "finds hard, and what every method made of them, beside the exact integral of the "
           "piecewise-constant panorama. The first figure of a cell is <b>rel_rms</b>, "
           "sqrt(Σ (x − ref)² / Σ ref²) over the texels of a cubemap; <b>max</b> is the largest "
           "|x − ref| / ref of a channel, large where next to no light falls; <b>energy</b> is "
           "Σ x / Σ ref − 1. r is perceptual roughness.</p>\n<p><span class=meets>✓ meets</span> "
           "the accuracy of "
        << plan.accuracy << "; <span class=near>≈ near</span>: within " << near_limit
        << "; <span class=fails>✗ fails</span>: further away, or not light; <span class=refuses>– "
           "refuses</span>: says that it does not do this. Methods that sample had "
        << plan.samples << " samples where a case does not say otherwise; panoramas have "
        << plan.sky_rows << " rows, faces " << plan.face_size
        << " texels. Pictures show the whole sphere, of all methods at one exposure.</p>\n";
}

}  // namespace

std::string page_of(const Atlas& atlas) {
    std::ostringstream out;
    out << "<!doctype html>\n<html lang=en><head><meta charset=utf-8>\n<meta name=viewport "
           "content=\"width=device-width, initial-scale=1\">\n<title>Splitsum: where methods "
           "fail</title>\n<style>"
        << page_style << "</style></head><body>\n";
    print_introduction(out, atlas.plan);
    print_overview(out, atlas);
    for (const AtlasEntry& entry : atlas.entries) print_entry(out, entry);
    print_methods(out, atlas);
    out << "<p>Splitsum " << version << "</p>\n</body></html>\n";
    return out.str();
}

}  // namespace splitsum
