#include "splitsum/atlas/light_cases.h"

#include "splitsum/atlas/skies.h"
#include "splitsum/base/text.h"

namespace splitsum {
namespace {

const std::vector<double> usual_roughness = {0, 0.1, 0.3, 0.6, 1};

Environment sun_1e2(int rows) { return sun_sky(rows, 1e2f); }
Environment sun_1e3(int rows) { return sun_sky(rows, 1e3f); }
Environment sun_1e4(int rows) { return sun_sky(rows, 1e4f); }
Environment sun_1e5(int rows) { return sun_sky(rows, 1e5f); }
Environment sun_1e6(int rows) { return sun_sky(rows, 1e6f); }

void add_smooth(std::vector<LightCase>& cases) {
    cases.push_back(
        {.id = "roughness",
         .title = "From no roughness to full roughness",
         .problem = "At r = 0 the density is 0 / ∞; for a tiny alpha 1 − (n·h)² cancels: 2.9 % off "
                    "at r = 0.045 in fp32 and 88 % at 0.02.",
         .conduct =
             "r = 0 is the mirror image, area-filtered, whatever the method; everywhere else "
             "sines come from the sampler or from differences of vectors.",
         .sky = gradient_sky,
         .perceptual_roughness = {0, 1e-4, 1e-3, 0.01, 0.02, 0.045, 0.1, 0.2, 0.5, 1}});
    cases.push_back({.id = "constant",
                     .title = "The same light from everywhere",
                     .problem = "Whatever is not normalised drifts away from the constant.",
                     .conduct = "The constant, to rounding; judged by the constant itself.",
                     .sky = constant_sky,
                     .perceptual_roughness = {0, 1e-4, 0.1, 0.3, 1},
                     .everywhere = Vec3(0.7f, 3.0f, 1e4f),
                     .tolerance = 1e-5});
}

void add_suns(std::vector<LightCase>& cases) {
    struct Sun {
        const char* radiance;
        Environment (*sky)(int rows);
    };
    for (const Sun& sun : {Sun{"1e2", sun_1e2},
                           {"1e3", sun_1e3},
                           {"1e4", sun_1e4},
                           {"1e5", sun_1e5},
                           {"1e6", sun_1e6}})
        cases.push_back(
            {.id = cat("sun-", sun.radiance),
             .title = cat("A sun of one texel, radiance ", sun.radiance),
             .problem = "Few samples meet it: fireflies, ghosts, lost energy; a series rings.",
             .conduct = "`auto` keeps as many bands as this sun asks for, or sums over texels.",
             .sky = sun.sky,
             .perceptual_roughness = usual_roughness});
    cases.push_back({.id = "two-suns",
                     .title = "Two suns, 1e5 and 1e4, of different colours",
                     .problem = "What was tuned to one light misses the other.",
                     .conduct = "Bands follow from the spectrum of this panorama.",
                     .sky = two_suns_sky,
                     .perceptual_roughness = usual_roughness});
    cases.push_back({.id = "one-texel",
                     .title = "Black but for one texel",
                     .problem = "Nothing hides an error: whatever is elsewhere is wrong.",
                     .conduct = "Exact light around it, nothing negative elsewhere.",
                     .sky = one_texel_sky,
                     .perceptual_roughness = usual_roughness});
    cases.push_back({.id = "night",
                     .title = "Night with 40 lamps of one texel each",
                     .problem = "Each sample meets a lamp or none: the ghosts of 40 suns.",
                     .conduct = "As for a sun.",
                     .sky = night_sky,
                     .perceptual_roughness = usual_roughness});
}

void add_places(std::vector<LightCase>& cases) {
    cases.push_back(
        {.id = "lit-poles",
         .title = "Both poles lit",
         .problem = "Rows shrink to a point: texels that are weighted alike make a dot.",
         .conduct = "Every sum weighs texels with their own solid angles.",
         .sky = lit_poles_sky,
         .perceptual_roughness = usual_roughness});
    cases.push_back({.id = "sun-at-pole",
                     .title = "A sun in one texel at the pole",
                     .problem = "The smallest texel of all; bilinear pyramids smear it around.",
                     .conduct = "Its own solid angle, however small.",
                     .sky = sun_at_pole_sky,
                     .perceptual_roughness = usual_roughness});
    cases.push_back(
        {.id = "lit-edge",
         .title = "A lit line along an edge of the cube",
         .problem = "Faces that are filtered one by one show a seam.",
         .conduct = "The panorama stays a panorama until a texel of a face is filtered.",
         .sky = lit_edge_sky,
         .perceptual_roughness = usual_roughness});
    cases.push_back({.id = "checkerboard",
                     .title = "A checkerboard of texels",
                     .problem = "All there is lies at the highest frequency: point samples alias.",
                     .conduct = "The integral over texels; the mirror image takes means of areas.",
                     .sky = checkerboard_sky,
                     .perceptual_roughness = usual_roughness});
}

void add_sizes(std::vector<LightCase>& cases, const AtlasPlan& plan) {
    for (const int rows : {1, 2, 5})
        cases.push_back({.id = cat("rows-", rows),
                         .title = cat("A panorama of ", 2 * rows, " × ", rows, " texels"),
                         .problem = "Wrong solid angles, empty pyramids, transforms of length 2.",
                         .conduct = "Works as any other.",
                         .sky = gradient_sky,
                         .perceptual_roughness = {0, 0.1, 0.5, 1},
                         .rows = rows});
    cases.push_back(
        {.id = "many-texels",
         .title = cat("The same light from ", 2L * plan.many_rows * plan.many_rows, " texels"),
         .problem = "A float sum stops growing at 2^24 times its step: lost energy.",
         .conduct = "Sums are ordered and in fp64, or of few terms each.",
         .sky = constant_sky,
         .perceptual_roughness = {0, 1},
         .rows = plan.many_rows,
         .face_size = 2,
         .everywhere = Vec3(0.7f, 3.0f, 1e4f),
         .tolerance = 1e-5});
}

void add_efforts(std::vector<LightCase>& cases) {
    cases.push_back(
        {.id = "bands",
         .title = "Too few bands for a sun of 1e6: accuracy asked for, from 0.1 to 1e-5",
         .problem = "A series cut off too early rings (Gibbs).",
         .conduct = "The bound of what is left out is computed from this panorama's spectrum, and "
                    "bands are kept until it is small enough; methods that know no bound ignore "
                    "the accuracy.",
         .sky = sun_1e6,
         .perceptual_roughness = {0.4},
         .diffuse = false,
         .accuracies = {0.1, 1e-2, 1e-3, 1e-4, 1e-5}});
    cases.push_back(
        {.id = "points",
         .title = "Few points under a sun of 1e6: 16 to 65536 samples",
         .problem = "Shared Hammersley points print their pattern: ghosts of the sun.",
         .conduct = "Shown in the chart and in the measured figures; `auto` never samples.",
         .sky = sun_1e6,
         .perceptual_roughness = {0.6},
         .diffuse = false,
         .samples = {16, 64, 256, 1024, 4096, 65536}});
}

}  // namespace

std::vector<LightCase> light_cases(const AtlasPlan& plan) {
    std::vector<LightCase> cases;
    add_smooth(cases);
    add_suns(cases);
    add_efforts(cases);
    add_places(cases);
    add_sizes(cases, plan);
    return cases;
}

}  // namespace splitsum
