// KTX 2 files as three's KTX2Loader hands them to a renderer. Its path for uncompressed formats needs
// neither a GPU nor a DOM; a cube comes as a DataTexture whose mipmaps hold six faces each.

import assert from 'node:assert/strict';
import { test } from 'node:test';

import {
    FloatType, HalfFloatType, LinearSRGBColorSpace, RGBAFormat, RGBFormat, RGFormat,
    UnsignedInt101111Type, UnsignedInt5999Type,
} from 'three';
import { KTX2Loader } from 'three/addons/loaders/KTX2Loader.js';

import {
    bytesOf, cubeFormats, eachCubeTexel, eachTableTexel, faceSize, levelCount, table, tableFormats,
} from './samples.mjs';

const loader = new KTX2Loader();
loader.detectSupport({ extensions: { has: () => false } });

const load = (name) =>
    new Promise((resolve, reject) => loader.parse(bytesOf(name).buffer, resolve, reject));

const kinds = {
    rgba16f: { format: RGBAFormat, type: HalfFloatType },
    rgba32f: { format: RGBAFormat, type: FloatType },
    rgb9e5: { format: RGBFormat, type: UnsignedInt5999Type },
    b10g11r11: { format: RGBFormat, type: UnsignedInt101111Type },
    rg16f: { format: RGFormat, type: HalfFloatType },
    rg32f: { format: RGFormat, type: FloatType },
};

const bytesIn = (data) => new Uint8Array(data.buffer, data.byteOffset, data.byteLength);

function checkKind(texture, name) {
    assert.equal(texture.format, kinds[name].format);
    assert.equal(texture.type, kinds[name].type);
    assert.equal(texture.generateMipmaps, false);
}

for (const suffix of ['.ktx2', '.zstd.ktx2']) {
    for (const { name } of cubeFormats)
        test(`cube_${name}${suffix}`, async () => {
            const texture = await load(`cube_${name}${suffix}`);
            checkKind(texture, name);
            assert.equal(texture.colorSpace, LinearSRGBColorSpace);
            assert.equal(texture.mipmaps.length, levelCount);
            texture.mipmaps.forEach((mipmap, level) => {
                assert.equal(mipmap.width, faceSize >> level);
                assert.equal(mipmap.height, faceSize >> level);
                eachCubeTexel(name, level, bytesIn(mipmap.data), assert.deepEqual);
            });
        });

    // The loader of three knows no two-channel unorms.
    for (const { name } of tableFormats.filter((format) => format.name !== 'rg16unorm'))
        test(`table_${name}${suffix}`, async () => {
            const texture = await load(`table_${name}${suffix}`);
            checkKind(texture, name);
            assert.equal(texture.image.width, table.width);
            assert.equal(texture.image.height, table.height);
            eachTableTexel(name, bytesIn(texture.mipmaps[0].data), assert.deepEqual);
        });
}
