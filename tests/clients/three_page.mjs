// Renders one sphere that fills the picture, seen by a camera without perspective.

import {
    FloatType, Mesh, MeshStandardMaterial, OrthographicCamera, Scene, SphereGeometry, Vector3,
    WebGLRenderTarget, WebGLRenderer,
} from 'three';

import { loadEnvironment } from './three_environment.mjs';

const renderer = new WebGLRenderer();
const environments = new Map();

async function environmentOf(url) {
    if (!environments.has(url)) environments.set(url, await loadEnvironment(url, renderer));
    return environments.get(url);
}

/// The linear colours of `pixels`, pairs (column, row) from the bottom left.
globalThis.render = async ({ url, size, towards, up, metalness, roughness, pixels }) => {
    const scene = new Scene();
    scene.environment = await environmentOf(url);
    const material = new MeshStandardMaterial({ color: 0xffffff, metalness, roughness });
    scene.add(new Mesh(new SphereGeometry(1, 512, 256), material));
    const camera = new OrthographicCamera(-1, 1, 1, -1, 0.5, 4);
    camera.up.set(...up);
    camera.position.set(...towards).multiplyScalar(2);
    camera.lookAt(new Vector3(0, 0, 0));

    const target = new WebGLRenderTarget(size, size, { type: FloatType });
    renderer.setRenderTarget(target);
    renderer.render(scene, camera);
    const values = new Float32Array(4 * size * size);
    renderer.readRenderTargetPixels(target, 0, 0, size, size, values);
    target.dispose();
    return pixels.map(([x, y]) => Array.from(values.slice(4 * (y * size + x), 4 * (y * size + x) + 3)));
};
