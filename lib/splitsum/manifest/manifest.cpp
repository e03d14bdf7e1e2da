#include "splitsum/manifest/manifest.h"

#include <algorithm>
#include <array>
#include <map>

#include "splitsum/base/text.h"
#include "splitsum/manifest/notations_detail.h"
#include "splitsum/manifest/panorama_entry_detail.h"
#include "splitsum/manifest/settings_detail.h"

namespace splitsum {
namespace {

namespace fs = std::filesystem;
using Kind = ManifestValue::Kind;

// Manifests in manifests beyond this are a mistake, or an attempt to exhaust the stack.
constexpr size_t deepest_include = 32;

const std::array<std::string, 3>& top_keys() {
    static const std::array<std::string, 3> keys = {"include", "defaults", "panoramas"};
    return keys;
}

const ManifestValue* member_of(const ManifestValue& table, const std::string& key) {
    const auto member = std::ranges::find(table.items, key, &ManifestValue::key);
    return member == table.items.end() ? nullptr : &*member;
}

// One file as symbolic links and .. may name it, if it exists.
fs::path identity_of(const fs::path& file) {
    std::error_code failure;
    const fs::path canonical = fs::canonical(file, failure);
    return failure ? file : canonical;
}

// The place of an include, "bake.toml:1"; the manifest that was asked for has none.
struct IncludedAt {
    fs::path file;
    int line = 0;
    std::string text() const { return cat(file.string(), ":", line); }
};

// Reads a manifest and what it includes, depth first.
class Reader {
public:
    explicit Reader(std::span<const KnownOption> options) : options_(options) {}

    Result<Manifest> read(const fs::path& file) {
        read_file(file, {}, {});
        check_distinct(manifest_.panoramas, problems_);
        if (!problems_.empty()) return problems_.error();
        return std::move(manifest_);
    }

private:
    void read_file(const fs::path& file, const IncludedAt& from,
                   const std::vector<Setting>& defaults_beneath);
    bool may_open(const fs::path& file, const IncludedAt& from);
    std::optional<ManifestValue> parse(const fs::path& file, const IncludedAt& from);
    void check_keys(const fs::path& file, const ManifestValue& root);
    std::vector<Setting> read_defaults(const fs::path& file, const ManifestValue& root,
                                       const SettingReader& reader);
    void read_includes(const fs::path& file, const ManifestValue& root,
                       const std::vector<Setting>& defaults);
    void read_panoramas(const fs::path& file, const ManifestValue& root,
                        const SettingReader& reader, const std::vector<Setting>& defaults);
    bool is_first(const fs::path& file) const { return file == manifest_.files.front(); }

