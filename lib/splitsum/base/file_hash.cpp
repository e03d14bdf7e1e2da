#include "splitsum/base/file_hash.h"

#include <xxhash.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <vector>

#include "splitsum/base/text.h"

namespace splitsum {
namespace {

struct CloseFile {
    void operator()(std::FILE* file) const { std::fclose(file); }
};

struct FreeState {
    void operator()(XXH3_state_t* state) const { XXH3_freeState(state); }
};

}  // namespace

Result<std::string> hash_of_file(const std::filesystem::path& path) {
    const std::unique_ptr<std::FILE, CloseFile> file(std::fopen(path.c_str(), "rb"));
    if (!file)
        return Error{ErrorKind::unreadable_input,
                     cat("cannot read ", path.string(), ": ", std::strerror(errno))};

    const std::unique_ptr<XXH3_state_t, FreeState> state(XXH3_createState());
    XXH3_128bits_reset(state.get());
    std::vector<char> buffer(1 << 20);
    while (const size_t count = std::fread(buffer.data(), 1, buffer.size(), file.get()))
        XXH3_128bits_update(state.get(), buffer.data(), count);
    if (std::ferror(file.get()))
        return Error{ErrorKind::unreadable_input,
                     cat("cannot read ", path.string(), ": ", std::strerror(errno))};

    XXH128_canonical_t bytes;
    XXH128_canonicalFromHash(&bytes, XXH3_128bits_digest(state.get()));
    std::string digits;
    for (const unsigned char byte : bytes.digest) {
        digits += "0123456789abcdef"[byte >> 4];
        digits += "0123456789abcdef"[byte & 15];
    }
    return digits;
}

}  // namespace splitsum
