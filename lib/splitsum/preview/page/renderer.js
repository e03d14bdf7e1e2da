// Draws pictures of picture.js with WebGL 2.

function compiled(gl, type, id) {
    const shader = gl.createShader(type);
    gl.shaderSource(shader, document.getElementById(id).textContent);
    gl.compileShader(shader);
    return shader;
}

function linkedProgram(gl) {
    const program = gl.createProgram();
    const shaders = [
        compiled(gl, gl.VERTEX_SHADER, 'vertex-shader'),
        compiled(gl, gl.FRAGMENT_SHADER, 'fragment-shader'),
    ];
    for (const shader of shaders) gl.attachShader(program, shader);
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS) && !gl.isContextLost())
        throw new Error([...shaders.map((s) => gl.getShaderInfoLog(s)), gl.getProgramInfoLog(program)].join('\n'));
    return program;
}

class Renderer {
    // Throws an Error with a sentence for people where the browser cannot do it.
    constructor(canvas) {
        this.canvas = canvas;
        this.gl = canvas.getContext('webgl2', { alpha: false, antialias: false, depth: false, stencil: false });
        if (!this.gl) throw new Error('WebGL 2 is not available here: the browser is too old, or it is switched off.');
        this.restore();
    }

    // Everything that goes with a context, also after one was lost.
    restore() {
        const { gl } = this;
        this.program = linkedProgram(gl);
        this.places = new Map();
        this.textures = {
            specular_levels: [gl.TEXTURE_CUBE_MAP, cubeTexture(gl, 'specular')],
            irradiance: [gl.TEXTURE_CUBE_MAP, cubeTexture(gl, 'irradiance')],
            split_sum_table: [gl.TEXTURE_2D,
                flatTexture(gl, 'table', facts.table.format, facts.table.width, facts.table.height)],
            spheres: [gl.TEXTURE_2D, newTexture(gl, gl.TEXTURE_2D, gl.NEAREST, gl.NEAREST)],
        };
        if (facts.truth)
            this.textures.truth = [gl.TEXTURE_2D,
                flatTexture(gl, 'truth', 'rgb16f', facts.truth.width, facts.truth.height)];
        this.luts = facts.views.map(({ lut }) => lut && lutTexture(gl, lut));
    }

    place(name) {
        if (!this.places.has(name)) this.places.set(name, this.gl.getUniformLocation(this.program, name));
        return this.places.get(name);
    }

    setFloat(name, value) {
        this.gl.uniform1f(this.place(name), value);
    }

    setInteger(name, value) {
        this.gl.uniform1i(this.place(name), value);
    }

    // Every sampler needs a unit of its own: two kinds of textures at one unit are an error.
    // What is not there is not read either, but browsers warn of units without a texture.
    bindTextures(lut) {
        const { gl } = this;
        const bound = {
            truth: this.textures.split_sum_table,
            ...this.textures,
            view_lut: [gl.TEXTURE_3D, lut ?? this.luts.find(Boolean)],
        };
        Object.entries(bound).forEach(([name, [target, texture]], unit) => {
            gl.activeTexture(gl.TEXTURE0 + unit);
            gl.bindTexture(target, texture);
            this.setInteger(name, unit);
        });
    }

    setChain() {
        const { curve, perceptualRoughness } = facts.specular;
        this.setInteger('curve', { linear: 0, filament: 1, list: 2 }[curve]);
        this.setFloat('last_level', perceptualRoughness.length - 1);
        const list = new Float32Array(16).fill(1);
        list.set(perceptualRoughness.slice(0, 16));
        this.gl.uniform4fv(this.place('roughness_list'), list);
    }

    setCamera({ width, height, camera, cubeFromView, spheres }) {
        const { gl } = this;
        gl.uniform2f(this.place('picture_size'), width, height);
        this.setFloat('tan_half_height', camera.tanHalfHeight);
        gl.uniform3fv(this.place('camera_position'), camera.position);
        gl.uniformMatrix3fv(this.place('cube_from_view'), false, cubeFromView);
        this.setInteger('sphere_count', spheres.length);
    }

    setView(index) {
        const { name, lut } = facts.views[index];
        this.setInteger('view', lut ? 2 : { srgb: 0, filmic: 1 }[name]);
        this.setFloat('lut_size', lut?.size ?? 1);
        this.setFloat('lut_steepness', lut?.steepness ?? 1);
        this.setFloat('lut_brightest', lut?.brightest ?? 1);
    }

    setTruth({ truthFrom, showsDifference }) {
        const { gl } = this;
        this.setFloat('truth_from', truthFrom);
        this.setInteger('shows_difference', showsDifference);
        if (!facts.truth) return;
        this.setFloat('least_luminance', facts.truth.leastLuminance);
        this.setFloat('full_difference', facts.truth.fullDifference);
        for (const [name, bytes] of [['too_bright', facts.truth.tooBright], ['too_dark', facts.truth.tooDark],
            ['difference_background', facts.truth.differenceBackground]])
            gl.uniform3fv(this.place(name), bytes.map((byte) => byte / 255));
    }

    draw(picture) {
        const { gl, canvas } = this;
        if (gl.isContextLost()) return;
        if (canvas.width !== picture.width) canvas.width = picture.width;
        if (canvas.height !== picture.height) canvas.height = picture.height;
        gl.viewport(0, 0, picture.width, picture.height);
        gl.useProgram(this.program);
        gl.activeTexture(gl.TEXTURE0);
        fillSpheres(gl, this.textures.spheres[1], picture.spheres);
        this.bindTextures(this.luts[picture.view]);
        this.setChain();
        this.setCamera(picture);
        this.setView(picture.view);
        this.setFloat('on_spheres', picture.onSpheres);
        this.setFloat('behind', picture.behind);
        this.setFloat('exposure', picture.exposure);
        this.setInteger('smooth_edges', picture.smoothEdges);
        this.setTruth(picture);
        gl.drawArrays(gl.TRIANGLES, 0, 3);
    }

    // RGBA of what was just drawn, row 0 at the top. To be called before the browser shows it.
    pixels() {
        const { gl, canvas: { width, height } } = this;
        const upwards = new Uint8Array(4 * width * height);
        gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, upwards);
        const rgba = new Uint8Array(upwards.length);
        for (let y = 0; y < height; ++y)
            rgba.set(upwards.subarray(4 * width * y, 4 * width * (y + 1)), 4 * width * (height - 1 - y));
        return { width, height, rgba };
    }
}
