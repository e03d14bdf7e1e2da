#pragma once

#include <vector>

#include "splitsum/base/progress.h"
#include "splitsum/brdf/lobe.h"
#include "splitsum/sphere/cubemap.h"
#include "splitsum/sphere/environment.h"
#include "splitsum/verify/probe_texels.h"

namespace splitsum {

/// The radiance at the probes, three numbers each, added to `values`.
void add_values_at(const Cubemap& cubemap, const std::vector<ProbeTexel>& probes,
                   std::vector<float>& values);

/// The exact integrals of `lobe` (alpha > 0) at the probes of a cube of `face_size`, likewise. The
/// cube lies along the panorama's axes. In parallel over probes; stops early when cancelled.
void add_exact_values(const Environment& environment, const Lobe& lobe, int face_size,
                      const std::vector<ProbeTexel>& probes, std::vector<float>& values,
                      Progress& progress);

}  // namespace splitsum
