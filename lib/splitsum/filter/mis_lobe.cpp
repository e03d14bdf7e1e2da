#include "splitsum/filter/mis_lobe.h"

#include <algorithm>

#include "splitsum/brdf/ggx.h"
#include "splitsum/brdf/lambert.h"

namespace splitsum {
namespace {

// The last number before the horizon, onto which rounding must not carry a sample: its pdf is 0.
constexpr double above_horizon = 1 - 0x1p-53;

}  // namespace

LobeSampler::LobeSampler(const Lobe& lobe)
    : lobe_(lobe), inverse_integral_(1 / lobe_integral(lobe)) {
    if (lobe.kind == LobeKind::ggx) visible_ = 1 / (1 + lobe.alpha * lobe.alpha);
}

LobeSampler::Sample LobeSampler::sample(const Vec2d& u) const {
    if (lobe_.kind == LobeKind::cosine) {
        const Vec3d direction = sample_cosine_direction(u);
        return {direction, std::min(u.x / (1 + direction.z), above_horizon)};
    }
    // l = 2 (n·h) h - n, so that 1 - n·l = 2 sin² theta_h.
    const auto [half, sin2_half] = sample_ggx_normal({u.x * visible_, u.y}, lobe_.alpha);
    return {{2 * half.z * half.x, 2 * half.z * half.y, 1 - 2 * sin2_half},
            std::min(2 * sin2_half, above_horizon)};
}

double LobeSampler::pdf(double versine) const {
    if (versine >= 1) return 0;
    if (lobe_.kind == LobeKind::cosine) return cosine_direction_pdf(1 - versine);
    return ggx_density(0.5 * versine, lobe_.alpha) / (4 * visible_);
}

double LobeSampler::value(double versine) const {
    return lobe_value(lobe_, versine) * inverse_integral_;
}

}  // namespace splitsum
