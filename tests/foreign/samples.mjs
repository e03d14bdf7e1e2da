// What write_samples wrote, and how to read its texels: decoders of the stored formats written from
// their specifications, so that this side shares nothing with the library.

import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';

export const folder = fileURLToPath(new URL('./samples/', import.meta.url));
export const bytesOf = (name) => new Uint8Array(readFileSync(folder + name));

export const cubeFormats = [
    { name: 'rgba16f', vkFormat: 97, typeSize: 2, texelBytes: 8 },
    { name: 'rgba32f', vkFormat: 109, typeSize: 4, texelBytes: 16 },
    { name: 'rgb9e5', vkFormat: 123, typeSize: 4, texelBytes: 4 },
    { name: 'b10g11r11', vkFormat: 122, typeSize: 4, texelBytes: 4 },
];
export const tableFormats = [
    { name: 'rg16f', vkFormat: 83, typeSize: 2, texelBytes: 4 },
    { name: 'rg32f', vkFormat: 103, typeSize: 4, texelBytes: 8 },
    { name: 'rg16unorm', vkFormat: 77, typeSize: 2, texelBytes: 4 },
];

export const faceSize = 8;
export const levelCount = 4;
export const table = { width: 5, height: 3 };

// The texels of sample_textures.h.
export const cubeTexel = (level, face, x, y) => [face + 1, x + 1, y + 1 + 16 * level];
export const tableTexel = (x, y) => [x + 1, 10 * (y + 1)];
// rg16unorm ends at 1: there the texels are divided by 64, and compared in 65535ths.
const unorm = (value) => Math.round((value / 64) * 65535);

// A float of 5 exponent bits with bias 15 and `mantissaBits` mantissa bits, without sign.
function smallFloat(bits, mantissaBits) {
    const exponent = bits >>> mantissaBits;
    const mantissa = bits & ((1 << mantissaBits) - 1);
    const fraction = mantissa / 2 ** mantissaBits;
    return exponent === 0 ? fraction * 2 ** -14 : (1 + fraction) * 2 ** (exponent - 15);
}

export const half = (bits) => (bits & 0x8000 ? -1 : 1) * smallFloat(bits & 0x7fff, 10);

const view = (bytes) => new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
const halfs = (count) => (bytes, i) =>
    Array.from({ length: count }, (_, c) => half(view(bytes).getUint16(2 * (count * i + c), true)));
const floats = (count) => (bytes, i) =>
    Array.from({ length: count }, (_, c) => view(bytes).getFloat32(4 * (count * i + c), true));

/// Channel values of texel `i` of a level's bytes, by format name.
export const texelOf = {
    rgba16f: halfs(4),
    rgba32f: floats(4),
    rg16f: halfs(2),
    rg32f: floats(2),
    rg16unorm: (bytes, i) =>
        [0, 1].map((c) => view(bytes).getUint16(2 * (2 * i + c), true)),
    rgb9e5: (bytes, i) => {
        const bits = view(bytes).getUint32(4 * i, true);
        const unit = 2 ** ((bits >>> 27) - 15 - 9);
        return [bits & 511, (bits >>> 9) & 511, (bits >>> 18) & 511].map((m) => m * unit);
    },
    b10g11r11: (bytes, i) => {
        const bits = view(bytes).getUint32(4 * i, true);
        return [
            smallFloat(bits & 0x7ff, 6),
            smallFloat((bits >>> 11) & 0x7ff, 6),
            smallFloat(bits >>> 22, 5),
        ];
    },
};

/// Calls check(found, expected, place) for every texel of a cube level.
export function eachCubeTexel(format, level, bytes, check) {
    const size = Math.max(1, faceSize >> level);
    for (let face = 0; face < 6; ++face)
        for (let y = 0; y < size; ++y)
            for (let x = 0; x < size; ++x) {
                const found = texelOf[format](bytes, (face * size + y) * size + x);
                const expected = cubeTexel(level, face, x, y);
                if (found.length === 4) expected.push(1);
                check(found, expected, `level ${level} face ${face} x ${x} y ${y}`);
            }
    return 6 * size * size;
}

/// Calls check(found, expected, place) for every texel of the table.
export function eachTableTexel(format, bytes, check) {
    for (let y = 0; y < table.height; ++y)
        for (let x = 0; x < table.width; ++x)
            check(
                texelOf[format](bytes, y * table.width + x),
                format === 'rg16unorm' ? tableTexel(x, y).map(unorm) : tableTexel(x, y),
                `x ${x} y ${y}`,
            );
}
