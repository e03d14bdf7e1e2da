#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

// Files and folders below an open folder. Names are single path components and links are never
// followed, so that nothing in a cache can lead out of it. Failures leave their reason in errno.
namespace splitsum {

/// An open file or folder, closed with the object; false if it could not be opened.
class Descriptor {
public:
    Descriptor() = default;
    explicit Descriptor(int descriptor) : descriptor_(descriptor) {}
    Descriptor(Descriptor&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}
    Descriptor& operator=(Descriptor&& other) noexcept {
        std::swap(descriptor_, other.descriptor_);
        return *this;
    }
    ~Descriptor();

    explicit operator bool() const { return descriptor_ >= 0; }
    int get() const { return descriptor_; }

private:
    int descriptor_ = -1;
};

/// The folder `name` in `parent`.
Descriptor open_folder(const Descriptor& parent, const std::string& name);

/// The same, made if it is missing.
Descriptor make_and_open_folder(const Descriptor& parent, const std::string& name);

/// The regular file `name` in `parent`, to read; pipes and devices are refused with EINVAL.
Descriptor open_file(const Descriptor& parent, const std::string& name);

/// A new file, to write and read back; refused with EEXIST where there is something of that name.
Descriptor create_file(const Descriptor& parent, const std::string& name);

/// The names in `folder` in no order, without "." and "..".
std::vector<std::string> names_in(const Descriptor& folder);

/// Whether `name` in `parent` is, at this moment, the file or folder that is open.
bool is_still(const Descriptor& parent, const std::string& name, const Descriptor& open);

/// Writes all of `text`; false with errno on failure.
bool write_all(const Descriptor& file, std::string_view text);

/// All of a file of at most `most` bytes; "" where it is longer or cannot be read. Of a file without
/// a length, as in /proc, the first `most` bytes.
std::string read_all(const Descriptor& file, size_t most);

}  // namespace splitsum
