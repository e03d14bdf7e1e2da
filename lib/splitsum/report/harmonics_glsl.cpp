#include <iomanip>
#include <sstream>

#include "splitsum/math/harmonics.h"
#include "splitsum/report/harmonics_glsl_detail.h"

namespace splitsum {
namespace {

// Y_lm = constant * polynomial, in the order of harmonic_index (Sloan 2008, appendix A2, without
// its alternating signs).
struct Term {
    double constant;
    const char* polynomial;
};

constexpr Term terms[] = {
    {0.28209479177387814, "1.0"},
    {0.4886025119029199, "n.y"},
    {0.4886025119029199, "n.z"},
    {0.4886025119029199, "n.x"},
    {1.0925484305920792, "n.x * n.y"},
    {1.0925484305920792, "n.y * n.z"},
    {0.31539156525252005, "(3.0 * n.z * n.z - 1.0)"},
    {1.0925484305920792, "n.x * n.z"},
    {0.5462742152960396, "(n.x * n.x - n.y * n.y)"},
    {0.5900435899266435, "n.y * (3.0 * n.x * n.x - n.y * n.y)"},
    {2.890611442640554, "n.x * n.y * n.z"},
    {0.4570457994644658, "n.y * (5.0 * n.z * n.z - 1.0)"},
    {0.3731763325901154, "n.z * (5.0 * n.z * n.z - 3.0)"},
    {0.4570457994644658, "n.x * (5.0 * n.z * n.z - 1.0)"},
    {1.445305721320277, "n.z * (n.x * n.x - n.y * n.y)"},
    {0.5900435899266435, "n.x * (n.x * n.x - 3.0 * n.y * n.y)"},
    {2.5033429417967046, "n.x * n.y * (n.x * n.x - n.y * n.y)"},
    {1.7701307697799304, "n.y * n.z * (3.0 * n.x * n.x - n.y * n.y)"},
    {0.9461746957575601, "n.x * n.y * (7.0 * n.z * n.z - 1.0)"},
    {0.6690465435572892, "n.y * n.z * (7.0 * n.z * n.z - 3.0)"},
    {0.10578554691520431, "(n.z * n.z * (35.0 * n.z * n.z - 30.0) + 3.0)"},
    {0.6690465435572892, "n.x * n.z * (7.0 * n.z * n.z - 3.0)"},
    {0.47308734787878004, "(n.x * n.x - n.y * n.y) * (7.0 * n.z * n.z - 1.0)"},
    {1.7701307697799304, "n.x * n.z * (n.x * n.x - 3.0 * n.y * n.y)"},
    {0.6258357354491761,
     "(n.x * n.x * (n.x * n.x - 3.0 * n.y * n.y) - n.y * n.y * (3.0 * n.x * n.x - n.y * n.y))"},
};

}  // namespace

std::string harmonics_glsl(const IrradianceHarmonics& harmonics) {
    std::ostringstream text;
    text << "// Diffuse light towards the unit normal n, divided by pi: multiply by the albedo.\n"
            "// Axes of the KTX cubemap: +y up, faces +X -X +Y -Y +Z -Z.\n"
            "vec3 splitsum_irradiance(vec3 n) {\n"
            "    vec3 sum = vec3(0.0);\n"
         << std::scientific << std::setprecision(8);
    for (size_t i = 0; i < harmonic_count(harmonics.order); ++i) {
        const Vec3d c = terms[i].constant * harmonics.coefficients[i];
        text << "    sum += vec3(" << c.x << ", " << c.y << ", " << c.z << ") * ("
             << terms[i].polynomial << ");\n";
    }
    text << "    return sum;\n}\n";
    return text.str();
}

}  // namespace splitsum
