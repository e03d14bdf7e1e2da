// What people do with the page: keys, pointer, touch, small screens, other browsers.

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';

import { openBrowser } from '../browser.mjs';
import { baked, panorama, preview } from './make.mjs';
import { difference, openFile, pixelsOf } from './tab.mjs';

let browser;
let plain; // without a truth
let compared;
before(async () => {
    browser = await openBrowser();
    const assets = await baked('controls', 'lopsided', '--size', '64');
    ({ url: plain } = await preview('controls', assets));
    ({ url: compared } = await preview('controls_truth', assets, '--size', '256x128',
        '--panorama', panorama('lopsided'), '--truth', '--noise', '0.3', '--probes', '4'));
});
after(() => browser?.close());

// The picture as it stands, small: the page's own state, whatever it is.
const small = { width: 128, height: 64 };
const shownNow = (tab) => tab.evaluate(() => location.hash.replace(/^#/, '')).then((fragment) =>
    pixelsOf(tab, { ...Object.fromEntries(new URLSearchParams(fragment)), ...small }));

// The address follows a moment after the last change.
const addressSays = (tab, expected) =>
    tab.waitForFunction((text) => decodeURIComponent(location.hash) === text, expected && `#${expected}`);

const focused = (tab) => tab.evaluate(() => {
    const { activeElement: at } = document;
    return at.id || at.dataset.field || at.getAttribute('aria-label');
});

async function tabStops(tab, most = 60) {
    const stops = [];
    for (let i = 0; i < most; ++i) {
        await tab.keyboard.press('Tab');
        const at = await focused(tab);
        if (at === null || stops.includes(at)) break;
        stops.push(at);
    }
    return stops;
}

test('the tabulator reaches every control, and what has the focus can be seen', async () => {
    const { tab, problems, close } = await openFile(browser, `${compared}#object=sphere&compare=off`);
    const stops = await tabStops(tab);
    for (const id of ['canvas', 'object', 'roughness', 'metalness', 'color', 'show', 'background', 'exposure',
        'view', 'smooth', 'compare', 'reset', 'Error of the levels'])
        assert.ok(stops.includes(id), `${id} is not among ${stops}`);
    await tab.goto(`${compared}#compare=split`);
    await tab.evaluate(() => document.activeElement.blur());
    assert.ok((await tabStops(tab)).includes('divider'));
    for (const selector of ['#canvas', '#show', '#exposure', '#reset', '#divider']) {
        await tab.keyboard.press('Tab'); // focus by keys is shown, focus by pointer need not be
        await tab.focus(selector);
        const outlines = await tab.evaluate((at) => {
            const target = document.querySelector(at);
            return [getComputedStyle(target), getComputedStyle(target.parentElement), getComputedStyle(target, '::before')]
                .map((style) => style.outlineStyle);
        }, selector);
        assert.ok(outlines.includes('solid'), `${selector}: ${outlines}`);
    }
    assert.deepEqual(problems, []);
    await close();
});

test('every control has a name', async () => {
    const { tab, close } = await openFile(browser, `${compared}#object=sphere`);
    const unnamed = await tab.evaluate(() =>
        [...document.querySelectorAll('input, select, button, [role=slider], canvas')]
            .filter((at) => !at.labels?.[0]?.textContent.trim() && !at.ariaLabel && !at.textContent.trim())
            .map((at) => at.outerHTML));
    assert.deepEqual(unnamed, []);
    await close();
});

test('arrow keys turn the light, Home turns it back, and the address remembers', async () => {
    const { tab, close } = await openFile(browser, plain);
    const before = await shownNow(tab);
    await tab.focus('#canvas');
    await tab.keyboard.press('ArrowRight');
    await addressSays(tab, 'yaw=5');
    const right = await shownNow(tab);
    assert.ok(difference(right, before).mean > 0.5);
    await tab.keyboard.press('Shift+ArrowUp');
    await addressSays(tab, 'yaw=5&pitch=30');
    for (let i = 0; i < 5; ++i) await tab.keyboard.press('Shift+ArrowUp');
    await addressSays(tab, 'yaw=5&pitch=90');
    await tab.keyboard.press('Home');
    await addressSays(tab, '');
    assert.deepEqual(await shownNow(tab), before);
    for (let i = 0; i < 72; ++i) await tab.keyboard.press('ArrowLeft');
    await addressSays(tab, '');
    await close();
});

test('dragging takes the background along, by pointer and by touch', async () => {
    const { tab, close } = await openFile(browser, plain, { hasTouch: true });
    const { x, y, width } = await tab.locator('#canvas').boundingBox();
    await tab.mouse.move(x + 100, y + 50);
    await tab.mouse.down();
    await tab.mouse.move(x + 100 + width / 6, y + 50, { steps: 4 });
    await tab.mouse.up();
    await tab.mouse.move(x + 300, y + 90);
    await tab.waitForFunction(() => location.hash !== '');
    const yaw = Number(new URLSearchParams(new URL(tab.url()).hash.slice(1)).get('yaw'));
    assert.ok(Math.abs(yaw + 30) < 1, tab.url());
    await tab.evaluate(() => { location.hash = ''; });
    const session = await tab.context().newCDPSession(tab);
    const touch = (type, px, py) => session.send('Input.dispatchTouchEvent',
        { type, touchPoints: type === 'touchEnd' ? [] : [{ x: px, y: py }] });
    await touch('touchStart', x + 100, y + 50);
    for (let step = 1; step <= 4; ++step) await touch('touchMove', x + 100, y + 50 + 20 * step);
    await touch('touchEnd');
    await tab.waitForFunction(() => location.hash.includes('pitch'));
    assert.ok(Number(new URLSearchParams(new URL(tab.url()).hash.slice(1)).get('pitch')) > 5, tab.url());
    await close();
});

test('every control changes the picture', async () => {
    const { tab, problems, close } = await openFile(browser, `${plain}#object=sphere&smooth=0`);
    let last = await shownNow(tab);
    const changes = async (what, use) => {
        const address = tab.url();
        await use();
        await tab.waitForFunction((old) => location.href !== old, address);
        const now = await shownNow(tab);
        assert.ok(difference(now, last).worst > 0, what);
        last = now;
    };
    const press = (selector, key) => async () => {
        await tab.focus(selector);
        await tab.keyboard.press(key);
    };
    await changes('roughness', press('#roughness', 'Home'));
    assert.equal(await tab.textContent('output[for=roughness]'), '0.00');
    await changes('metalness', press('#metalness', 'PageDown'));
    await changes('colour', () => tab.fill('#color', '#ff2000'));
    await changes('exposure', press('#exposure', 'ArrowRight'));
    await changes('object', press('[value=sphere]', 'ArrowLeft'));
    assert.ok(!(await tab.isVisible('#roughness')));
    for (const [select, first] of [['#view', 'aces'], ['#background', 'level-0'], ['#show', 'shaded']])
        for (const value of await tab.$$eval(`${select} option`, (all) => all.map((option) => option.value)))
            if (value !== first) await changes(`${select} ${value}`, () => tab.selectOption(select, value));
    await tab.click('#reset');
    await addressSays(tab, '');
    assert.deepEqual(problems, []);
    await close();
});

test('the divider moves by keys and by dragging', async () => {
    const { tab, close } = await openFile(browser, compared);
    const at = () => tab.getAttribute('#divider', 'aria-valuenow').then(Number);
    assert.equal(await at(), 50);
    await tab.focus('#divider');
    await tab.keyboard.press('ArrowLeft');
    await tab.keyboard.press('PageUp');
    assert.equal(await at(), 59);
    await tab.keyboard.press('Home');
    assert.equal(await at(), 0);
    const { x, y, width, height } = await tab.locator('#frame').boundingBox();
    await tab.mouse.move(x + 5, y + height / 2);
    await tab.mouse.down();
    await tab.mouse.move(x + width / 4, y + height / 2, { steps: 3 });
    await tab.mouse.up();
    assert.equal(await at(), 25);
    assert.ok(!(await tab.isVisible('#misfit')));
    await close();
});

test('the truth belongs to one viewpoint, and a button leads back to it', async () => {
    const { tab, close } = await openFile(browser, compared);
    const before = await pixelsOf(tab, { ...small, compare: 'split' });
    await tab.focus('#canvas');
    await tab.keyboard.press('ArrowLeft');
    assert.ok(await tab.isVisible('#misfit'));
    assert.ok(!(await tab.isVisible('#divider')));
    assert.deepEqual(await pixelsOf(tab, { ...small, compare: 'split', yaw: -5 }),
        await pixelsOf(tab, { ...small, compare: 'off', yaw: -5 }));
    await tab.click('#back');
    assert.ok(await tab.isVisible('#divider'));
    assert.deepEqual(await pixelsOf(tab, { ...small, compare: 'split' }), before);
    await close();
});

test('without a truth there is nothing to compare, and why', async () => {
    const { tab, close } = await openFile(browser, plain);
    assert.ok(await tab.isDisabled('#compare'));
    assert.match(await tab.textContent('#compare-note'), /--truth/);
    await close();
});

for (const [colorScheme, background] of [['light', 'rgb(251, 250, 248)'], ['dark', 'rgb(23, 22, 21)']])
    test(`a phone of 360 pixels shows everything without scrolling sideways, ${colorScheme}`, async () => {
        const phone = { viewport: { width: 360, height: 740 }, deviceScaleFactor: 2, isMobile: true, hasTouch: true, colorScheme };
        for (const state of ['', '#object=sphere', '#yaw=20', '#show=table']) {
            const { tab, problems, close } = await openFile(browser, compared + state, phone);
            const widths = await tab.evaluate(() => [document.documentElement.scrollWidth, innerWidth,
                ...[...document.querySelectorAll('canvas, input, select, button')]
                    .map((at) => Math.round(at.getBoundingClientRect().right))]);
            assert.ok(widths.every((width) => width <= 360), `${state}: ${widths}`);
            assert.equal(await tab.evaluate(() => getComputedStyle(document.body).backgroundColor), background);
            assert.deepEqual(problems, []);
            await close();
        }
    });

test('pixels of the screen are pixels of the picture', async () => {
    const { tab, close } = await openFile(browser, plain, { deviceScaleFactor: 1.5 });
    const [drawn, wide] = await tab.evaluate(() =>
        [document.getElementById('canvas').width, document.getElementById('frame').getBoundingClientRect().width]);
    assert.equal(drawn, Math.round(1.5 * wide));
    await tab.setViewportSize({ width: 500, height: 600 });
    await tab.waitForFunction((old) => document.getElementById('canvas').width < old, drawn);
    await close();
});

test('nothing is drawn while nothing changes', async () => {
    const { tab, close } = await openFile(browser, plain);
    const drawn = await tab.evaluate(async () => {
        const frames = async (count) => {
            for (let i = 0; i < count; ++i) await new Promise(requestAnimationFrame);
        };
        await frames(5);
        let count = 0;
        const { drawArrays } = WebGL2RenderingContext.prototype;
        WebGL2RenderingContext.prototype.drawArrays = function (...rest) {
            ++count;
            return drawArrays.apply(this, rest);
        };
        await frames(20);
        const idle = count;
        document.getElementById('canvas').dispatchEvent(new KeyboardEvent('keydown', { key: 'ArrowLeft' }));
        await frames(5);
        return [idle, count];
    });
    assert.deepEqual(drawn, [0, 1]);
    await close();
});

test('a lost context comes back with the same picture', async () => {
    const { tab, problems, close } = await openFile(browser, compared);
    const before = await pixelsOf(tab, { ...small, compare: 'split' });
    await tab.evaluate(async () => {
        const canvas = document.getElementById('canvas');
        const restored = new Promise((resolve) => { canvas.addEventListener('webglcontextrestored', resolve); });
        const loser = canvas.getContext('webgl2').getExtension('WEBGL_lose_context');
        loser.loseContext();
        await new Promise((resolve) => { setTimeout(resolve, 100); });
        document.getElementById('canvas').dispatchEvent(new KeyboardEvent('keydown', { key: 'ArrowLeft' }));
        loser.restoreContext();
        await restored;
    });
    assert.deepEqual(await pixelsOf(tab, { ...small, compare: 'split' }), before);
    assert.deepEqual(problems.filter((text) => !text.includes('CONTEXT_LOST_WEBGL')), []);
    await close();
});

test('an address of another time is read as far as it makes sense', async () => {
    const { tab, problems, close } = await openFile(browser,
        `${plain}#yaw=45&pitch=200&view=vhs&exposure=NaN&show=level-99&__proto__=1&compare=split&color=red&roughness`);
    await addressSays(tab, 'yaw=45&pitch=200&view=vhs&exposure=NaN&show=level-99&__proto__=1&compare=split&color=red&roughness');
    assert.match(await tab.textContent('#caption'), /Yaw 45°, pitch 90°/);
    await tab.evaluate(() => { location.hash = 'show=irradiance'; });
    await tab.waitForFunction(() => document.getElementById('show').value === 'irradiance');
    assert.deepEqual(problems, []);
    await close();
});

test('without WebGL 2 the page says so and still has its figures', async () => {
    const context = await browser.newContext();
    const tab = await context.newPage();
    const problems = [];
    tab.on('pageerror', (error) => problems.push(String(error)));
    await tab.addInitScript(() => { HTMLCanvasElement.prototype.getContext = () => null; });
    await tab.goto(compared);
    assert.match(await tab.textContent('#failure'), /WebGL 2/);
    assert.ok(!(await tab.isVisible('#controls')));
    assert.ok(await tab.getByText('Error of the levels').isVisible());
    assert.deepEqual(problems, []);
    await context.close();
});
