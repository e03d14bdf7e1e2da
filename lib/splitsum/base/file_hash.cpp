#include "splitsum/base/file_hash.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <vector>

#include "splitsum/base/content_hash.h"
#include "splitsum/base/text.h"

namespace splitsum {
namespace {

struct CloseFile {
    void operator()(std::FILE* file) const { std::fclose(file); }
};

}  // namespace

Result<std::string> hash_of_file(const std::filesystem::path& path) {
    const std::unique_ptr<std::FILE, CloseFile> file(std::fopen(path.c_str(), "rb"));
    if (!file)
        return Error{ErrorKind::unreadable_input,
                     cat("cannot read ", path.string(), ": ", std::strerror(errno))};

    ContentHash hash;
    std::vector<std::byte> buffer(1 << 20);
    while (const size_t count = std::fread(buffer.data(), 1, buffer.size(), file.get()))
        hash.add(std::span(buffer).first(count));
    if (std::ferror(file.get()))
        return Error{ErrorKind::unreadable_input,
                     cat("cannot read ", path.string(), ": ", std::strerror(errno))};
    return hash.digits();
}

}  // namespace splitsum
