#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "splitsum/filter/methods.h"
#include "splitsum/measure/error_figures.h"

namespace splitsum {

/// How the cases at which methods fail are gone through.
struct AtlasPlan {
    std::span<const FilterMethod> methods = filter_methods();  ///< the rows of most tables
    int sky_rows = 64;       ///< of the generated panoramas, where a case does not need its own
    int face_size = 8;       ///< texels along an edge of the levels that are compared
    int many_rows = 2048;    ///< of the panorama with so many texels that float sums lose light
    int samples = 1024;      ///< directions a texel; of the methods that sample
    double accuracy = 3e-4;  ///< rel_rms by which `auto` may miss, as FilterPlan::accuracy
    bool pictures = true;    ///< of skies and of what each method made
};

/// Fails with bad_argument: what was asked, and what would work.
Status validate(const AtlasPlan& plan);

/// What a figure means.
enum class Verdict {
    meets,    ///< within the accuracy that was asked for
    near,     ///< within 1e-2, which is hard to see
    fails,    ///< further away, or not light at all: NaN, infinite, negative
    refuses,  ///< says that it does not do this, and why
};

/// "meets", "near", "fails", "refuses".
std::string_view name_of(Verdict verdict);

/// The largest rel_rms and |bias| of Verdict::near.
inline constexpr double near_limit = 1e-2;

/// The verdict on figures for an accuracy; NaN fails.
Verdict verdict_of(const ErrorFigures& figures, double accuracy);

/// One case by one method. Never blank: it has figures, or a text that says what happened.
struct AtlasCell {
    Verdict verdict = Verdict::fails;
    std::optional<ErrorFigures> figures{};
    std::string text{};  ///< beside the figures how they came about, without them what happened
    std::string png{};   ///< a picture of what was made; may be empty
};

struct AtlasRow {
    std::string label;
    std::vector<AtlasCell> cells{};  ///< one a column
};

struct AtlasTable {
    std::string row_kind = "method";  ///< what the labels of the rows are
    std::vector<std::string> columns{};
    std::vector<AtlasRow> rows{};
};

/// A case at which methods fail.
struct AtlasEntry {
    std::string id{};       ///< short, unique, lower case
    std::string title{};    ///< a few words
    std::string problem{};  ///< what goes wrong there
    std::string conduct{};  ///< what this project does about it
    std::string png{};      ///< the panorama; may be empty
    AtlasTable table{};
};

struct Atlas {
    AtlasPlan plan;
    std::vector<AtlasEntry> entries;
};

/// The most severe verdict of a row: fails, near, meets; refuses only where it does nothing else.
Verdict worst_of(const AtlasRow& row);

}  // namespace splitsum
