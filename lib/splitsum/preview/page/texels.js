// Textures from the texels in the document.

function bytesOf(name) {
    const binary = atob(document.getElementById(`texels-${name}`).textContent);
    const bytes = new Uint8Array(binary.length);
    for (let i = 0; i < bytes.length; ++i) bytes[i] = binary.charCodeAt(i);
    return bytes;
}

// How WebGL 2 takes a format of preview/page_texels.h. `numbers` of `Numbers` make a texel.
const uploads = (gl) => ({
    rgb9e5: {
        stored: gl.RGB9_E5, format: gl.RGB, type: gl.UNSIGNED_INT_5_9_9_9_REV, Numbers: Uint32Array, numbers: 1,
    },
    b10g11r11: {
        stored: gl.R11F_G11F_B10F, format: gl.RGB, type: gl.UNSIGNED_INT_10F_11F_11F_REV, Numbers: Uint32Array, numbers: 1,
    },
    rgb16f: { stored: gl.RGB16F, format: gl.RGB, type: gl.HALF_FLOAT, Numbers: Uint16Array, numbers: 3 },
    rg16f: { stored: gl.RG16F, format: gl.RG, type: gl.HALF_FLOAT, Numbers: Uint16Array, numbers: 2 },
    rgb10: {
        stored: gl.RGB10_A2, format: gl.RGBA, type: gl.UNSIGNED_INT_2_10_10_10_REV, Numbers: Uint32Array, numbers: 1,
    },
});

// A new texture that clamps to its edges, bound to `target`.
function newTexture(gl, target, minFilter, magFilter) {
    const texture = gl.createTexture();
    gl.bindTexture(target, texture);
    gl.pixelStorei(gl.UNPACK_ALIGNMENT, 1);
    gl.texParameteri(target, gl.TEXTURE_MIN_FILTER, minFilter);
    gl.texParameteri(target, gl.TEXTURE_MAG_FILTER, magFilter);
    for (const axis of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T, gl.TEXTURE_WRAP_R])
        gl.texParameteri(target, axis, gl.CLAMP_TO_EDGE);
    return texture;
}

function cubeTexture(gl, name) {
    const { format: formatName, sizes } = facts[name];
    const { stored, format, type, Numbers, numbers } = uploads(gl)[formatName];
    const texels = new Numbers(bytesOf(name).buffer);
    const texture = newTexture(gl, gl.TEXTURE_CUBE_MAP, gl.LINEAR_MIPMAP_LINEAR, gl.LINEAR);
    gl.texStorage2D(gl.TEXTURE_CUBE_MAP, sizes.length, stored, sizes[0], sizes[0]);
    let from = 0;
    sizes.forEach((size, level) => {
        for (let face = 0; face < 6; ++face, from += numbers * size * size)
            gl.texSubImage2D(gl.TEXTURE_CUBE_MAP_POSITIVE_X + face, level, 0, 0, size, size, format, type,
                texels.subarray(from, from + numbers * size * size));
    });
    return texture;
}

function flatTexture(gl, name, formatName, width, height) {
    const { stored, format, type, Numbers } = uploads(gl)[formatName];
    const texture = newTexture(gl, gl.TEXTURE_2D, gl.LINEAR, gl.LINEAR);
    gl.texStorage2D(gl.TEXTURE_2D, 1, stored, width, height);
    gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, width, height, format, type, new Numbers(bytesOf(name).buffer));
    return texture;
}

function lutTexture(gl, { size, texels }) {
    const { stored, format, type, Numbers } = uploads(gl).rgb10;
    const texture = newTexture(gl, gl.TEXTURE_3D, gl.LINEAR, gl.LINEAR);
    gl.texStorage3D(gl.TEXTURE_3D, 1, stored, size, size, size);
    gl.texSubImage3D(gl.TEXTURE_3D, 0, 0, 0, 0, size, size, size, format, type,
        new Numbers(bytesOf(texels).buffer));
    return texture;
}

// The texels that camera.glsl and page.frag read of each sphere, a row each.
function fillSpheres(gl, texture, spheres) {
    const values = spheres.flatMap(({ centre, radius, baseColor, metalness, perceptualRoughness }) =>
        [...centre, radius, ...baseColor, metalness, perceptualRoughness, 0, 0, 0]);
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA32F, 3, spheres.length, 0, gl.RGBA, gl.FLOAT,
        new Float32Array(values));
}
