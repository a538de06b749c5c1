// SPDX-License-Identifier: MIT
import assert from 'node:assert/strict';
import { after, test } from 'node:test';
import { centre, drag, settled } from './drags.mjs';
import { close, long, near, printed, row, shown, within } from './models.mjs';
import { degrees, dot, euler, inverse, product, rotated } from './quaternions.mjs';

after(close);
const orders = ['XYZ', 'XZY', 'YXZ', 'YZX', 'ZXY', 'ZYX'];
const axis = letter => [...'XYZ'].map(l => l === letter ? 1 : 0);
const at = (query, use, options) => within(`pole?${query}`, use, options);
const chosen = tab => tab.$eval('.order[aria-pressed=true] span', span => span.textContent);

/** The sine of the middle angle is, but for its sign, an element of the matrix: outer axis times R times inner axis. */
const toPole = (order, q) => 90 - Math.abs(Math.asin(dot(axis(order[0]), rotated(q, axis(order[2]))))) * degrees;

test('the angles of each order are the same orientation, and its pole is as far as the matrix says', () =>
  at('order=ZXY&x=50&y=-20&z=130', (_, n) => {
    const q = row(n, 'q', 4), own = euler('ZXY', [50, -20, 130]);
    near(Math.abs(dot(own, q)), 1, 1e-6, 'q');
    for (const order of orders) {
      near(Math.abs(dot(euler(order, row(n, order)), q)), 1, 1e-6, order);
      near(n[`${order}.3`], toPole(order, own), 1e-3, `${order}: its pole`);
    }
    near(n['ZXY.3'], 40, 1e-3, 'the middle angle is 50');
    near(Math.abs(dot(euler('ZXY', row(n, 'other')), q)), 1, 1e-6, 'the other angles');
  }));

test('at a middle angle of 90 degrees the outer and the inner axis coincide, and C prints it', long, async () => {
  for (const order of orders)
    await at(new URLSearchParams({ order, x: 30, y: 40, z: 20, [order[1].toLowerCase()]: 90 }), async (tab, n) => {
      near(Math.abs(dot(row(n, 'outer'), row(n, 'inner'))), 1, 1e-6, order);
      near(dot(row(n, 'outer'), row(n, 'middle')), 0, 1e-6, order);
      assert.match(await tab.textContent('.beside .note'), /no gimbal/);
      assert.deepEqual(await printed(tab), n);
    });
});

test('the pass misses the pole by the angle given, and C prints it', () =>
  at('order=XYZ&by=pass&miss=5&time=1', async (tab, n) => {
    near(Math.abs(n['angles.1']), 85, 1e-3, 'middle angle');
    near(n['XYZ.3'], 5, 1e-3, 'distance');
    assert.deepEqual(await printed(tab), n);
  }));

test('the angles turn at the speeds of the formula: beside the pole far faster than the object', long, async () => {
  for (const order of orders)
    await at(`order=${order}&by=pass&miss=3&time=1.015625`, async (tab, n) => {
      const h = 1e-5, angles = row(n, 'angles'), [i, j] = [...order].map(letter => 'XYZ'.indexOf(letter));
      const about = (k, angle) => euler('XYZ'[k], [0, 1, 2].map(l => l === k ? angle : 0));
      near(Math.abs(dot(product(about(j, 90 + 60 * 0.015625), about(i, 3)), row(n, 'q', 4))), 1, 1e-6, `${order}: q`);
      // The orientation after h seconds at these speeds is that of the object.
      const later = euler(order, angles.map((angle, k) => angle + h * n[`speed.${k}`])), now = euler(order, angles);
      const turn = product(later, inverse(now)).map(x => x * 2 / h * degrees);
      [0, 1, 2].forEach(k => near(turn[k], k === j ? 60 : 0, 0.05, `${order}: w ${k}`));
      assert.ok(Math.max(...row(n, 'speed').map(Math.abs)) > 1000);
      assert.deepEqual(await printed(tab), n);
    });
});

for (const pointer of ['mouse', 'touch'])
  test(`a gimbal dragged by ${pointer} changes its angle alone`, () => at('', async (tab, before) => {
    await drag(tab, '[data-handle="0"]', 0, 10, pointer);
    const numbers = await shown(tab);
    assert.ok(Math.abs(numbers['angles.1'] - before['angles.1']) > 2);
    near(numbers['angles.0'], before['angles.0'], 0.01, 'x');
    near(numbers['angles.2'], before['angles.2'], 0.01, 'z');
    assert.deepEqual(await printed(tab), numbers);
  }, { hasTouch: pointer === 'touch' }));

test('the arrow keys turn a gimbal', () => at('', async (tab, before) => {
  const from = await centre(tab, '[data-handle="2"]');
  await tab.focus('[data-handle="2"]');
  await tab.keyboard.press('ArrowRight');
  await settled(tab);
  const numbers = await shown(tab);
  assert.ok((await centre(tab, '[data-handle="2"]')).x > from.x + 2);
  assert.ok(Math.abs(numbers['angles.2'] - before['angles.2']) > 1);
  near(numbers['angles.1'], before['angles.1'], 0.01, 'y');
}));

test('buttons bring the middle gimbal to the pole and away', () => at('order=ZYX&x=20&y=-30&z=50', async tab => {
  const press = async name => {
    await tab.getByRole('button', { name, exact: true }).click();
    await settled(tab);
    return row(await shown(tab), 'angles').map(x => +x.toFixed(3));
  };
  assert.deepEqual(await press('to the pole'), [20, -90, 50]);
  assert.deepEqual(await press('away from the pole'), [20, 0, 50]);
}));

test('another order by its bar: the object stays', () => at('x=80', async (tab, before) => {
  assert.equal(await chosen(tab), 'YXZ');
  await tab.getByRole('button', { name: /^XYZ/ }).click();
  await settled(tab);
  const numbers = await shown(tab);
  assert.equal(await chosen(tab), 'XYZ');
  near(Math.abs(dot(row(numbers, 'q', 4), row(before, 'q', 4))), 1, 1e-6, 'q');
  [0, 1, 2].forEach(i => near(numbers[`angles.${i}`], before[`XYZ.${i}`], 0.006, 'angles'));
}));

test('a later time begins the pass, and an angle ends it where it is', () => at('', async tab => {
  await tab.locator('.time').evaluate(slider => {
    slider.value = '0.5';
    slider.dispatchEvent(new Event('input'));
  });
  await settled(tab);
  const pass = await shown(tab);
  assert.ok('speed.0' in pass);
  near(pass['angles.0'], 60, 0.2, 'x'); // 30 + 60/2
  await tab.focus('[data-handle="0"]');
  await tab.keyboard.press('ArrowRight');
  await settled(tab);
  const numbers = await shown(tab);
  assert.ok(!('speed.0' in numbers));
  near(numbers['angles.0'], pass['angles.0'], 0.01, 'x stays');
}));

test('through the pole itself: its numbers are those of C', () => at('by=pass&miss=0&time=1', async (tab, n) => {
  near(n['YXZ.3'], 0, 1e-3, 'distance');
  assert.deepEqual(await printed(tab), n);
}));
