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

test('there are all of them', () => assert.equal(shaders.length, 5));

test('functions keep their names', () => {
    const text = readFileSync(`${folder}/image_based_light.frag.wgsl`, 'utf8');
    assert.match(text, /fn splitsum_specular_light\(/);
});

test('an error is noticed', async () => {
    await assert.rejects(checked(
        () => device.createShaderModule({code: 'fn wrong() -> f32 { return 1u; }'})));
});
