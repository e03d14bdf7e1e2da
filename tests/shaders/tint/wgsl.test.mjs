// Tint, the compiler of Chromium's WebGPU, takes the translations to WGSL, links each fragment shader
// with the vertex shader, and notices an error. Dawn's null backend needs no device.
import assert from 'node:assert/strict';
import {readdirSync, readFileSync} from 'node:fs';
import {after, before, test} from 'node:test';
import {create, globals} from 'webgpu';

Object.assign(globalThis, globals);
const folder = process.env.SPLITSUM_WGSL_FOLDER;
const shaders = readdirSync(folder).filter(name => name.endsWith('.wgsl'));
let gpu, device;

before(async () => {
    gpu = create(['backend=null']);
    device = await (await gpu.requestAdapter()).requestDevice();
});
after(() => device.destroy());

async function checked(make) {
    device.pushErrorScope('validation');
    const made = make();
    const error = await device.popErrorScope();
    assert.equal(error, null, error?.message);
    return made;
}

const module = name =>
    checked(() => device.createShaderModule({code: readFileSync(`${folder}/${name}`, 'utf8')}));

const attributes = [0, 1].map(
    shaderLocation => ({shaderLocation, offset: 12 * shaderLocation, format: 'float32x3'}));

for (const name of shaders.filter(name => name.includes('.frag.')))
    test(`${name} compiles and links`, async () => {
        const vertex = await module('surface.vert.wgsl');
        const fragment = await module(name);
        await checked(() => device.createRenderPipeline({
            layout: 'auto',
            vertex: {module: vertex, buffers: [{arrayStride: 24, attributes}]},
            fragment: {module: fragment, targets: [{format: 'rgba16float'}]},
        }));
    });

test('there are all of them', () => assert.equal(shaders.length, 6));

test('functions keep their names, and all of the library is there', () => {
    const text = readFileSync(`${folder}/every_function.frag.wgsl`, 'utf8');
    const includes = readdirSync(`${folder}/../include`).map(
        name => readFileSync(`${folder}/../include/${name}`, 'utf8'));
    const functions = [...includes.join('\n').matchAll(/\n(?:float|bool|vec\d|mat3) (splitsum_\w+)\(/g)];
    assert.ok(functions.length > 45);
    for (const [, name] of functions) assert.match(text, new RegExp(`fn ${name}\\(`));
});

test('an error is noticed', async () => {
    await assert.rejects(checked(
        () => device.createShaderModule({code: 'fn wrong() -> f32 { return 1u; }'})));
});
