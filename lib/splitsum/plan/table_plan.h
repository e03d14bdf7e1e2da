#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "splitsum/base/result.h"
#include "splitsum/brdf/smith.h"

namespace splitsum {

/// Where the texels of a table sit on its axes, `size` of them over [0, 1].
enum class TexelLayout {
    centre,  ///< texel i at (i + 1/2) / size: texture coordinates are the quantities themselves
    edge,    ///< texel i at i / (size - 1): the first is exactly at 0, the last at 1
};

/// Which quantity goes right and which goes down.
enum class TableAxes {
    nv_roughness,  ///< x = n·v, y = roughness
    roughness_nv,  ///< x = roughness, y = n·v
};

/// What the roughness axis counts in.
enum class RoughnessAxis {
    perceptual,  ///< perceptual roughness r
    alpha,       ///< the width alpha = r² of the lobe
};

/// A value of one of these, its name as typed and written into files, and a line for --help. The
/// first row of each list is the default.
template <class Value>
struct NamedValue {
    Value value;
    std::string_view name;
    std::string_view summary;
};

std::span<const NamedValue<TexelLayout>> texel_layouts();
std::span<const NamedValue<TableAxes>> table_axes();
std::span<const NamedValue<RoughnessAxis>> roughness_axes();

/// The name of a value, as typed; `rows` is one of the lists above.
template <class Value>
std::string_view name_of(std::span<const NamedValue<Value>> rows, Value value) {
    for (const NamedValue<Value>& row : rows)
        if (row.value == value) return row.name;
    return rows.front().name;
}

/// The value with that name, if any.
template <class Value>
std::optional<Value> value_named(std::span<const NamedValue<Value>> rows, std::string_view name) {
    for (const NamedValue<Value>& row : rows)
        if (row.name == name) return row.value;
    return std::nullopt;
}

/// A table that a renderer looks up: which one, how exactly, where its texels sit. Pure data: equal
/// plans give equal bits.
struct TablePlan {
    /// Asks for the smallest power of two that meets `accuracy` between texels as well.
    static constexpr int automatic_size = 0;

    std::string kind = "ggx";           ///< a name from table_kinds()
    std::string method = "quadrature";  ///< a name from split_sum_methods()
    int size = 512;                     ///< texels along an edge, in [1, 8192], or automatic_size
    int samples = 1024;                 ///< points per texel; of the methods that sample
    /// The largest error that the stored table may have (max_abs), in [1e-7, 0.1]: at its texels,
    /// and between them too where the size is automatic. Without one, the quadrature is converged
    /// to default_table_accuracy and the format rounds as it does.
    std::optional<double> accuracy = std::nullopt;
    SmithTerm geometry = SmithTerm::height_correlated;
    TexelLayout layout = TexelLayout::centre;
    TableAxes axes = TableAxes::nv_roughness;
    RoughnessAxis roughness_axis = RoughnessAxis::perceptual;
    bool flip = false;  ///< rows from 1 down to 0 instead of from 0 up to 1
};

/// What a quadrature is converged to when nothing is asked for: about the rounding of floats near 1.
inline constexpr double default_table_accuracy = 1e-7;

/// The sizes that automatic_size chooses among: powers of two between these.
inline constexpr int smallest_automatic_size = 8;
inline constexpr int largest_automatic_size = 1024;

/// The error that the computation itself may make, so that rounding and, with an automatic size,
/// interpolation have room in `plan.accuracy`.
double quadrature_tolerance(const TablePlan& plan);

/// Fails with bad_argument: what was asked, and what would work. Whether kind and method exist is
/// told by find_table_kind.
Status validate(const TablePlan& plan);

}  // namespace splitsum
