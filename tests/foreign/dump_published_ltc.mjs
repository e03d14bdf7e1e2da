// Writes the tables that were published with Heitz et al. 2016, which three ships for its area
// lights, as they lie in memory: node dump_published_ltc.mjs FOLDER. Data to compare with, read at
// test time and never stored.

import fs from 'node:fs';
import path from 'node:path';

import { RectAreaLightTexturesLib } from 'three/addons/lights/RectAreaLightTexturesLib.js';

const folder = process.argv[2];
fs.mkdirSync(folder, { recursive: true });
RectAreaLightTexturesLib.init();
for (const [name, texture] of [
    ['ltc_1', RectAreaLightTexturesLib.LTC_FLOAT_1],
    ['ltc_2', RectAreaLightTexturesLib.LTC_FLOAT_2],
]) {
    const { width, height, data } = texture.image;
    if (width !== 64 || height !== 64 || data.length !== 4 * 64 * 64)
        throw new Error(`${name} is ${width} x ${height}, ${data.length} numbers`);
    fs.writeFileSync(path.join(folder, `${name}.f32`), new Float32Array(data));
}
