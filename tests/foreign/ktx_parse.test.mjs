// KTX 2 files as ktx-parse 2 reads them: header, descriptor, keys, and the texels of every level.

import assert from 'node:assert/strict';
import { test } from 'node:test';

import { read } from 'ktx-parse';
import { ZSTDDecoder } from 'three/addons/libs/zstddec.module.js';

import {
    bytesOf, cubeFormats, eachCubeTexel, eachTableTexel, faceSize, levelCount, table, tableFormats,
} from './samples.mjs';

const zstd = new ZSTDDecoder();
await zstd.init();

const FLOAT = 128, SIGNED = 64, EXPONENT = 32;
const ONE = 0x3f800000, MINUS_ONE = 0xbf800000;
const signedFloat = (channel, bitOffset, bits) =>
    ({ channelType: channel | FLOAT | SIGNED, bitOffset, bits, lower: MINUS_ONE, upper: ONE });
const unsignedFloat = (channel, bitOffset, bits) =>
    ({ channelType: channel | FLOAT, bitOffset, bits, lower: 0, upper: ONE });
const sharedExponent = (channel, bitOffset) => [
    { channelType: channel, bitOffset, bits: 9, lower: 0, upper: 8448 },
    { channelType: channel | EXPONENT, bitOffset: 27, bits: 5, lower: 15, upper: 31 },
];

const descriptors = {
    rgba16f: [0, 1, 2, 15].map((channel, i) => signedFloat(channel, 16 * i, 16)),
    rgba32f: [0, 1, 2, 15].map((channel, i) => signedFloat(channel, 32 * i, 32)),
    rg16f: [0, 1].map((channel, i) => signedFloat(channel, 16 * i, 16)),
    rg32f: [0, 1].map((channel, i) => signedFloat(channel, 32 * i, 32)),
    rg16unorm: [0, 1].map((channel) => ({
        bitOffset: 16 * channel,
        bits: 16,
        channelType: channel,
        lower: 0,
        upper: 65535,
    })),
    b10g11r11: [unsignedFloat(0, 0, 11), unsignedFloat(1, 11, 11), unsignedFloat(2, 22, 10)],
    rgb9e5: [0, 1, 2].flatMap((channel) => sharedExponent(channel, 9 * channel)),
};

function checkDescriptor(container, format, supercompressed) {
    assert.equal(container.dataFormatDescriptor.length, 1);
    const [descriptor] = container.dataFormatDescriptor;
    assert.equal(descriptor.vendorId, 0);
    assert.equal(descriptor.descriptorType, 0);
    assert.equal(descriptor.versionNumber, 2);
    assert.equal(descriptor.colorModel, 1, 'RGBSDA');
    assert.equal(descriptor.colorPrimaries, 1, 'BT.709');
    assert.equal(descriptor.transferFunction, 1, 'linear');
    assert.equal(descriptor.bytesPlane[0], supercompressed ? 0 : format.texelBytes);
    // ktx-parse hands out the stored bit length, which is one less, and signed limits.
    const samples = descriptor.samples.map((sample) => ({
        channelType: sample.channelType, bitOffset: sample.bitOffset, bits: sample.bitLength + 1,
        lower: sample.sampleLower >>> 0, upper: sample.sampleUpper >>> 0,
    }));
    assert.deepEqual(samples, descriptors[format.name]);
}

// Values of keys that the specification does not name are bytes to ktx-parse; ours end with a NUL.
function text(value) {
    if (typeof value === 'string') return value;
    assert.equal(value.at(-1), 0);
    return new TextDecoder().decode(value.subarray(0, -1));
}

function checkKeys(keyValue) {
    const expected = {
        'splitsum.convention': 'ktx',
        'splitsum.empty': '',
        'splitsum.roughness': '0 0.25 0.5 1',
        'splitsum.source': 'a sky named été',
        KTXorientation: 'rd',
    };
    for (const [key, value] of Object.entries(expected)) assert.equal(text(keyValue[key]), value);
    assert.match(text(keyValue.KTXwriter), /^splitsum \d/);
    assert.equal(Object.keys(keyValue).length, Object.keys(expected).length + 1);
}

function levelBytes(container, level) {
    const { levelData, uncompressedByteLength } = container.levels[level];
    if (container.supercompressionScheme === 0) return levelData;
    assert.equal(container.supercompressionScheme, 2);
    return zstd.decode(levelData, uncompressedByteLength);
}

for (const suffix of ['.ktx2', '.zstd.ktx2']) {
    const supercompressed = suffix === '.zstd.ktx2';

    for (const format of cubeFormats)
        test(`cube_${format.name}${suffix}`, () => {
            const container = read(bytesOf(`cube_${format.name}${suffix}`));
            assert.equal(container.vkFormat, format.vkFormat);
            assert.equal(container.typeSize, format.typeSize);
            assert.equal(container.pixelWidth, faceSize);
            assert.equal(container.pixelHeight, faceSize);
            assert.equal(container.pixelDepth, 0);
            assert.equal(container.layerCount, 0);
            assert.equal(container.faceCount, 6);
            assert.equal(container.levelCount, levelCount);
            assert.equal(container.supercompressionScheme, supercompressed ? 2 : 0);
            assert.equal(container.globalData, null);
            checkDescriptor(container, format, supercompressed);

            checkKeys(container.keyValue);

            assert.equal(container.levels.length, levelCount);
            for (let level = 0; level < levelCount; ++level) {
                const bytes = levelBytes(container, level);
                const texels = eachCubeTexel(format.name, level, bytes, assert.deepEqual);
                assert.equal(bytes.byteLength, texels * format.texelBytes);
                assert.equal(container.levels[level].uncompressedByteLength, bytes.byteLength);
            }
        });

    for (const format of tableFormats)
        test(`table_${format.name}${suffix}`, () => {
            const container = read(bytesOf(`table_${format.name}${suffix}`));
            assert.equal(container.vkFormat, format.vkFormat);
            assert.equal(container.typeSize, format.typeSize);
            assert.equal(container.pixelWidth, table.width);
            assert.equal(container.pixelHeight, table.height);
            assert.equal(container.faceCount, 1);
            assert.equal(container.levels.length, 1);
            checkDescriptor(container, format, supercompressed);
            eachTableTexel(format.name, levelBytes(container, 0), assert.deepEqual);
        });
}
