// SPDX-License-Identifier: MIT
// What the tests of the page share: Chromium, an exhibit by its address, its numbers, what the copied C prints.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';

// The folder of the page, the build folder with its node_modules, the source folder, flags that link the library, the
// file with the address of the browser (browser.mjs).
const { NKW_PAGE: page, NKW_BUILD: build, NKW_ROOT: root, NKW_LINK: link, NKW_BROWSER: address } = process.env;
export const require = createRequire(`${build}/`);
export { page, root };

const browser = await require('playwright-core').chromium.connect(readFileSync(address, 'utf8'));
/** Options of tests that take long: they run at night. */
export const long = { skip: process.env.NKW_TEST_SET === 'nightly' ? false : 'at night' };
/** Closes the tabs of this file of tests. */
export const close = () => browser.close();

/** An empty tab; `problems` receives what the console has. */
export async function blank(options = {}) {
  const tab = await browser.newPage({ viewport: { width: 1280, height: 800 }, ...options }), problems = [];
  tab.on('console', message => {
    if (/error|warning/.test(message.type()) && !/GL Driver Message|GPU stall/.test(message.text()))
      problems.push(message.text());
  });
  tab.on('pageerror', error => problems.push(String(error)));
  return { tab, problems };
}

/** Where an exhibit is. */
export const url = address => `file://${page}/index.html#${address}`;

/** An exhibit by its address. */
export async function open(address, options = {}) {
  const made = await blank(options);
  await made.tab.goto(url(address));
  return made;
}

/** Waits until the exhibit, or the exhibit `id`, is drawn. */
export const drawn = (tab, id) => tab.waitForSelector(`main${id ? `[data-exhibit="${id}"]` : ''}[data-drawn]`,
  { state: 'attached', timeout: 60000 });

/** An exhibit by its address, drawn. */
export async function start(address, options) {
  const made = await open(address, options);
  await drawn(made.tab);
  return made;
}

/** Calls `use` with a tab and its numbers in an exhibit; the console has nothing to say. */
export async function within(address, use, options) {
  const { tab, problems } = await start(address, options);
  await use(tab, await shown(tab));
  assert.deepEqual(problems, []);
  await tab.close();
}

/** Waits for frames of the browser. */
export const frames = (tab, count) => tab.evaluate(n => new Promise(resolve => {
  const next = () => n-- ? requestAnimationFrame(next) : resolve();
  next();
}), count);

/** The numbers on the page: { 'x.0': value }. */
export const shown = tab => tab.evaluate(() => Object.fromEntries([...document.querySelectorAll('[data-name]')]
  .map(cell => [cell.dataset.name, Number(cell.dataset.value)])));

/** Numbers name.0, name.1, ... of those shown. */
export const row = (numbers, name, count = 3) => Array.from({ length: count }, (_, i) => numbers[`${name}.${i}`]);

export const near = (a, b, tolerance = 1e-5, what = '') =>
  assert.ok(Math.abs(a - b) <= tolerance, `${what}: ${a}, not ${b}`);

/** Drags by a finger from the middle of an element; `path` is a list of [dx, dy] from there, in pixels. */
export async function touchDrag(tab, element, path) {
  const { x, y, width, height } = await element.boundingBox(), session = await tab.context().newCDPSession(tab);
  const send = (type, at) => session.send('Input.dispatchTouchEvent', { type,
    touchPoints: at ? [{ x: x + width / 2 + at[0], y: y + height / 2 + at[1] }] : [] });
  await send('touchStart', [0, 0]);
  for (const at of path)
    await send('touchMove', at);
  await send('touchEnd');
  await session.detach();
}

// The words of printf for numbers that are not finite.
const read = text => Number(/nan/.test(text) ? NaN : text.replace('inf', 'Infinity'));

/** What the copied program prints, in the same form. */
export async function printed(tab) {
  await tab.click('.code');
  const code = await tab.textContent('.program'), folder = mkdtempSync(`${tmpdir()}/nakawari-`);
  await tab.keyboard.press('Escape');
  try {
    writeFileSync(`${folder}/program.c`, code);
    execFileSync('cc', ['-std=c99', '-Wall', '-Wextra', '-Werror', `${folder}/program.c`, '-o', `${folder}/program`,
      `-I${root}/include`, ...link.split(' ')]);
    const lines = execFileSync(`${folder}/program`, { encoding: 'utf8' }).trim().split('\n');
    return Object.fromEntries(lines.map(line => line.split(' ')).map(([name, value]) => [name, read(value)]));
  } finally {
    rmSync(folder, { recursive: true });
  }
}

/** The findings of axe. */
export async function axe(tab) {
  await tab.addScriptTag({ content: readFileSync(require.resolve('axe-core/axe.min.js'), 'utf8') });
  // preload: a page that is a file cannot fetch its style sheet
  const { violations } = await tab.evaluate(() => globalThis.axe.run(document, { preload: false }));
  return violations.map(v => `${v.id}: ${v.nodes.map(n => n.target).join(' ')}`);
}
