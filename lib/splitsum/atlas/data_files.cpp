#include "splitsum/atlas/data_files.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

namespace splitsum {
namespace {

using Json = nlohmann::ordered_json;

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json json_of(const AtlasCell& cell, const std::string& column) {
    Json json = {{"column", column}, {"verdict", name_of(cell.verdict)}};
    if (cell.figures) {
        json["rel_rms"] = number(cell.figures->rel_rms);
        json["max_rel"] = number(cell.figures->max_rel);
        json["bias"] = number(cell.figures->bias);
        json["max_abs"] = number(cell.figures->max_abs);
    }
    json["text"] = cell.text;
    return json;
}

Json json_of(const AtlasEntry& entry) {
    Json json = {{"case", entry.id},
                 {"title", entry.title},
                 {"problem", entry.problem},
                 {"conduct", entry.conduct},
                 {"row_kind", entry.table.row_kind},
                 {"rows", Json::array()}};
    for (const AtlasRow& row : entry.table.rows) {
        Json cells = Json::array();
        for (size_t i = 0; i < row.cells.size(); ++i)
            cells.push_back(json_of(row.cells[i], entry.table.columns[i]));
        json["rows"].push_back(
            {{"row", row.label}, {"worst", name_of(worst_of(row))}, {"cells", cells}});
    }
    return json;
}

std::string quoted(const std::string& text) {
    std::string result = "\"";
    for (const char c : text) result.append(c == '"' ? 2 : 1, c);
    return result + '"';
}

void append_line(std::ostream& csv, const AtlasEntry& entry, const AtlasRow& row, size_t column) {
    const AtlasCell& cell = row.cells[column];
    csv << entry.id << ',' << quoted(row.label) << ',' << quoted(entry.table.columns[column]) << ','
        << name_of(cell.verdict) << ',';
    if (cell.figures)
        csv << cell.figures->rel_rms << ',' << cell.figures->max_rel << ',' << cell.figures->bias
            << ',' << cell.figures->max_abs << ',';
    else
        csv << ",,,,";
    csv << quoted(cell.text) << "\r\n";
}

}  // namespace

std::string json_of(const Atlas& atlas) {
    Json json = {{"sky_rows", atlas.plan.sky_rows}, {"face_size", atlas.plan.face_size},
                 {"samples", atlas.plan.samples},   {"accuracy", atlas.plan.accuracy},
                 {"near_limit", near_limit},        {"cases", Json::array()}};
    for (const AtlasEntry& entry : atlas.entries) json["cases"].push_back(json_of(entry));
    return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string csv_of(const Atlas& atlas) {
    std::ostringstream csv;
    csv << "case,row,column,verdict,rel_rms,max_rel,bias,max_abs,text\r\n";
    for (const AtlasEntry& entry : atlas.entries)
        for (const AtlasRow& row : entry.table.rows)
            for (size_t column = 0; column < row.cells.size(); ++column)
                append_line(csv, entry, row, column);
    return csv.str();
}

}  // namespace splitsum
