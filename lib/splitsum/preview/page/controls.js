// The form, and what else says or changes the state.

const element = (id) => document.getElementById(id);

const roughnessText = (level) => facts.specular.perceptualRoughness[level].toFixed(2);

function levelLabel(level) {
    return `Level ${level}, roughness ${roughnessText(level)}`;
}

const lightLabels = {
    shaded: 'Shaded',
    blurred: 'Panorama, blurred',
    irradiance: 'Irradiance',
    table: 'The split-sum table',
    none: 'None',
};
const viewLabels = { aces: 'ACES', filmic: 'Filmic', srgb: 'sRGB, clipped' };

const lightLabel = (name) => lightLabels[name] ?? levelLabel(levelNumber(name));

function fillSelect(id, names, label) {
    element(id).replaceChildren(...names.map((name) => new Option(label(name), name)));
}

function fillControls() {
    fillSelect('show', ['shaded', ...levelNames, 'irradiance', 'table'], lightLabel);
    fillSelect('background', ['level-0', 'blurred', ...levelNames.slice(1), 'irradiance', 'none'],
        (name) => (name === 'level-0' ? 'Panorama' : lightLabel(name)));
    fillSelect('view', facts.views.map(({ name }) => name), (name) => viewLabels[name] ?? name);
    const exposure = element('exposure');
    exposure.min = facts.start.exposure - 8;
    exposure.max = facts.start.exposure + 8;
    element('compare').disabled = facts.truth === undefined;
    element('compare-note').textContent = facts.truth ? facts.truth.note : facts.noTruth;
    element('scene-name').textContent = facts.spheres.length === 1 ? 'The sphere' : `All ${facts.spheres.length}`;
}

// Calls change({field: value}) when someone uses the form.
function listenToControls(change) {
    element('controls').addEventListener('submit', (event) => event.preventDefault());
    element('controls').addEventListener('input', ({ target }) => {
        const name = target.dataset.field;
        if (!name) return;
        const value = target.type === 'checkbox' ? asText(target.checked) : asText(target.value);
        change({ [name]: fields[name].read(value) ?? fields[name].initial });
    });
}

function showControls(state) {
    for (const control of document.querySelectorAll('[data-field]')) {
        const value = state[control.dataset.field];
        if (control.type === 'radio') control.checked = control.value === value;
        else if (control.type === 'checkbox') control.checked = value && !control.disabled;
        else if (control.value !== String(value)) control.value = value;
    }
    const signed = (value) => `${value < 0 ? '\u2212' : '+'}${Math.abs(value).toFixed(1)}`;
    document.querySelector('output[for=exposure]').textContent = `${signed(state.exposure)} stops`;
    for (const [id, name] of [['roughness', 'perceptual_roughness'], ['metalness', 'metalness']])
        document.querySelector(`output[for=${id}]`).textContent = state[name].toFixed(2);
    element('material').hidden = state.object !== 'sphere';
}

function captionOf(state) {
    if (comparison(state) === 'difference')
        return 'Red: baked light is brighter than the truth. Blue: it is darker. White: both are equal. ' +
            `The colours are full at ${Math.round(100 * facts.truth.fullDifference)} %.`;
    if (state.show === 'table')
        return 'The split-sum table. To the right n·v, upwards perceptual roughness, both from 0 to 1; ' +
            'red is a, green is b of F0 · a + b.';
    const direction = atStart(state) ? 'Drag the picture to turn the light around it.'
        : `Yaw ${Math.round(state.yaw)}°, pitch ${Math.round(state.pitch)}°.`;
    if (state.show === 'irradiance') return `Irradiance / π by normal. ${direction}`;
    if (state.show !== 'shaded')
        return `${levelLabel(levelNumber(state.show))}, as a perfect reflector shows it. ${direction}`;
    if (state.object === 'sphere') return `One sphere. ${direction}`;
    return `${facts.sceneNote} ${direction}`;
}

function showDivider(state) {
    const split = comparison(state) === 'split';
    for (const id of ['divider', 'badge-baked', 'badge-truth']) element(id).hidden = !split;
    const divider = element('divider');
    divider.style.left = `${100 * state.split}%`;
    divider.setAttribute('aria-valuenow', Math.round(100 * state.split));
    const reason = state.compare !== 'off' && facts.truth ? misfit(state) : undefined;
    element('misfit').hidden = reason === undefined;
    element('misfit-text').textContent = reason ?? '';
}

// Calls change while the divider is dragged or moved by keys.
function listenToDivider(stateNow, change) {
    const divider = element('divider');
    const drag = ({ clientX }) => {
        const { left, width } = element('frame').getBoundingClientRect();
        change({ split: clamped((clientX - left) / width, 0, 1) });
    };
    divider.addEventListener('pointerdown', (event) => divider.setPointerCapture(event.pointerId));
    divider.addEventListener('pointermove', (event) => {
        if (divider.hasPointerCapture(event.pointerId)) drag(event);
    });
    const steps = { ArrowLeft: -0.01, ArrowDown: -0.01, ArrowRight: 0.01, ArrowUp: 0.01, PageDown: -0.1, PageUp: 0.1, Home: -1, End: 1 };
    divider.addEventListener('keydown', (event) => {
        const step = steps[event.key];
        if (step === undefined || event.ctrlKey || event.altKey || event.metaKey) return;
        event.preventDefault();
        change({ split: clamped(stateNow().split + (event.shiftKey ? 10 * step : step), 0, 1) });
    });
}

// Yaw stays within half a turn of where it began, so that a whole turn comes back there.
function turned(state, yaw, pitch) {
    const from = state.yaw - facts.start.yaw + yaw;
    return {
        yaw: facts.start.yaw + from - 360 * Math.round(from / 360),
        pitch: clamped(state.pitch + pitch, -90, 90),
    };
}

// Dragging takes what is behind the spheres along; a picture's width is half a turn.
function listenToOrbit(stateNow, change) {
    const canvas = element('canvas');
    let last;
    canvas.addEventListener('pointerdown', (event) => {
        canvas.setPointerCapture(event.pointerId);
        last = event;
    });
    canvas.addEventListener('pointermove', (event) => {
        if (!last || event.pointerId !== last.pointerId || !canvas.hasPointerCapture(event.pointerId)) return;
        const perPixel = 180 / canvas.clientWidth;
        const [right, down] = [event.clientX - last.clientX, event.clientY - last.clientY];
        last = event;
        change(turned(stateNow(), -perPixel * right, perPixel * down));
    });
    const keys = { ArrowLeft: [-5, 0], ArrowRight: [5, 0], ArrowUp: [0, 5], ArrowDown: [0, -5] };
    canvas.addEventListener('keydown', (event) => {
        if (event.ctrlKey || event.altKey || event.metaKey) return;
        const [yaw, pitch] = keys[event.key] ?? [0, 0];
        if (event.key !== 'Home' && !keys[event.key]) return;
        event.preventDefault();
        if (event.key === 'Home') change({ yaw: facts.start.yaw, pitch: facts.start.pitch });
        else change(turned(stateNow(), event.shiftKey ? 6 * yaw : yaw, event.shiftKey ? 6 * pitch : pitch));
    });
}
