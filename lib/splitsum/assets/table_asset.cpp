#include "splitsum/assets/table_asset.h"

#include <algorithm>
#include <cmath>

#include "splitsum/base/parallel.h"
#include "splitsum/math/low_discrepancy.h"
#include "splitsum/report/asset_facts.h"
#include "splitsum/table/split_sum.h"
#include "splitsum/table/split_sum_exact.h"

namespace splitsum {
namespace {

struct Texel {
    int x, y;
};

// The corners and edges, where tables fail, and Hammersley points inside.
std::vector<Texel> probe_texels(int size) {
    constexpr int along_edge = 9, inside = 64;
    std::vector<Texel> texels;
    for (int i = 0; i < along_edge; ++i) {
        const int at = (size - 1) * i / (along_edge - 1);
        for (const Texel texel :
             {Texel{at, 0}, Texel{at, size - 1}, Texel{0, at}, Texel{size - 1, at}})
            texels.push_back(texel);
    }
    for (int i = 0; i < inside; ++i) {
        const Vec2d point = hammersley(uint32_t(i), inside);
        texels.push_back({int(point.x * size), int(point.y * size)});
    }
    return texels;
}

double error_at(const Table& table, const Texel& texel, SmithTerm geometry) {
    const double n_dot_v = (texel.x + 0.5) / table.width;
    const double perceptual_roughness = (texel.y + 0.5) / table.height;
    const SplitSum exact =
        split_sum_exact(geometry, n_dot_v, perceptual_roughness * perceptual_roughness);
    const Vec2 stored = table.texels[size_t(texel.y) * size_t(table.width) + size_t(texel.x)];
    return std::max(std::abs(double(stored.x) - exact.a), std::abs(double(stored.y) - exact.b));
}

double worst_error(const Table& table, SmithTerm geometry, const std::vector<Texel>& texels) {
    std::vector<double> errors(texels.size());
    parallel_rows(int(texels.size()),
                  [&](int i) { errors[size_t(i)] = error_at(table, texels[size_t(i)], geometry); });
    return *std::ranges::max_element(errors);
}

}  // namespace

Result<TableAsset> bake_table(const TablePlan& plan, PixelFormat format, Progress& progress) {
    const auto table = split_sum_table(plan, progress);
    if (!table) return table.error();
    EncodeCounts counts;  // nothing in a table reaches the limits of a format
    TableAsset asset{texture_from_table(*table, format, counts)};
    AssetFacts facts;
    facts.kind = AssetFacts::Kind::split_sum;
    facts.table = plan;
    asset.texture.metadata = metadata_of(facts);

    const auto stored = table_of(asset.texture);
    if (!stored) return stored.error();
    const std::vector<Texel> probes = probe_texels(plan.size);
    asset.max_abs = worst_error(*stored, plan.geometry, probes);
    asset.probes = int(probes.size());
    return asset;
}

}  // namespace splitsum
