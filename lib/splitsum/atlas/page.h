#pragma once

#include <string>

#include "splitsum/atlas/atlas.h"

namespace splitsum {

/// The atlas as one HTML page that needs nothing else: pictures are inside, there is no script. It
/// is readable on a phone and without colours (each verdict has a sign), and has no times in it.
std::string page_of(const Atlas& atlas);

}  // namespace splitsum
