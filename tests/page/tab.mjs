// The page in a browser, opened from disk.

import { problemsOf } from '../browser.mjs';

/// Opens a page and waits until it has drawn. `problems`: of problemsOf(), and every address that was
/// asked for beside the file itself. `options` of playwright's contexts.
export async function openFile(browser, url, options = {}) {
    const context = await browser.newContext({ viewport: { width: 640, height: 600 }, ...options });
    const tab = await context.newPage();
    const problems = problemsOf(tab);
    await context.route('**', (route, request) => {
        if (request.url().split('#')[0] === url.split('#')[0]) return route.continue();
        if (!request.url().startsWith('data:')) problems.push(`asked for ${request.url()}`);
        return route.abort();
    });
    await tab.goto(url);
    await tab.waitForFunction(() => globalThis.splitsum !== undefined);
    return { tab, problems, close: () => context.close() };
}

/// The pixels of a state of the page: { width, height, rgb }, row 0 at the top.
export async function pixelsOf(tab, state = {}) {
    const fragment = new URLSearchParams({ smooth: 0, compare: 'off', ...state }).toString();
    const drawn = await tab.evaluate((text) => {
        const { width, height, rgba } = globalThis.splitsum.pixels(text);
        let binary = '';
        for (let i = 0; i < rgba.length; i += 4)
            binary += String.fromCharCode(rgba[i], rgba[i + 1], rgba[i + 2]);
        return { width, height, base64: btoa(binary) };
    }, fragment);
    return { width: drawn.width, height: drawn.height, rgb: Buffer.from(drawn.base64, 'base64') };
}

/// How far two pictures of one size are apart, in 255ths of the range: the mean over all channels, what 1 %
/// of the pixels are above (each by its worst channel), and the largest difference.
export function difference(a, b) {
    if (a.width !== b.width || a.height !== b.height) throw new Error('pictures of two sizes');
    const worstOfPixel = [];
    let sum = 0;
    for (let pixel = 0; pixel < a.width * a.height; ++pixel) {
        const off = [0, 1, 2].map((c) => Math.abs(a.rgb[3 * pixel + c] - b.rgb[3 * pixel + c]));
        sum += off[0] + off[1] + off[2];
        worstOfPixel.push(Math.max(...off));
    }
    worstOfPixel.sort((x, y) => x - y);
    return {
        mean: sum / a.rgb.length,
        worstPercent: worstOfPixel[Math.floor(0.99 * worstOfPixel.length)],
        worst: worstOfPixel.at(-1),
    };
}

