#pragma once

#include <nlohmann/json.hpp>
#include <span>

#include "splitsum/filter/methods.h"
#include "splitsum/measure/error_figures.h"
#include "splitsum/verify/check_levels.h"
#include "splitsum/verify/reconstruction.h"

namespace splitsum {

/// {"rel_rms": ..., "max_rel": ..., "max_abs": ..., "bias": ..., "texels": ...}; a figure that is
/// not finite is null, because JSON has no other word for it.
nlohmann::ordered_json figures_json(const ErrorFigures& figures);

/// How a level was made: method, reason, bands, error_bound, clamped_negative.
nlohmann::ordered_json account_json(const LevelAccount& account);

/// A level's place, figures (if any were measured) and mean radiance as one object.
nlohmann::ordered_json check_json(const LevelCheck& check);

/// What an engine reads between texels and levels: an object for each band of roughness.
nlohmann::ordered_json readings_json(std::span<const ReconstructionError> bands);

}  // namespace splitsum
