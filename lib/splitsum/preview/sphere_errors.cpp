#include "splitsum/preview/sphere_errors.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace splitsum {
namespace {

Vec3d pixel_of(const Image& image, size_t index) {
    const float* const rgb = image.rgb.data() + 3 * index;
    return {rgb[0], rgb[1], rgb[2]};
}

double sum_of(const Vec3d& v) { return v.x + v.y + v.z; }

// The share of `part` in `whole`, infinite where there is a part of nothing.
double ratio(double part, double whole) {
    if (whole > 0) return part / whole;
    return part == 0 ? 0 : std::copysign(std::numeric_limits<double>::infinity(), part);
}

class NoisySums {
public:
    void add(const Vec3d& value, const TruthPicture& truth, size_t pixel) {
        const Vec3d error(truth.standard_error[pixel]);
        if (std::isinf(error.x)) return;
        const Vec3d t(truth.mean[pixel]);
        difference2_ += dot(value - t, value - t);
        truth2_ += dot(t, t);
        variance_ += dot(error, error);
        value_ += sum_of(value);
        truth_ += sum_of(t);
        ++pixels_;
    }

    NoisyFigures figures() const {
        const double truth2 = truth2_ - variance_;
        return {std::sqrt(ratio(std::max(difference2_ - variance_, 0.0), truth2)),
                ratio(value_ - truth_, truth_), std::sqrt(ratio(variance_, truth2_)), pixels_};
    }

private:
    double difference2_ = 0, truth2_ = 0, variance_ = 0, value_ = 0, truth_ = 0;
    int pixels_ = 0;
};

struct Sums {
    std::vector<Vec3> baked, exact;
    NoisySums approximation, together;
};

}  // namespace

std::vector<SphereErrors> sphere_errors(const Image& baked, const Image& exact,
                                        const TruthPicture& truth, int spheres) {
    std::vector<Sums> sums{size_t(spheres)};
    for (size_t i = 0; i < truth.sphere_at.size(); ++i) {
        if (truth.sphere_at[i] == TruthPicture::background) continue;
        Sums& of_sphere = sums[size_t(truth.sphere_at[i])];
        of_sphere.baked.push_back(Vec3(pixel_of(baked, i)));
        of_sphere.exact.push_back(Vec3(pixel_of(exact, i)));
        of_sphere.approximation.add(pixel_of(exact, i), truth, i);
        of_sphere.together.add(pixel_of(baked, i), truth, i);
    }
    std::vector<SphereErrors> errors;
    for (const Sums& of_sphere : sums)
        errors.push_back({error_figures(of_sphere.baked, of_sphere.exact),
                          of_sphere.approximation.figures(), of_sphere.together.figures()});
    return errors;
}

}  // namespace splitsum
