#pragma once

#include <optional>
#include <string>
#include <vector>

#include "asset_file.h"
#include "splitsum/base/progress.h"
#include "splitsum/base/result.h"
#include "splitsum/report/certificate.h"
#include "splitsum/sphere/environment.h"

namespace splitsum::tools {

/// What became of a file's certificate.
struct CertificateCheck {
    std::vector<LevelCheck> levels;           ///< with the certified figures
    bool measured = false;                    ///< the figures were measured once more
    std::vector<std::string> contradictions;  ///< none: the certificate holds
};

/// Checks the certificate against the file's texels and keys, and where there is an `environment`,
/// the one that the file was made from as `facts` say, its figures against exact integration at the
/// certified probes. Nothing for a file without certificate. Fails with unusable_input for a
/// certificate that cannot be read.
Result<std::optional<CertificateCheck>> check_certificate(const AssetFile& file,
                                                          const AssetFacts& facts,
                                                          const Environment* environment,
                                                          Progress& progress);

}  // namespace splitsum::tools
