#include "splitsum/brdf/charlie_albedo.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "splitsum/math/tanh_sinh.h"

namespace splitsum {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double coarsest_step = 1.0 / 6;
constexpr double finest_step = 1.0 / 48;

bool knows_the_width(ClothVisibility visibility) {
    return visibility == ClothVisibility::estevez_kulla;
}

// n·l below which Neubelt's term exceeds 1; 0 where it never does.
double clamping_cosine(ClothVisibility visibility, double n_dot_v) {
    if (visibility != ClothVisibility::neubelt_clamped) return 0;
    return std::max(0.0, (0.25 - n_dot_v) / (1 - n_dot_v));
}

double sine_of(double cosine) { return std::sqrt((1 - cosine) * (1 + cosine)); }

// n·l = middle + swing cos(azimuth) around one theta_h.
struct RingOfLight {
    double swing;
    double middle;

    // Where n·l falls to `level`: 0 if it never is above, pi if it never falls to it.
    double azimuth_of(double level) const {
        if (middle - swing >= level) return pi;
        return std::acos(std::clamp((level - middle) / swing, -1.0, 1.0));
    }

    // At `distance` before `end`; where that is the azimuth of the horizon, as a product that keeps
    // its digits: cos a - cos end = 2 sin((end + a) / 2) sin((end - a) / 2).
    double n_dot_l(double azimuth, double end, double distance) const {
        if (middle >= swing || end < azimuth_of(0)) return middle + swing * std::cos(azimuth);
        return 2 * swing * std::sin(0.5 * (end + azimuth)) * std::sin(0.5 * distance);
    }
};

}  // namespace

ClothAlbedo::ClothAlbedo(ClothVisibility visibility, double n_dot_v, double tolerance)
    : visibility_(visibility), n_dot_v_(std::max(n_dot_v, most_grazing_cloth_view)) {
    constexpr double widths[] = {narrowest_cloth_alpha, 0.01, 0.15, 1.0};
    double before[] = {0, 0, 0, 0};
    for (double step = coarsest_step; step >= finest_step; step *= 0.5) {
        place_rings(step);
        double change = 0;
        for (size_t i = 0; i < std::size(widths); ++i) {
            const double now = albedo(widths[i]);
            change = std::max(change, std::abs(now - before[i]) / std::max(1.0, now));
            before[i] = now;
        }
        // The error that is left is far below the change: halving the step squares it.
        if (change < std::sqrt(tolerance) * 0.1) return;
    }
}

double ClothAlbedo::at(double alpha) const {
    return albedo(std::clamp(alpha, narrowest_cloth_alpha, 1.0));
}

// With the view in the plane of azimuth 0, s = sin theta_v:
//
//     n·l = s sin(2 theta) cos(azimuth) + n·v cos(2 theta),
//
// which is cos(2 theta - theta_v) at azimuth 0 and cos(2 theta + theta_v) at azimuth pi: light there
// falls to a level at half of its angle plus or minus theta_v. Between such angles all is smooth.
void ClothAlbedo::place_rings(double step) {
    rings_.clear();
    const double theta_v = std::atan2(sine_of(n_dot_v_), n_dot_v_);
    std::vector<double> ends = {0};
    for (const double level : {0.0, clamping_cosine(visibility_, n_dot_v_)})
        for (const double shift : {theta_v, -theta_v})
            ends.push_back(0.5 * std::max(0.0, std::acos(level) + shift));
    std::ranges::sort(ends);
    const std::vector<UnitNode> nodes = tanh_sinh(step);
    for (size_t i = 0; i + 1 < ends.size(); ++i) {
        const double length = ends[i + 1] - ends[i];
        if (!(length > 0)) continue;
        for (const UnitNode& node : nodes)
            add_ring(ends[i + 1] - length * node.from_end, length * node.weight, nodes);
    }
}

// n·l falls with the azimuth: at `clamped` the visibility has a kink, at `end` light sinks.
void ClothAlbedo::add_ring(double theta, double weight, const std::vector<UnitNode>& nodes) {
    const double sin_v = sine_of(n_dot_v_);
    const double sine = std::sin(theta), cosine = std::cos(theta);
    const RingOfLight at{2 * sin_v * sine * cosine, n_dot_v_ * (cosine - sine) * (cosine + sine)};
    if (!(sine > 0) || at.middle + at.swing <= 0) return;
    Ring ring{std::log(sine), 0, {}};
    const auto add_arc = [&](double from, double to) {
        for (const UnitNode& node : nodes) {
            const double azimuth = to - (to - from) * node.from_end;
            const double n_dot_l = at.n_dot_l(azimuth, to, (to - from) * node.from_end);
            if (!(n_dot_l > 0)) continue;
            const double v_dot_h = sin_v * sine * std::cos(azimuth) + n_dot_v_ * cosine;
            const double light = 8 * node.weight * (to - from) * weight * v_dot_h * sine * n_dot_l;
            if (knows_the_width(visibility_))
                ring.lights.push_back({n_dot_l, light});
            else
                ring.sum += light * cloth_visibility(visibility_, n_dot_l, n_dot_v_, 1);
        }
    };
    const double end = at.azimuth_of(0);
    const double clamped = at.azimuth_of(clamping_cosine(visibility_, n_dot_v_));
    if (clamped > 0) add_arc(0, clamped);
    if (end > clamped) add_arc(clamped, end);
    rings_.push_back(std::move(ring));
}

double ClothAlbedo::albedo(double alpha) const {
    const double inverse = 1 / alpha;
    const double lambda_v = knows_the_width(visibility_) ? charlie_lambda(n_dot_v_, alpha) : 0;
    double sum = 0;
    for (const Ring& ring : rings_) {
        const double density = std::exp(inverse * ring.log_sine);
        if (density < 1e-16) continue;
        double lights = ring.sum;
        for (const Light& light : ring.lights)
            lights +=
                light.weight * 0.25 /
                (light.n_dot_l * n_dot_v_ * (1 + charlie_lambda(light.n_dot_l, alpha) + lambda_v));
        sum += density * lights;
    }
    return sum * (2 + inverse) * 0.5 * std::numbers::inv_pi;
}

// Light that grazes at the viewer's azimuth has the half vector nearest to the horizon: the peak is at
// a corner of the square of n·l and azimuth.
double charlie_albedo_exact(ClothVisibility visibility, double n_dot_v, double alpha, double step) {
    const double width = std::clamp(alpha, narrowest_cloth_alpha, 1.0);
    const double cos_v = std::max(n_dot_v, most_grazing_cloth_view);
    const std::vector<UnitNode> nodes = tanh_sinh(step);
    const auto up_to = [&](double from, double to) {
        double sum = 0;
        for (const UnitNode& height : nodes) {
            const double cos_l = from + (to - from) * height.from_start;
            if (!(cos_l > 0)) continue;
            const double sines = sine_of(cos_v) * sine_of(cos_l);
            double around = 0;
            for (const UnitNode& turn : nodes) {
                const double l_dot_v = cos_l * cos_v + sines * std::cos(pi * turn.from_start);
                const double cos2_h = 0.5 * (cos_l + cos_v) * (cos_l + cos_v) / (1 + l_dot_v);
                around += turn.weight * charlie_density(std::clamp(1 - cos2_h, 0.0, 1.0), width);
            }
            sum +=
                height.weight * cos_l * cloth_visibility(visibility, cos_l, cos_v, width) * around;
        }
        return (to - from) * sum;
    };
    const double kink = clamping_cosine(visibility, cos_v);
    return 2 * pi * ((kink > 0 ? up_to(0, kink) : 0) + up_to(kink, 1));
}

}  // namespace splitsum
