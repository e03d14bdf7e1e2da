// node translate.mjs IN.spv OUT.wgsl: SPIR-V without combined samplers to WGSL, by naga, the
// translator of wgpu.
import {readFileSync, writeFileSync} from 'node:fs';
import {NagaError, parseSpirv, validate, writeWgsl} from 'naga-wasm';

const [input, output] = process.argv.slice(2);
try {
    const module = parseSpirv(new Uint8Array(readFileSync(input)));
    const text = writeWgsl(module, validate(module));
    // SPIR-V names a function with its types, "splitsum_f0(vf3;f1;"; naga spells that out.
    writeFileSync(output, text.replace(/\b(\w+?)_u0028_\w*/g, '$1'));
} catch (error) {
    console.error(`${input}: ${error instanceof NagaError ? error.formatted : error}`);
    process.exitCode = 1;
}
