#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace splitsum {

/// The XXH3-128 hash of bytes that come piece by piece. Not cryptographic. Cost: about 10 GB/s.
class ContentHash {
public:
    ContentHash();
    ~ContentHash();
    ContentHash(const ContentHash&) = delete;
    ContentHash& operator=(const ContentHash&) = delete;

    void add(std::span<const std::byte> bytes);
    void add(std::string_view text);

    /// Of all bytes so far as 32 hexadecimal digits, as `xxhsum -H2` prints it.
    std::string digits() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

/// A hash as files and reports name it: "xxh3-128:" and its digits.
inline std::string named_hash(const std::string& digits) { return "xxh3-128:" + digits; }

}  // namespace splitsum
