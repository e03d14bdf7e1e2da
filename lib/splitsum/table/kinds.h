#pragma once

#include <span>
#include <string_view>

#include "splitsum/base/progress.h"
#include "splitsum/base/result.h"
#include "splitsum/image/table.h"
#include "splitsum/plan/table_plan.h"
#include "splitsum/table/grid.h"

namespace splitsum {

/// What a table is like where nobody asks for something else: what the engines that read it expect.
struct TableDefaults {
    int size = 512;
    TexelLayout layout = TexelLayout::centre;
    TableAxes axes = TableAxes::nv_roughness;
};

/// One kind of table: what a lookup returns, how it is computed, and how one lookup is judged. A
/// kind joins by one row; --help, files, self-checks, previews and tests find it there.
struct TableKind {
    std::string_view name;     ///< as typed after --table
    std::string_view summary;  ///< one line for --help
    std::string_view value;    ///< what a lookup returns, written into the file: "albedo = ..."
    /// What each channel holds, layer by layer; `layers` times as many as a texel has channels, at
    /// most 4 a layer. Identifiers: they name the channels in generated source.
    std::span<const std::string_view> channel_names;
    int layers = 1;
    ViewAxis view_axis = ViewAxis::cosine;
    bool has_geometry = true;  ///< whether TablePlan::geometry matters
    bool has_methods = true;   ///< whether it can be computed by every split_sum_methods()
    int probes = 128;          ///< points a self-check judges; fewer where judging one is slow
    TableDefaults defaults = {};
    bool wants_floats = false;  ///< whether half floats are too coarse for what a renderer computes

    int channels() const { return static_cast<int>(channel_names.size()) / layers; }

    /// The canonical table (see grid.h) over `grid`, for a valid plan of this kind. Reports its own
    /// steps. The same bits for every number of threads. Fails with bad_argument or interrupted.
    Result<Table> (*bake)(const TablePlan& plan, const TableGrid& grid, Progress& progress);

    /// The largest error of what a renderer read at one point (`read` holds all channels of all
    /// layers), against a computation that shares nothing with `bake`: max |read - exact|, or for
    /// channels without a unique right value the error of the figure that they stand for, absolute
    /// where values are of order 1. `n_dot_v` and `perceptual_roughness` in [0, 1].
    double (*error_of)(const TablePlan& plan, double n_dot_v, double perceptual_roughness,
                       std::span<const double> read);

    /// Of a formula, which is written as source and never as a texture: its value at a point into
    /// `read`. Nothing for tables.
    void (*evaluate)(const TablePlan& plan, double n_dot_v, double perceptual_roughness,
                     std::span<double> read) = nullptr;

    bool is_closed_form() const { return evaluate != nullptr; }
};

/// Every kind; the first is the default.
std::span<const TableKind> table_kinds();

/// The plan of a kind where nothing else is asked for.
TablePlan default_plan(const TableKind& kind);

/// The kind of a plan, which must exist and offer the plan's method. Fails with bad_argument, naming
/// what there is.
Result<TableKind> kind_of(const TablePlan& plan);

}  // namespace splitsum
