#include "splitsum/report/figures_text.h"

#include <iomanip>
#include <sstream>

namespace splitsum {
namespace {

constexpr int name_width = 12;
constexpr int column_width = 11;

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
    for (const char* name : {"size", "roughness", "rel_rms", "max_rel", "bias", "probes"})
        line << std::setw(column_width) << name;
    return line.str() + (with_accounts ? "  method\n" : "\n");
}

std::string figures_line(const std::string& what, const LevelCheck& check,
                         const LevelAccount* account) {
    std::ostringstream line;
    line << std::left << std::setw(name_width) << what << std::right << std::setw(column_width)
         << check.face_size << std::setw(column_width) << std::fixed << std::setprecision(4)
         << check.perceptual_roughness << std::scientific << std::setprecision(2);
    for (const double figure : {check.figures.rel_rms, check.figures.max_rel, check.figures.bias}) {
        line << std::setw(column_width);
        check.figures.texels > 0 ? line << figure : line << "-";
    }
    line << std::setw(column_width) << check.figures.texels;
    if (account) line << "  " << made_by(*account);
    line << "\n";
    return line.str();
}

}  // namespace splitsum
