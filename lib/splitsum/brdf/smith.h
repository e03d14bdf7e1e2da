#pragma once

#include <span>
#include <string_view>

namespace splitsum {

/// Shadowing and masking of a GGX surface, always as the visibility V = G / (4 n·l n·v).
enum class SmithTerm {
    height_correlated,  ///< Heitz 2014, eq. 99: V = 0.5 / (n·l sqrt(...) + n·v sqrt(...))
    schlick_half,       ///< separable Schlick-Smith, k = alpha / 2 (Karis 2013)
    schlick_sqrt,       ///< separable Schlick-Smith, k = alpha sqrt(2 / pi) (Schlick 1994)
};

struct SmithTermInfo {
    SmithTerm term;
    std::string_view name;     ///< as typed after --geometry
    std::string_view summary;  ///< one line for --help
};

/// Every term; the first is the default.
std::span<const SmithTermInfo> smith_terms();

const SmithTermInfo& info_of(SmithTerm term);

/// V = G / (4 n·l n·v) for cosines in (0, 1]; `alpha` is the GGX width in [0, 1]. Finite as long as
/// both cosines are above 0.
double smith_visibility(SmithTerm term, double n_dot_l, double n_dot_v, double alpha);

/// G1 = 2 / (1 + sqrt(1 + alpha² tan²)) of a GGX surface (Smith 1967; Heitz 2014, eq. 72): the part
/// of facets that a viewer at this cosine from the normal sees. `cosine` in (0, 1], `alpha` in
/// [0, 1].
double smith_masking(double cosine, double alpha);

/// The k of a Schlick term: G1(c) = c / (c (1 - k) + k). Not for `height_correlated`.
double schlick_k(SmithTerm term, double alpha);

}  // namespace splitsum
