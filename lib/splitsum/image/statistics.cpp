#include "splitsum/image/statistics.h"

#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "splitsum/base/parallel.h"
#include "splitsum/base/text.h"

namespace splitsum {
namespace {

void count_one(Census::Kind& kind, int x, int y) {
    if (kind.count++ > 0) return;
    kind.first_x = x;
    kind.first_y = y;
}

Census census_of_row(std::span<const float> row, int y) {
    Census census;
    if (all_are_radiance(row)) return census;
    for (int x = 0; x < static_cast<int>(row.size() / 3); ++x) {
        const auto pixel = row.subspan(3 * static_cast<size_t>(x), 3);
        bool nan = false, infinite = false, negative = false;
        for (const float value : pixel) {
            nan |= std::isnan(value);
            infinite |= std::isinf(value);
            negative |= value < 0;
        }
        if (nan)
            count_one(census.nan, x, y);
        else if (infinite)
            count_one(census.infinite, x, y);
        else if (negative)
            count_one(census.negative, x, y);
    }
    return census;
}

// `above` lies above `below` in the image, so its first position wins.
Census::Kind joined(const Census::Kind& above, const Census::Kind& below) {
    Census::Kind both = above.count > 0 ? above : below;
    both.count = above.count + below.count;
    return both;
}

/// Which pixels hold a radiance by now, and the holes that do not.
class HoleFiller {
public:
    explicit HoleFiller(Image& image)
        : image_(image), state_(static_cast<size_t>(image.width) * size_t(image.height)) {
        parallel_rows(image.height, [&](int y) { clear_negatives(y); });
    }

    void fill() {
        std::vector<Pixel> ring = first_ring();
        while (!ring.empty()) ring = close(ring);
        parallel_rows(image_.height, [&](int y) { blacken_unreached(y); });
    }

private:
    enum class State : unsigned char { good, hole, in_ring };
    struct Pixel {
        int x;
        int y;
    };

    State& state(Pixel p) {
        return state_[static_cast<size_t>(p.y) * static_cast<size_t>(image_.width) +
                      static_cast<size_t>(p.x)];
    }
    float* rgb(Pixel p) { return image_.row(p.y).data() + 3 * static_cast<size_t>(p.x); }

    void clear_negatives(int y) {
        for (int x = 0; x < image_.width; ++x) {
            float* const pixel = rgb({x, y});
            const bool finite =
                std::isfinite(pixel[0]) && std::isfinite(pixel[1]) && std::isfinite(pixel[2]);
            state({x, y}) = finite ? State::good : State::hole;
            for (int c = 0; finite && c < 3; ++c) pixel[c] = pixel[c] > 0 ? pixel[c] : 0;
        }
    }

    // The eight neighbours on the sphere: over a pole means half a turn away in the same row.
    std::array<Pixel, 8> neighbours(Pixel p) const {
        static constexpr std::array<std::array<int, 2>, 8> steps = {
            {{-1, -1}, {0, -1}, {1, -1}, {-1, 0}, {1, 0}, {-1, 1}, {0, 1}, {1, 1}}};
        std::array<Pixel, 8> around;
        for (size_t i = 0; i < steps.size(); ++i) {
            const int y = p.y + steps[i][1];
            const bool over_pole = y < 0 || y >= image_.height;
            const int x = p.x + steps[i][0] + (over_pole ? image_.width / 2 : 0);
            around[i] = {(x + image_.width) % image_.width, over_pole ? p.y : y};
        }
        return around;
    }

    bool touches_good(Pixel p) {
        for (const Pixel n : neighbours(p))
            if (state(n) == State::good) return true;
        return false;
    }

    std::vector<Pixel> first_ring() {
        std::vector<Pixel> ring;
        for (int y = 0; y < image_.height; ++y)
            for (int x = 0; x < image_.width; ++x)
                if (state({x, y}) == State::hole && touches_good({x, y})) ring.push_back({x, y});
        for (const Pixel p : ring) state(p) = State::in_ring;
        return ring;
    }

    void set_to_mean_of_good_neighbours(Pixel p) {
        std::array<double, 3> sum{};
        int count = 0;
        for (const Pixel n : neighbours(p)) {
            if (state(n) != State::good) continue;
            for (size_t c = 0; c < 3; ++c) sum[c] += rgb(n)[c];
            ++count;
        }
        for (size_t c = 0; c < 3; ++c) rgb(p)[c] = static_cast<float>(sum[c] / count);
    }

    /// Fills a ring of holes that touch good pixels; returns the next ring.
    std::vector<Pixel> close(const std::vector<Pixel>& ring) {
        parallel_rows(static_cast<int>(ring.size()),
                      [&](int i) { set_to_mean_of_good_neighbours(ring[static_cast<size_t>(i)]); });
        for (const Pixel p : ring) state(p) = State::good;
        std::vector<Pixel> next;
        for (const Pixel p : ring)
            for (const Pixel n : neighbours(p))
                if (std::exchange(state(n), state(n) == State::hole ? State::in_ring : state(n)) ==
                    State::hole)
                    next.push_back(n);
        return next;
    }

    // Only an image without any good pixel has holes left.
    void blacken_unreached(int y) {
        for (int x = 0; x < image_.width; ++x)
            if (state({x, y}) == State::hole)
                for (int c = 0; c < 3; ++c) rgb({x, y})[c] = 0;
    }

    Image& image_;
    std::vector<State> state_;
};

}  // namespace

Census operator+(const Census& above, const Census& below) {
    return {joined(above.nan, below.nan), joined(above.infinite, below.infinite),
            joined(above.negative, below.negative)};
}

Census take_census(const Image& image) {
    return ordered_sum(image.height, [&](int y) { return census_of_row(image.row(y), y); });
}

// Without a branch, so that the compiler compares many values at once.
bool all_are_radiance(std::span<const float> values) {
    unsigned bad = 0;
    for (const float value : values)
        bad |= static_cast<unsigned>(!(value >= 0)) |
               static_cast<unsigned>(value > std::numeric_limits<float>::max());
    return bad == 0;
}

std::string describe(const Census& census) {
    std::string text;
    const auto add = [&](const Census::Kind& kind, const char* name) {
        if (kind.count == 0) return;
        text += cat(text.empty() ? "" : ", ", kind.count, " ", name, " (first at x ", kind.first_x,
                    ", y ", kind.first_y, ")");
    };
    add(census.nan, "NaN");
    add(census.infinite, "infinite");
    add(census.negative, "negative");
    return text.empty() ? "clean" : text;
}

void repair(Image& image) { HoleFiller(image).fill(); }

}  // namespace splitsum
