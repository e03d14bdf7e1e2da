// Bakes what the tests beside this file load: node bake.mjs FOLDER_OF_THE_PROGRAMS.

import { execFileSync } from 'node:child_process';
import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';

import { writePanorama } from './sky.mjs';

const programs = process.argv[2];
const folder = fileURLToPath(new URL('./baked/', import.meta.url));

const run = (program, output, ...options) =>
    execFileSync(join(programs, program),
        [join(folder, 'sky.pfm'), '-o', join(folder, output), '--no-verify', '--quiet', ...options],
        { stdio: ['ignore', 'ignore', 'inherit'] });

mkdirSync(folder, { recursive: true });
writePanorama(join(folder, 'sky.pfm'));
const chain = ['--size', '256', '--levels', '6'];
run('splitsum-specular', 'three.ktx2', ...chain, '--roughness', 'filament');
run('splitsum-specular', 'three_mirrored.ktx2', ...chain, '--roughness', 'filament', '--mirror');
run('splitsum-specular', 'three_zstd.ktx2', ...chain, '--roughness', 'filament', '--zstd');
run('splitsum-specular', 'three_floats.ktx2', ...chain, '--roughness', 'filament', '--format', 'rgba32f');
run('splitsum-specular', 'linear.ktx2', ...chain);
run('splitsum-specular', 'linear.dds', ...chain);
run('splitsum-specular', 'linear_mirrored.dds', ...chain, '--mirror');
run('splitsum-specular', 'babylon.dds', '--size', '256', '--levels', '9', '--roughness', 'babylon');
run('splitsum-specular', 'floats.dds', '--size', '16', '--levels', '3', '--format', 'rgba32f');
run('splitsum-specular', 'floats.ktx2', '--size', '16', '--levels', '3', '--format', 'rgba32f');
run('splitsum-irradiance', 'harmonics.json');
