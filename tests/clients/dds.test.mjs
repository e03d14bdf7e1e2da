// Our DDS files, read by the loader of Babylon.js without a browser: the same texels as in the KTX 2
// files of the same bake, which ktx-parse reads.

import assert from 'node:assert/strict';
import { execFileSync, spawnSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';

import { DDSTools } from '@babylonjs/core/Misc/dds.pure.js';
import { read } from 'ktx-parse';

const pathOf = (name) => fileURLToPath(new URL(`./baked/${name}`, import.meta.url));
const bytesOf = (name) => new Uint8Array(readFileSync(pathOf(name)));

// What the loader hands to the engine: the texels of each face and level.
function uploadsOf(bytes) {
    const uploads = [];
    const capabilities = {
        textureFloat: true, textureFloatLinearFiltering: true,
        textureHalfFloat: true, textureHalfFloatLinearFiltering: true,
    };
    const engine = {
        getCaps: () => capabilities,
        _getRGBABufferInternalSizedFormat() {},
        _uploadDataToTextureDirectly: (texture, data, face, level) =>
            uploads.push({ data, face, level, width: texture.width }),
    };
    const info = DDSTools.GetDDSInfo(bytes);
    DDSTools.UploadDDSLevels(engine, {}, bytes, info, true, 6);
    return { info, uploads };
}

for (const [name, size, levels, Values] of [
    ['linear', 256, 6, Uint16Array], ['floats', 16, 3, Float32Array],
])
    test(`${name}.dds has the texels of ${name}.ktx2`, () => {
        const { info, uploads } = uploadsOf(bytesOf(`${name}.dds`));
        assert.deepEqual([info.width, info.height, info.mipmapCount], [size, size, levels]);
        assert.ok(info.isCube && info.isFourCC && !info.isCompressed);
        assert.equal(uploads.length, 6 * levels);

        const stored = read(bytesOf(`${name}.ktx2`));
        assert.equal(stored.levels.length, levels);
        for (const { data, face, level } of uploads) {
            const bytes = stored.levels[level].levelData;
            const length = bytes.byteLength / 6;
            const expected = new Values(bytes.slice(face * length, (face + 1) * length).buffer);
            assert.ok(data instanceof Values);
            assert.deepEqual(data, expected, `face ${face} level ${level}`);
        }
    });

test('who writes a file without metadata is told so', () => {
    const bake = (name) =>
        execFileSync(`${process.env.SPLITSUM_BIN}/splitsum-specular`,
            [pathOf('sky.pfm'), '-o', pathOf(name), '--size', '16', '--levels', '3', '--quiet'],
            { encoding: 'utf8' });
    assert.match(bake('noted.dds'), /^note: \.dds files keep no metadata/m);
    assert.doesNotMatch(bake('noted.ktx2'), /^note:/m);
});

test('a file without metadata must be told what it is', () => {
    const compare = (...options) =>
        spawnSync(`${process.env.SPLITSUM_BIN}/splitsum-compare`,
            [pathOf('linear.dds'), '--quiet', '--probes', '8', ...options], { encoding: 'utf8' });
    const alone = compare();
    assert.equal(alone.status, 5, alone.stderr);
    assert.match(alone.stderr, /--as specular/);
    const measured = compare('--as', 'specular', '--panorama', pathOf('sky.pfm'), '--limit', 'rel_rms=1e-3');
    assert.equal(measured.status, 0, measured.stdout + measured.stderr);
    assert.equal(compare('--as', 'specular', '--roughness', 'filament', '--panorama', pathOf('sky.pfm'),
        '--limit', 'rel_rms=1e-3').status, 1);
});
