// What the page shows, as plain values; the fragment of its address says the same:
// page.html#object=sphere&perceptual_roughness=0.2&yaw=90. Names and ranges: README.md beside this file.

const facts = JSON.parse(document.getElementById('facts').textContent);

const clamped = (value, low, high) => Math.min(Math.max(value, low), high);

// Fields read text and return undefined for what they do not take.
const number = (initial, low, high) => ({
    initial,
    read: (text) => {
        const value = text.trim() === '' ? NaN : Number(text);
        return Number.isFinite(value) ? clamped(value, low, high) : undefined;
    },
});
const choice = (initial, values) => ({
    initial,
    read: (text) => (values.includes(text) ? text : undefined),
});
const flag = (initial) => ({ initial, read: (text) => ({ 0: false, 1: true })[text] });

const levelCount = facts.specular.sizes.length;
const levelNames = facts.specular.sizes.map((_, level) => `level-${level}`);

const fields = {
    object: choice('scene', ['scene', 'sphere']),
    perceptual_roughness: number(0.25, 0, 1),
    metalness: number(1, 0, 1),
    color: { initial: '#e6e6e6', read: (text) => `#${text}`.match(/^#[0-9a-f]{6}$/i)?.[0].toLowerCase() },
    show: choice('shaded', ['shaded', ...levelNames, 'irradiance', 'table']),
    background: choice(facts.start.background, [...levelNames, 'blurred', 'irradiance', 'none']),
    exposure: number(facts.start.exposure, facts.start.exposure - 8, facts.start.exposure + 8),
    view: choice(facts.start.view, facts.views.map(({ name }) => name)),
    smooth: flag(true),
    compare: choice(facts.truth ? 'split' : 'off', ['off', 'split', 'difference']),
    split: number(0.5, 0, 1),
    yaw: number(facts.start.yaw, -36000, 36000),
    pitch: number(facts.start.pitch, -90, 90),
    width: number(0, 0, 8192),
    height: number(0, 0, 8192),
};

const initialState = () =>
    Object.fromEntries(Object.entries(fields).map(([name, { initial }]) => [name, initial]));

// What a fragment says, and the initial value of what it does not say or says wrongly.
function stateOf(fragment) {
    const state = initialState();
    for (const [name, text] of new URLSearchParams(fragment.replace(/^#/, ''))) {
        if (!Object.hasOwn(fields, name)) continue;
        state[name] = fields[name].read(text) ?? state[name];
    }
    return state;
}

const asText = (value) =>
    typeof value === 'boolean' ? String(Number(value)) : String(value).replace(/^#/, '');

// The shortest fragment that stateOf reads back.
function fragmentOf(state) {
    const said = Object.entries(state).filter(([name, value]) => value !== fields[name].initial);
    return new URLSearchParams(said.map(([name, value]) => [name, asText(value)])).toString();
}
