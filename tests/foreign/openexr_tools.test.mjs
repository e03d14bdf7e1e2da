// EXR files as OpenEXR's own programs read them (Debian package openexr), and three's EXRLoader.

import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';

import { FloatType } from 'three';
import { EXRLoader } from 'three/addons/loaders/EXRLoader.js';

import { cubeTexel, faceSize, folder } from './samples.mjs';

const run = (program, ...args) => execFileSync(program, args, { encoding: 'utf8' });
const scratch = mkdtempSync(join(tmpdir(), 'splitsum-exr-'));
process.on('exit', () => rmSync(scratch, { recursive: true }));

/// The pixels of an EXR file's largest level: pixel(x, y) with row 0 on top.
function readExr(path) {
    const { width, height, data } = new EXRLoader().setDataType(FloatType).parse(
        new Uint8Array(readFileSync(path)).buffer);
    const pixel = (x, y) => {
        const at = 4 * ((height - 1 - y) * width + x);  // three keeps rows bottom up
        return Array.from(data.subarray(at, at + 3));
    };
    return { width, height, pixel };
}

for (const [format, type] of [['rgba16f', '16-bit'], ['rgba32f', '32-bit']])
    test(`exrheader knows cube_${format}.exr`, () => {
        const header = run('exrheader', `${folder}cube_${format}.exr`);
        assert.match(header, /envmap \(type envmap\): cube-face map/);
        assert.match(header, /tiles \(type tiledesc\):\s+mip-map/);
        assert.match(header, /level sizes rounded down/);
        assert.match(header, /dataWindow \(type box2i\): \(0 0\) - \(7 47\)/);
        for (const channel of ['R', 'G', 'B'])
            assert.match(header, new RegExp(`^ +${channel}, ${type} floating-point`, 'm'));
        assert.doesNotMatch(header, /^ +A, /m);
        assert.match(header, /splitsum\.roughness \(type string\): "0 0\.25 0\.5 1"/);
    });

test('exrheader knows table_rg16f.exr', () => {
    const header = run('exrheader', `${folder}table_rg16f.exr`);
    assert.match(header, /dataWindow \(type box2i\): \(0 0\) - \(4 2\)/);
    assert.match(header, /splitsum\.table \(type string\): "split sum"/);
    assert.doesNotMatch(header, /envmap/);
});

test('exrinfo accepts every file', () => {
    for (const name of ['cube_rgba16f', 'cube_rgba32f', 'direction', 'table_rg16f'])
        assert.match(run('exrinfo', '-s', `${folder}${name}.exr`), /compression: 'zip'/);
});

test('exrmakepreview reads the cube', () => {
    const preview = join(scratch, 'preview.exr');
    run('exrmakepreview', `${folder}direction.exr`, preview);
    assert.match(run('exrheader', preview), /preview \(type preview\)/);
});

// exrenvmap looks the sky up through OpenEXR's cube map functions; the colour of a texel is its
// direction. Half a texel of placement and its antialiasing filter cost 0.008; a face turned the wrong way
// costs up to 2.
test('exrenvmap finds each direction where OpenEXR puts it', () => {
    const panorama = join(scratch, 'panorama.exr');
    run('exrenvmap', '-l', '-w', '128', `${folder}direction.exr`, panorama);
    const { width, height, pixel } = readExr(panorama);
    assert.deepEqual([width, height], [128, 64]);
    let worst = 0;
    for (let y = 0; y < height; ++y)
        for (let x = 0; x < width; ++x) {
            const latitude = Math.PI * (0.5 - y / (height - 1));
            const longitude = Math.PI * (1 - 2 * (x / (width - 1)));
            const direction = [Math.sin(longitude) * Math.cos(latitude), Math.sin(latitude),
                Math.cos(longitude) * Math.cos(latitude)];
            pixel(x, y).forEach((value, c) => {
                worst = Math.max(worst, Math.abs(2 * (value - 1.5) - direction[c]));
            });
        }
    assert.ok(worst < 0.02, `worst component ${worst}`);
});

test("three's EXRLoader reads the largest level texel by texel", () => {
    for (const format of ['rgba16f', 'rgba32f']) {
        const { width, height, pixel } = readExr(`${folder}cube_${format}.exr`);
        assert.deepEqual([width, height], [faceSize, 6 * faceSize]);
        for (let face = 0; face < 6; ++face)
            for (let y = 0; y < faceSize; ++y)
                for (let x = 0; x < faceSize; ++x) {
                    const upsideDown = face === 2 || face === 3;
                    const [atX, atY] = upsideDown
                        ? [x, faceSize - 1 - y] : [faceSize - 1 - x, y];
                    assert.deepEqual(pixel(atX, face * faceSize + atY), cubeTexel(0, face, x, y));
                }
    }
});
