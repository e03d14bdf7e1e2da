#include "splitsum/cache/cache_folder_detail.h"

#include <fcntl.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <string>

#include "splitsum/base/atomic_file.h"
#include "splitsum/base/temporary.h"
#include "splitsum/base/text.h"

namespace splitsum {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view tag_name = "CACHEDIR.TAG";
constexpr std::string_view signature = "Signature: 8a477f597d28d172789f06886806bc55\n";
constexpr std::string_view line = "# splitsum content cache, version ";
constexpr std::string_view version_of_layout = "1\n";
constexpr std::string_view explanation =
    "# Baked results that can be made again. Removing this folder loses nothing but time.\n";

enum class Tag { missing, foreign, other_version, ours };

Tag tag_in(const Descriptor& root) {
    const Descriptor file = open_file(root, std::string(tag_name));
    if (!file) return errno == ENOENT ? Tag::missing : Tag::foreign;
    const std::string text = read_all(file, 4096);
    const std::string expected = cat(signature, line);
    if (!text.starts_with(expected)) return Tag::foreign;
    return std::string_view(text).substr(expected.size()).starts_with(version_of_layout)
               ? Tag::ours
               : Tag::other_version;
}

// Another process may be about to make the same cache.
bool is_empty(const Descriptor& root) {
    return std::ranges::all_of(names_in(root), is_temporary_name);
}

Error refusal(const fs::path& folder, Tag tag) {
    return {ErrorKind::bad_argument,
            cat("cannot use ", folder.string(), " as a cache: ",
                tag == Tag::other_version ? "another version of this program made it"
                                          : "it has files of other kinds in it",
                "; an empty folder or a new one would do")};
}

}  // namespace

Result<Descriptor> open_cache_folder(const fs::path& folder) {
    if (const Status made = make_folder(folder); !made) return made.error();
    Descriptor root(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (!root)
        return Error{ErrorKind::unwritable_output,
                     cat("cannot open the cache ", folder.string(), ": ", std::strerror(errno))};
    Tag tag = tag_in(root);
    if (tag == Tag::missing && is_empty(root)) {
        const std::string text = cat(signature, line, version_of_layout, explanation);
        if (const Status written = write_text_whole(folder / tag_name, text); !written)
            return written.error();
        tag = Tag::ours;
    } else if (tag == Tag::missing) {
        tag = tag_in(root);  // made between the two looks, and in use by now
    }
    if (tag != Tag::ours) return refusal(folder, tag);
    return root;
}

}  // namespace splitsum
