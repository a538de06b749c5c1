// SPDX-License-Identifier: MIT
// The value at a time by bisection, the triangle of a split, a vertical curve, the ellipse of the policies,
// and drags that end the regression.
import assert from 'node:assert/strict';
import { after, test } from 'node:test';
import { centre, drag } from './drags.mjs';
import { close, near, printed, shown, start } from './models.mjs';

after(close);
const bezier = (a, b, c, d, s) => (1 - s) ** 3 * a + 3 * s * (1 - s) ** 2 * b + 3 * s * s * (1 - s) * c + s ** 3 * d;

/* ---- the numbers ---- */

/** A segment that does not run back, and its parameter at 0.3. */
const steady = '0_0_0.8_0.2_-0.1_0.5_1_1', timesOf = [0, 0.8, 0.9, 1], valuesOf = [0, 0.2, 1.5, 1];
function parameter(time) {
  let [low, high] = [0, 1];
  for (let i = 0; i < 60; i++) {
    const middle = (low + high) / 2;
    [low, high] = bezier(...timesOf, middle) < time ? [middle, high] : [low, middle];
  }
  return low;
}

test('a segment that does not run back, by bisection', async () => {
  const { tab, problems } = await start(`time?time=0.3&segment=${steady}`), numbers = await shown(tab);
  near(numbers['none.2'], parameter(0.3));
  near(numbers['none.0'], bezier(...valuesOf, parameter(0.3)));
  assert.equal(numbers['runs_back.0'], 0);
  assert.deepEqual(await printed(tab), numbers);
  assert.deepEqual(problems, []);
  await tab.close();
});

test('the split, by the triangle of de Casteljau', async () => {
  const { tab, problems } = await start(`time?time=0.3&split=1&segment=${steady}`), numbers = await shown(tab);
  const s = parameter(0.3), halve = points => points.slice(1).map((p, i) => points[i] + s * (p - points[i]));
  [timesOf, valuesOf].forEach((p, i) => {
    const first = halve(p), second = halve(first), [key] = halve(second);
    near(numbers[`key.${i}`], key);
    near(numbers[`left.${i}`], first[0] - p[0]);
    near(numbers[`left.${2 + i}`], second[0] - key);
    near(numbers[`right.${i}`], second[1] - key);
    near(numbers[`right.${2 + i}`], first[2] - p[3]);
  });
  assert.equal(numbers['key.1'], numbers['none.0']);
  assert.deepEqual(await printed(tab), numbers);
  assert.deepEqual(problems, []);
  await tab.close();
});

test('the velocity is infinite where the curve is vertical, on the page and in C', async () => {
  const { tab } = await start('time?time=0.5'), numbers = await shown(tab);
  assert.equal(numbers['contain.1'], Infinity);
  assert.equal(await tab.textContent('[data-name="contain.1"]'), '∞');
  assert.deepEqual(await printed(tab), numbers);
  await tab.close();
  const falling = await start('time?time=0&segment=0_0_0_-0.5_-0.3_0_1_1');
  assert.equal((await shown(falling.tab))['none.1'], -Infinity);
  assert.equal(await falling.tab.textContent('[data-name="none.1"]'), '−∞');
  assert.deepEqual(await printed(falling.tab), await shown(falling.tab));
  await falling.tab.close();
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

/* ---- what can be done ---- */

/** Drags a handle until it is above or below another. */
async function over(tab, handle, target, pointer) {
  const [from, to] = [handle, target].map(k => `[data-handle="${k}"]`), { x } = await centre(tab, from);
  await drag(tab, from, (await centre(tab, to)).x - x, 0, pointer);
}
const until = (tab, name, value) => tab.waitForFunction(([key, text]) =>
  document.querySelector(`[data-name="${key}"]`)?.dataset.value === text, [name, value]);

function assertEqualCurves(numbers) {
  for (const name of ['contain', 'ratio', 'start'])
    for (let i = 0; i < 3; i++)
      assert.equal(numbers[`${name}.${i}`], numbers[`none.${i}`]);
}

test('drags of the handles end the regression, and every policy then has the same curve', async () => {
  const { tab, problems } = await start('time');
  await over(tab, 2, 0);
  await over(tab, 3, 1);
  await until(tab, 'runs_back.0', '0');
  assertEqualCurves(await shown(tab));
  assert.deepEqual(problems, []);
  await tab.close();
});

test('a finger drags a handle', async () => {
  const { tab, problems } = await start('time', { hasTouch: true, viewport: { width: 390, height: 844 } });
  await over(tab, 2, 0, 'touch');
  await tab.waitForFunction(() =>
    Number(document.querySelector('[data-name="none_handles.0"]').dataset.value) < 0.05);
  assert.deepEqual(problems, []);
  await tab.close();
});

test('the sentence follows the policy, and s splits', async () => {
  const { tab } = await start('time');
  for (const name of ['none', 'contain', 'ratio', 'start']) {
    await tab.selectOption('.side select', { index: ['none', 'contain', 'ratio', 'start'].indexOf(name) });
    const word = { none: 'None:', contain: 'Contain:', ratio: 'Keep the ratio:', start: 'Keep the start:' }[name];
    await tab.waitForFunction(text => document.querySelector('.side .note').textContent.startsWith(text), word);
  }
  await tab.focus('#stage');
  await tab.keyboard.press('s');
  await tab.waitForSelector('[data-name="right.3"]');
  await tab.close();
});
