#include "splitsum/report/figures_text.h"

#include <iomanip>
#include <sstream>

namespace splitsum {
namespace {

constexpr int name_width = 12;
constexpr int column_width = 11;
constexpr const char* figure_names[] = {"rel_rms", "max_rel", "bias", "probes"};

void write_figures(std::ostream& line, const ErrorFigures& figures) {
    line << std::scientific << std::setprecision(2);
    for (const double figure : {figures.rel_rms, figures.max_rel, figures.bias}) {
        line << std::setw(column_width);
        figures.texels > 0 ? line << figure : line << "-";
    }
    line << std::setw(column_width) << figures.texels;
}

std::string made_by(const LevelAccount& account) {
    std::ostringstream text;
    text << account.method << std::scientific << std::setprecision(2);
    if (account.bands > 0) text << ", " << account.bands << " bands, bound " << account.error_bound;
    return text.str();
}

}  // namespace

std::string figures_heading(bool with_accounts) {
    std::ostringstream line;
    line << std::left << std::setw(name_width) << "" << std::right;
    for (const char* name : {"size", "roughness"}) line << std::setw(column_width) << name;
    for (const char* name : figure_names) line << std::setw(column_width) << name;
    return line.str() + (with_accounts ? "  method\n" : "\n");
}

std::string figures_line(const std::string& what, const LevelCheck& check,
                         const LevelAccount* account) {
    std::ostringstream line;
    line << std::left << std::setw(name_width) << what << std::right << std::setw(column_width)
         << check.face_size << std::setw(column_width) << std::fixed << std::setprecision(4)
         << check.perceptual_roughness;
    write_figures(line, check.figures);
    if (account) line << "  " << made_by(*account);
    line << "\n";
    return line.str();
}

std::string readings_text(std::span<const ReconstructionError> bands) {
    std::ostringstream text;
    text << std::left << std::setw(name_width) << "" << std::right << std::setw(2 * column_width)
         << "roughness";
    for (const char* name : figure_names) text << std::setw(column_width) << name;
    text << "\n";
    for (const ReconstructionError& band : bands) {
        std::ostringstream range;
        range << band.range.from << " to " << band.range.to;
        text << std::left << std::setw(name_width) << "between" << std::right
             << std::setw(2 * column_width) << range.str();
        write_figures(text, band.figures);
        text << "\n";
    }
    return text.str();
}

}  // namespace splitsum
