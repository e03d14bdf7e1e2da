#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "splitsum/preview/scene.h"
#include "splitsum/preview/sphere_errors.h"
#include "splitsum/preview/truth_picture.h"
#include "splitsum/verify/check_levels.h"
#include "splitsum/verify/reconstruction.h"

namespace splitsum::tools {

/// The specular chain against exact integration of its panorama, as splitsum-compare finds it.
struct ChainFigures {
    std::vector<LevelCheck> levels;  ///< none where there was no panorama
    std::vector<ReconstructionError> between;
};

/// What is said of one sphere.
struct SphereResult {
    Sphere sphere;
    int pixels;                                         ///< in which it is seen
    std::optional<SphereErrors> errors = std::nullopt;  ///< where there is a truth
};

/// How the truth was found.
struct TruthResult {
    double noise;  ///< as TruthPicture::noise
    int passes;
    int64_t samples;
    TruthEnd end;
    ErrorFigures split_exact{};  ///< of the exact split sum, where it was computed
};

/// What a run of splitsum-preview comes to.
struct PreviewResults {
    std::filesystem::path file;
    std::filesystem::path page;         ///< empty if none was asked for
    std::vector<std::string> pictures;  ///< in the file: from top to bottom, or layers
    std::string view;
    double yaw_degrees = 0;
    double exposure_stops;
    std::vector<SphereResult> spheres;
    std::optional<TruthResult> truth;
    ChainFigures chain;
    std::vector<std::string> notes;
};

/// Prints them on stdout, as text or as JSON.
void print(const PreviewResults& results, bool json);

}  // namespace splitsum::tools
