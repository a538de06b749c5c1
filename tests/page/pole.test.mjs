// SPDX-License-Identifier: MIT
import assert from 'node:assert/strict';
import { after, test } from 'node:test';
import { close, open, printed, shown } from './models.mjs';

after(close);
const drawn = tab => tab.waitForSelector('main[data-drawn]', { state: 'attached', timeout: 60000 });
const near = (a, b, tolerance, what) => assert.ok(Math.abs(a - b) <= tolerance, `${what}: ${a}, ${b}`);
const row = (numbers, name, count = 3) => Array.from({ length: count }, (_, i) => numbers[`${name}.${i}`]);
const dot = (a, b) => a.reduce((sum, x, i) => sum + x * b[i], 0);
const orders = ['XYZ', 'XZY', 'YXZ', 'YZX', 'ZXY', 'ZYX'];

async function at(query, use) {
  const { tab, problems } = await open(`pole?${query}`);
  await drawn(tab);
  await use(tab, await shown(tab));
  assert.deepEqual(problems, []);
  await tab.close();
}

// The quaternion of a product of rotations about axes, by the product of quaternions.
function product(order, angles) {
  return [...order].reduce(([x, y, z, w], letter) => {
    const i = 'XYZ'.indexOf(letter), half = angles[i] * Math.PI / 360, s = Math.sin(half), c = Math.cos(half);
    const [a, b, d] = [0, 1, 2].map(k => k === i ? s : 0);
    return [w * a + x * c + y * d - z * b, w * b + y * c + z * a - x * d, w * d + z * c + x * b - y * a,
      w * c - x * a - y * b - z * d];
  }, [0, 0, 0, 1]);
}

test('the angles of each order are the same orientation', () => at('order=ZXY&x=50&y=-20&z=130', (_, n) => {
  const q = row(n, 'q', 4);
  near(Math.abs(dot(product('ZXY', [50, -20, 130]), q)), 1, 1e-6, 'q');
  for (const order of orders)
    near(Math.abs(dot(product(order, row(n, order)), q)), 1, 1e-6, order);
  near(Math.abs(dot(product('ZXY', row(n, 'other')), q)), 1, 1e-6, 'the other angles');
}));

test('at a middle angle of 90 degrees the outer and the inner axis coincide, and C prints it', async () => {
  for (const order of orders)
    await at(new URLSearchParams({ order, x: 30, y: 40, z: 20, [order[1].toLowerCase()]: 90 }), async (tab, n) => {
      near(Math.abs(dot(row(n, 'outer'), row(n, 'inner'))), 1, 1e-6, order);
      near(dot(row(n, 'outer'), row(n, 'middle')), 0, 1e-6, order);
      assert.deepEqual(await printed(tab), n);
    });
});

test('the pass misses the pole by the angle given, and C prints it', () =>
  at('order=XYZ&by=pass&miss=5&time=1', async (tab, n) => {
    near(Math.abs(n['angles.1']), 85, 1e-3, 'middle angle');
    assert.deepEqual(await printed(tab), n);
  }));

test('a dragged gimbal changes its angle alone', () => at('', async (tab, before) => {
  const box = await tab.locator('[data-handle="0"]').boundingBox(), x = box.x + 11, y = box.y + 11;
  await tab.mouse.move(x, y);
  await tab.mouse.down();
  await tab.mouse.move(x, y + 10, { steps: 2 });
  await tab.mouse.up();
  await tab.waitForTimeout(100);
  const numbers = await shown(tab);
  assert.ok(Math.abs(numbers['angles.1'] - before['angles.1']) > 2);
  near(numbers['angles.0'], before['angles.0'], 0.01, 'x');
  near(numbers['angles.2'], before['angles.2'], 0.01, 'z');
}));
