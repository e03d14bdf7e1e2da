// write_captures.mjs FOLDER NAME...: writes NAME.exr for each capture. The package holds them as
// modules whose default export is a data URL.

import { mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';

const [folder, ...names] = process.argv.slice(2);
mkdirSync(folder, { recursive: true });
for (const name of names) {
    const { default: url } = await import(`@pmndrs/assets/hdri/${name}.exr.js`);
    const [kind, base64] = url.split(',');
    if (!kind.endsWith(';base64')) throw new Error(`${name}: expected base64, found ${kind}`);
    writeFileSync(join(folder, `${name}.exr`), Buffer.from(base64, 'base64'));
}
