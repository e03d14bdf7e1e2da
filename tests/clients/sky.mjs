// A panorama without any symmetry, and its exact integrals: written from the formulas of
// lib/README.md, so that this side shares nothing with the library.
//
// Directions are those of the panorama: +z in its middle, +x to the right of it, +y up.

import { writeFileSync } from 'node:fs';

const width = 512;
const height = 256;

const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const normalized = (a) => a.map((x) => x / Math.hypot(...a));

export const sun = normalized([0.4, 0.5, -0.7]);

/// Red grows along +x, green along +y, blue along +z; a soft sun stands off all axes.
export function radiance(direction) {
    const glow = 20 * Math.exp(40 * (dot(direction, sun) - 1));
    return direction.map((component) => 1.2 + component + glow);
}

// Every texel: its direction, radiance and solid angle.
const texels = [];
for (let y = 0; y < height; ++y)
    for (let x = 0; x < width; ++x) {
        const theta = (Math.PI * (y + 0.5)) / height;
        const phi = (2 * Math.PI * (x + 0.5)) / width - Math.PI;
        const direction = [
            Math.sin(theta) * Math.sin(phi), Math.cos(theta), Math.sin(theta) * Math.cos(phi),
        ];
        const solidAngle = ((2 * Math.PI) / width) *
            (Math.cos((Math.PI * y) / height) - Math.cos((Math.PI * (y + 1)) / height));
        texels.push({ direction, solidAngle, light: radiance(direction) });
    }

/// Writes the panorama as PFM: floats, bottom row first.
export function writePanorama(path) {
    const floats = new Float32Array(3 * width * height);
    texels.forEach(({ light }, i) => {
        const row = height - 1 - Math.floor(i / width);
        floats.set(light, 3 * (row * width + (i % width)));
    });
    writeFileSync(path, Buffer.concat([
        Buffer.from(`PF\n${width} ${height}\n-1.0\n`), Buffer.from(floats.buffer),
    ]));
}

// The average of the light with weight(cosine to `axis`), summed over all texels.
function average(axis, weight) {
    const sum = [0, 0, 0];
    let norm = 0;
    for (const { direction, solidAngle, light } of texels) {
        const cosine = dot(direction, axis);
        if (cosine <= 0) continue;
        const w = weight(cosine) * solidAngle;
        norm += w;
        for (let c = 0; c < 3; ++c) sum[c] += w * light[c];
    }
    return sum.map((s) => s / norm);
}

/// What a reflection of that perceptual roughness returns: the light weighed by
/// D(cos(theta / 2)) cos(theta). Sums of one point a texel: for roughness 0.2 and above.
export function prefiltered(axis, perceptualRoughness) {
    const alpha2 = perceptualRoughness ** 4;
    return average(axis, (cosine) => {
        const cosineHalf2 = (1 + cosine) / 2;
        return cosine / (cosineHalf2 * (alpha2 - 1) + 1) ** 2;
    });
}

/// Irradiance / pi.
export const irradiance = (normal) => average(normal, (cosine) => cosine);
