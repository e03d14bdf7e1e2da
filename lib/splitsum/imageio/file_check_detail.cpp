#include "splitsum/imageio/file_check_detail.h"

#include <array>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include "splitsum/base/text.h"

namespace splitsum {
namespace {

namespace fs = std::filesystem;

Error unreadable(const fs::path& path, const std::string& reason) {
    return {ErrorKind::unreadable_input, cat("cannot read ", path.string(), ": ", reason)};
}

/// Reads numbers of a TIFF file (TIFF 6.0, section 2; BigTIFF has 8-byte offsets and counts).
class TiffBytes {
public:
    explicit TiffBytes(std::ifstream& file) : file_(file) {
        const auto mark = bytes(0, 4);
        if (!mark) return;
        const std::string text(mark->begin(), mark->begin() + 4);
        is_tiff_ = text == std::string("II*\0", 4) || text == std::string("MM\0*", 4) ||
                   text == std::string("II+\0", 4) || text == std::string("MM\0+", 4);
        little_endian_ = text[0] == 'I';
        big_ = text.find('+') != std::string::npos;
    }

    bool is_tiff() const { return is_tiff_; }
    bool big() const { return big_; }

    std::optional<uint64_t> number(uint64_t position, int size) {
        const auto data = bytes(position, size);
        if (!data) return std::nullopt;
        uint64_t value = 0;
        for (int i = 0; i < size; ++i)
            value = value << 8 | (*data)[static_cast<size_t>(little_endian_ ? size - 1 - i : i)];
        return value;
    }

private:
    std::optional<std::array<unsigned char, 8>> bytes(uint64_t position, int size) {
        std::array<unsigned char, 8> data{};
        file_.clear();
        file_.seekg(static_cast<std::streamoff>(position));
        if (!file_.read(reinterpret_cast<char*>(data.data()), size)) return std::nullopt;
        return data;
    }

    std::ifstream& file_;
    bool is_tiff_ = false;
    bool little_endian_ = true;
    bool big_ = false;
};

/// An entry of a TIFF directory: `count` numbers of `number_size` bytes at `position`.
struct TiffArray {
    uint64_t position = 0;
    uint64_t count = 0;
    int number_size = 0;
};

/// One of the two arrays that say where the pixels of the first image are, by either tag.
std::optional<TiffArray> find_array(TiffBytes& tiff, uint64_t tag_of_strips,
                                    uint64_t tag_of_tiles) {
    const int offset_size = tiff.big() ? 8 : 4;
    const int entry_size = tiff.big() ? 20 : 12;
    const auto directory = tiff.number(tiff.big() ? 8 : 4, offset_size);
    if (!directory) return std::nullopt;
    const int count_size = tiff.big() ? 8 : 2;
    const auto entries = tiff.number(*directory, count_size);
    for (uint64_t i = 0; entries && i < *entries; ++i) {
        const uint64_t entry = *directory + count_size + i * entry_size;
        const auto tag = tiff.number(entry, 2);
        if (!tag) return std::nullopt;
        if (*tag != tag_of_strips && *tag != tag_of_tiles) continue;
        const auto type = tiff.number(entry + 2, 2);
        const auto count = tiff.number(entry + 4, offset_size);
        if (!type || !count) return std::nullopt;
        TiffArray array;
        array.count = *count;
        array.number_size = *type == 3 ? 2 : *type == 16 ? 8 : 4;  // SHORT, LONG8, LONG
        array.position = entry + 4 + offset_size;
        if (array.count > static_cast<uint64_t>(offset_size / array.number_size)) {
            const auto elsewhere = tiff.number(array.position, offset_size);
            if (!elsewhere) return std::nullopt;
            array.position = *elsewhere;
        }
        return array;
    }
    return std::nullopt;
}

/// True when a strip or tile of the first image lies outside a file of `file_size` bytes.
bool tiff_is_cut_short(TiffBytes& tiff, uint64_t file_size) {
    const auto offsets = find_array(tiff, 273, 324);
    const auto sizes = find_array(tiff, 279, 325);
    if (!offsets || !sizes || offsets->count != sizes->count) return true;
    for (uint64_t i = 0; i < offsets->count; ++i) {
        const auto offset =
            tiff.number(offsets->position + i * offsets->number_size, offsets->number_size);
        const auto size = tiff.number(sizes->position + i * sizes->number_size, sizes->number_size);
        if (!offset || !size || *offset > file_size || *size > file_size - *offset) return true;
    }
    return false;
}

}  // namespace

Status check_file(const fs::path& path) {
    std::error_code failure;
    const fs::file_status status = fs::status(path, failure);
    if (status.type() == fs::file_type::not_found) return unreadable(path, "no such file");
    if (!fs::exists(status)) return unreadable(path, failure.message());
    if (fs::is_directory(status)) return unreadable(path, "it is a folder, not an image file");
    if (!fs::is_regular_file(status)) return unreadable(path, "it is not a regular file");
    const uint64_t file_size = fs::file_size(path, failure);
    if (!failure && file_size == 0) return unreadable(path, "the file is empty");

    errno = 0;
    std::ifstream file(path, std::ios::binary);
    if (failure || !file)
        return unreadable(path, errno != 0 ? std::strerror(errno) : failure.message());
    TiffBytes tiff(file);
    if (tiff.is_tiff() && tiff_is_cut_short(tiff, file_size))
        return unreadable(path, "the file ends before its pixels do");
    return ok;
}

}  // namespace splitsum
