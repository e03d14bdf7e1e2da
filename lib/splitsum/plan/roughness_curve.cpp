#include "splitsum/plan/roughness_curve.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <charconv>
#include <cmath>
#include <string_view>

#include "splitsum/base/text.h"

namespace splitsum {
namespace {

Error not_a_curve(std::string_view text, std::string_view names) {
    return {ErrorKind::bad_argument,
            cat("'", text, "' is not a roughness curve; use ", names, ", or the perceptual ",
                "roughness of every level such as 0,0.25,0.5,1")};
}

Result<std::vector<double>> parse_list(std::string_view text, std::string_view names) {
    std::vector<double> values;
    const char* at = text.data();
    const char* const end = at + text.size();
    while (true) {
        double value = 0;
        const auto [stopped, failure] = std::from_chars(at, end, value);
        if (failure != std::errc()) return not_a_curve(text, names);
        values.push_back(value);
        if (stopped == end) return values;
        if (*stopped != ',') return not_a_curve(text, names);
        at = stopped + 1;
    }
}

// The shortest text that reads back as the same double.
std::string exact_text(double value) {
    std::array<char, 32> buffer;
    const auto written = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
    return {buffer.data(), written.ptr};
}

// filament: lod = r (2 - r), so r = 1 - sqrt(1 - lod), without the cancellation at small lod.
double filament_roughness(double lod) { return lod / (1 + std::sqrt(1 - lod)); }

double level_in_list(const std::vector<double>& list, double perceptual_roughness) {
    const auto above = std::lower_bound(list.begin(), list.end(), perceptual_roughness);
    if (above == list.begin()) return 0;
    const double level = static_cast<double>(above - list.begin());
    if (above == list.end()) return level - 1;
    const double below = *(above - 1);
    return level - 1 + (perceptual_roughness - below) / (*above - below);
}

// `names` are the curves with a name that an error lists.
Result<RoughnessCurve> parse_curve(const std::string& text, std::string_view names) {
    if (text == "linear") return RoughnessCurve{};
    if (text == "filament") return RoughnessCurve{RoughnessCurve::Kind::filament, {}};
    auto values = parse_list(text, names);
    if (!values) return values.error();
    RoughnessCurve curve{RoughnessCurve::Kind::list, std::move(*values)};
    if (const Status valid = validate(curve); !valid) return valid.error();
    return curve;
}

}  // namespace

Status validate(const RoughnessCurve& curve) {
    if (curve.kind != RoughnessCurve::Kind::list) return ok;
    if (curve.list.empty())
        return Error{ErrorKind::bad_argument,
                     "the list of roughness values is empty; name one for every level"};
    double previous = 0;
    for (const double r : curve.list) {
        if (!(r >= 0 && r <= 1))
            return Error{ErrorKind::bad_argument,
                         cat("perceptual roughness must be in [0, 1], got ", r)};
        if (r < previous)
            return Error{ErrorKind::bad_argument,
                         cat("roughness values must not fall from level to level, got ", r,
                             " after ", previous)};
        previous = r;
    }
    return ok;
}

Result<RoughnessCurve> parse_roughness_curve(const std::string& text) {
    return parse_curve(text, "linear, filament");
}

RoughnessCurve babylon_curve(int face_size, int levels) {
    RoughnessCurve curve{RoughnessCurve::Kind::list, {0}};
    for (int level = 1; level < levels; ++level) {
        const double alpha = std::exp2(level / 0.8) / face_size - 0.0005;
        curve.list.push_back(std::sqrt(std::clamp(alpha, 0.0, 1.0)));
    }
    return curve;
}

Result<RoughnessCurve> parse_roughness_curve_of_chain(const std::string& text, int face_size,
                                                      int levels) {
    if (text == "babylon") return babylon_curve(face_size, levels);
    return parse_curve(text, "linear, filament, babylon");
}

std::string to_string(const RoughnessCurve& curve) {
    switch (curve.kind) {
        case RoughnessCurve::Kind::linear: return "linear";
        case RoughnessCurve::Kind::filament: return "filament";
        case RoughnessCurve::Kind::list: break;
    }
    return join(curve.list, ",", exact_text);
}

std::vector<double> roughness_of_levels(const RoughnessCurve& curve, int levels) {
    if (curve.kind == RoughnessCurve::Kind::list) {
        assert(curve.list.size() == static_cast<size_t>(levels));
        return curve.list;
    }
    std::vector<double> roughness(static_cast<size_t>(levels), 0.0);
    for (int level = 1; level < levels; ++level) {
        const double lod = static_cast<double>(level) / (levels - 1);
        roughness[static_cast<size_t>(level)] =
            curve.kind == RoughnessCurve::Kind::filament ? filament_roughness(lod) : lod;
    }
    return roughness;
}

double level_of_roughness(const RoughnessCurve& curve, int levels, double perceptual_roughness) {
    const double r = std::clamp(perceptual_roughness, 0.0, 1.0);
    switch (curve.kind) {
        case RoughnessCurve::Kind::linear: return r * (levels - 1);
        case RoughnessCurve::Kind::filament: return r * (2 - r) * (levels - 1);
        case RoughnessCurve::Kind::list: break;
    }
    return level_in_list(curve.list, r);
}

}  // namespace splitsum
