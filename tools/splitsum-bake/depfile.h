#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "splitsum/base/result.h"

namespace splitsum::tools {

/// The text of a depfile: one rule, "targets: sources", as Make and Ninja read it. Behind it each
/// source has an empty rule, so that Make rebuilds instead of failing once it is gone.
///
/// Fails with bad_argument for a name that not both can read: with control characters, quotes, or one
/// of &^*?<>|`;= in it, or a backslash before '#' or ':'.
Result<std::string> depfile_text(std::span<const std::string> targets,
                                 std::span<const std::string> sources);

/// A name as it stands there: blanks, '#', ':' and '$' are escaped.
std::string escaped_for_make(const std::string& name);

}  // namespace splitsum::tools
