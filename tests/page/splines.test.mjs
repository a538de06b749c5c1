// SPDX-License-Identifier: MIT
import assert from 'node:assert/strict';
import { after, test } from 'node:test';
import { close, open, printed, shown } from './models.mjs';

after(close);
const drawn = tab => tab.waitForSelector('main[data-drawn]', { state: 'attached', timeout: 60000 });
const near = (a, b, tolerance, what) => assert.ok(Math.abs(a - b) <= tolerance, `${what}: ${a}, ${b}`);

async function at(query, use) {
  const { tab, problems } = await open(`splines?${query}`);
  await drawn(tab);
  await use(tab, await shown(tab));
  assert.deepEqual(problems, []);
  await tab.close();
}
const even = ['gltf', 'hermite', 'bspline'];

test('evenly spaced keys: only slerp has a corner', () => at('', (_, n) => {
  assert.ok(n['slerp_key.2'] > 10);
  for (const method of [...even, 'squad'])
    near(n[`${method}_key.2`], 0, 0.01, method);
}));

test('unevenly spaced keys: squad has a corner too, curves of velocities per second have none', () =>
  at('middle=1.3&time=2.25', async (tab, n) => {
    for (const method of ['squad', 'bspline'])
      assert.ok(n[`${method}_key.2`] > 5, method);
    for (const method of ['gltf', 'hermite'])
      near(n[`${method}_key.2`], 0, 0.01, method);
    assert.deepEqual(await printed(tab), n);
  }));

test('keys by yaw alone: the velocity is that of the angles', () => at(new URLSearchParams({ time: 2.5,
  keys: '0_0_0_0_30_0_0_50_0_0_90_0_0_100_0' }), (_, n) => {
  near(n['slerp.3'], 40, 1e-3, 'slerp'); // from 50 to 90 degrees in a second
  near(n['slerp_key.0'], 20, 1e-3, 'before');
  near(n['slerp_key.2'], 20, 1e-3, 'jump');
  near(n['hermite_key.0'], 30, 1e-3, 'the mean of both'); // (90 - 30)/2
  near(n['squad_key.0'], 30, 1e-3, 'squad');
  near(n['bspline_key.0'], 30, 1e-3, 'B-spline');
}));

test('a dragged nose changes the velocities, and C prints them; the end of time is in range', () =>
  at('time=4', async (tab, before) => {
    const box = await tab.locator('[data-handle="2"]').boundingBox(), x = box.x + 11, y = box.y + 11;
    await tab.mouse.move(x, y);
    await tab.mouse.down();
    await tab.mouse.move(x + 20, y + 25, { steps: 2 });
    await tab.mouse.up();
    await tab.waitForTimeout(100);
    const numbers = await shown(tab);
    assert.notEqual(numbers['slerp_key.2'], before['slerp_key.2']);
    assert.deepEqual(await printed(tab), numbers);
  }));
