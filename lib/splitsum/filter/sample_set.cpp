#include "splitsum/filter/sample_set.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace splitsum {
namespace {

constexpr double pi = std::numbers::pi;

// Collects samples in fp64, then normalises the weights and stores floats.
class Collector {
public:
    // A direction at `azimuth` whose polar angle has this sine and cosine.
    void add(double sine, double cosine, double azimuth, double weight, double solid_angle) {
        samples_.push_back(
            {sine * std::cos(azimuth), sine * std::sin(azimuth), cosine, weight, solid_angle});
        weight_sum_ += weight;
    }

    SampleSet finish() const {
        const size_t padded =
            (samples_.size() + SampleSet::padding - 1) / SampleSet::padding * SampleSet::padding;
        SampleSet set;
        set.count = samples_.size();
        for (auto* values : {&set.x, &set.y, &set.z, &set.weight, &set.solid_angle})
            values->assign(padded, 0.0f);
        std::fill(set.z.begin(), set.z.end(), 1.0f);
        for (size_t i = 0; i < samples_.size(); ++i) {
            set.x[i] = float(samples_[i].x);
            set.y[i] = float(samples_[i].y);
            set.z[i] = float(samples_[i].z);
            set.weight[i] = float(samples_[i].weight / weight_sum_);
            set.solid_angle[i] = float(samples_[i].solid_angle);
        }
        return set;
    }

private:
    struct Sample {
        double x, y, z, weight, solid_angle;
    };
    std::vector<Sample> samples_;
    double weight_sum_ = 0;
};

}  // namespace

SampleSet importance_samples(const Lobe& lobe, int count, const PointList& points) {
    Collector samples;
    const double alpha2 = lobe.alpha * lobe.alpha;
    const double visible = 1 / (1 + alpha2);  // xi at theta_h = 45 degrees
    for (int i = 0; i < count; ++i) {
        const Vec2d point = points[uint32_t(i)];
        const double azimuth = 2 * pi * point.y;
        if (lobe.kind == LobeKind::cosine) {
            const double cosine = std::sqrt(1 - point.x);
            samples.add(std::sqrt(point.x), cosine, azimuth, 1, pi / (count * cosine));
            continue;
        }
        const double xi = point.x * visible;
        const double tan2 = alpha2 * xi / (1 - xi);
        const double cos2 = 1 / (1 + tan2);  // of theta_h; sin² = tan² cos²
        const double sine = 2 * std::sqrt(tan2) * cos2;
        const double cosine = (1 - tan2) * cos2;
        const double root = (1 - xi) / alpha2;
        const double density = alpha2 * root * root / (cos2 * cos2 * pi);
        samples.add(sine, cosine, azimuth, cosine, 4 * visible / (count * density));
    }
    return samples.finish();
}

SampleSet importance_samples(const Lobe& lobe, int count) {
    return importance_samples(lobe, count, PointList::hammersley(uint32_t(count)));
}

SampleSet riemann_samples(const Lobe& lobe, int count) {
    Collector samples;
    const int rows = std::max(1, int(std::lround(std::sqrt(count / 4.0))));
    const int columns = 4 * rows;
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            const double theta = 0.5 * pi * (row + 0.5) / rows;
            const double half = std::sin(0.5 * theta);
            const double sine = std::sin(theta);
            const double solid_angle = 0.5 * pi / rows * 2 * pi / columns * sine;
            samples.add(sine, std::cos(theta), 2 * pi * (column + 0.5) / columns,
                        lobe_value(lobe, 2 * half * half) * sine, solid_angle);
        }
    return samples.finish();
}

}  // namespace splitsum
