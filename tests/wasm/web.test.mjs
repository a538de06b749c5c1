// SPDX-License-Identifier: MIT
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdirSync, mkdtempSync, rmSync, symlinkSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { test } from 'node:test';
import { parts } from '../../src/wasm/parts.mjs';
import { packageFolder, root, text } from './support.mjs';

const examples = [...text(`${root}/docs/web.md`).matchAll(/```js\n([\s\S]*?)```/g)].map(m => m[1]);
const rounded = printed => printed.match(/\[([^\]]*)\]/)[1].split(',').map(x => Math.round(x * 1e6) / 1e6 + 0);

// What an example prints in a project that has the package.
function run(code) {
  const folder = mkdtempSync(`${tmpdir()}/nakawari-`);
  try {
    mkdirSync(`${folder}/node_modules`);
    symlinkSync(packageFolder, `${folder}/node_modules/nakawari`);
    writeFileSync(`${folder}/example.mjs`, code);
    return execFileSync(process.execPath, [`${folder}/example.mjs`], { encoding: 'utf8' });
  } finally {
    rmSync(folder, { recursive: true });
  }
}

test('the first example of docs/web.md prints a column of a matrix', () => {
  assert.deepEqual(rounded(run(examples[0])), [0, 1, 0, 0]);
});

test('the example of structs prints a point of a curve, and a limb that reaches', () => {
  const printed = run(examples.find(code => code.includes('FCurve')));
  assert.deepEqual(rounded(printed).slice(0, 1), [2]);
  assert.ok(Number(printed.trim().split('\n').at(-1)) < 1e-6);
});

test('docs/web.md lists the objects', async () => {
  const [, listed] = text(`${root}/docs/web.md`).match(/\nObjects \(([^)]*)\)/);
  const names = listed.match(/\w+/g).sort();
  const exported = Object.entries(await import(`${packageFolder}/all.js`))
    .filter(([name, value]) => typeof value?.prototype?.dispose === 'function' && !/^(Owner|Floats)$/.test(name)); // bases
  assert.deepEqual(names, exported.map(([name]) => name).sort());
});

test('docs/web.md has a row for each part, and for each function of the adapter', async () => {
  const page = text(`${root}/docs/web.md`);
  for (const name of parts.map(part => part.name))
    assert.match(page, new RegExp(`\n\\| \`nakawari/${name}\``));
  for (const name of Object.keys(await import(`${packageFolder}/three.js`)))
    assert.match(page, new RegExp(`\n\\|[^|]*\`${name}\\(`));
});
