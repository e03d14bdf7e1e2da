#include "limits.h"

#include <array>
#include <cmath>
#include <string_view>

#include "splitsum/base/text.h"

namespace splitsum::tools {
namespace {

struct Figure {
    std::string_view name;
    double (*of)(const ErrorFigures&);
};

constexpr std::array<Figure, 4> table = {{
    {"rel_rms", [](const ErrorFigures& f) { return f.rel_rms; }},
    {"max_rel", [](const ErrorFigures& f) { return f.max_rel; }},
    {"max_abs", [](const ErrorFigures& f) { return f.max_abs; }},
    {"bias", [](const ErrorFigures& f) { return std::abs(f.bias); }},
}};

const Figure* find_figure(std::string_view name) {
    for (const Figure& figure : table)
        if (figure.name == name) return &figure;
    return nullptr;
}

}  // namespace

Result<Limit> parse_limit(const std::string& text) {
    const size_t equals = text.find('=');
    const std::string name = equals == std::string::npos ? "rel_rms" : text.substr(0, equals);
    const std::string number = equals == std::string::npos ? text : text.substr(equals + 1);
    if (!find_figure(name))
        return Error{ErrorKind::bad_argument,
                     cat("no figure '", name, "' to limit; there are: ",
                         join(table, ", ", [](const Figure& f) { return f.name; }))};
    std::istringstream stream(number);
    double value = 0;
    if (!(stream >> value) || !stream.eof() || !(value >= 0) || !std::isfinite(value))
        return Error{ErrorKind::bad_argument,
                     cat("'", text, "' is not a limit; write for instance rel_rms=0.01")};
    return Limit{name, value};
}

std::vector<std::string> exceeded(const ErrorFigures& figures, const std::vector<Limit>& limits) {
    std::vector<std::string> names;
    for (const Limit& limit : limits) {
        const double found = find_figure(limit.figure)->of(figures);
        if (!(found <= limit.value))
            names.push_back(cat(limit.figure, " ", found, " is over ", limit.value));
    }
    return names;
}

}  // namespace splitsum::tools
