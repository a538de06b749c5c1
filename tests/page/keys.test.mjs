// SPDX-License-Identifier: MIT
// Exhibit 2: drags of a key and of a tangent, and the Hermite curve by its basis, per second and per segment.
import assert from 'node:assert/strict';
import { after, test } from 'node:test';
import { close, open, printed, shown } from './models.mjs';

after(close);
const start = async address => {
  const { tab, problems } = await open(address);
  await tab.waitForSelector('main[data-drawn]', { state: 'attached' });
  return { tab, problems };
};
const near = (a, b) => assert.ok(Math.abs(a - b) < 1e-5, `${a} ${b}`);

/** Value, velocity and acceleration of the default keys in the segment from 0.5 to 2 seconds. */
function hermite(time, scale) {
  const h = 1.5, t = (time - 0.5) / h, p = [1, 2], v = [1.5, -3].map(x => scale === 'second' ? x * h : x);
  const sum = w => w[0] * p[0] + w[1] * v[0] + w[2] * p[1] + w[3] * v[1];
  return [sum([2 * t ** 3 - 3 * t ** 2 + 1, t ** 3 - 2 * t ** 2 + t, 3 * t ** 2 - 2 * t ** 3, t ** 3 - t ** 2]),
    sum([6 * t * t - 6 * t, 3 * t * t - 4 * t + 1, 6 * t - 6 * t * t, 3 * t * t - 2 * t]) / h,
    sum([12 * t - 6, 6 * t - 4, 6 - 12 * t, 6 * t - 2]) / h ** 2];
}

for (const scale of ['second', 'segment'])
  test(`the Hermite curve, tangents per ${scale}`, async () => {
    const { tab, problems } = await start(`keys?time=0.75&scale=${scale}`), numbers = await shown(tab);
    hermite(0.75, scale).forEach((x, i) => near(numbers[`own.${i}`], x));
    near(numbers['linear.0'], 1 + 1 / 6);
    assert.equal(numbers['step.0'], 1);
    assert.deepEqual(await printed(tab), numbers);
    assert.deepEqual(problems, []);
    await tab.close();
  });

test('the velocity jumps at a key if tangents are read per segment', async () => {
  for (const [time, velocity] of [[1.999999, -3 / 1.5], [2, -3 / 0.5]]) {
    const { tab } = await start(`keys?time=${time}&scale=segment`);
    assert.ok(Math.abs((await shown(tab))['own.1'] - velocity) < 1e-3);
    await tab.close();
  }
});

async function drag(tab, handle, dx, dy) {
  await tab.locator(`[data-handle="${handle}"]`).scrollIntoViewIfNeeded();
  const box = await tab.locator(`[data-handle="${handle}"]`).boundingBox();
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await tab.mouse.move(x, y);
  await tab.mouse.down();
  await tab.mouse.move(x + dx, y + dy, { steps: 4 });
  await tab.mouse.up();
  await tab.waitForTimeout(100);
}

test('a drag of a key moves every curve, one of a tangent takes the tangents of the method', async () => {
  const { tab, problems } = await start('keys?time=0.75&method=pchip'), before = await shown(tab);
  await drag(tab, 1, 0, -20);
  const moved = await shown(tab);
  for (const name of ['step', 'linear', 'catmull', 'pchip', 'c2', 'bspline'])
    assert.ok(moved[`${name}.0`] > before[`${name}.0`], name);
  await drag(tab, 6, 0, -15);
  const turned = await shown(tab);
  assert.ok(turned['after.1'] > moved['after.1']);
  assert.equal(turned['after.3'], moved['after.3']);
  assert.equal(turned['pchip.0'], moved['pchip.0']);
  assert.deepEqual(problems, []);
  await tab.close();
});
