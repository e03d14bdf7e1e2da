// Our KTX 2 chain as scene.environment of three.js, in Chromium.

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';

import { openPage } from './browser.mjs';
import { radiance } from './sky.mjs';
import { errorsOf, grid, landmarks, size, views } from './spheres.mjs';
import { shaded } from './three_shading.mjs';

// The convention under test: which direction of the panorama three finds in a direction of its world.
const toPanorama = ([x, y, z]) => [-x, y, z];

let page;
before(async () => { page = await openPage('three_page.html'); });
after(() => page?.close());

const render = (file, view, surface, pixels) =>
    page.render({ url: `baked/${file}`, size, ...view, ...surface, pixels });

// The largest difference of any channel from the sky's own formula, at the landmarks of all views.
async function mirrorError(file, direction = toPanorama) {
    let worst = 0;
    for (const view of views.rightHanded) {
        const marks = landmarks(view);
        const found = await render(file, view, { metalness: 1, roughness: 0 },
            marks.map(({ pixel }) => pixel));
        marks.forEach((mark, i) => radiance(direction(mark.direction)).forEach((expected, c) => {
            worst = Math.max(worst, Math.abs(found[i][c] - expected));
        }));
    }
    return worst;
}

async function roughErrors(file, view, surface) {
    const pixels = grid();
    const expected = pixels.map((pixel) => shaded(view, pixel, surface, toPanorama));
    return errorsOf(await render(file, view, surface, pixels), expected);
}

// Landmarks are up to a pixel off (0.016 of a channel's range of 2) and three blurs its sharpest mirror to
// roughness 0.045: 0.034 measured.
const mirrorLimit = 0.05;

test('a mirror shows left on the left, up above, and what is behind the camera in the middle', async () => {
    for (const file of ['three.ktx2', 'three_zstd.ktx2', 'three_floats.ktx2'])
        assert.ok((await mirrorError(file)) < mirrorLimit, file);
});

test('every other convention would be noticed', async () => {
    for (const signs of [[1, 1, 1], [1, 1, -1], [-1, -1, 1], [-1, 1, -1], [1, -1, 1]])
        assert.ok((await mirrorError('three.ktx2', (d) => d.map((v, i) => signs[i] * v))) > 1, signs);
    assert.ok((await mirrorError('three.ktx2', ([x, y, z]) => [z, y, x])) > 1);
    assert.ok((await mirrorError('three_mirrored.ktx2')) > 1);
});

// Measured over both views, mean and worst: 0.0044 and 0.070. The rest is what a linear filter loses
// between texels and levels beside a sun.
const surfaces = [
    { metalness: 1, roughness: 0.3675 },
    { metalness: 1, roughness: 0.5528 },
    { metalness: 1, roughness: 1 },
    { metalness: 0, roughness: 0.5 },
];
for (const surface of surfaces)
    test(`metalness ${surface.metalness}, roughness ${surface.roughness}: exact integrals in the formulas of three`, async () => {
        for (const view of views.rightHanded.slice(0, 2)) {
            const errors = await roughErrors('three.ktx2', view, surface);
            assert.ok(errors.count > 300);
            assert.ok(errors.mean < 0.007, JSON.stringify(errors));
            assert.ok(errors.worst < 0.11, JSON.stringify(errors));
            assert.ok(Math.abs(errors.bias) < 0.004, JSON.stringify(errors));
        }
    });

test('a chain of another curve would be noticed', async () => {
    const errors = await roughErrors('linear.ktx2', views.rightHanded[1], surfaces[1]);
    assert.ok(errors.mean > 0.02, JSON.stringify(errors));
});

test('the page complained about nothing', () => assert.deepEqual(page.problems, []));
