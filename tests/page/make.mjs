// Pages and pictures of the same light by splitsum-preview, made when a test asks for them.

import { execFile } from 'node:child_process';
import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { promisify } from 'node:util';

import { readPng } from './png.mjs';

const programs = process.env.SPLITSUM_BIN;
const panoramas = process.env.SPLITSUM_PANORAMAS;

/// The folder for all that is made.
export const folder = fileURLToPath(new URL('./made/', import.meta.url));
mkdirSync(folder, { recursive: true });

const execute = promisify(execFile);
const run = (program, ...options) => execute(join(programs, program), [...options.map(String), '--quiet']);

export const panorama = (name) => join(panoramas, `${name}.exr`);

/// The folder of a panorama's assets. Each combination of options needs a `name` of its own.
export async function baked(name, of, ...options) {
    const place = join(folder, name);
    await run('splitsum-bake', panorama(of), '-o', place, '--no-verify', ...options);
    return join(place, of);
}

/// Writes `name`.html and `name`.png of assets; { url, picture } of them.
export async function preview(name, assets, ...options) {
    const [png, html] = [join(folder, `${name}.png`), join(folder, `${name}.html`)];
    await run('splitsum-preview', assets, '-o', png, '--html', html, ...options);
    return { url: pathToFileURL(html).href, picture: readPng(png) };
}

/// The picture alone.
export async function picture(name, assets, ...options) {
    const png = join(folder, `${name}.png`);
    await run('splitsum-preview', assets, '-o', png, ...options);
    return readPng(png);
}
