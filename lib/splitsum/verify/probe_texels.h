#pragma once

#include <vector>

namespace splitsum {

/// A texel of a cubemap at which it is measured.
struct ProbeTexel {
    int face, x, y;

    bool operator==(const ProbeTexel&) const = default;
};

/// `count` different texels of a cubemap, spread evenly over the sphere: those that the points of a
/// spherical Fibonacci lattice (Swinbank & Purser 2006) fall into; every texel, in order, of a
/// cubemap that has no more. The lattice is turned by an angle that depends on `face_size`, so that
/// the levels of a chain do not all look the same way. Chosen without a look at the light: none is
/// easier than others.
std::vector<ProbeTexel> probe_texels(int face_size, int count);

}  // namespace splitsum
