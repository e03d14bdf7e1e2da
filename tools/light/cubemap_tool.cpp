#include "light/cubemap_tool.h"

#include <iostream>
#include <nlohmann/json.hpp>

#include "splitsum/bake/facts.h"
#include "splitsum/base/atomic_file.h"
#include "splitsum/base/text.h"
#include "splitsum/filter/methods.h"
#include "splitsum/report/certificate_check.h"
#include "splitsum/report/figures_json.h"
#include "splitsum/report/figures_text.h"

namespace splitsum::tools {

std::vector<Choice> methods_for(LobeKind kind) {
    std::vector<Choice> choices;
    for (const FilterMethod& method : filter_methods())
        if (kind == LobeKind::ggx ? method.filters_ggx : method.filters_cosine)
            choices.push_back({method.name, method.summary});
    return choices;
}

CubemapOutputOptions::CubemapOutputOptions(CLI::App& app, const std::string& what) : verify_(app) {
    app.add_option("-o,--output", path_, cat(what, " as ", container_endings(), " (required)"))
        ->option_text("FILE")
        ->required()
        ->check(not_empty());
    app.add_flag("--json", json_, "print the figures as JSON");
}

Status CubemapOutputOptions::check(const CubeShape& shape) const {
    const auto container = container_of(path_);
    if (!container) return container.error();
    if (const Status fits = container->check_cube(shape); !fits) return fits;
    return check_writable(path_);
}

Status CubemapOutputOptions::measure_and_write(CubemapAsset asset,
                                               const std::vector<LevelAccount>& accounts,
                                               const Light& light, const LevelsPlan& plan,
                                               const ContainerOptions& container,
                                               Progress& progress) const {
    const auto facts = facts_of(asset.texture.metadata);
    if (!facts) return facts.error();
    const auto exact = exact_texels(light, plan, probes(), progress);
    if (!exact) return exact.error();
    const auto checks = check_asset(asset.levels, *facts, *exact);
    certify(asset.texture,
            certificate_from(accounts, asset.counts, checks, mean_radiance(light.environment)));
    if (const Status written = write_texture(asset.texture, path_, container); !written)
        return written;
    print(checks, accounts, asset.counts, light);
    return ok;
}

void CubemapOutputOptions::print(const std::vector<LevelCheck>& checks,
                                 const std::vector<LevelAccount>& accounts,
                                 const std::vector<EncodeCounts>& counts,
                                 const Light& light) const {
    int64_t saturated = 0;
    for (const EncodeCounts& count : counts) saturated += count.saturated;
    std::vector<std::string> notes = light.notes;
    if (const auto container = container_of(path_); container && !container->keeps_metadata)
        notes.push_back(cat(container->extension,
                            " files keep no metadata: neither the roughness of ",
                            "each level nor the certificate is in the file"));
    if (json_) {
        nlohmann::ordered_json json = {
            {"file", path_.string()}, {"notes", notes}, {"saturated", saturated}};
        json["measured"] = nlohmann::ordered_json::array();
        for (size_t i = 0; i < checks.size(); ++i) {
            json["measured"].push_back(check_json(checks[i]));
            if (i < accounts.size()) json["measured"].back().update(account_json(accounts[i]));
        }
        std::cout << json.dump(2) << "\n";
        return;
    }
    for (const std::string& note : notes) std::cout << "note: " << note << "\n";
    if (saturated > 0)
        std::cout << "note: " << saturated << " values were above the format's largest and are "
                  << "stored as that\n";
    std::cout << figures_heading(!accounts.empty());
    for (size_t i = 0; i < checks.size(); ++i)
        std::cout << figures_line(cat("level ", i), checks[i],
                                  i < accounts.size() ? &accounts[i] : nullptr);
    std::cout << path_.string() << "\n";
}

Result<std::vector<LevelCheck>> check_cubemap_asset(const std::vector<Cubemap>& levels,
                                                    const AssetFacts& facts,
                                                    const Environment& environment, int probes,
                                                    Progress& progress) {
    const bool is_chain = facts.kind == AssetFacts::Kind::specular;
    const int face_size = levels[0].face_size;
    const auto probed = is_chain ? probed_chain(face_size, facts.perceptual_roughness)
                                 : std::vector{ProbedCubemap{{LobeKind::cosine}, face_size}};
    const auto exact =
        exact_texels(environment, panorama_from_cube(facts.orientation), probed, probes, progress);
    if (!exact) return exact.error();
    return check_asset(levels, facts, *exact);
}

Result<std::vector<ReconstructionError>> check_readings(const std::vector<Cubemap>& levels,
                                                        const AssetFacts& facts,
                                                        const Environment& environment, int probes,
                                                        Progress& progress) {
    if (facts.kind != AssetFacts::Kind::specular) return std::vector<ReconstructionError>{};
    const auto exact = reconstruction_probes(environment, panorama_from_cube(facts.orientation),
                                             roughness_bands(), probes, progress);
    if (!exact) return exact.error();
    return reconstruction_error(levels, facts.curve, *exact);
}

}  // namespace splitsum::tools
