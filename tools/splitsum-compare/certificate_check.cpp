#include "certificate_check.h"

#include <algorithm>

#include "light/cubemap_tool.h"
#include "splitsum/report/certificate_check.h"

namespace splitsum::tools {
namespace {

// Levels of fewer texels have all of them.
int probes_of(const Certificate& certificate) {
    int64_t probes = 0;
    for (const CertifiedLevel& level : certificate.levels)
        probes = std::max(probes, level.figures.texels);
    return int(std::min<int64_t>(probes, 1 << 24));
}

}  // namespace

Result<std::optional<CertificateCheck>> check_certificate(const AssetFile& file,
                                                          const AssetFacts& facts,
                                                          const Environment* environment,
                                                          Progress& progress) {
    if (!file.texture) return std::optional<CertificateCheck>();
    const auto certificate = certificate_of(file.texture->metadata);
    if (!certificate) return certificate.error();
    if (!*certificate) return std::optional<CertificateCheck>();
    CertificateCheck check;
    check.levels = check_asset(file.levels, facts, {});
    if (environment) {
        auto levels = check_cubemap_asset(file.levels, facts, *environment,
                                          probes_of(**certificate), progress);
        if (!levels) return levels.error();
        check.levels = std::move(*levels);
    }
    check.measured = environment != nullptr;
    check.contradictions = contradictions(**certificate, *file.texture, check.levels);
    for (size_t i = 0; i < std::min(check.levels.size(), (*certificate)->levels.size()); ++i)
        check.levels[i].figures = (*certificate)->levels[i].figures;
    return std::optional(std::move(check));
}

}  // namespace splitsum::tools
