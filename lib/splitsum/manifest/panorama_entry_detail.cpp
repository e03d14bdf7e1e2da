#include "splitsum/manifest/panorama_entry_detail.h"

#include <algorithm>
#include <array>
#include <unordered_map>

#include "splitsum/base/text.h"

namespace splitsum {
namespace {

using Kind = ManifestValue::Kind;

// What is wrong with a name of a folder below the output folder; "" if nothing is.
std::string problem_of_name(const std::string& name) {
    const auto refused = [&](const char* reason) {
        return cat("name: ", in_quotes(name), " ", reason,
                   "; it names a folder below the output folder, such as \"dusk/red\"");
    };
    if (name.find('\\') != std::string::npos) return refused("has a \\ where / parts folders");
    if (name.starts_with('/')) return refused("is absolute");
    for (size_t begin = 0; begin <= name.size();) {
        const size_t end = std::min(name.find('/', begin), name.size());
        const std::string part = name.substr(begin, end - begin);
        if (part.empty()) return refused("has an empty part");
        if (part == "..") return refused("leads out of it");
        if (part.starts_with('.')) return refused("has a part that begins with a dot");
        begin = end + 1;
    }
    return "";
}

// Text, or a list of texts, as patterns.
std::optional<std::vector<std::string>> patterns_of(const ManifestValue& value) {
    const auto usable = [](const ManifestValue& v) {
        return v.kind == Kind::text && !v.text.empty();
    };
    if (usable(value)) return std::vector<std::string>{value.text};
    if (value.kind != Kind::list || !std::ranges::all_of(value.items, usable)) return std::nullopt;
    std::vector<std::string> patterns;
    for (const ManifestValue& item : value.items) patterns.push_back(item.text);
    return patterns;
}

// Reads the members of one table.
class EntryReader {
public:
    EntryReader(ManifestPanorama& panorama, const SettingReader& settings, Problems& problems)
        : panorama_(panorama), settings_(settings), problems_(problems) {}

    void read(const ManifestValue& member) {
        if (member.key == "file")
            read_file(member);
        else if (member.key == "name")
            read_name(member);
        else if (member.key == "only")
            read_patterns(member, panorama_.only);
        else if (member.key == "except")
            read_patterns(member, panorama_.except);
        else
            settings_.read(member, SettingReader::Table::panorama, panorama_.settings);
    }

    void read_file(const ManifestValue& value) {
        if (value.kind != Kind::text || value.text.empty())
            return add(value, cat("file: found ", description_of(value),
                                  "; it takes the name of a panorama or a folder, in quotes"));
        panorama_.file = (panorama_.manifest.parent_path() / value.text).lexically_normal();
    }

private:
    void read_name(const ManifestValue& value) {
        if (value.kind != Kind::text || value.text.empty())
            return add(value, cat("name: found ", description_of(value),
                                  "; it takes text in quotes, such as \"dusk/red\""));
        if (const std::string problem = problem_of_name(value.text); !problem.empty())
            return add(value, problem);
        panorama_.name = value.text;
    }

    void read_patterns(const ManifestValue& value, std::vector<std::string>& patterns) {
        const auto found = patterns_of(value);
        if (!found)
            return add(value, cat(value.key, ": found ", description_of(value),
                                  "; it takes patterns in quotes, such as [\"*.exr\"]"));
        patterns = *found;
    }

    void add(const ManifestValue& value, const std::string& text) {
        problems_.add(panorama_.manifest, value.line, text);
    }

    ManifestPanorama& panorama_;
    const SettingReader& settings_;
    Problems& problems_;
};

// Where the results of a file go.
std::string name_of(const ManifestPanorama& panorama) {
    return panorama.name ? *panorama.name : panorama.file.stem().string();
}

std::string clash(const ManifestPanorama& first, const std::string& name) {
    return cat("the results would be written over those of ", place_of(first),
               ", as both are named ", in_quotes(name),
               "; give one of them another name, such as name = \"other/", name, "\"");
}

}  // namespace

std::span<const std::string> panorama_keys() {
    static const std::array<std::string, 4> keys = {"file", "name", "only", "except"};
    return keys;
}

std::optional<ManifestPanorama> panorama_of(const ManifestValue& entry,
                                            const std::filesystem::path& file,
                                            const SettingReader& settings, Problems& problems) {
    ManifestPanorama panorama;
    panorama.manifest = file;
    panorama.line = entry.line;
    EntryReader reader(panorama, settings, problems);
    if (entry.kind == Kind::text) {
        reader.read_file(entry);
    } else if (entry.kind == Kind::table) {
        for (const ManifestValue& member : entry.items) reader.read(member);
        if (std::ranges::find(entry.items, "file", &ManifestValue::key) == entry.items.end())
            problems.add(file, entry.line, "this panorama has no file; add file = \"sky.exr\"");
    } else {
        problems.add(
            file, entry.line,
            cat("found ", description_of(entry),
                " where a panorama should be: a table with a file, or its name in quotes"));
    }
    if (panorama.file.empty()) return std::nullopt;
    return panorama;
}

void check_distinct(std::span<const ManifestPanorama> panoramas, Problems& problems) {
    std::unordered_map<std::string, const ManifestPanorama*> first_of_name;
    for (const ManifestPanorama& panorama : panoramas) {
        std::error_code ignored;
        if (std::filesystem::is_directory(panorama.file, ignored)) continue;
        const std::string name = name_of(panorama);
        const auto [other, is_new] = first_of_name.emplace(name, &panorama);
        if (!is_new) problems.add(panorama.manifest, panorama.line, clash(*other->second, name));
    }
}

}  // namespace splitsum