    std::span<const KnownOption> options_;
    Problems problems_;
    Manifest manifest_;
    std::map<fs::path, IncludedAt> included_at_;  // of every file that was opened, by identity
    std::vector<fs::path> open_;                  // from the first manifest down to this one
};

// Whether it is neither open, nor was read before, nor in too long a chain.
bool Reader::may_open(const fs::path& file, const IncludedAt& from) {
    const fs::path identity = identity_of(file);
    const auto same = [&](const fs::path& other) { return identity_of(other) == identity; };
    if (const auto above = std::ranges::find_if(open_, same); above != open_.end()) {
        std::vector<fs::path> circle(above, open_.end());
        circle.push_back(file);
        problems_.add(from.file, from.line,
                      cat("manifests include each other in a circle: ",
                          join(circle, " -> ", [](const fs::path& p) { return p.string(); }),
                          "; leave one of these includes out"));
        return false;
    }
    const auto [other, is_new] = included_at_.emplace(identity, from);
    if (!is_new) {
        problems_.add(from.file, from.line,
                      cat(file.string(), " is included already, at ", other->second.text(),
                          "; once is enough"));
        return false;
    }
    if (open_.size() < deepest_include) return true;
    problems_.add(from.file, from.line,
                  cat("more than ", deepest_include,
                      " manifests include one another; list the "
                      "panoramas in fewer"));
    return false;
}

std::optional<ManifestValue> Reader::parse(const fs::path& file, const IncludedAt& from) {
    const std::string ending = file.extension().string();
    if (ending != ".toml" && ending != ".json") {
        problems_.add(from.line > 0 ? from.file : file, from.line,
                      cat(from.line > 0 ? file.string() + " " : "",
                          "is no manifest by its name; that ends in .toml or .json"));
        return std::nullopt;
    }
    const SourceText source = read_source(file);
    if (source.problem) {
        // What is wrong with a file as a whole is told where it was asked for.
        if (source.problem->line == 0 && from.line > 0)
            problems_.add_unreadable(from.file, from.line,
                                     cat(file.string(), " ", source.problem->text));
        else
            problems_.add_unreadable(file, source.problem->line, source.problem->text);
        return std::nullopt;
    }
    ParsedText parsed = ending == ".json" ? parse_json(source.text) : parse_toml(source.text);
    if (parsed.problem) {
        problems_.add_unreadable(file, parsed.problem->line, parsed.problem->text);
        return std::nullopt;
    }
    return std::move(parsed.root);
}

void Reader::read_file(const fs::path& file, const IncludedAt& from,
                       const std::vector<Setting>& defaults_beneath) {
    if (!may_open(file, from)) return;
    manifest_.files.push_back(file);
    const auto root = parse(file, from);
    if (!root) return;
    const SettingReader reader(options_, panorama_keys(), file, problems_);
    open_.push_back(file);
    const size_t panoramas_before = manifest_.panoramas.size();
    check_keys(file, *root);
    const auto defaults = overlaid(read_defaults(file, *root, reader), defaults_beneath);
    read_includes(file, *root, defaults);
    read_panoramas(file, *root, reader, defaults);
    if (problems_.empty() && manifest_.panoramas.size() == panoramas_before)
        problems_.add(file, 1,
                      "names no panorama; add some: panoramas = [\"sky.exr\"] (defaults hold for "
                      "the panoramas of their own manifest and of those that it includes)");
    open_.pop_back();
}

void Reader::check_keys(const fs::path& file, const ManifestValue& root) {
    for (const ManifestValue& member : root.items) {
        if (std::ranges::find(top_keys(), member.key) != top_keys().end()) continue;
        const bool is_option =
            std::ranges::find(options_, member.key, &KnownOption::name) != options_.end();
        problems_.add(file, member.line,
                      is_option ? cat(member.key,
                                      " is a setting; it belongs into the defaults or "
                                      "to a panorama")
                                : no_such_key(member.key, top_keys()));
    }
}

// Its defaults for panoramas; those of the run go to the manifest.
std::vector<Setting> Reader::read_defaults(const fs::path& file, const ManifestValue& root,
                                           const SettingReader& reader) {
    const ManifestValue* defaults = member_of(root, "defaults");
    if (!defaults) return {};
    if (defaults->kind != Kind::table) {
        problems_.add(
            file, defaults->line,
            cat("defaults: found ", description_of(*defaults), "; it is a table of settings"));
        return {};
    }
    std::vector<Setting> all;
    for (const ManifestValue& member : defaults->items)
        reader.read(member, SettingReader::Table::defaults, all);
    std::vector<Setting> of_panoramas;
    for (Setting& setting : all) {
        if (!reader.is_for_run(setting))
            of_panoramas.push_back(std::move(setting));
        else if (is_first(file))
            manifest_.run.push_back(std::move(setting));
        else
            problems_.add(file, setting.line,
                          cat(setting.option, " holds for the whole run, and ",
                              open_.front().string(), " includes this manifest; move it there"));
    }
    return of_panoramas;
}

void Reader::read_includes(const fs::path& file, const ManifestValue& root,
                           const std::vector<Setting>& defaults) {
    const ManifestValue* include = member_of(root, "include");
    if (!include) return;
    if (include->kind != Kind::list) {
        problems_.add(file, include->line,
                      cat("include: found ", description_of(*include),
                          "; it is a list of manifests such as [\"studio.toml\"]"));
        return;
    }
    for (const ManifestValue& item : include->items) {
        if (item.kind == Kind::text && !item.text.empty())
            read_file((file.parent_path() / item.text).lexically_normal(), {file, item.line},
                      defaults);
        else
            problems_.add(file, item.line,
                          cat("include: found ", description_of(item),
                              "; it takes names of manifests, in quotes"));
    }
}

void Reader::read_panoramas(const fs::path& file, const ManifestValue& root,
                            const SettingReader& reader, const std::vector<Setting>& defaults) {
    const ManifestValue* panoramas = member_of(root, "panoramas");
    if (!panoramas) return;
    if (panoramas->kind != Kind::list) {
        problems_.add(file, panoramas->line,
                      cat("panoramas: found ", description_of(*panoramas),
                          "; it is a list: [[panoramas]] in TOML, [{\"file\": ...}] in JSON"));
        return;
    }
    for (const ManifestValue& entry : panoramas->items) {
        auto panorama = panorama_of(entry, file, reader, problems_);
        if (!panorama) continue;
        panorama->settings = overlaid(panorama->settings, defaults);
        manifest_.panoramas.push_back(std::move(*panorama));
    }
}

}  // namespace

std::string place_of(const ManifestPanorama& panorama) {
    return cat(panorama.manifest.string(), ":", panorama.line);
}

Result<Manifest> read_manifest(const fs::path& path, std::span<const KnownOption> options) {
    return Reader(options).read(path.lexically_normal());
}

}  // namespace splitsum
