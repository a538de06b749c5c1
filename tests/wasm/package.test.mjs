// SPDX-License-Identifier: MIT
import assert from 'node:assert/strict';
import { existsSync, readFileSync, readdirSync } from 'node:fs';
import { test } from 'node:test';
import { gzipSync, inflateRawSync } from 'node:zlib';
import { checkList, readAll } from '../../src/wasm/generate.mjs';
import { adapters, excluded, excludedStems, parts } from '../../src/wasm/parts.mjs';
import { packageFolder, root, text } from './support.mjs';

const headers = readAll(root);
// The sizes of docs/web.md and the limits are those with wasm-opt. It makes a part up to 8 % smaller.
const without = process.env.NKW_WASM_OPT ? 1 : 1.08;

test('every public function is bound or excluded with a reason', () => {
  const { bound, missing, stale, unknown } = checkList(headers);
  assert.deepEqual({ missing, stale, unknown }, { missing: [], stale: [], unknown: [] });
  assert.ok(bound > 250, `${bound}`);
  for (const [name, reason] of Object.entries({ ...excluded, ...excludedStems }))
    assert.ok(reason.length > 8, name);
});

test('the list names stems of the library only', () => {
  for (const stem of [...parts.flatMap(part => part.stems), ...Object.keys(excludedStems)])
    assert.ok(headers.stems.includes(stem), stem);
});

for (const part of parts) {
  test(`${part.name}: at most ${part.limit} KB of module and script after gzip, about as docs/web.md states`, t => {
    const bytes = ['', 'wasm/'].map(folder =>
      gzipSync(text(`${packageFolder}/${folder}${part.name}.js`), { level: 9 }).length);
    t.diagnostic(`${part.name}: ${bytes[0]} + ${bytes[1]} bytes`);
    assert.ok(bytes[0] + bytes[1] <= 1000 * part.limit * without, `${bytes[0]} + ${bytes[1]}`);
    const row = new RegExp(`^\\| .nakawari/${part.name}\\b.* (\\d+) \\|$`, 'm');
    const [, stated] = text(`${root}/docs/web.md`).match(row);
    assert.ok(Math.abs(bytes[0] + bytes[1] - 1000 * stated * without) < 80 * stated, `docs/web.md states ${stated}`);
  });

  test(`${part.name}: the modules import nothing`, async () => {
    const of = async name => Buffer.from((await import(`${packageFolder}/wasm/${name}.js`)).default, 'base64');
    for (const bytes of [inflateRawSync(await of(part.name)), await of(`${part.name}.plain`)])
      assert.deepEqual(WebAssembly.Module.imports(new WebAssembly.Module(bytes)), []);
  });
}

for (const name of [...parts.map(part => part.name), ...Object.keys(adapters)])
  test(`${name}: each exported name has a type, and each type a name`, () => {
    const names = source => [...source.matchAll(/^export (?:function|class|const) (\w+)/gm)].map(m => m[1]).sort();
    const [js, ts] = ['js', 'd.ts'].map(end => names(text(`${packageFolder}/${name}.${end}`)));
    assert.deepEqual(js, ts);
    assert.equal(new Set(js).size, js.length);
  });

test('adapters import their part, and nothing else', () => {
  for (const [name, part] of Object.entries(adapters))
    for (const [, from] of text(`${packageFolder}/${name}.js`).matchAll(/from '(.*)'/g))
      assert.equal(new URL(from, `file:///${name}.js`).pathname, `/${part}.js`);
});

test('the package has no dependency, and its files are there', () => {
  const about = JSON.parse(text(`${packageFolder}/package.json`));
  assert.equal(about.dependencies, undefined);
  for (const entry of Object.values(about.exports))
    for (const file of Object.values(entry))
      assert.ok(existsSync(`${packageFolder}/${file}`), file);
  assert.equal(readdirSync(`${packageFolder}/wasm`).length, 2 * parts.length);
  assert.ok(readFileSync(`${packageFolder}/LICENSE`).length > 0);
});
