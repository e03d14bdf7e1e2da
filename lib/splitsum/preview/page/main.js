// Wires state, form and picture; draws only when something has changed.

let state = stateOf(location.hash);
let renderer;
let scheduled = false;  // a picture is on its way
let remembering;        // the timer of the address

// The canvas is as large as its place in device pixels, but no larger than what draws quickly.
function pictureSize() {
    if (state.width > 0 && state.height > 0) return [Math.round(state.width), Math.round(state.height)];
    const { width, height } = element('frame').getBoundingClientRect();
    const most = Math.sqrt(4e6 / Math.max(width * height, 1));
    const ratio = Math.min(globalThis.devicePixelRatio, most);
    return [Math.max(1, Math.round(width * ratio)), Math.max(1, Math.round(height * ratio))];
}

function drawNow() {
    renderer.draw(pictureOf(state, ...pictureSize()));
}

function schedule() {
    if (scheduled || !renderer) return;
    scheduled = true;
    requestAnimationFrame(() => {
        scheduled = false;
        drawNow();
    });
}

const narrow = matchMedia('(max-width: 54rem)');

// One sphere on a phone has room for more height than a row of them needs.
function showShape() {
    const whole = facts.start.width / facts.start.height;
    const shape = state.object === 'sphere' && narrow.matches ? Math.min(whole, 1.4) : whole;
    element('frame').style.setProperty('--shape', shape);
}

function rememberInAddress() {
    const fragment = fragmentOf(state);
    if (fragment === location.hash.replace(/^#/, '')) return;
    history.replaceState(null, '', fragment ? `#${fragment}` : location.href.replace(/#.*/, ''));
}

function show() {
    showShape();
    showControls(state);
    showDivider(state);
    element('caption').textContent = captionOf(state);
    schedule();
}

function change(changes) {
    state = { ...state, ...changes };
    clearTimeout(remembering);
    remembering = setTimeout(rememberInAddress, 200);
    show();
}

function fail(message) {
    element('stage').hidden = true;
    element('controls').hidden = true;
    element('failure').hidden = false;
    element('failure').textContent = `No picture: ${message} The figures below do not need it.`;
}

function listen() {
    const stateNow = () => state;
    listenToControls(change);
    listenToOrbit(stateNow, change);
    listenToDivider(stateNow, change);
    element('reset').addEventListener('click', () => change(initialState()));
    element('back').addEventListener('click', () => change({
        object: 'scene', show: 'shaded', yaw: facts.start.yaw, pitch: facts.start.pitch,
    }));
    addEventListener('hashchange', () => change(stateOf(location.hash)));
    new ResizeObserver(schedule).observe(element('frame'));
    narrow.addEventListener('change', show);
    const canvas = element('canvas');
    canvas.addEventListener('webglcontextlost', (event) => event.preventDefault());
    canvas.addEventListener('webglcontextrestored', () => {
        renderer.restore();
        schedule();
    });
}

showFigures();
fillControls();
try {
    renderer = new Renderer(element('canvas'));
    listen();
    show();
    // For programs: the pixels that the page shows with another fragment, { width, height, rgba }.
    globalThis.splitsum = {
        pixels: (fragment) => {
            const kept = state;
            state = stateOf(fragment);
            drawNow();
            const pixels = renderer.pixels();
            state = kept;
            schedule();
            return pixels;
        },
    };
} catch (error) {
    fail(error.message);
}
