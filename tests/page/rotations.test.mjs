// SPDX-License-Identifier: MIT
import assert from 'node:assert/strict';
import { after, test } from 'node:test';
import { centre, drag, follows, settled } from './drags.mjs';
import { close, near, printed, row, shown, within } from './models.mjs';
import { degrees, dot, euler, nearer, slerp, velocity } from './quaternions.mjs';

after(close);
const at = (query, use, options) => within(`rotations?${query}`, use, options);

const [A, B] = [[20, -50, 10], [40, 75, -35]]; // x y z
const keys = new URLSearchParams({ ax: A[0], ay: A[1], az: A[2], bx: B[0], by: B[1], bz: B[2] });
const [a, b] = [A, B].map(angles => euler('YXZ', angles)), h = Math.acos(Math.abs(dot(a, b)));
const nlerp = t => {
  const q = nearer(a, b).map((x, i) => a[i] + t * (x - a[i])), length = Math.hypot(...q);
  return q.map(x => x / length);
};
const linear = t => euler('YXZ', A.map((x, i) => x + t * (B[i] - x)));

test('orientations and speeds after a quarter of the time are those of the formulas', () =>
  at(`${keys}&time=0.5&turns=2`, (_, n) => {
    const t = 0.25, arc = 2 * h * degrees;
    const between = (p, q) => 2 * Math.acos(Math.min(Math.abs(dot(p, q)), 1)) * degrees;
    near(n['arc.0'], arc, 1e-3, 'arc');
    near(Math.abs(dot(row(n, 'q', 4), slerp(a, nearer(a, b), t))), 1, 1e-6, 'q');
    near(n['slerp.0'], arc / 2, 1e-3, 'slerp');
    near(n['long.0'], (360 - arc) / 2, 1e-3, 'the long arc');
    near(n['turns.0'], (arc + 720) / 2, 1e-3, 'two turns more');
    near(n['nlerp.0'], Math.sin(h) / ((1 - t) ** 2 + 2 * t * (1 - t) * Math.cos(h) + t * t) * degrees, 1e-3, 'nlerp');
    near(n['nlerp.1'], between(nlerp(t), slerp(a, nearer(a, b), t)), 1e-3, 'nlerp against slerp');
    near(n['euler.0'], Math.hypot(...velocity(linear, t)) / 2 * degrees, 1e-3, 'Euler angles');
    near(n['euler.1'], between(linear(t), slerp(a, nearer(a, b), t)), 1e-3, 'Euler angles against slerp');
  }));

test('the angular velocity of the object is that of its orientations', async () => {
  for (const [method, q] of [['euler', linear], ['nlerp', nlerp], ['slerp', t => slerp(a, nearer(a, b), t)]])
    await at(`${keys}&time=1.5&method=${method}`, (_, n) => {
      const w = velocity(q, 0.75).map(x => x / 2);
      row(n, 'w', 3).forEach((x, i) => near(x, w[i], 1e-5, `${method} ${i}`));
    });
});

test('the other sign of a key changes only the method that takes signs as given', async () => {
  let n, flipped;
  await at('time=0.5', (_, numbers) => { n = numbers; });
  await at('time=0.5&flip=1', (_, numbers) => { flipped = numbers; });
  for (const name of ['euler', 'nlerp', 'slerp', 'long', 'turns'])
    assert.deepEqual([flipped[`${name}.0`], flipped[`${name}.1`]], [n[`${name}.0`], n[`${name}.1`]], name);
  near(flipped['dot.0'], -n['dot.0'], 0, 'dot');
  near(n['given.0'], n['slerp.0'], 1e-4, 'the short arc');
  near(flipped['given.0'], n['long.0'], 1e-4, 'the long arc');
});

test('the other sign shows the object on the wrong way at once', () => at('', async tab => {
  const picture = () => tab.$eval('.space', canvas => canvas.toDataURL()), note = () => tab.textContent('.note');
  const before = await picture();
  assert.equal(await note(), '');
  await tab.getByLabel('B with the other sign').check();
  await settled(tab);
  assert.match(await note(), /long way/);
  assert.notEqual(await picture(), before);
}));

test('the legend hides a curve on the sphere, and the address keeps it', () => at('', async tab => {
  const picture = () => tab.$eval('.space', canvas => canvas.toDataURL()), before = await picture();
  const entry = tab.getByRole('button', { name: 'Euler angles' });
  await entry.click();
  await settled(tab);
  assert.equal(await entry.getAttribute('aria-pressed'), 'false');
  assert.notEqual(await picture(), before);
  await tab.waitForURL(/hidden=turns_euler/);
}));

for (const pointer of ['mouse', 'touch'])
  test(`a nose dragged by ${pointer} turns its key, and C prints the new numbers`, () =>
    at('time=0.75', async (tab, before) => {
      await follows(tab, '[data-handle="0"]', 25, 30, pointer);
      const numbers = await shown(tab);
      assert.notEqual(numbers['a.0'], before['a.0']);
      assert.equal(numbers['b.0'], before['b.0']);
      assert.deepEqual(await printed(tab), numbers);
    }, { hasTouch: pointer === 'touch' }));

test('the arrow keys move a nose, and turn the camera', () => at('', async (tab, before) => {
  const place = () => centre(tab, '[data-handle="0"]'), from = await place();
  await tab.focus('[data-handle="0"]');
  await tab.keyboard.press('ArrowRight');
  await settled(tab);
  const to = await place(), numbers = await shown(tab);
  near(to.x - from.x, 6, 0.5, 'x');
  near(to.y, from.y, 0.5, 'y');
  assert.notEqual(numbers['a.0'], before['a.0']);
  await tab.focus('.space');
  await tab.keyboard.press('ArrowLeft');
  await settled(tab);
  assert.ok(Math.abs((await place()).x - to.x) > 2);
  assert.deepEqual(await shown(tab), numbers);
}));

for (const pointer of ['mouse', 'touch'])
  test(`a drag of the space by ${pointer} turns the camera alone`, () => at('', async (tab, before) => {
    const from = await centre(tab, '[data-handle="0"]');
    await drag(tab, '.space', 60, 0, pointer);
    assert.ok(Math.abs((await centre(tab, '[data-handle="0"]')).x - from.x) > 5);
    assert.deepEqual(await shown(tab), before);
  }, { hasTouch: pointer === 'touch' }));

test('a method that is chosen is no longer hidden', () => at('', async tab => {
  const entry = tab.getByRole('button', { name: 'slerp, k more turns' });
  assert.equal(await entry.getAttribute('aria-pressed'), 'false');
  await tab.getByLabel('the object turns by').selectOption({ label: 'slerp, k more turns' });
  await settled(tab);
  assert.equal(await entry.getAttribute('aria-pressed'), 'true');
}));
