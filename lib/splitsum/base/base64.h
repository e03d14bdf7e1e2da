#pragma once

#include <string>
#include <string_view>

namespace splitsum {

/// `bytes` in base 64 with padding (RFC 4648, section 4), as a page carries pictures.
std::string base64(std::string_view bytes);

}  // namespace splitsum
