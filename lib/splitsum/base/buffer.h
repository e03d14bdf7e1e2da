#pragma once

#include <cstddef>
#include <memory>

namespace splitsum {

/// An array that is not filled when it is made: whoever computes the values touches the memory
/// first, on all threads instead of one. Every value must be written before it is read.
template <class T>
class Buffer {
public:
    explicit Buffer(size_t size) : values_(std::make_unique_for_overwrite<T[]>(size)) {}

    T* data() { return values_.get(); }
    const T* data() const { return values_.get(); }

private:
    std::unique_ptr<T[]> values_;
};

}  // namespace splitsum
