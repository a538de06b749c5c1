// SPDX-License-Identifier: MIT
import assert from 'node:assert/strict';
import { after, test } from 'node:test';
import { close, open, printed, shown } from './models.mjs';

after(close);
const drawn = tab => tab.waitForSelector('main[data-drawn]', { state: 'attached', timeout: 60000 });
const near = (a, b, tolerance, what) => assert.ok(Math.abs(a - b) <= tolerance, `${what}: ${a}, ${b}`);
const degrees = 180 / Math.PI;

async function numbersAt(query) {
  const { tab, problems } = await open(`rotations?${query}`);
  await drawn(tab);
  const numbers = await shown(tab);
  assert.deepEqual(problems, []);
  await tab.close();
  return numbers;
}

test('arcs and speeds follow from the dot product of the keys', async () => {
  const n = await numbersAt('time=0.5&turns=2'), dot = [0, 1, 2, 3].reduce((sum, i) => sum + n[`a.${i}`] * n[`b.${i}`], 0);
  const arc = 2 * Math.acos(Math.abs(dot)) * degrees;
  near(n['arc.0'], arc, 1e-3, 'arc');
  near(n['slerp.0'], arc / 2, 0.01, 'slerp');
  near(n['long.0'], (360 - arc) / 2, 0.01, 'the long way');
  near(n['turns.0'], (arc + 720) / 2, 0.01, 'two turns more');
  // nlerp after a quarter: tan p = t sin h/(1 - t + t cos h), h half the arc
  const h = arc / 2 / degrees, p = Math.atan2(0.25 * Math.sin(h), 0.75 + 0.25 * Math.cos(h));
  near(n['nlerp.1'], Math.abs(2 * p * degrees - arc / 4), 1e-3, 'nlerp against slerp');
  assert.ok(n['euler.1'] > 1, 'Euler angles leave the arc');
});

test('the other sign of a key changes only the method that takes signs as given', async () => {
  const [n, flipped] = [await numbersAt('time=0.5'), await numbersAt('time=0.5&flip=1')];
  for (const name of ['euler', 'nlerp', 'slerp', 'long', 'turns'])
    assert.deepEqual([flipped[`${name}.0`], flipped[`${name}.1`]], [n[`${name}.0`], n[`${name}.1`]], name);
  near(flipped['dot.0'], -n['dot.0'], 0, 'dot');
  near(Math.max(n['given.0'], flipped['given.0']), n['long.0'], 0.01, 'one of them is the long arc');
});

test('a dragged nose turns its key, and C prints the new numbers', async () => {
  const { tab, problems } = await open('rotations?time=0.75');
  await drawn(tab);
  const before = await shown(tab), box = await tab.locator('[data-handle="1"]').boundingBox();
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await tab.mouse.move(x, y);
  await tab.mouse.down();
  await tab.mouse.move(x + 25, y + 30, { steps: 3 });
  await tab.mouse.up();
  await tab.waitForTimeout(100);
  const numbers = await shown(tab), moved = await tab.locator('[data-handle="1"]').boundingBox();
  assert.notEqual(numbers['b.0'], before['b.0']);
  assert.equal(numbers['a.0'], before['a.0']);
  near(moved.x - box.x, 25, 1.5, 'the nose follows the pointer');
  near(moved.y - box.y, 30, 1.5, 'the nose follows the pointer');
  assert.deepEqual(await printed(tab), numbers);
  assert.deepEqual(problems, []);
  await tab.close();
});
