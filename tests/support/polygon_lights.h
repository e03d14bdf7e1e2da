#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>
#include <vector>

#include "splitsum/base/parallel.h"
#include "splitsum/base/random.h"
#include "splitsum/ltc/polygon_light.h"
#include "splitsum/ltc/polygon_reference.h"
#include "splitsum/table/bilinear.h"
#include "splitsum/table/grid.h"
#include "splitsum/table/ltc_lookup.h"

namespace splitsum {

using Polygon = std::vector<Vec3d>;

/// What a renderer shades: a light seen by a surface from a view.
struct Scene {
    Polygon light;
    double n_dot_v;
    double perceptual_roughness;
};

// Numbers in [0, 1) of scene `index`, one after the other.
class Numbers {
public:
    explicit Numbers(uint32_t index) : key_(64 * index) {}
    double next() { return static_cast<double>(unit_float(key_++)); }
    Vec3d next_direction(double lowest_z) {
        const double z = lowest_z + (1 - lowest_z) * next();
        const double phi = 2 * std::numbers::pi * next();
        return {std::sqrt(1 - z * z) * std::cos(phi), std::sqrt(1 - z * z) * std::sin(phi), z};
    }

private:
    uint32_t key_;
};

/// A triangle or a rectangle about a point at distance 1, 0.3 to 4 wide, turned anyhow; centres down
/// to 12 degrees below the horizon, so that many lights cross it.
inline Scene random_scene(uint32_t index) {
    Numbers numbers(index);
    Scene scene{{}, numbers.next(), numbers.next()};
    const Vec3d centre = numbers.next_direction(-0.2);
    const Basis frame = basis_around(numbers.next_direction(-1));
    const double size = 0.15 * std::pow(2 / 0.15, numbers.next());
    if (numbers.next() < 0.5) {
        const double start = numbers.next();
        for (int i = 0; i < 3; ++i) {
            const double turn =
                2 * std::numbers::pi * (start + (i + 0.6 * (numbers.next() - 0.5)) / 3);
            scene.light.push_back(centre + size * (std::cos(turn) * frame.tangent +
                                                   std::sin(turn) * frame.bitangent));
        }
    } else {
        const double other = size * (0.3 + 0.7 * numbers.next());
        for (const auto& [x, y] : {std::pair(1, 1), {-1, 1}, {-1, -1}, {1, -1}})
            scene.light.push_back(centre + x * size * frame.tangent + y * other * frame.bitangent);
    }
    return scene;
}

/// The shaded value as an engine reads it from a table of transformed cosines: bilinear.
inline double shaded(const Table& table, const TablePlan& plan, const Scene& scene) {
    std::array<double, 8> read{};
    read_bilinear(table,
                  texture_coordinates(plan, table.width, ViewAxis::sqrt_one_minus_cosine,
                                      scene.n_dot_v, scene.perceptual_roughness),
                  read);
    return ltc_reflectance(read, 1) * ltc_polygon_light(ltc_inverse(read), scene.light);
}

struct ShadingErrors {
    double rms;      // of the difference, lights of radiance 1
    double rel_rms;  // over the rms of the shaded values
};

/// Of 6000 random scenes, against integration of the lobe itself.
inline ShadingErrors shading_errors(const Table& table, const TablePlan& plan, LtcTarget target) {
    constexpr int scenes = 6000;
    struct Sums {
        double difference2 = 0, value2 = 0;
        Sums operator+(const Sums& other) const {
            return {difference2 + other.difference2, value2 + other.value2};
        }
    };
    const Sums sums = ordered_sum(scenes, [&](int i) {
        const Scene scene = random_scene(static_cast<uint32_t>(i));
        const double value = polygon_light_reference(
            TargetLobe(target, scene.n_dot_v, scene.perceptual_roughness), scene.light);
        const double difference = shaded(table, plan, scene) - value;
        return Sums{difference * difference, value * value};
    });
    return {std::sqrt(sums.difference2 / scenes), std::sqrt(sums.difference2 / sums.value2)};
}

}  // namespace splitsum
