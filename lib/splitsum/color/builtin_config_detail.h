#pragma once

#include <OpenColorIO/OpenColorIO.h>

#include <filesystem>

#include "splitsum/base/result.h"
#include "splitsum/color/primaries.h"

namespace splitsum {

/// Our config, made in code. Its reference space is the working space, so that a file in the
/// working space passes through without a change.
OCIO_NAMESPACE::ConstConfigRcPtr make_builtin_config();

/// The config in `file`, or the built-in one where that is empty. Fails with unreadable_input.
Result<OCIO_NAMESPACE::ConstConfigRcPtr> load_config(const std::filesystem::path& file);

/// A colour matrix as OpenColorIO applies it.
OCIO_NAMESPACE::MatrixTransformRcPtr matrix_transform(const ColorMatrix& matrix);

}  // namespace splitsum
