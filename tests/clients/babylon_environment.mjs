// How Babylon.js (9) uses a specular.dds of Splitsum, and harmonics.json for diffuse light.

import { CubeTexture } from '@babylonjs/core/Materials/Textures/cubeTexture.js';
import { SphericalHarmonics, SphericalPolynomial } from '@babylonjs/core/Maths/sphericalPolynomial.js';
import '@babylonjs/core/Materials/Textures/baseTexture.polynomial.js';

/// A texture for scene.environmentTexture. `levels` is the number of levels of a chain that was baked
/// with --roughness linear, the default; leave it out if it was baked with --roughness babylon.
/// `harmonics` is the content of harmonics.json; without it Babylon.js projects level 0 itself.
export async function loadEnvironment(url, scene, { levels, harmonics } = {}) {
    const texture = await new Promise((resolve, reject) => {
        const loading = new CubeTexture(url, scene, {
            prefiltered: true,
            createPolynomials: harmonics === undefined,
            onLoad: () => resolve(loading),
            onError: (message) => reject(new Error(`${url}: ${message}`)),
        });
    });
    if (levels !== undefined) {
        texture.linearSpecularLOD = true; // level = log2(width) * roughness * lodGenerationScale
        texture.lodGenerationScale = (levels - 1) / Math.log2(texture.getSize().width);
    }
    if (harmonics !== undefined) texture.sphericalPolynomial = polynomialOf(harmonics);
    return texture;
}

/// Babylon.js has the same order of coefficients, and the opposite sign where the order m is odd.
function polynomialOf(harmonics) {
    const coefficients = harmonics.coefficients.slice(0, 9);
    const signs = [1, -1, 1, -1, 1, -1, 1, -1, 1];
    return SphericalPolynomial.FromHarmonics(SphericalHarmonics.FromArray(
        coefficients.map((colour, i) => colour.map((value) => signs[i] * value)),
    ));
}
