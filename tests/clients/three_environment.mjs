// How three.js (0.187 and newer) uses a specular.ktx2 of Splitsum as it is, without filtering
// anything itself. Bake with --roughness filament, the curve that three reads, as rgba16f or rgba32f.

import { CompressedCubeTexture, LinearFilter, LinearMipmapLinearFilter } from 'three';
import { KTX2Loader } from 'three/addons/loaders/KTX2Loader.js';

/// A texture for scene.environment.
export async function loadEnvironment(url, renderer) {
    const loader = new KTX2Loader().detectSupport(renderer);
    const stored = await loader.loadAsync(url);
    loader.dispose();
    // An uncompressed cubemap comes as one texture whose levels hold six faces, one after the other.
    const faces = [0, 1, 2, 3, 4, 5].map((face) => ({
        width: stored.image.width,
        height: stored.image.height,
        mipmaps: stored.mipmaps.map(({ data, width, height }) => ({
            width,
            height,
            data: data.subarray((face * data.length) / 6, ((face + 1) * data.length) / 6),
        })),
    }));
    const texture = new CompressedCubeTexture(faces, stored.format, stored.type);
    texture.colorSpace = stored.colorSpace;
    texture.minFilter = LinearMipmapLinearFilter;
    texture.magFilter = LinearFilter;
    texture.isPMREMTexture = true; // already prefiltered
    texture.needsUpdate = true;
    return texture;
}
