// Which picture a state asks for: what the shader is told.

const levelNumber = (name) => Number(name.slice('level-'.length));

// The level at which the chain is about as rough as this; only to be looked at.
function levelNear(perceptualRoughness) {
    const values = facts.specular.perceptualRoughness;
    const above = values.findIndex((value) => value >= perceptualRoughness);
    if (above <= 0) return above < 0 ? values.length - 1 : 0;
    const below = above - 1;
    return below + (perceptualRoughness - values[below]) / (values[above] - values[below]);
}

const blurredLevel = levelNear(0.4);

const linearOf = (encoded) =>
    (encoded <= 0.04045 ? encoded / 12.92 : ((encoded + 0.055) / 1.055) ** 2.4);

const linearColour = (hex) =>
    [1, 3, 5].map((at) => linearOf(parseInt(hex.slice(at, at + 2), 16) / 255));

function spheresOf(state) {
    if (state.object === 'scene') return facts.spheres;
    return [{
        centre: [0, 0, 0],
        radius: 0.45,
        baseColor: linearColour(state.color),
        metalness: state.metalness,
        perceptualRoughness: state.perceptual_roughness,
    }];
}

// The constants of page.frag.
const whichLight = (name) =>
    ({ shaded: -1, irradiance: -2, none: -3, table: -4, blurred: blurredLevel })[name] ?? levelNumber(name);

// Whether the viewpoint is that of the truth, but for rounding.
const atStart = ({ yaw, pitch }) =>
    Math.max(Math.abs(yaw - facts.start.yaw), Math.abs(pitch - facts.start.pitch)) < 1e-6;

// Why the truth cannot stand beside what is shown now; nothing if it can.
function misfit(state) {
    if (state.object !== 'scene') return 'The truth is of all spheres.';
    if (state.show !== 'shaded') return 'The truth is of shaded spheres.';
    if (!atStart(state)) return 'The truth was computed for one viewpoint.';
    return undefined;
}

// 'split', 'difference', or 'off' where the truth is not to be or cannot be seen.
const comparison = (state) =>
    (facts.truth === undefined || misfit(state) !== undefined ? 'off' : state.compare);

function pictureOf(state, width, height) {
    const spheres = spheresOf(state);
    return {
        width,
        height,
        spheres,
        camera: cameraFor(spheres, width, height),
        cubeFromView: cubeFromView(state.yaw, state.pitch),
        onSpheres: whichLight(state.show),
        behind: whichLight(state.background),
        exposure: 2 ** state.exposure,
        view: facts.views.findIndex(({ name }) => name === state.view),
        smoothEdges: state.smooth,
        truthFrom: comparison(state) === 'split' ? Math.round(state.split * width) : width,
        showsDifference: comparison(state) === 'difference',
    };
}
