// A sphere that fills a square picture, seen without perspective: what its pixels reflect, and how
// far they are from what they should be.

export const size = 128;

const scaled = (a, s) => a.map((x) => x * s);
const sum = (...vectors) => [0, 1, 2].map((i) => vectors.reduce((s, v) => s + v[i], 0));
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

/// Camera axes, by hand: `towards` leads from the sphere to the camera. In a right-handed world right
/// = up x towards; a left-handed one has the opposite.
export const views = {
    rightHanded: [
        { towards: [0, 0, 1], right: [1, 0, 0], up: [0, 1, 0] },
        { towards: [1, 0, 0], right: [0, 0, -1], up: [0, 1, 0] },
        { towards: [0, 0, -1], right: [-1, 0, 0], up: [0, 1, 0] },
        { towards: [0, 1, 0], right: [1, 0, 0], up: [0, 0, -1] },
    ],
    leftHanded: [
        { towards: [0, 0, -1], right: [1, 0, 0], up: [0, 1, 0] },
        { towards: [1, 0, 0], right: [0, 0, 1], up: [0, 1, 0] },
        { towards: [0, 0, 1], right: [-1, 0, 0], up: [0, 1, 0] },
        { towards: [0, 1, 0], right: [1, 0, 0], up: [0, 0, 1] },
    ],
};

/// Pixels whose mirror direction is known without a formula: the middle reflects the camera, and a
/// normal halfway between the camera and an edge of the picture reflects what is beyond that edge.
export const landmarks = (view) => {
    const middle = size / 2;
    const half = Math.round(middle * Math.SQRT1_2);
    return [
        { pixel: [middle, middle], direction: view.towards },
        { pixel: [middle + half, middle], direction: view.right },
        { pixel: [middle - half, middle], direction: scaled(view.right, -1) },
        { pixel: [middle, middle + half], direction: view.up },
        { pixel: [middle, middle - half], direction: scaled(view.up, -1) },
    ];
};

/// Pixels over the inner nine tenths of the disc, some hundred.
export function grid() {
    const pixels = [];
    for (let y = 4; y < size; y += 10)
        for (let x = 7; x < size; x += 10)
            if (Math.hypot(...diskPoint([x, y])) < 0.9) pixels.push([x, y]);
    return pixels;
}

// The middle of a pixel, the picture being [-1, 1]².
const diskPoint = ([x, y]) => [(2 * x + 1) / size - 1, (2 * y + 1) / size - 1];

/// Normal, cosine to the camera and mirror direction at a pixel, in the world of the view.
export function surfaceAt(view, pixel) {
    const [x, y] = diskPoint(pixel);
    const cosine = Math.sqrt(1 - x * x - y * y);
    const normal = sum(scaled(view.right, x), scaled(view.up, y), scaled(view.towards, cosine));
    const mirror = sum(scaled(normal, 2 * cosine), scaled(view.towards, -1));
    return { normal, cosine, mirror };
}

/// Errors over all channels of all pixels, as shares of the expected mean.
export function errorsOf(found, expected) {
    const a = found.flat();
    const b = expected.flat();
    const mean = b.reduce((s, v) => s + v, 0) / b.length;
    const off = a.map((v, i) => Math.abs(v - b[i]) / mean);
    return {
        count: a.length,
        mean: off.reduce((s, v) => s + v, 0) / off.length,
        worst: off.reduce((s, v) => Math.max(s, Number.isNaN(v) ? Infinity : v), 0),
        bias: a.reduce((s, v) => s + v, 0) / a.length / mean - 1,
    };
}

/// mix(a, b, t), normalised.
export function mixed(a, b, t) {
    const v = sum(scaled(a, 1 - t), scaled(b, t));
    return scaled(v, 1 / Math.sqrt(dot(v, v)));
}
