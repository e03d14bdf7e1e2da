// A headless Chromium that renders on the CPU, and a server for its pages.

import { createReadStream, existsSync } from 'node:fs';
import { createServer } from 'node:http';
import { extname, join, normalize } from 'node:path';
import { fileURLToPath } from 'node:url';

import { chromium } from 'playwright-core';

const root = fileURLToPath(new URL('.', import.meta.url));
const types = { '.html': 'text/html', '.js': 'text/javascript', '.mjs': 'text/javascript' };

// Serves this folder to this machine alone.
function startServer() {
    const server = createServer((request, response) => {
        const path = join(root, normalize(new URL(request.url, 'http://x').pathname));
        if (!path.startsWith(root) || !existsSync(path)) {
            response.writeHead(404).end();
            return;
        }
        response.writeHead(200, {
            'content-type': types[extname(path)] ?? 'application/octet-stream',
            'cache-control': 'no-store',
        });
        createReadStream(path).pipe(response);
    });
    return new Promise((resolve) =>
        server.listen(0, '127.0.0.1', () => resolve(server)));
}

/// A browser without a window, for tests beside this one too.
export const openBrowser = () => chromium.launch({
    executablePath: process.env.SPLITSUM_CHROMIUM,
    args: ['--use-angle=swiftshader', '--enable-unsafe-swiftshader'],
    chromiumSandbox: process.getuid() !== 0, // Chromium refuses to use it as root
    timeout: 120000,
});

/// A list that collects what the tab's console and the network complain about from now on.
export function problemsOf(tab) {
    const problems = [];
    tab.on('console', (message) => {
        if (['error', 'warning'].includes(message.type())) problems.push(message.text());
    });
    tab.on('pageerror', (error) => problems.push(String(error)));
    tab.on('response', (response) => {
        if (response.status() >= 400) problems.push(`${response.status()} ${response.url()}`);
    });
    return problems;
}

/// Opens `page` (a file beside this one) and waits until it says that it is ready. `problems` is that of
/// problemsOf().
export async function openPage(page) {
    const server = await startServer();
    const browser = await openBrowser();
    const tab = await browser.newPage();
    const problems = problemsOf(tab);
    await tab.goto(`http://127.0.0.1:${server.address().port}/${page}`);
    await tab.waitForFunction(() => globalThis.render !== undefined, null, { timeout: 120000 });
    return {
        problems,
        /// The page's render(request).
        render: (request) => tab.evaluate((r) => globalThis.render(r), request),
        close: async () => {
            await browser.close();
            server.close();
        },
    };
}
