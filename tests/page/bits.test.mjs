// SPDX-License-Identifier: MIT
// The same bits: this browser's hash is that of the C program, and depends on the sequence.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { after, test } from 'node:test';
import { close, open, root, shown } from './models.mjs';

after(close);
const names = ['sine', 'curve', 'slerp', 'spring'];
const openBits = async query => {
  const { tab } = await open(`bits?lang=en${query}`);
  await tab.waitForSelector('main[data-drawn]', { state: 'attached' });
  return tab;
};

test('bits: the hash of the initial sequence is the one of the C program', async () => {
  const tab = await openBits('');
  assert.match(await tab.textContent('.verdict'), /^the same bits as the C program/);
  const numbers = await shown(tab);
  assert.equal(await tab.textContent('.hash'), names.map(name =>
    numbers[`${name}.0`].toString(16).padStart(8, '0')).join(' '));
  await tab.close();
});

test('bits: one step is the hash of four bytes, of another start another hash', async () => {
  const tab = await openBits('&count=1&start=0');
  const numbers = await shown(tab); // sin 0 = 0: the hash of four zero bytes
  const zero = [0, 0, 0, 0].reduce(hash => Math.imul(hash, 0x01000193) >>> 0, 0x811c9dc5);
  assert.equal(numbers['sine.0'], zero);
  const box = await (await tab.$$('.lil-slider'))[1].boundingBox();
  await tab.mouse.move(box.x + box.width * 0.5, box.y + box.height / 2);
  await tab.mouse.down();
  await tab.mouse.move(box.x + box.width * 0.8, box.y + box.height / 2, { steps: 4 });
  await tab.mouse.up();
  await tab.waitForFunction(old => Number(document.querySelector('[data-name="sine.0"]').dataset.value) !== old, zero);
  await tab.close();
});

test('bits: the table is that of docs/determinism.md', async () => {
  const tab = await openBits('');
  const rows = readFileSync(`${root}/docs/determinism.md`, 'utf8').split('\n')
    .filter(line => /^\| /.test(line) && line.split('|').length === 8).slice(1)
    .map(line => line.split('|').slice(1, 4).map(cell => cell.trim()));
  assert.ok(rows.length > 10);
  const here = await tab.$$eval('.targets tbody tr', list => list.map(row => [...row.cells].map(c => c.textContent)));
  assert.deepEqual(here.flatMap(([target, compilers, on]) => compilers.split(', ').map(one => [target, one, on])),
    rows);
  await tab.close();
});
