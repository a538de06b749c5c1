// SPDX-License-Identifier: MIT
// Joints: the numbers of docs/joints.md, each product against C and against binary64, and drags, clicks and keys.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { after, test } from 'node:test';
import { centre, drag } from './drags.mjs';
import { close, long, printed, root, shown, start } from './models.mjs';

after(close);
const orders = ['turn', 'origin', 'noParent', 'right', 'noInverse', 'noTranslation', 'turnFirst', 'swapped',
  'parentLast', 'transposed', 'degrees', 'unnormalised'];
const heights = [0, 1, 2, 3];

async function numbersOf(address) {
  const { tab, problems } = await start(address);
  const numbers = await shown(tab);
  assert.deepEqual(problems, []);
  return { tab, numbers };
}

/* ---- the numbers ---- */

test('the matrices and the vertex are those of the lesson finished', async () => {
  const text = readFileSync(`${root}/docs/joints.md`, 'utf8');
  const rows = i => text.split(`\njoint ${i}\n`)[1].split('inverse bind')[1].split('\n').slice(1, 5)
    .map(line => line.trim().split(/\s+/).map(Number));
  for (const i of heights) {
    const { tab, numbers } = await numbersOf(`joints?joint=${i}`);
    rows(i).forEach((list, r) => list.forEach((x, k) => {
      const here = numbers[k < 4 ? `I${r}.${k}` : `M${r}.${k - 4}`];
      assert.ok(Math.abs(here - x) < 1e-6, `joint ${i}, row ${r}, ${k}: ${here} ${x}`);
    }));
    const moved = text.match(/by blended matrices it goes to \((.*)\)/)[1].split(', ').map(Number);
    moved.forEach((x, k) => assert.ok(Math.abs(numbers[`moved.${k}`] - x) < 1e-6));
    const weights = text.match(/weights (\d+ \d+ \d+ \d+) of 65535/)[1].split(' ').map(Number);
    assert.deepEqual(weights.map((_, k) => numbers[`weights.${k}`]), weights);
    assert.equal(numbers['sum.0'], 65535);
    await tab.close();
  }
});

// Matrices by rows, in binary64.
const mul = (a, b) => a.map(row => [0, 1, 2, 3].map(k => row.reduce((sum, x, i) => sum + x * b[i][k], 0)));
const move = (m, p) => m.slice(0, 3).map(([x, y, z, w]) => x * p[0] + y * p[1] + z * p[2] + w);
const shift = y => [[1, 0, 0, 0], [0, 1, 0, y], [0, 0, 1, 0], [0, 0, 0, 1]];
function rotation(angle) { // about z
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  return [[c, -s, 0, 0], [s, c, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]];
}

/** The matrices of the joints by the words of each product, for the angles given. */
function palette(order, angles) {
  const product = [];
  heights.forEach((h, i) => {
    const [P, T, I] = [product[i - 1] ?? shift(0), shift(h), shift(-h)];
    const J = rotation(order === 'degrees' ? angles[i] * 180 / Math.PI : angles[i]);
    const right = [P, T, J, I];
    const list = { turn: [J], origin: [J, I], noParent: [T, J, I], noInverse: [P, T, J], noTranslation: [P, J, I],
      turnFirst: [P, J, T, I], swapped: [P, I, J, T], parentLast: [T, J, I, P] }[order] ?? right;
    product.push(list.reduce(mul));
  });
  return order === 'transposed' ? product.map(m => m.map((_, r) => m.map(row => row[r]))) : product;
}

test('each product: C prints the numbers of the page, and the vertex is at the same place in binary64', long,
  async () => {
  const places = new Map();
  for (const order of orders) {
    const { tab, numbers } = await numbersOf(`joints?order=${order}&joint=2&ring=16&column=3&angle0=0.3&axis=z`);
    const of = await printed(tab);
    for (const [name, value] of Object.entries(numbers))
      assert.ok(Object.is(of[name], value), `${order}, ${name}: ${value}, C prints ${of[name]}`);
    const list = palette(order, [0.3, 0.5, -0.5, 0]), at = k => [0, 1, 2].map(i => numbers[`${k}.${i}`]);
    const wanted = [0, 1, 2].map(k => list.reduce((sum, m, j) =>
      sum + numbers[`weights.${j}`] / 65535 * move(m, at('vertex'))[k], 0));
    wanted.forEach((x, k) => assert.ok(Math.abs(at('moved')[k] - x) < 3e-6, `${order}: ${at('moved')} ${wanted}`));
    assert.equal(numbers['sum.0'], [0, 1, 2, 3].reduce((sum, j) => sum + numbers[`weights.${j}`], 0));
    assert.equal(numbers['sum.0'] === 65535, order !== 'unnormalised');
    places.set(order, at('moved').map(x => x.toFixed(3)).join());
    await tab.close();
  }
  assert.equal(new Set(places.values()).size, orders.length, [...places].join('; '));
});

