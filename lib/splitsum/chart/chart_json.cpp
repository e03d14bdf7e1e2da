#include "splitsum/chart/chart_json.h"

#include <nlohmann/json.hpp>

#include "splitsum/base/version.h"

namespace splitsum {
namespace {

using Json = nlohmann::ordered_json;

Json figures_of(const ErrorFigures& figures) {
    return {{"rel_rms", figures.rel_rms},
            {"max_rel", figures.max_rel},
            {"max_abs", figures.max_abs},
            {"bias", figures.bias},
            {"probes", figures.texels}};
}

Json row_of(const Measurement& row) {
    Json json = {{"method", row.method}};
    if (!row.effort_name.empty()) json[row.effort_name] = row.effort;
    json.update(figures_of(row.figures));
    json["milliseconds"] = row.milliseconds;
    json["repeats"] = row.repeats;
    json["on_front"] = row.on_front;
    return json;
}

Json panel_of(const MeasuredPanel& panel) {
    const PanelFacts& facts = panel.facts;
    Json json;
    if (!facts.panorama.empty()) json["panorama"] = facts.panorama;
    json["asset"] = facts.asset;
    if (facts.asset == "specular") json["perceptual_roughness"] = facts.perceptual_roughness;
    if (facts.size > 0) json["size"] = facts.size;
    json["shown_figure"] = facts.figure;
    json["timed"] = facts.timed;
    json["rows"] = Json::array();
    for (const Measurement& row : panel.rows) json["rows"].push_back(row_of(row));
    return json;
}

Json chain_of(const StoredChain& chain) {
    Json json = {{"panorama", chain.panorama},   {"format", chain.format},
                 {"face_size", chain.face_size}, {"levels", chain.levels},
                 {"bytes", chain.bytes},         {"saturated", chain.saturated}};
    json["bands"] = Json::array();
    for (const ReconstructionError& error : chain.errors) {
        json["bands"].push_back({{"perceptual_roughness", {error.range.from, error.range.to}}});
        json["bands"].back().update(figures_of(error.figures));
    }
    return json;
}

}  // namespace

std::string chart_json(const Chart& chart) {
    Json json = {{"splitsum", version},
                 {"complete", chart.complete},
                 {"quick", chart.quick},
                 {"threads", chart.threads}};
    json["panoramas"] = Json::array();
    for (const Chart::Source& source : chart.sources)
        json["panoramas"].push_back({{"name", source.name},
                                     {"file", source.file},
                                     {"hash", source.hash},
                                     {"width", source.width},
                                     {"height", source.height}});
    json["methods"] = Json::object();
    for (const MethodNote& note : chart.notes) json["methods"][note.name] = note.sentence;
    json["panels"] = Json::array();
    for (const MeasuredPanel& panel : chart.panels) json["panels"].push_back(panel_of(panel));
    json["storage"] = Json::array();
    for (const StoredChain& chain : chart.storage) json["storage"].push_back(chain_of(chain));
    return json.dump(2) + "\n";
}

}  // namespace splitsum
