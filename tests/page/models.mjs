// SPDX-License-Identifier: MIT
// The two exhibits that load three.js, in Chromium: the numbers of the page, and what the copied C prints.
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';

// The folder of the page, the build folder with its node_modules, the source folder, flags that link the library.
const { NKW_PAGE: page, NKW_BUILD: build, NKW_ROOT: root, NKW_CHROMIUM: chromium, NKW_LINK: link } = process.env;
const require = createRequire(`${build}/`);
export { root };

// Without a GPU, pages are painted by the processor and WebGL by SwiftShader.
const browser = await require('playwright-core').chromium.launch({
  executablePath: chromium, args: ['--no-sandbox', '--disable-gpu', '--enable-unsafe-swiftshader'] });
export const close = () => browser.close();

/** An exhibit by its address; `problems` receives what the console has. */
export async function open(address, options = {}) {
  const tab = await browser.newPage({ viewport: { width: 1280, height: 800 }, ...options }), problems = [];
  tab.on('console', message => {
    if (/error|warning/.test(message.type()) && !/GL Driver Message|GPU stall/.test(message.text()))
      problems.push(message.text());
  });
  tab.on('pageerror', error => problems.push(String(error)));
  await tab.goto(`file://${page}/index.html#${address}`);
  return { tab, problems };
}

/** The numbers on the page: { 'x.0': value }. */
export const shown = tab => tab.evaluate(() => Object.fromEntries([...document.querySelectorAll('[data-name]')]
  .map(cell => [cell.dataset.name, Number(cell.dataset.value)])));

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
  const { violations } = await tab.evaluate(() => globalThis.axe.run(document, { preload: false })); // a file cannot fetch the style sheet
  return violations.map(v => `${v.id}: ${v.nodes.map(n => n.target).join(' ')}`);
}
