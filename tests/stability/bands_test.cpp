// Row 10: too few bands ring. How many there are follows from what is asked for, and the bound that is
// printed holds.
#include "splitsum/atlas/answers.h"
#include "splitsum/atlas/skies.h"
#include "splitsum/filter/reference.h"
#include "stability/levels.h"

namespace splitsum::tests {
namespace {

TEST(Bands, AreAsManyAsTheLightAndTheAccuracyAskFor) {
    const Environment sun = sun_sky(16, 1e6f), smooth = gradient_sky(16);
    const Lobe lobe = reflection(0.4);
    NoProgress progress;
    const auto spectral = find_filter_method("spectral", LobeKind::ggx);
    const auto made_of = [&](const Environment& sky, double accuracy) {
        FilterPlan effort;
        effort.accuracy = accuracy;
        auto answers = answers_of(*spectral, sky, {&lobe, 1}, effort, 8, progress);
        return *(*answers)[0];
    };
    const auto reference = prepare_reference(sun, {&lobe, 1}, {});
    const auto truth = filter_cubemap(*reference, 0, 8, Mat3d(1), 0, progress);
    int fewer = 0;
    for (const double accuracy : {0.1, 1e-2, 1e-3, 1e-4, 1e-5}) {
        const FilteredCubemap level = made_of(sun, accuracy);
        const ErrorFigures figures = error_figures(level.cubemap.texels, truth->cubemap.texels);
        EXPECT_LE(level.account.error_bound, accuracy);
        EXPECT_LE(figures.rel_rms, accuracy);
        EXPECT_GT(level.account.bands, fewer) << accuracy;
        EXPECT_LT(made_of(smooth, accuracy).account.bands, level.account.bands) << accuracy;
        fewer = level.account.bands;
        expect_light(level.cubemap);
    }
}

}  // namespace
}  // namespace splitsum::tests
