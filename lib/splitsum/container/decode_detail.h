#pragma once

#include <cstddef>
#include <span>

#include "splitsum/base/result.h"
#include "splitsum/base/text.h"

namespace splitsum {

// What decoders of containers say of a file that is broken, and of one that is whole but of no use.

using Bytes = std::span<const std::byte>;

template <class... What>
Error unreadable(const What&... what) {
    return {ErrorKind::unreadable_input, cat(what...)};
}

template <class... What>
Error unusable(const What&... what) {
    return {ErrorKind::unusable_input, cat(what...)};
}

}  // namespace splitsum
