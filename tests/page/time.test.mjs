// SPDX-License-Identifier: MIT
// Exhibit 3: the value at a time by bisection, the ellipse of the policies, and a drag that ends the regression.
import assert from 'node:assert/strict';
import { after, test } from 'node:test';
import { close, open, printed, shown } from './models.mjs';

after(close);
const start = async address => {
  const { tab, problems } = await open(address);
  await tab.waitForSelector('main[data-drawn]', { state: 'attached' });
  return { tab, problems };
};
const near = (a, b, tolerance = 1e-5) => assert.ok(Math.abs(a - b) < tolerance, `${a} ${b}`);
const bezier = (a, b, c, d, s) => (1 - s) ** 3 * a + 3 * s * (1 - s) ** 2 * b + 3 * s * s * (1 - s) * c + s ** 3 * d;

test('a segment that does not run back, by bisection', async () => {
  const { tab, problems } = await start('time?time=0.3&segment=0_0_0.8_0.2_-0.1_0.5_1_1'), numbers = await shown(tab);
  let [low, high] = [0, 1];
  for (let i = 0; i < 60; i++) {
    const middle = (low + high) / 2;
    [low, high] = bezier(0, 0.8, 0.9, 1, middle) < 0.3 ? [middle, high] : [low, middle];
  }
  near(numbers['none.2'], low);
  near(numbers['none.0'], bezier(0, 0.2, 1.5, 1, low));
  assert.equal(numbers['runs_back.0'], 0);
  assert.deepEqual(await printed(tab), numbers);
  assert.deepEqual(problems, []);
  await tab.close();
});

test('the policies shorten the handles as they say', async () => {
  const { tab } = await start('time'), numbers = await shown(tab);
  const lengths = name => [numbers[`${name}_handles.0`], -numbers[`${name}_handles.2`]];
  assert.equal(numbers['runs_back.0'], 1);
  assert.deepEqual(lengths('contain'), [1, 1]);
  const [p, q] = lengths('ratio');
  near(p / q, 1.75 / 1.05);
  near(p * p + p * q + q * q - 2 * (p + q) + 1, 0);
  [4 / 3, 1 / 3].forEach((x, i) => near(lengths('start')[i], x));
  await tab.close();
});

test('a drag of a handle ends the regression, and every policy then has the same curve', async () => {
  const { tab, problems } = await start('time');
  const drag = async (handle, dx) => {
    const box = await tab.locator(`[data-handle="${handle}"]`).boundingBox();
    await tab.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
    await tab.mouse.down();
    await tab.mouse.move(box.x + box.width / 2 + dx, box.y + box.height / 2, { steps: 4 });
    await tab.mouse.up();
    await tab.waitForTimeout(100);
  };
  await drag(2, -300);
  await drag(3, 150);
  const numbers = await shown(tab);
  assert.equal(numbers['runs_back.0'], 0);
  for (const name of ['contain', 'ratio', 'start'])
    for (let i = 0; i < 3; i++)
      assert.equal(numbers[`${name}.${i}`], numbers[`none.${i}`]);
  assert.deepEqual(problems, []);
  await tab.close();
});
