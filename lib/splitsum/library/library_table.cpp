#include "splitsum/library/library_table.h"

#include "splitsum/assets/table_asset.h"
#include "splitsum/base/content_hash.h"
#include "splitsum/base/text.h"
#include "splitsum/base/version.h"
#include "splitsum/report/asset_facts.h"
#include "splitsum/report/certificate.h"

namespace splitsum {
namespace {

namespace fs = std::filesystem;

constexpr const char* recipe_key = "splitsum.recipe";
constexpr const char* hash_key = "splitsum.hash";

// Every field by name, so that a new one does not compile until it is here.
std::string recipe_of(const LibraryTable& table) {
    const auto& [kind, method, size, samples, accuracy, geometry, layout, axes, roughness_axis,
                 flip] = table.plan;
    const auto& [ktx2] = table.container;
    ContentHash hash;
    hash.add(cat("algorithm ", algorithm_version, "\nkind ", kind, "\nmethod ", method, "\nsize ",
                 size, "\nsamples ", samples, "\naccuracy ", accuracy.value_or(0), "\ngeometry ",
                 int(geometry), "\nlayout ", int(layout), "\naxes ", int(axes), "\nroughness axis ",
                 int(roughness_axis), "\nflip ", flip, "\nzstd ", ktx2.zstd ? ktx2.zstd_level : 0));
    return named_hash(hash.digits());
}

// Of everything that the file says but this hash.
std::string hash_of(TextureAsset texture) {
    texture.metadata.erase(hash_key);
    return certificate_hash(texture);
}

std::string text_under(const TextureAsset& texture, const char* key) {
    const auto entry = texture.metadata.find(key);
    return entry == texture.metadata.end() ? std::string() : entry->second;
}

// Why the table in that file is not to be used, "" if it is.
std::string objection(const Result<TextureAsset>& texture, const LibraryTable& table) {
    if (!texture) return cat("it cannot be read: ", texture.error().message);
    const std::string recipe = text_under(*texture, recipe_key);
    if (recipe.empty()) return "it does not say how it was baked";
    if (recipe != recipe_of(table)) return "it was baked with other options or another version";
    if (text_under(*texture, hash_key) != hash_of(*texture))
        return "its texels or keys are not those that were baked";
    return "";
}

}  // namespace

Status validate(const LibraryTable& table) {
    if (const Status valid = validate(table.plan); !valid) return valid;
    const auto kind = kind_of(table.plan);
    if (!kind) return kind.error();
    if (kind->is_closed_form())
        return Error{ErrorKind::bad_argument,
                     cat("'", kind->name, "' is a formula, no texture; splitsum-brdf writes it")};
    return ok;
}

TableResult find_library_table(const LibraryTable& table, const fs::path& folder) {
    TableResult result;
    result.file = folder / library_table_file;
    std::error_code failure;
    if (!fs::exists(result.file, failure)) {
        result.why = "there is none yet";
        return result;
    }
    const auto texture = read_texture(result.file);
    result.why = objection(texture, table);
    if (!result.why.empty()) return result;
    result.outcome = Outcome::up_to_date;
    if (const auto facts = facts_of(texture->metadata)) result.max_abs = facts->table.max_abs;
    return result;
}

Result<TableResult> bake_library_table(const LibraryTable& table, const fs::path& folder,
                                       Progress& progress) {
    if (const Status valid = validate(table); !valid) return valid.error();
    auto asset = bake_table(table.plan, default_format(*kind_of(table.plan)), progress);
    if (!asset) return asset.error();
    asset->texture.metadata[recipe_key] = recipe_of(table);
    asset->texture.metadata[hash_key] = hash_of(asset->texture);
    const fs::path file = folder / library_table_file;
    if (const Status written = write_texture(asset->texture, file, table.container); !written)
        return written.error();
    std::error_code failure;
    return TableResult{Outcome::baked, "", file, int64_t(fs::file_size(file, failure)),
                       asset->check.at_texels};
}

}  // namespace splitsum
