#include "light/verify_options.h"

#include "common/values.h"

namespace splitsum::tools {

VerifyOptions::VerifyOptions(CLI::App& app) {
    app.add_flag("--verify,!--no-verify", verify_,
                 "measure stored texels against exact integration (the default), or do not");
    app.add_option("--probes", probes_,
                   "texels per level that are measured (default 8; 1 above 2048 x 1024, where the "
                   "panorama is streamed; 64 to be thorough)")
        ->option_text("COUNT")
        ->check(whole_number(0, 1 << 24));
}

std::optional<int> VerifyOptions::probes() const { return verify_ ? probes_ : 0; }

}  // namespace splitsum::tools
