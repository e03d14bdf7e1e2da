// Reads the PNG files of our programs: 8-bit RGB, not interlaced (PNG specification, third edition, 2025).

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { inflateSync } from 'node:zlib';

function* chunks(file) {
    for (let at = 8; at < file.length;) {
        const length = file.readUInt32BE(at);
        yield { type: file.toString('latin1', at + 4, at + 8), data: file.subarray(at + 8, at + 8 + length) };
        at += 12 + length;
    }
}

function paeth(left, up, upLeft) {
    const guess = left + up - upLeft;
    const [a, b, c] = [left, up, upLeft].map((value) => Math.abs(guess - value));
    if (a <= b && a <= c) return left;
    return b <= c ? up : upLeft;
}

const predictions = [
    () => 0,
    (left) => left,
    (left, up) => up,
    (left, up) => Math.floor((left + up) / 2),
    paeth,
];

/// { width, height, rgb }, row 0 at the top.
export function readPng(path) {
    const found = [...chunks(readFileSync(path))];
    const header = found.find(({ type }) => type === 'IHDR').data;
    assert.deepEqual([...header.subarray(8)], [8, 2, 0, 0, 0], path);
    const [width, height] = [header.readUInt32BE(0), header.readUInt32BE(4)];
    const rows = inflateSync(Buffer.concat(found.filter(({ type }) => type === 'IDAT').map(({ data }) => data)));
    const rgb = new Uint8Array(3 * width * height);
    const at = (x, y) => (x < 0 || y < 0 ? 0 : rgb[3 * width * y + x]);
    for (let y = 0; y < height; ++y) {
        const predict = predictions[rows[(3 * width + 1) * y]];
        for (let x = 0; x < 3 * width; ++x)
            rgb[3 * width * y + x] = rows[(3 * width + 1) * y + 1 + x] +
                predict(at(x - 3, y), at(x, y - 1), x < 3 ? 0 : at(x - 3, y - 1));
    }
    return { width, height, rgb };
}
