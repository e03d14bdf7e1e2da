#pragma once

#include <array>
#include <functional>
#include <span>
#include <vector>

namespace splitsum {

/// Gathers the many rows of a large panorama on fewer rings, so that integrals against smooth
/// functions stay what they were. Each row's light goes to the nine rings around it with the weights
///     w_q = ∫ over the row of l_q(theta) sin theta dtheta,
/// l_q Lagrange's polynomials through eight rings: then the sum over rings of w_q f(theta_q) is the
/// integral over rows of the interpolated f, the transpose of interpolation (Boyd 1992, J. Comput.
/// Phys. 103, sec. 5). Unlike an average it moves no light: for a harmonic that turns by `angle`
/// radians from ring to ring the error is at most 1.1e-3 angle⁸.
///
/// Rings lie at polar angles pi (k + 1/2) / rings. Rings beyond a pole are those on its other side,
/// half a circle further on. Sums are fp32. Memory: the rings that are not complete yet, 20 or so.
class RowsToRings {
public:
    /// `rings` complete lines from `first_ring`, an even number, on; valid during the call.
    using CompleteRings = std::function<void(int first_ring, std::span<const float* const> rings)>;

    /// At least two rows a ring; `height` rows of 2 height texels.
    RowsToRings(int height, int rings);

    /// The next rows from the top down; `complete` gets each ring once, in order, as texels of
    /// `floats_per_texel` floats (the same number in every call).
    void add_rows(int row_count, const float* texels, int floats_per_texel,
                  const CompleteRings& complete);

private:
    static constexpr int taps = 9;
    struct RowTaps {
        int first_ring = 0;  // may lie beyond a pole
        std::array<float, taps> weight{};
    };

    RowTaps taps_of(int row) const;
    void add_band(int row_count, const float* texels, const CompleteRings& complete);
    void add_columns(int row, const float* texels, size_t first, size_t count);
    void hand_out(int end, const CompleteRings& complete);
    float* slot(int ring) { return window_.data() + size_t(ring % slots_) * line_floats_; }

    int height_;
    int rings_;
    int slots_;
    std::vector<RowTaps> rows_;
    std::vector<float> window_;  // ring k in slot k % slots_
    size_t line_floats_ = 0;
    int next_row_ = 0;
    int next_ring_ = 0;
};

}  // namespace splitsum
