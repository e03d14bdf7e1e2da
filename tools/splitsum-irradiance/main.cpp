#include <CLI/CLI.hpp>

#include "common/options.h"
#include "common/run_tool.h"
#include "light/cubemap_tool.h"
#include "splitsum/bake/facts.h"
#include "splitsum/base/atomic_file.h"
#include "splitsum/filter/irradiance_harmonics.h"
#include "splitsum/report/harmonics_file.h"

namespace splitsum {
namespace {

bool is_harmonics(const std::filesystem::path& path) {
    const std::string ending = path.extension().string();
    return ending == ".json" || ending == ".txt" || ending == ".glsl";
}

Status write_cubemap(const Light& light, const LevelsPlan& plan,
                     const tools::EncodingOptions& encoding,
                     const tools::CubemapOutputOptions& output, Progress& progress) {
    const auto levels = filter_levels(light.filter_source(), plan, progress);
    if (!levels) return levels.error();
    const auto asset = cubemap_asset(
        {&*levels->irradiance, 1}, encoding.format(),
        irradiance_facts(light.source, *plan.irradiance, plan.filter, plan.orientation));
    if (!asset) return asset.error();
    return output.measure_and_write(*asset, levels->accounts, light, plan, encoding.container(),
                                    progress);
}

Status write_series(const Light& light, const LevelsPlan& plan,
                    const tools::CubemapOutputOptions& output, Progress& progress) {
    const Mat3d turn = panorama_from_cube(plan.orientation);
    const IrradianceHarmonics harmonics = irradiance_harmonics(
        light.filter_source(), plan.irradiance->harmonics_order, plan.irradiance->windowed, turn);
    const auto exact = exact_texels(light, plan, output.probes(), progress);
    if (!exact) return exact.error();
    const Status written = write_harmonics(
        harmonics, irradiance_facts(light.source, *plan.irradiance, plan.filter, plan.orientation),
        output.path());
    if (written)
        output.print({check_diffuse(cubemap_of_harmonics(harmonics), exact->back())}, {}, {},
                     light);
    return written;
}

}  // namespace
}  // namespace splitsum

int main(int argc, char** argv) {
    using namespace splitsum;
    CLI::App app("Integrates the diffuse light of a panorama: a cubemap of E / pi, or harmonics.",
                 "splitsum-irradiance");
    app.footer(
        "Examples: splitsum-irradiance sunset.exr -o irradiance.ktx2 --size 32\n"
        "          splitsum-irradiance sunset.exr -o harmonics.glsl --order 3 --window");
    const tools::InputOptions input(app);
    const tools::IrradianceOptions irradiance(app);
    const tools::OrientationOptions orientation(app);
    const tools::FilterOptions filter(app, tools::methods_for(LobeKind::cosine));
    const tools::EncodingOptions encoding(app, tools::EncodingOptions::Content::cubemap);
    const tools::CubemapOutputOptions output(app, "harmonics as .json, .txt or .glsl, a cubemap");

    return tools::run_tool(app, argc, argv, [&](Progress& progress) -> Status {
        const bool series = is_harmonics(output.path());
        const Status possible =
            series ? check_writable(output.path())
                   : output.check({encoding.format(), irradiance.plan.face_size, 1});
        if (!possible) return possible;
        const LevelsPlan plan{std::nullopt, irradiance.plan, filter.plan, orientation.plan};
        const auto light = load_light(input.panorama(), input.plan(),
                                      {.levels = plan, .probes = output.probes()}, progress);
        if (!light) return light.error();
        if (series) return write_series(*light, plan, output, progress);
        return write_cubemap(*light, plan, encoding, output, progress);
    });
}
