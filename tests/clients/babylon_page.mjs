// Renders one sphere that fills the picture, seen by a camera without perspective.

import { Camera } from '@babylonjs/core/Cameras/camera.js';
import { TargetCamera } from '@babylonjs/core/Cameras/targetCamera.js';
import { Engine } from '@babylonjs/core/Engines/engine.js';
import { PBRMaterial } from '@babylonjs/core/Materials/PBR/pbrMaterial.js';
import { RenderTargetTexture } from '@babylonjs/core/Materials/Textures/renderTargetTexture.js';
import { Color3, Color4 } from '@babylonjs/core/Maths/math.color.js';
import { Vector3 } from '@babylonjs/core/Maths/math.vector.js';
import { CreateSphere } from '@babylonjs/core/Meshes/Builders/sphereBuilder.js';
import { Scene } from '@babylonjs/core/scene.js';

import { loadEnvironment } from './babylon_environment.mjs';

const engine = new Engine(document.querySelector('canvas'), false);

// Without perspective Babylon.js still looks from the camera's place, so that it stands far away.
function makeCamera(scene, { towards, up }) {
    const distance = 2000;
    const camera = new TargetCamera('camera', Vector3.FromArray(towards).scale(distance), scene);
    camera.upVector = Vector3.FromArray(up);
    camera.setTarget(Vector3.Zero());
    camera.mode = Camera.ORTHOGRAPHIC_CAMERA;
    camera.orthoLeft = camera.orthoBottom = -1;
    camera.orthoRight = camera.orthoTop = 1;
    camera.minZ = distance - 2;
    camera.maxZ = distance + 2;
    return camera;
}

// White; as a dielectric without any reflection, so that diffuse light is seen alone.
// `mixing` is Babylon.js's own blend of rough reflections with diffuse light, on unless told otherwise.
function makeMaterial(scene, { metalness, roughness, mixing }) {
    const material = new PBRMaterial('surface', scene);
    material.albedoColor = Color3.White();
    material.metallic = metalness;
    material.roughness = roughness;
    material.brdf.mixIblRadianceWithIrradiance = mixing;
    if (metalness === 0) material.metallicF0Factor = 0;
    return material;
}

async function pictureOf(scene, camera, mesh, size) {
    const target = new RenderTargetTexture('target', size, scene, { type: Engine.TEXTURETYPE_FLOAT });
    target.clearColor = new Color4(0, 0, 0, 0);
    target.renderList = [mesh];
    target.activeCamera = camera;
    await scene.whenReadyAsync();
    await mesh.material.forceCompilationAsync(mesh);
    target.render();
    return target.readPixels();
}

/// The linear colours of `pixels`, pairs (column, row) from the bottom left.
globalThis.render = async (request) => {
    const { url, rightHanded, size, pixels, environment } = request;
    const scene = new Scene(engine);
    scene.useRightHandedSystem = rightHanded;
    scene.imageProcessingConfiguration.applyByPostProcess = true; // leaves linear colours
    scene.environmentTexture = await loadEnvironment(url, scene, environment);
    const mesh = CreateSphere('sphere', { diameter: 2, segments: 128 }, scene);
    mesh.material = makeMaterial(scene, request);
    const values = await pictureOf(scene, makeCamera(scene, request), mesh, size);
    scene.dispose();
    return pixels.map(([x, y]) => Array.from(values.slice(4 * (y * size + x), 4 * (y * size + x) + 3)));
};
