#include "splitsum/preview/baked_files.h"

#include <algorithm>

#include "splitsum/base/text.h"
#include "splitsum/container/containers.h"
#include "splitsum/preview/look_up_table.h"
#include "splitsum/report/harmonics_file.h"
#include "splitsum/verify/check_levels.h"

namespace splitsum {
namespace {

namespace fs = std::filesystem;
using Kind = AssetFacts::Kind;

Error unusable(const fs::path& path, const std::string& what) {
    return {ErrorKind::unusable_input, cat(path.string(), " ", what)};
}

const char* name_of(Kind kind) {
    return kind == Kind::specular ? "a specular chain"
           : kind == Kind::table  ? "a table"
                                  : "irradiance";
}

struct ReadTexture {
    TextureAsset texture;
    AssetFacts facts;
};

Result<ReadTexture> read_kind(const fs::path& path, Kind wanted) {
    auto texture = read_texture(path);
    if (!texture) return texture.error();
    const auto facts = facts_of(texture->metadata);
    if (!facts)
        return unusable(path, cat("does not say what its texels mean (", facts.error().message,
                                  "); the .ktx2 and .exr files of splitsum do"));
    if (facts->kind != wanted)
        return unusable(path, cat("is ", name_of(facts->kind), ", not ", name_of(wanted)));
    return ReadTexture{std::move(*texture), *facts};
}

Result<std::vector<Cubemap>> levels_of(const fs::path& path, const TextureAsset& texture) {
    auto levels = cubemaps_of(texture);
    if (!levels) return unusable(path, cat("cannot be used: ", levels.error().message));
    return levels;
}

Status read_specular(const fs::path& path, BakedAssets& assets) {
    const auto read = read_kind(path, Kind::specular);
    if (!read) return read.error();
    auto levels = levels_of(path, read->texture);
    if (!levels) return levels.error();
    if (levels->size() != read->facts.perceptual_roughness.size())
        return unusable(path, cat("has ", levels->size(), " levels and names ",
                                  read->facts.perceptual_roughness.size(), " roughness values"));
    auto certificate = certificate_of(read->texture.metadata);
    if (!certificate) return unusable(path, certificate.error().message);
    assets.certificate = std::move(*certificate);
    assets.light.specular = std::move(*levels);
    assets.light.curve = read->facts.curve;
    assets.facts = read->facts;
    return ok;
}

struct Irradiance {
    Cubemap cubemap;
    AssetFacts facts;
};

Result<Irradiance> irradiance_of_series(const fs::path& path) {
    constexpr int face_size = 64;  // reading between such texels is evaluating the series
    const auto file = read_harmonics(path);
    if (!file) return file.error();
    return Irradiance{cubemap_of_harmonics(file->harmonics, face_size), file->facts};
}

Result<Irradiance> irradiance_of_cubemap(const fs::path& path) {
    const auto read = read_kind(path, Kind::irradiance);
    if (!read) return read.error();
    auto levels = levels_of(path, read->texture);
    if (!levels) return levels.error();
    Cubemap cubemap = std::move(levels->front());
    const auto per_stored = float(1 / stored_factor(read->facts));
    for (Vec3& texel : cubemap.texels) texel = per_stored * texel;
    return Irradiance{std::move(cubemap), read->facts};
}

bool same_light(const AssetFacts& a, const AssetFacts& b) {
    return a.source.hash == b.source.hash && a.source.exposure_stops == b.source.exposure_stops &&
           panorama_from_cube(a.orientation) == panorama_from_cube(b.orientation);
}

Status read_irradiance(const BakedFiles& files, BakedAssets& assets) {
    const bool is_series = files.irradiance.extension() == ".json";
    auto irradiance = is_series ? irradiance_of_series(files.irradiance)
                                : irradiance_of_cubemap(files.irradiance);
    if (!irradiance) return irradiance.error();
    assets.light.irradiance = std::move(irradiance->cubemap);
    if (!same_light(assets.facts, irradiance->facts))
        assets.notes.push_back(cat(files.irradiance.string(),
                                   " is of another panorama, exposure or orientation than ",
                                   files.specular.string()));
    return ok;
}

Status read_split_sum(const fs::path& path, BakedAssets& assets) {
    const auto read = read_kind(path, Kind::table);
    if (!read) return read.error();
    const auto table = table_of(read->texture);
    if (!table) return unusable(path, cat("cannot be used: ", table.error().message));
    auto split_sum = look_up_table(*table, read->facts.table.plan);
    if (!split_sum) return unusable(path, split_sum.error().message);
    assets.light.split_sum = std::move(*split_sum);
    const SmithTermInfo& geometry = info_of(read->facts.table.plan.geometry);
    if (geometry.term != TablePlan{}.geometry)
        assets.notes.push_back(cat(path.string(), " has the masking term ", geometry.name,
                                   "; exact integration takes ",
                                   info_of(TablePlan{}.geometry).name));
    return ok;
}

}  // namespace

BakedFiles files_of_bake(const fs::path& folder) {
    std::error_code ignored;
    fs::path place = (fs::absolute(folder, ignored) / "").lexically_normal().parent_path();
    fs::path table = place.parent_path() / "brdf.ktx2";
    for (int up = 0; up <= 4; ++up, place = place.parent_path())
        if (fs::exists(place / "brdf.ktx2", ignored)) {
            table = place / "brdf.ktx2";
            break;
        }
    return {folder / "specular.ktx2", folder / "irradiance.ktx2", table};
}

Result<BakedAssets> read_baked(const BakedFiles& files) {
    BakedAssets assets;
    if (const Status read = read_specular(files.specular, assets); !read) return read.error();
    if (const Status read = read_irradiance(files, assets); !read) return read.error();
    if (const Status read = read_split_sum(files.table, assets); !read) return read.error();
    return assets;
}

}  // namespace splitsum
