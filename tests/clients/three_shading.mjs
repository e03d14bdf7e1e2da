// What MeshStandardMaterial of three 0.187 makes of light that is known exactly: its own table and
// formulas, from lights_physical_pars_fragment, lights_physical_fragment and envmap_physical_pars_fragment.
// White surfaces only.

import { DataUtils } from 'three';
import { getDFGLUT } from 'three/src/renderers/shaders/DFGLUTData.js';

import { irradiance, prefiltered } from './sky.mjs';
import { mixed, size, surfaceAt } from './spheres.mjs';

const table = getDFGLUT().image;

// A linear lookup, clamped to the edge.
function tableAt(perceptualRoughness, cosine) {
    const place = (value, count) => {
        const at = Math.min(Math.max(value * count - 0.5, 0), count - 1);
        const low = Math.min(Math.floor(at), count - 2);
        return [low, at - low];
    };
    const [x, right] = place(perceptualRoughness, table.width);
    const [y, down] = place(cosine, table.height);
    return [0, 1].map((channel) => {
        const texel = (i, j) => DataUtils.fromHalfFloat(table.data[2 * (j * table.width + i) + channel]);
        const row = (j) => texel(x, j) * (1 - right) + texel(x + 1, j) * right;
        return row(y) * (1 - down) + row(y + 1) * down;
    });
}

// three widens the roughness by how much the normal changes from pixel to pixel, along any axis of
// the camera.
function shadedRoughness(view, [x, y], perceptualRoughness) {
    const axes = [view.right, view.up, view.towards];
    const normalAt = (pixel) => surfaceAt(view, pixel).normal;
    const change = (a, b) =>
        Math.max(...axes.map((axis) =>
            Math.abs(axis.reduce((s, v, i) => s + v * (normalAt(a)[i] - normalAt(b)[i]), 0))));
    // Derivatives are taken within blocks of two by two pixels.
    const wider = Math.max(change([x | 1, y], [x & ~1, y]), change([x, y | 1], [x, y & ~1]));
    return Math.min(Math.max(perceptualRoughness, 0.045) + wider, 1);
}

/// The colour of a pixel of the sphere. `toPanorama` takes a direction of three's world into the panorama.
export function shaded(view, pixel, { metalness, roughness }, toPanorama) {
    const { normal, cosine, mirror } = surfaceAt(view, pixel);
    const r = shadedRoughness(view, pixel, roughness);
    const specular = prefiltered(toPanorama(mixed(mirror, normal, r ** 4)), r);
    const diffuse = irradiance(toPanorama(normal));
    const [slope, bias] = tableAt(r, cosine);
    const f0 = metalness === 1 ? 1 : 0.04;
    const single = f0 * slope + bias;
    const lost = 1 - (slope + bias);
    const average = f0 + (1 - f0) / 21;
    const multiple = (single * average * lost) / (1 - lost * average);
    const below = metalness === 1 ? 0 : 1 - single - multiple;
    return specular.map((light, c) => light * single + diffuse[c] * (multiple + below));
}