test('in the bind pose, some products do not move the mesh', long, async () => {
  const wrong = ['origin', 'noInverse', 'noTranslation', 'unnormalised'];
  for (const order of orders) {
    const { tab, numbers } = await numbersOf(`joints?order=${order}&angle1=0&angle2=0`);
    const still = [0, 1, 2].every(k => Math.abs(numbers[`moved.${k}`] - numbers[`vertex.${k}`]) < 1e-6);
    assert.equal(still, !wrong.includes(order), order);
    await tab.close();
  }
});

test('one joint per vertex, as in the lesson: the weight is 65535', async () => {
  const { tab, numbers } = await numbersOf('joints?influence=hard');
  assert.deepEqual([0, 1, 2, 3].map(j => numbers[`weights.${j}`]), [0, 0, 65535, 0]);
  await tab.close();
});

test('the timer of the lesson: |fmod(timer, 1) - 0.5| radians', async () => {
  for (const time of [0, 0.5, 1, 2, 3.25]) {
    const { tab, numbers } = await numbersOf(`joints?time=${time}&joint=1`), angle = Math.abs(time / 4 % 1 - 0.5);
    assert.ok(Math.abs(numbers['J2.1'] - Math.sin(angle)) < 1e-6, `${time}: ${numbers['J2.1']} ${angle}`);
    await tab.close();
  }
});

/* ---- handles, clicks, keys ---- */

const value = name => Number(document.querySelector(`[data-name="${name}"]`).dataset.value);
const angleOf = numbers => Math.atan2(numbers['J2.1'], numbers['J1.1']);
const changed = (tab, name, old) => tab.waitForFunction(([n, before]) =>
  Number(document.querySelector(`[data-name="${n}"]`).dataset.value) !== before, [name, old]);

test('a handle is dragged: its joint turns, is shown, and the next one follows', async () => {
  const { tab, numbers: before } = await numbersOf('joints?lang=en&joint=2&yaw=90&pitch=0');
  await drag(tab, '[data-handle="1"]', 20, 60);
  await changed(tab, 'J1.1', before['J1.1']);
  const now = await shown(tab), angle = angleOf(now);
  assert.ok(angle > 0.7, `${angle}`);
  assert.match(await tab.textContent('.equation'), /^M1/);
  await tab.keyboard.press('j');
  await tab.waitForFunction(() => document.querySelector('.equation').textContent.startsWith('M2'));
  assert.ok(Math.abs((await shown(tab))['P2.1'] - Math.sin(angle)) < 1e-6);
  await tab.close();
});

test('a finger drags a handle', async () => {
  const { tab } = await start('joints?lang=en&yaw=90&pitch=0',
    { hasTouch: true, viewport: { width: 390, height: 844 } });
  const before = await shown(tab);
  await drag(tab, '[data-handle="1"]', 13, 40, 'touch');
  await changed(tab, 'J1.1', before['J1.1']);
  assert.ok(angleOf(await shown(tab)) > 0.7);
  await tab.close();
});

test('arrow keys turn the joint of a handle', async () => {
  const { tab, numbers: before } = await numbersOf('joints?lang=en');
  await tab.focus('[data-handle="1"]');
  await tab.keyboard.press('ArrowRight');
  await changed(tab, 'J1.1', before['J1.1']);
  assert.ok(Math.abs(angleOf(await shown(tab)) - 0.55) < 1e-6);
  await tab.close();
});

test('a click chooses a vertex, and keys choose others', async () => {
  const { tab, numbers: before } = await numbersOf('joints?lang=en&angle1=0&angle2=0&yaw=0&pitch=0');
  const { x, y } = await centre(tab, 'canvas.space');
  await tab.mouse.click(x, y);
  await changed(tab, 'vertex.1', before['vertex.1']);
  const now = await shown(tab);
  assert.ok(Math.abs(now['vertex.1'] - 1.5) < 0.1 && now['vertex.2'] > 0.45, `${now['vertex.1']} ${now['vertex.2']}`);
  await tab.keyboard.press('u');
  await changed(tab, 'vertex.1', now['vertex.1']);
  assert.ok(await tab.evaluate(value, 'vertex.1') > now['vertex.1']);
  await tab.close();
});

test('a drag during the play stops it and keeps the other angles', async () => {
  const { tab } = await start('joints?lang=en&time=1&joint=2&yaw=90&pitch=0');
  await drag(tab, '[data-handle="1"]', 10, 30);
  await tab.waitForFunction(() => document.querySelector('.seconds').textContent === '0.00 s');
  await tab.keyboard.press('j');
  await tab.waitForFunction(() => document.querySelector('.equation').textContent.startsWith('M2'));
  assert.ok(Math.abs(angleOf(await shown(tab)) + 0.25) < 1e-6);
  await tab.close();
});
