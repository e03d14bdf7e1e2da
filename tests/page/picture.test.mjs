// The page's pixels beside those of splitsum-preview, which shades on the CPU.

import assert from 'node:assert/strict';
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';

import { baked, folder, panorama, picture, preview } from './make.mjs';
import { openBrowser } from '../browser.mjs';
import { difference, openFile, pixelsOf } from './tab.mjs';

const size = { width: 512, height: 256 };
const sizeOption = ['--size', `${size.width}x${size.height}`];

// The promise is a mean of 1/255 and 4/255 for the worst 1 % of the pixels. Measured on SwiftShader:
// formulas 1.6e-4 and 0; ACES, which the page reads from a table of 32³ colours, 0.33 and 2.
const limits = {
    srgb: { mean: 0.01, worstPercent: 1 },
    filmic: { mean: 0.01, worstPercent: 1 },
    aces: { mean: 0.5, worstPercent: 3 },
};
// The truth travels as half floats, which costs 0.028 and 1 through the clipped view.
const halfFloats = { mean: 0.05, worstPercent: 1 };

// Each is stored in another way, and read by another curve.
const lights = [
    { of: 'sunset', stored: ['--format', 'rgba16f', '--roughness', 'filament'] },
    { of: 'studio', stored: ['--format', 'rgb9e5'] },
    { of: 'lopsided', stored: ['--format', 'b10g11r11', '--levels', '5', '--roughness', '0,0.1,0.3,0.6,1'] },
];
const cases = [{ yaw: 0, pitch: 0 }, { yaw: -130, pitch: 35 }].flatMap((orbit) =>
    Object.keys(limits).map((view) => ({ ...orbit, view })));

let browser;
before(async () => { browser = await openBrowser(); });
after(() => browser?.close());

function assertNear(found, expected, { mean, worstPercent }) {
    const off = difference(found, expected);
    assert.ok(off.mean <= mean && off.worstPercent <= worstPercent, JSON.stringify(off));
}

for (const { of, stored } of lights)
    test(`${of}: every view from two sides, ${stored[1]}`, async () => {
        const assets = await baked(`picture_${of}`, of, ...stored);
        const { url } = await preview(`picture_${of}`, assets, ...sizeOption);
        const { tab, problems, close } = await openFile(browser, url);
        await Promise.all(cases.map(async (state, i) => {
            const expected = await picture(`picture_${of}_${i}`, assets, ...sizeOption, '--yaw', state.yaw,
                '--pitch', state.pitch, '--view', state.view);
            assertNear(await pixelsOf(tab, { ...size, ...state }), expected, limits[state.view]);
        }));
        assert.deepEqual(problems, []);
        await close();
    });

test('objects of a file, their names, another exposure, and no background', async () => {
    const assets = await baked('picture_file', 'lopsided');
    const name = '</script><script>alert(1)</script> & "\u00fc" {{facts}} <!-- <script>';
    const scene = join(folder, 'picture_scene.json');
    writeFileSync(scene, JSON.stringify({
        spheres: [
            { name, centre: [0.4, 0.3, 1], radius: 0.8, base_color: [0.2, 0.9, 0.4], metalness: 0.3, perceptual_roughness: 0.13 },
            { centre: [-0.6, -0.4, 0.2], radius: 0.5, base_color: [0.9, 0.3, 0.1], metalness: 1, perceptual_roughness: 0.45 },
            { centre: [0.2, -0.1, -1.5], radius: 0.3 },
        ],
    }));
    const options = ['--scene', scene, '--size', '256x320', '--exposure', '1.5', '--no-background', '--view', 'filmic', '--yaw', '75'];
    const { url, picture: expected } = await preview('picture_file', assets, ...options,
        '--panorama', panorama('lopsided'), '--truth', '--noise', '0.3', '--probes', '1');
    const { tab, problems, close } = await openFile(browser, url);
    const found = await pixelsOf(tab, { width: 256, height: 320 });
    const bakedPart = { width: 256, height: 320, rgb: expected.rgb.subarray(0, found.rgb.length) };
    assertNear(found, bakedPart, limits.filmic);
    assert.ok(await tab.getByText(name, { exact: true }).isVisible());
    assert.deepEqual(problems, []);
    await close();
});

test('one sphere is that of a file with one', async () => {
    const assets = await baked('picture_one', 'studio');
    const scene = join(folder, 'picture_one.json');
    // #d4af37 is [0.658, 0.428, 0.0382] in linear light (IEC 61966-2-1).
    writeFileSync(scene, JSON.stringify({
        spheres: [{ centre: [0, 0, 0], base_color: [0.65837482, 0.42869050, 0.03820437], metalness: 0.8, perceptual_roughness: 0.35 }],
    }));
    const expected = await picture('picture_one_cpu', assets, ...sizeOption, '--scene', scene, '--view', 'srgb');
    const { url } = await preview('picture_one', assets);
    const { tab, close } = await openFile(browser, url);
    const found = await pixelsOf(tab, {
        ...size, view: 'srgb', object: 'sphere', color: 'd4af37', metalness: 0.8, perceptual_roughness: 0.35,
    });
    assertNear(found, expected, limits.srgb);
    await close();
});

// splitsum-preview draws baked light, the truth and the difference below each other.
test('the truth and the difference are those of the picture', async () => {
    const assets = await baked('picture_truth', 'sunset');
    const { url, picture: three } = await preview('picture_truth', assets, ...sizeOption, '--view', 'srgb',
        '--panorama', panorama('sunset'), '--truth', '--noise', '0.1', '--probes', '1', '--yaw', '-40');
    const { tab, problems, close } = await openFile(browser, url);
    const part = (index) => {
        const bytes = 3 * size.width * size.height;
        return { ...size, rgb: three.rgb.subarray(index * bytes, (index + 1) * bytes) };
    };
    const leftHalf = ({ rgb }) => {
        const kept = [];
        for (let y = 0; y < size.height; ++y)
            kept.push(rgb.subarray(3 * size.width * y, 3 * (size.width * y + size.width / 2)));
        return { width: size.width / 2, height: size.height, rgb: Buffer.concat(kept) };
    };
    const states = { truth: { compare: 'split', split: 0 }, both: { compare: 'split', split: 0.5 }, difference: { compare: 'difference' } };
    const found = {};
    for (const [name, state] of Object.entries(states))
        found[name] = await pixelsOf(tab, { ...size, ...state });
    assertNear(found.truth, part(1), halfFloats);
    assertNear(found.difference, part(2), halfFloats);
    assertNear(leftHalf(found.both), leftHalf(part(0)), limits.srgb);
    assert.ok(difference(found.both, part(0)).mean > 1, 'the right half is the truth');
    assert.deepEqual(problems, []);
    await close();
});

test('turned the other way, another level or another view would be noticed', async () => {
    const assets = await baked('picture_wrong', 'lopsided');
    const expected = await picture('picture_wrong_cpu', assets, ...sizeOption, '--yaw', '25', '--view', 'filmic');
    const { url } = await preview('picture_wrong', assets);
    const { tab, close } = await openFile(browser, url);
    const state = { ...size, yaw: 25, view: 'filmic' };
    assertNear(await pixelsOf(tab, state), expected, limits.filmic);
    for (const wrong of [{ yaw: -25 }, { yaw: 25.3 }, { background: 'level-1' }, { view: 'aces' }, { exposure: 1.2 }, { show: 'level-2' }]) {
        const found = await pixelsOf(tab, { ...state, ...wrong });
        assert.throws(() => assertNear(found, expected, limits.filmic), assert.AssertionError, JSON.stringify(wrong));
    }
    await close();
});
