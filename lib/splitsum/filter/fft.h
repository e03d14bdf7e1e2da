#pragma once

#include <memory>
#include <span>

namespace splitsum {

struct FftValue {
    float r;
    float i;
};

/// A complex Fourier transform of fixed length, unnormalised, in fp32. Made once, used by many
/// threads. The only file that includes KissFFT.
class Fft {
public:
    enum class Direction {
        forward,  ///< sum of x_j e^(-2 pi i j k / n)
        inverse,  ///< sum of x_j e^(+2 pi i j k / n)
    };

    Fft(int length, Direction direction);
    Fft(Fft&&) noexcept;
    Fft& operator=(Fft&&) noexcept;
    ~Fft();

    /// `in` and `out` hold `length` values and must not overlap.
    void transform(std::span<const FftValue> in, std::span<FftValue> out) const;

    /// The smallest even length from `least` on that has no factors but 2, 3 and 5.
    static int fast_length(int least);

private:
    struct Plan;
    std::unique_ptr<Plan> plan_;
};

}  // namespace splitsum
