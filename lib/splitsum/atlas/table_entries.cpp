#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>

#include "splitsum/atlas/entries.h"
#include "splitsum/base/parallel.h"
#include "splitsum/base/text.h"
#include "splitsum/table/kinds.h"
#include "splitsum/table/self_check.h"
#include "splitsum/table/split_sum.h"
#include "splitsum/table/split_sum_exact.h"

namespace splitsum {
namespace {

const std::vector<double> views = {0, 1e-7, 1e-4, 1e-3, 0.01, 0.1, 0.3, 0.6, 1};
const std::vector<double> roughness = {0, 1e-4, 1e-3, 0.01, 0.02, 0.045, 0.1, 0.2, 0.5, 1};

// Sums over the grid of the lists above, row by row of roughness.
using Sums = std::vector<SplitSum>;

TableGrid grid() { return {views, roughness}; }

Sums exact_sums() {
    Sums sums(views.size() * roughness.size());
    parallel_rows(static_cast<int>(sums.size()), [&](int i) {
        const auto at = static_cast<size_t>(i);
        const double r = roughness[at / views.size()];
        sums[at] = split_sum_exact(SmithTerm::height_correlated, views[at % views.size()], r * r);
    });
    return sums;
}

// The figures of the entries i for which `counts(i)`, a and b as two channels.
template <class Counts>
AtlasCell judged(const Sums& sums, const Sums& exact, double accuracy, const Counts& counts) {
    std::vector<float> values, truth;
    double max_abs = 0;
    for (size_t i = 0; i < sums.size(); ++i) {
        if (!counts(i)) continue;
        for (const auto& [value, right] :
             {std::pair(sums[i].a, exact[i].a), {sums[i].b, exact[i].b}}) {
            values.push_back(static_cast<float>(value));
            truth.push_back(static_cast<float>(right));
            max_abs = std::isfinite(value) ? std::max(max_abs, std::abs(value - right)) : INFINITY;
        }
    }
    AtlasCell cell;
    cell.figures = error_figures(values, truth, 2);
    cell.figures->max_abs = max_abs;
    cell.text = cat("max_abs ", std::setprecision(2), max_abs);
    cell.verdict = max_abs <= accuracy     ? Verdict::meets
                   : max_abs <= near_limit ? Verdict::near
                                           : Verdict::fails;
    return cell;
}

// `cells(sums, exact)` makes the cells of a method's row.
template <class Cells>
Result<AtlasTable> table_of_methods(const AtlasPlan& plan, Progress& progress, const Cells& cells) {
    const Sums exact = exact_sums();
    AtlasTable table;
    for (const SplitSumMethod& method : split_sum_methods()) {
        TablePlan effort{.method = std::string(method.name), .samples = plan.samples};
        effort.accuracy = plan.accuracy;
        const Sums sums = method.bake(effort, grid(), progress);
        if (progress.cancelled()) return Error{ErrorKind::interrupted, "interrupted"};
        table.rows.push_back({std::string(method.name), cells(sums, exact)});
    }
    return table;
}

AtlasRow kind_row(const TableKind& kind, const AtlasPlan& plan, const Result<Table>& made,
                  const TablePlan& effort) {
    AtlasRow row{std::string(kind.name)};
    if (!made) {
        row.cells.assign(2, {.verdict = Verdict::fails, .text = made.error().message});
        return row;
    }
    const auto wrong =
        std::ranges::count_if(made->values, [](float value) { return !std::isfinite(value); });
    row.cells.push_back({.verdict = wrong == 0 ? Verdict::meets : Verdict::fails,
                         .text = cat(wrong, " of ", made->values.size())});
    const TableCheck check =
        check_table(kind, effort, arranged(*made, effort),
                    {.along_edge = 4, .texels = 4, .points = 0, .rim_points = 0});
    // Within this a fitted shape and a fitted formula are what they say to be; exact kinds meet more.
    constexpr double fitted = 0.05;
    row.cells.push_back({.verdict = check.at_texels <= plan.accuracy ? Verdict::meets
                                    : check.at_texels <= fitted      ? Verdict::near
                                                                     : Verdict::fails,
                         .text = cat("max_abs ", std::setprecision(2), check.at_texels)});
    return row;
}

}  // namespace

Result<AtlasEntry> grazing_entry(const AtlasPlan& plan, Progress& progress) {
    auto table = table_of_methods(plan, progress, [&](const Sums& sums, const Sums& exact) {
        std::vector<AtlasCell> cells;
        for (size_t view = 0; view < views.size(); ++view)
            cells.push_back(judged(sums, exact, plan.accuracy,
                                   [&](size_t i) { return i % views.size() == view; }));
        return cells;
    });
    if (!table) return table.error();
    for (const double view : views) table->columns.push_back(cat("n·v = ", view));
    return AtlasEntry{.id = "grazing",
                      .title = "Split sum at grazing views, worst of all roughness",
                      .problem = "Division by n·v; at n·v = 0 nothing is left to sample.",
                      .conduct = "Finite everywhere: half vectors that end at the horizon.",
                      .table = std::move(*table)};
}

Result<AtlasEntry> smooth_tables_entry(const AtlasPlan& plan, Progress& progress) {
    auto table = table_of_methods(plan, progress, [&](const Sums& sums, const Sums& exact) {
        std::vector<AtlasCell> cells;
        for (size_t row = 0; row < roughness.size(); ++row)
            cells.push_back(judged(sums, exact, plan.accuracy,
                                   [&](size_t i) { return i / views.size() == row; }));
        return cells;
    });
    if (!table) return table.error();
    for (const double r : roughness) table->columns.push_back(cat("r = ", r));
    return AtlasEntry{.id = "smooth-tables",
                      .title = "Split sum down to no roughness, worst of all views",
                      .problem = "Cancellation: a widely used baker loses 16 % below r = 0.01.",
                      .conduct = "r = 0 is Fresnel's term exactly; above it nothing cancels.",
                      .table = std::move(*table)};
}

Result<AtlasEntry> table_kinds_entry(const AtlasPlan& plan, Progress& progress) {
    AtlasEntry entry{
        .id = "table-kinds",
        .title = "Every kind of table, its corners and edges included",
        .problem = "Each kind has its own 0 / 0 where views graze or nothing is rough.",
        .conduct =
            "Finite everywhere, and measured at corners and edges. The fitted "
            "ltc tables and the formula ggx-fit are approximations by nature, near up to 0.05."};
    entry.table = {"table", {"not finite", "largest error at texels"}, {}};
    for (const TableKind& kind : table_kinds()) {
        TablePlan effort{.kind = std::string(kind.name), .size = 12};
        effort.layout = TexelLayout::edge;
        const auto made = kind.bake(effort, grid_of(effort, kind.view_axis), progress);
        if (progress.cancelled()) return Error{ErrorKind::interrupted, "interrupted"};
        entry.table.rows.push_back(kind_row(kind, plan, made, effort));
    }
    return entry;
}

}  // namespace splitsum
