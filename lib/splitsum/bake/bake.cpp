#include "splitsum/bake/bake.h"

#include <span>

#include "splitsum/assets/cubemap_asset.h"
#include "splitsum/bake/facts.h"
#include "splitsum/bake/recipe.h"
#include "splitsum/base/atomic_file.h"
#include "splitsum/base/content_hash.h"
#include "splitsum/base/file_hash.h"
#include "splitsum/base/staged_folder.h"
#include "splitsum/base/text.h"
#include "splitsum/filter/irradiance_harmonics.h"
#include "splitsum/picture/contact_sheet.h"
#include "splitsum/report/certificate.h"
#include "splitsum/report/harmonics_file.h"

namespace splitsum {
namespace {

struct BakedAssets {
    CubemapAsset specular;
    CubemapAsset irradiance;
    IrradianceHarmonics harmonics;
    std::vector<LevelAccount> accounts;
};

LevelsPlan levels_plan(const BakePlan& plan) {
    return {plan.specular, plan.irradiance, plan.filter, plan.orientation};
}

Result<BakedAssets> make_assets(const Light& light, const BakePlan& plan, const BakeReport& report,
                                Progress& progress) {
    const auto levels = filter_levels(light.filter_source(), levels_plan(plan), progress);
    if (!levels) return levels.error();
    auto specular = cubemap_asset(levels->specular, plan.format, report.specular_facts);
    if (!specular) return specular.error();
    auto irradiance =
        cubemap_asset({&*levels->irradiance, 1}, plan.format, report.irradiance_facts);
    if (!irradiance) return irradiance.error();
    return BakedAssets{
        std::move(*specular), std::move(*irradiance),
        irradiance_harmonics(light.filter_source(), plan.irradiance.harmonics_order,
                             plan.irradiance.windowed, panorama_from_cube(plan.orientation)),
        levels->accounts};
}

// Fills in the figures of the report.
Status measure(const BakedAssets& assets, const Light& light, const BakePlan& plan,
               BakeReport& report, Progress& progress) {
    const auto exact = exact_texels(light, levels_plan(plan), plan.probes, progress);
    if (!exact) return exact.error();
    const size_t levels = assets.specular.levels.size();
    report.accounts = assets.accounts;
    report.probes = int(exact->front().texels.size());
    report.specular =
        check_chain(assets.specular.levels, report.specular_facts.perceptual_roughness, *exact);
    report.specular_counts = assets.specular.counts;
    report.irradiance = check_diffuse(assets.irradiance.levels[0], exact->at(levels),
                                      stored_factor(report.irradiance_facts));
    report.irradiance_counts = assets.irradiance.counts[0];
    report.harmonics = check_diffuse(cubemap_of_harmonics(assets.harmonics), exact->at(levels + 1));
    report.harmonics_lowest = assets.harmonics.lowest;
    const auto readings = exact_readings(light, levels_plan(plan), plan.probes, progress);
    if (!readings) return readings.error();
    report.between =
        reconstruction_error(assets.specular.levels, plan.specular.roughness, *readings);
    return ok;
}

// What was reported of them, into the textures.
void certify(BakedAssets& assets, const BakeReport& report) {
    const std::span accounts(report.accounts);
    certify(assets.specular.texture,
            certificate_from(accounts, report.specular_counts, report.specular,
                             report.source_mean_radiance));
    certify(assets.irradiance.texture,
            certificate_from(accounts.last(1), {&report.irradiance_counts, 1},
                             {&report.irradiance, 1}, report.source_mean_radiance));
}

ContactSheet contact_sheet(const BakedAssets& assets, const BakeReport& report) {
    ContactSheet sheet;
    for (size_t level = 0; level < assets.specular.levels.size(); ++level)
        sheet.levels.push_back(
            {&assets.specular.levels[level], report.specular_facts.perceptual_roughness[level]});
    sheet.irradiance = &assets.irradiance.levels[0];
    return sheet;
}

Status write_assets(const BakedAssets& assets, const BakePlan& plan, BakeReport& report,
                    StagedFolder& folder) {
    const auto write = [&](const std::string& name, const std::string& what, Status written) {
        if (!written) return written;
        const auto path = folder.path() / name;
        const auto hash = hash_of_file(path);
        if (!hash) return Status(hash.error());
        report.files.push_back({name, int64_t(file_size(path)), what, named_hash(*hash)});
        return written;
    };
    const auto& container = plan.container;
    Status status =
        write("specular.ktx2", "prefiltered radiance for a direction and a roughness",
              write_texture(assets.specular.texture, folder.path() / "specular.ktx2", container));
    if (status)
        status = write(
            "irradiance.ktx2",
            plan.irradiance.store_irradiance ? "E for a normal" : "E / pi for a normal",
            write_texture(assets.irradiance.texture, folder.path() / "irradiance.ktx2", container));
    if (status)
        status = write("harmonics.json", "E / pi as spherical harmonics",
                       write_harmonics(assets.harmonics, report.irradiance_facts,
                                       folder.path() / "harmonics.json"));
    if (status && plan.picture)
        status = write(
            "contact.png", "a picture of the levels, for people",
            write_contact_sheet(contact_sheet(assets, report), folder.path() / "contact.png"));
    return status;
}

Status write_files(const BakedAssets& assets, const BakePlan& plan,
                   const std::filesystem::path& folder, BakeReport& report) {
    auto staged = StagedFolder::create(folder);
    if (!staged) return staged.error();
    if (const Status done = write_assets(assets, plan, report, *staged); !done) return done;
    // Last: they say that everything else is there.
    for (const auto& [name, text] : {std::pair("report.txt", report_text(report)),
                                     std::pair("report.json", report_json(report))})
        if (const Status done = write_text_whole(staged->path() / name, text); !done) return done;
    return staged->publish("report.json", drawn_files());
}

}  // namespace

Status validate(const BakePlan& plan) {
    if (plan.probes && *plan.probes < 0)
        return Error{ErrorKind::bad_argument,
                     cat("cannot measure ", *plan.probes, " texels a level; 0 measures none")};
    if (const Status valid = validate(plan.specular); !valid) return valid;
    if (const Status valid = validate(plan.irradiance); !valid) return valid;
    if (const Status valid = validate(plan.filter); !valid) return valid;
    return validate(plan.orientation);
}

LightUse light_use(const BakePlan& plan, std::shared_ptr<FilterTables> tables) {
    return {.levels = levels_plan(plan), .probes = plan.probes, .tables = std::move(tables)};
}

std::vector<std::string> drawn_files() { return {"contact.png", "preview.png", "preview.html"}; }

Result<BakeReport> bake(const Light& light, const BakePlan& plan,
                        const std::filesystem::path& folder, Progress& progress) {
    if (const Status valid = validate(plan); !valid) return valid.error();
    ConfigHashes configs;
    auto settings = settings_of(light.reading, plan, configs);
    if (!settings) return settings.error();
    BakeReport report;
    report.recipe = recipe_of(light.source.name, light.source.hash, *settings);
    report.settings = std::move(*settings);
    report.source = light.source;
    report.source_width = light.width;
    report.source_height = light.height;
    report.source_mean_radiance = mean_radiance(light.environment);
    report.notes = light.notes;
    report.format = plan.format;
    report.specular_facts =
        specular_facts(report.source, plan.specular, plan.filter, plan.orientation);
    report.irradiance_facts =
        irradiance_facts(report.source, plan.irradiance, plan.filter, plan.orientation);

    auto assets = make_assets(light, plan, report, progress);
    if (!assets) return assets.error();
    const Status measured = measure(*assets, light, plan, report, progress);
    if (!measured) return measured.error();
    certify(*assets, report);
    const Status written = write_files(*assets, plan, folder, report);
    if (!written) return written.error();
    return report;
}

}  // namespace splitsum
