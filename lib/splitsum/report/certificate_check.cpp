#include "splitsum/report/certificate_check.h"

namespace splitsum {

std::vector<LevelCheck> check_asset(std::span<const Cubemap> levels, const AssetFacts& facts,
                                    std::span<const ExactTexels> exact) {
    if (facts.kind == AssetFacts::Kind::specular)
        return check_chain(levels, facts.perceptual_roughness, exact);
    return {
        check_diffuse(levels[0], exact.empty() ? ExactTexels() : exact[0], stored_factor(facts))};
}

std::vector<std::string> broken_certificate(const TextureAsset& texture) {
    const auto certificate = certificate_of(texture.metadata);
    if (!certificate) return {certificate.error().message};
    if (!*certificate) return {"it carries no certificate"};
    const auto facts = facts_of(texture.metadata);
    if (!facts) return {facts.error().message};
    const auto levels = cubemaps_of(texture);
    if (!levels) return {levels.error().message};
    if (facts->kind == AssetFacts::Kind::specular &&
        facts->perceptual_roughness.size() != levels->size())
        return {"it does not name the roughness of each of its levels"};
    return contradictions(**certificate, texture, check_asset(*levels, *facts, {}));
}

}  // namespace splitsum
