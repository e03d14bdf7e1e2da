#include "splitsum/chart/chart_csv.h"

#include <sstream>
#include <string_view>

namespace splitsum {
namespace {

std::string field(std::string_view text) {
    if (text.find_first_of(",\"\n") == std::string_view::npos) return std::string(text);
    std::string quoted = "\"";
    for (const char letter : text) {
        if (letter == '"') quoted += '"';
        quoted += letter;
    }
    return quoted + "\"";
}

void add_row(std::ostream& out, const Chart& chart, const PanelFacts& facts,
             const Measurement& row) {
    const ErrorFigures& figures = row.figures;
    out << field(facts.panorama) << ',' << facts.asset << ',' << facts.perceptual_roughness << ','
        << facts.size << ',' << field(row.method) << ',' << row.effort_name << ',' << row.effort
        << ',' << figures.rel_rms << ',' << figures.max_rel << ',' << figures.max_abs << ','
        << figures.bias << ',' << figures.texels << ',' << chart.threads << ',' << row.milliseconds
        << ',' << row.repeats << ',' << (row.on_front ? "yes" : "no") << '\n';
}

}  // namespace

std::string chart_csv(const Chart& chart) {
    std::ostringstream out;
    out << "panorama,asset,perceptual_roughness,size,method,effort_name,effort,rel_rms,max_rel,"
           "max_abs,bias,probes,threads,milliseconds,repeats,on_front\n";
    for (const MeasuredPanel& panel : chart.panels)
        for (const Measurement& row : panel.rows) add_row(out, chart, panel.facts, row);
    return out.str();
}

std::string storage_csv(const Chart& chart) {
    std::ostringstream out;
    out << "panorama,format,face_size,levels,bytes,saturated,roughness_from,roughness_to,rel_rms,"
           "max_rel,max_abs,bias,probes\n";
    for (const StoredChain& chain : chart.storage)
        for (const ReconstructionError& error : chain.errors)
            out << field(chain.panorama) << ',' << chain.format << ',' << chain.face_size << ','
                << chain.levels << ',' << chain.bytes << ',' << chain.saturated << ','
                << error.range.from << ',' << error.range.to << ',' << error.figures.rel_rms << ','
                << error.figures.max_rel << ',' << error.figures.max_abs << ','
                << error.figures.bias << ',' << error.figures.texels << '\n';
    return out.str();
}

}  // namespace splitsum
