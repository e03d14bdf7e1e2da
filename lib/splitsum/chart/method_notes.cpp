#include "splitsum/chart/method_notes.h"

#include <algorithm>
#include <array>

#include "splitsum/base/text.h"
#include "splitsum/filter/methods.h"
#include "splitsum/table/split_sum.h"

namespace splitsum {
namespace {

struct Sentence {
    std::string_view name;
    std::string_view text;
};

// Of lines that are no rows of a registry, or rows of two: tables have an `importance` of their own.
constexpr std::array<Sentence, 9> sentences = {{
    {"importance",
     "points through the lobe's distribution, for tables through that of all normals"},
    {"importance (random points)", "importance with independent points instead of even ones"},
    {"importance (1024 samples)", "tables of many sizes from 1024 samples a texel"},
    {"mis (random points)", "mis with independent points instead of even ones"},
    {"mis (balance heuristic)", "mis weighted by densities instead of their squares"},
    {"harmonics", "a short series of the irradiance's spherical harmonics; order 2 has 9 of them"},
    {"harmonics (windowed)", "the same series, damped until no direction is negative (Sloan 2008)"},
    {"spherical Gaussians",
     "a few lobes with amplitudes that are not negative, evaluated in closed form"},
    {"quadrature (texels at edges)",
     "the outermost texels lie at 0 and 1, so that nothing has to be clamped"},
}};

template <class Rows>
std::string_view summary_in(const Rows& rows, std::string_view name) {
    for (const auto& row : rows)
        if (row.name == name) return row.summary;
    return "";
}

std::string sentence_about(std::string_view name) {
    for (const Sentence& sentence : sentences)
        if (sentence.name == name) return std::string(sentence.text);
    const std::string_view of_light = summary_in(filter_methods(), name);
    return std::string(of_light.empty() ? summary_in(split_sum_methods(), name) : of_light);
}

}  // namespace

std::vector<MethodNote> method_notes(const std::vector<MeasuredPanel>& panels) {
    std::vector<MethodNote> notes;
    for (const MeasuredPanel& panel : panels)
        for (const Measurement& row : panel.rows) {
            const auto known = [&](const MethodNote& note) { return note.name == row.method; };
            if (std::ranges::none_of(notes, known))
                notes.push_back({row.method, sentence_about(row.method)});
        }
    return notes;
}

}  // namespace splitsum
