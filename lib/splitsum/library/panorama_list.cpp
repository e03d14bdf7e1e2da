#include "splitsum/library/panorama_list.h"

#include <fnmatch.h>

#include <algorithm>
#include <array>
#include <utility>

#include "splitsum/base/text.h"

namespace splitsum {
namespace {

namespace fs = std::filesystem;

constexpr std::array endings = {"hdr", "exr", "pfm", "tif", "tiff", "rgbe"};

bool matches(const std::string& pattern, const fs::path& below) {
    const bool is_path = pattern.find('/') != std::string::npos;
    const std::string text = is_path ? below.generic_string() : below.filename().string();
    return fnmatch(pattern.c_str(), text.c_str(), 0) == 0;
}

bool has_panorama_ending(const fs::path& file) {
    const std::string name = file.filename().string();
    return std::ranges::any_of(endings, [&](const char* ending) {
        return fnmatch(cat("*.", ending).c_str(), name.c_str(), FNM_CASEFOLD) == 0;
    });
}

// Searches one folder after the other, and remembers which patterns were of use.
class Search {
public:
    explicit Search(const ListOptions& options)
        : options_(options), used_(options.include.size(), false) {}

    Result<std::vector<ListedPanorama>> list(const fs::path& root) {
        std::vector<ListedPanorama> found;
        root_ = root;
        if (Status searched = search({}, found); !searched) return searched.error();
        std::ranges::sort(found, {}, [](const auto& panorama) {
            return std::pair(panorama.name, panorama.file);
        });
        return found;
    }

    Status check_patterns() const {
        const auto unused = std::ranges::find(used_, false);
        if (unused == used_.end()) return ok;
        return Error{ErrorKind::bad_argument, cat("no file in the folders matches '",
                                                  options_.include[size_t(unused - used_.begin())],
                                                  "'; patterns are of shells: '*.hdr', 'dusk/*'")};
    }

private:
    bool is_excluded(const fs::path& below) const {
        return std::ranges::any_of(
            options_.exclude, [&](const std::string& pattern) { return matches(pattern, below); });
    }

    bool is_included(const fs::path& below) {
        if (options_.include.empty()) return has_panorama_ending(below);
        bool included = false;
        for (size_t i = 0; i < used_.size(); ++i)
            if (matches(options_.include[i], below)) used_[i] = included = true;
        return included;
    }

    // The output, or one of the folders that this one is in, reached through a link.
    bool is_closed(const fs::path& folder) const {
        std::error_code failure;
        const auto is_this = [&](const fs::path& other) {
            return fs::equivalent(folder, other, failure);
        };
        return (!options_.output.empty() && is_this(options_.output)) ||
               std::ranges::any_of(above_, is_this);
    }

    Status search(const fs::path& below, std::vector<ListedPanorama>& found) {
        const fs::path folder = below.empty() ? root_ : root_ / below;
        std::error_code failure;
        fs::directory_iterator entries(folder, failure);
        above_.push_back(folder);
        for (const fs::directory_iterator end; !failure && entries != end;
             entries.increment(failure))
            if (Status added = add(*entries, below / entries->path().filename(), found); !added)
                return added;
        above_.pop_back();
        if (!failure) return ok;
        return Error{ErrorKind::unreadable_input,
                     cat("cannot read the folder ", folder.string(), ": ", failure.message())};
    }

    Status add(const fs::directory_entry& entry, const fs::path& below,
               std::vector<ListedPanorama>& found) {
        std::error_code ignored;
        if (below.filename().string().starts_with('.') || is_excluded(below)) return ok;
        if (entry.is_directory(ignored))
            return is_closed(entry.path()) ? Status(ok) : search(below, found);
        // A link to nowhere is listed, so that its failure is told.
        const bool is_file = entry.is_regular_file(ignored) || !entry.exists(ignored);
        if (is_file && is_included(below))
            found.push_back({entry.path(), fs::path(below).replace_extension().generic_string()});
        return ok;
    }

    const ListOptions& options_;
    std::vector<bool> used_;  // of options_.include
    fs::path root_;
    std::vector<fs::path> above_;  // the folders being searched, outermost first
};

Status check_folder(const fs::path& folder, const ListOptions& options) {
    std::error_code failure;
    if (options.output.empty() || !fs::equivalent(folder, options.output, failure)) return ok;
    return Error{ErrorKind::bad_argument,
                 cat("the folder ", folder.string(),
                     " is the output as well; write the results into another folder")};
}

Error no_panoramas_in(const fs::path& folder, const ListOptions& options) {
    const std::string wanted =
        options.include.empty()
            ? join(endings, ", ", [](auto* ending) { return cat("*.", ending); })
            : join(options.include, ", ");
    return {ErrorKind::unusable_input,
            cat("the folder ", folder.string(), " holds no panorama (", wanted,
                options.exclude.empty() ? "" : ", less what is excluded", ")")};
}

}  // namespace

std::span<const char* const> panorama_endings() { return endings; }

Result<std::vector<ListedPanorama>> list_panoramas(const std::vector<fs::path>& inputs,
                                                   const ListOptions& options) {
    Search search(options);
    std::vector<ListedPanorama> panoramas;
    for (const fs::path& input : inputs) {
        std::error_code failure;
        if (!fs::is_directory(input, failure)) {
            panoramas.push_back({input, input.stem().string()});
            continue;
        }
        if (Status usable = check_folder(input, options); !usable) return usable.error();
        const auto found = search.list(input);
        if (!found) return found.error();
        if (found->empty()) return no_panoramas_in(input, options);
        panoramas.insert(panoramas.end(), found->begin(), found->end());
    }
    if (Status used = search.check_patterns(); !used) return used.error();
    return panoramas;
}

}  // namespace splitsum
