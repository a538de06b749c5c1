// SPDX-License-Identifier: MIT
// Joints: the numbers of docs/joints.md, each order against C, and a slider dragged by coordinates.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { after, test } from 'node:test';
import { close, open, printed, root, shown } from './models.mjs';

after(close);
const drawn = tab => tab.waitForSelector('main[data-drawn]', { state: 'attached', timeout: 60000 });
const orders = ['right', 'noParent', 'parentLast', 'swapped', 'noInverse', 'onlyTurn'];

test('the matrices and the vertex are those of the lesson finished', async () => {
  const text = readFileSync(`${root}/docs/joints.md`, 'utf8');
  const rows = i => text.split(`\njoint ${i}\n`)[1].split('inverse bind')[1].split('\n').slice(1, 5)
    .map(line => line.trim().split(/\s+/).map(Number));
  for (const i of [0, 1, 2, 3]) {
    const { tab } = await open(`joints?joint=${i}`);
    await drawn(tab);
    const numbers = await shown(tab);
    rows(i).forEach((list, r) => list.forEach((x, k) => {
      const here = numbers[k < 4 ? `I${r}.${k}` : `M${r}.${k - 4}`];
      assert.ok(Math.abs(here - x) < 1e-6, `joint ${i}, row ${r}, ${k}: ${here} ${x}`);
    }));
    const moved = text.match(/by blended matrices it goes to \((.*)\)/)[1].split(', ').map(Number);
    moved.forEach((x, k) => assert.ok(Math.abs(numbers[`moved.${k}`] - x) < 1e-6));
    const weights = text.match(/weights (\d+ \d+ \d+ \d+) of 65535/)[1].split(' ').map(Number);
    assert.deepEqual(weights.map((_, k) => numbers[`weights.${k}`]), weights);
    await tab.close();
  }
});

test('each order: the C program prints the numbers of the page, and only one is right', async () => {
  const places = new Set();
  for (const order of orders) {
    const { tab, problems } = await open(
      `joints?order=${order}&joint=2&ring=16&influence=${order === 'swapped' ? 'hard' : 'smooth'}&angle0=0.3&axis=z`);
    await drawn(tab);
    const numbers = await shown(tab);
    assert.deepEqual(await printed(tab), numbers, order);
    places.add([0, 1, 2].map(k => numbers[`moved.${k}`].toFixed(3)).join());
    assert.deepEqual(problems, []);
    await tab.close();
  }
  assert.equal(places.size, orders.length);
});

test('in the bind pose, the orders with T and its inverse do not move the mesh', async () => {
  for (const order of orders) {
    const { tab } = await open(`joints?order=${order}&angle1=0&angle2=0`);
    await drawn(tab);
    const numbers = await shown(tab);
    assert.equal([0, 1, 2].every(k => Math.abs(numbers[`moved.${k}`] - numbers[`vertex.${k}`]) < 1e-6), order !== 'noInverse', order);
    await tab.close();
  }
});

test('a slider is dragged: joint 1 turns, and joint 2 follows', async () => {
  const { tab } = await open('joints?lang=en&joint=2');
  await drawn(tab);
  const before = await shown(tab);
  const slider = tab.locator('.lil-controller', { hasText: 'J1: angle' }).locator('.lil-slider');
  const { x, y, width, height } = await slider.boundingBox();
  await tab.mouse.move(x + width * 0.58, y + height / 2);
  await tab.mouse.down();
  await tab.mouse.move(x + width * 0.75, y + height / 2, { steps: 5 });
  await tab.mouse.up();
  await tab.waitForFunction(old => Number(document.querySelector('[data-name="P1.2"]').dataset.value) !== old, before['P1.2']);
  const now = await shown(tab), angle = Number(await slider.locator('..').locator('input').inputValue());
  assert.ok(Math.abs(angle - 1.6) < 0.1, `${angle}`);
  assert.ok(Math.abs(now['P1.2'] + Math.sin(angle)) < 1e-6);
  assert.equal(now['J1.2'], before['J1.2']);
  await tab.close();
});
