#pragma once

#include <OpenColorIO/OpenColorIO.h>

#include "splitsum/color/primaries.h"

namespace splitsum {

/// Our config, made in code. Its reference space is the working space, so that a file in the
/// working space passes through without a change.
OCIO_NAMESPACE::ConstConfigRcPtr make_builtin_config();

/// A colour matrix as OpenColorIO applies it.
OCIO_NAMESPACE::MatrixTransformRcPtr matrix_transform(const ColorMatrix& matrix);

}  // namespace splitsum
