// Compiled once for each instruction set of this machine's family; the plain functions at the end
// choose among them at run time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "splitsum/sphere/area_kernels.cpp"
#include "splitsum/sphere/area_kernels.h"

#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace splitsum {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using Lanes = hn::CappedTag<double, 4>;
using FloatLanes = hn::Rebind<float, Lanes>;
using Doubles = hn::Vec<Lanes>;

// The components of FourTurns, one after the other.
constexpr size_t components = 12;
static_assert(sizeof(FourTurns) == components * sizeof(double));
constexpr size_t lanes = hn::MaxLanes(Lanes());

HWY_INLINE const double* components_of(const FourTurns& turns) { return &turns[0].x; }
HWY_INLINE double* components_of(FourTurns& turns) { return &turns[0].x; }

HWY_INLINE void add_texels(const FourTurns& above, FourTurns& below,
                           const std::array<const float*, 4>& texels, double zone_height) {
    for (size_t turn = 0; turn < 4; ++turn) {
        const float* texel = texels[turn];
        below[turn] = above[turn] + zone_height * Vec3d(texel[0], texel[1], texel[2]);
    }
}

void AddRow(const FourTurns* above, FourTurns* below, size_t count,
            std::array<const float*, 4> texels, std::ptrdiff_t step, double zone_height) {
    const Lanes d;
    const Doubles zone = hn::Set(d, zone_height);
    for (size_t i = 0; i < count; ++i) {
        // Four numbers a texel are read and written; the fourth is put right by the next texel. At
        // the ends there may be none.
        if (i == 0 || i + 1 == count) {
            add_texels(above[i], below[i], texels, zone_height);
        } else {
            for (size_t turn = 0; turn < 4; ++turn)
                for (size_t c = 0; c < 4; c += lanes) {
                    const auto light = hn::PromoteTo(d, hn::LoadU(FloatLanes(), texels[turn] + c));
                    const size_t at = 3 * turn + c;
                    const Doubles sum =
                        hn::MulAdd(zone, light, hn::LoadU(d, components_of(above[i]) + at));
                    hn::StoreU(sum, d, components_of(below[i]) + at);
                }
        }
        for (const float*& texel : texels) texel += step;
    }
}

// The integral along a run.
struct RunIntegral {
    Doubles parts[components / lanes];

    HWY_INLINE void clear() {
        for (Doubles& part : parts) part = hn::Zero(Lanes());
    }

    // F lies between the sums above and below the row.
    HWY_INLINE void add(std::span<const AreaNode> nodes, int step, bool lower,
                        const FourTurns* above, const FourTurns* below) {
        const Lanes d;
        for (const AreaNode& node : nodes) {
            const double below_edge = node.below * (1 / AreaNode::whole_row);
            const Doubles fraction = hn::Set(d, lower ? 1 - below_edge : below_edge);
            const Doubles weight = hn::Set(d, node.weight);
            for (size_t i = 0; i < components / lanes; ++i) {
                const Doubles upper = hn::LoadU(d, components_of(*above) + i * lanes);
                const Doubles row = hn::Sub(hn::LoadU(d, components_of(*below) + i * lanes), upper);
                parts[i] = hn::MulAdd(weight, hn::MulAdd(fraction, row, upper), parts[i]);
            }
            above += step;
            below += step;
        }
    }

    // Each place of the edge receives what lies `quarter` quarter turns further on.
    HWY_INLINE void add_to(FourTurns& edge, uint32_t quarter) const {
        const Lanes d;
        double* out = components_of(edge);
        if (quarter == 0) {
            for (size_t i = 0; i < components; i += lanes)
                hn::StoreU(hn::Add(hn::LoadU(d, out + i), parts[i / lanes]), d, out + i);
            return;
        }
        double sum[components];
        for (size_t i = 0; i < components; i += lanes) hn::StoreU(parts[i / lanes], d, sum + i);
        const size_t turned = 3 * quarter;
        for (size_t i = turned; i < components; ++i) out[i - turned] += sum[i];
        for (size_t i = 0; i < turned; ++i) out[i + components - turned] += sum[i];
    }
};

uint32_t AddRuns(const AreaArc& arc, int column_step, uint32_t done, const AreaRows& rows,
                 FourTurns* edges) {
    const std::span runs(arc.runs);
    const std::span nodes(arc.nodes);
    for (; done < runs.size(); ++done) {
        const size_t i = rows.lower ? runs.size() - 1 - done : done;
        const AreaRun& run = runs[i];
        const int row =
            (rows.lower ? rows.height - 1 - int(run.row) : int(run.row)) - rows.first_row;
        if (row >= rows.row_count) break;
        const size_t first = i == 0 ? 0 : runs[i - 1].end;
        RunIntegral integral;
        integral.clear();
        integral.add(nodes.subspan(first, run.end - first), column_step, rows.lower,
                     rows.above[row] + run.column, rows.above[row + 1] + run.column);
        integral.add_to(edges[run.texel], run.quarter);
    }
    return done;
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace splitsum
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace splitsum {
namespace {

HWY_EXPORT(AddRow);
HWY_EXPORT(AddRuns);

}  // namespace

void add_row(const FourTurns* above, FourTurns* below, size_t count,
             std::array<const float*, 4> texels, std::ptrdiff_t step, double zone_height) {
    HWY_DYNAMIC_DISPATCH(AddRow)(above, below, count, texels, step, zone_height);
}

uint32_t add_runs(const AreaArc& arc, int column_step, uint32_t done, const AreaRows& rows,
                  FourTurns* edges) {
    return HWY_DYNAMIC_DISPATCH(AddRuns)(arc, column_step, done, rows, edges);
}

}  // namespace splitsum
#endif  // HWY_ONCE
