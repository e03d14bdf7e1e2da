#include "splitsum/filter/fft.h"

#include <kissfft/kiss_fft.h>

#include <type_traits>

namespace splitsum {

static_assert(sizeof(FftValue) == sizeof(kiss_fft_cpx) &&
                  std::is_same_v<decltype(kiss_fft_cpx::r), float>,
              "the single-precision build of KissFFT");

struct Fft::Plan {
    kiss_fft_cfg configuration;

    ~Plan() { kiss_fft_free(configuration); }
};

Fft::Fft(int length, Direction direction)
    : plan_(new Plan{
          kiss_fft_alloc(length, direction == Direction::inverse ? 1 : 0, nullptr, nullptr)}) {}

Fft::Fft(Fft&&) noexcept = default;
Fft& Fft::operator=(Fft&&) noexcept = default;
Fft::~Fft() = default;

void Fft::transform(std::span<const FftValue> in, std::span<FftValue> out) const {
    kiss_fft(plan_->configuration, reinterpret_cast<const kiss_fft_cpx*>(in.data()),
             reinterpret_cast<kiss_fft_cpx*>(out.data()));
}

int Fft::fast_length(int least) {
    for (int length = least + least % 2;; length += 2) {
        int rest = length;
        for (const int factor : {2, 3, 5})
            while (rest % factor == 0) rest /= factor;
        if (rest == 1) return length;
    }
}

}  // namespace splitsum
