#include <algorithm>
#include <array>
#include <map>
#include <string_view>

#include "splitsum/base/text.h"
#include "splitsum/library/panorama_list.h"

namespace splitsum {
namespace {

namespace fs = std::filesystem;

// What bakes put into the folder of a name; what begins with a dot is kept by the rule for names.
constexpr std::array files_of_a_bake = {"specular.ktx2", "irradiance.ktx2", "harmonics.json",
                                        "contact.png",   "report.txt",      "report.json"};
constexpr const char* file_of_all = "brdf.ktx2";

std::string lower_case(std::string text) {
    for (char& c : text)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return text;
}

bool is_plain(const std::string& name) {
    size_t begin = 0;
    while (begin <= name.size()) {
        const size_t end = std::min(name.find('/', begin), name.size());
        const std::string_view part = std::string_view(name).substr(begin, end - begin);
        if (part.empty() || part == "." || part == "..") return false;
        // Hidden names below the first part may be our own bookkeeping.
        if (part.starts_with(".splitsum-") || (begin > 0 && part.starts_with('.'))) return false;
        begin = end + 1;
    }
    return name.find('\0') == std::string::npos;
}

Error cannot_be(const ListedPanorama& panorama, const std::string& why) {
    return {ErrorKind::bad_argument,
            cat(panorama.file.string(), " would be baked into '", panorama.name, "', ", why,
                "; rename it, or leave it out and bake it into another folder")};
}

Error same_folder(const ListedPanorama& a, const ListedPanorama& b) {
    std::error_code failure;
    if (a.name == b.name && fs::equivalent(a.file, b.file, failure))
        return {ErrorKind::bad_argument,
                cat(b.file.string(), " is given twice", a.file == b.file ? "" : ": once as ",
                    a.file == b.file ? "" : a.file.string())};
    return {ErrorKind::bad_argument,
            cat(a.file.string(), " and ", b.file.string(), " would both be baked into '", a.name,
                "'", a.name == b.name ? "" : " on disks that do not tell upper from lower case",
                "; bake them into folders of their own")};
}

using FirstWithName = std::map<std::string, const ListedPanorama*>;

// The panorama whose file would have to be a folder for this name: "a" for "a/report.json" and for
// "a/report.json/b".
const ListedPanorama* file_in_the_way(const std::string& name, const FirstWithName& names) {
    for (size_t slash = name.find('/'); slash != std::string::npos;
         slash = name.find('/', slash + 1)) {
        const auto owner = names.find(name.substr(0, slash));
        const size_t end = std::min(name.find('/', slash + 1), name.size());
        const std::string part = name.substr(slash + 1, end - slash - 1);
        if (owner != names.end() && std::ranges::count(files_of_a_bake, part)) return owner->second;
    }
    return nullptr;
}

}  // namespace

Status check_names(std::span<const ListedPanorama> panoramas) {
    FirstWithName names;
    for (const ListedPanorama& panorama : panoramas) {
        if (panorama.name.empty())
            return Error{ErrorKind::bad_argument,
                         cat("'", panorama.file.string(), "' is not the name of a file")};
        if (!is_plain(panorama.name))
            return cannot_be(panorama, "which is not a plain name of a folder");
        const auto [other, is_new] = names.emplace(lower_case(panorama.name), &panorama);
        if (!is_new) return same_folder(*other->second, panorama);
    }
    for (const ListedPanorama& panorama : panoramas) {
        const std::string name = lower_case(panorama.name);
        if (name.substr(0, name.find('/')) == file_of_all)
            return cannot_be(panorama, "where the table brdf.ktx2 is written");
        if (const ListedPanorama* other = file_in_the_way(name, names))
            return cannot_be(panorama, cat("where a result of ", other->file.string(), " lies"));
    }
    return ok;
}

}  // namespace splitsum
