#pragma once

#include <OpenEXR/ImfIO.h>

#include <cstddef>
#include <span>
#include <vector>

namespace splitsum::exr {

/// What OpenEXR writes, in memory. Files are written from here, because OpenEXR's file writers
/// finish the file in a destructor that keeps a full disk to itself.
class MemoryOutput final : public Imf::OStream {
public:
    MemoryOutput() : Imf::OStream("memory") {}

    void write(const char data[], int count) override;
    uint64_t tellp() override { return position_; }
    void seekp(uint64_t position) override { position_ = position; }

    std::vector<std::byte> take() { return std::move(bytes_); }

private:
    std::vector<std::byte> bytes_;
    uint64_t position_ = 0;
};

/// Bytes in memory as OpenEXR reads a file. Reading past the end throws, as OpenEXR expects.
class MemoryInput final : public Imf::IStream {
public:
    explicit MemoryInput(std::span<const std::byte> bytes)
        : Imf::IStream("memory"), bytes_(bytes) {}

    bool read(char data[], int count) override;
    uint64_t tellg() override { return position_; }
    void seekg(uint64_t position) override { position_ = position; }

private:
    std::span<const std::byte> bytes_;
    uint64_t position_ = 0;
};

}  // namespace splitsum::exr
