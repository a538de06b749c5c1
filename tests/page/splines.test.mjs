// SPDX-License-Identifier: MIT
import assert from 'node:assert/strict';
import { after, test } from 'node:test';
import { centre, drag, follows, settled } from './drags.mjs';
import { close, drawn, near, open, printed, row, shown, within } from './models.mjs';
import { cross, degrees, dot, euler, inverse, log, nearer, product, rotated, scale } from './quaternions.mjs';

after(close);
const at = (query, use, options) => within(`splines?${query}`, use, options);
const methods = ['slerp', 'squad', 'gltf', 'hermite', 'bspline'];

/* ---- the formulas ---- */

const angles = [[10, 20, 0], [-35, 60, 30], [40, 10, -20], [0, -40, 50], [25, -80, 0]];
const times = [0, 0.7, 2, 2.9, 4];
const uneven = new URLSearchParams({ keys: angles.flat().join('_'), times: times.join('_') });
const keys = angles.map(a => euler('YXZ', a))
  .reduce((list, q) => [...list, list.length ? nearer(list.at(-1), q) : q], []);
const chord = k => scale(log(product(nearer(keys[k], keys[k + 1]), inverse(keys[k]))), 2 / (times[k + 1] - times[k]));
const add = (a, b, s = 1) => a.map((x, i) => x + s * b[i]);

/** The mean of both chords, each weighted by the other's duration. */
function catmullRom(k) {
  const [before, after] = [times[k] - times[k - 1], times[k + 1] - times[k]];
  return scale(add(scale(chord(k - 1), after), chord(k), before), 1 / (before + after));
}

/** glTF's cubic of four numbers from key k, with its angular velocity. */
function cubic(k, omegas, t) {
  const h = times[k + 1] - times[k], tangent = i => scale(product([...omegas[i - k], 0], keys[i]), h / 2);
  const [a, u, b, v] = [keys[k], tangent(k), keys[k + 1], tangent(k + 1)];
  const mix = (wa, wu, wb, wv) => a.map((_, i) => wa * a[i] + wu * u[i] + wb * b[i] + wv * v[i]);
  const p = mix(2 * t ** 3 - 3 * t ** 2 + 1, t ** 3 - 2 * t ** 2 + t, -2 * t ** 3 + 3 * t ** 2, t ** 3 - t ** 2);
  const d = mix(6 * t ** 2 - 6 * t, 3 * t ** 2 - 4 * t + 1, -6 * t ** 2 + 6 * t, 3 * t ** 2 - 2 * t);
  return scale(product(d, inverse(p)).slice(0, 3), 2 / dot(p, p) / h);
}

test('slerp: the chords and their differences at the keys', () => at(`${uneven}&time=2.5`, (_, n) => {
  row(n, 'slerp').forEach((x, i) => near(x, chord(2)[i], 1e-5, `ω ${i}`));
  for (const k of [1, 2, 3])
    near(n[`slerp_key.${k - 1}`], Math.hypot(...add(chord(k), chord(k - 1), -1)) * degrees, 1e-2, `key ${k}`);
}));

test('Hermite: at a key the velocity of Catmull-Rom, and glTF follows its own cubic', async () => {
  await at(`${uneven}&time=2`, (_, n) => {
    for (const m of ['hermite', 'gltf'])
      row(n, m).forEach((x, i) => near(x, catmullRom(2)[i], 2e-5, `${m} ${i}`));
  });
  await at(`${uneven}&time=2.3`, (_, n) => {
    const w = cubic(2, [catmullRom(2), catmullRom(3)], 1 / 3);
    row(n, 'gltf').forEach((x, i) => near(x, w[i], 1e-4, `glTF ${i}`));
  });
});

test('given angular velocities: Hermite and glTF have them at the keys, and C prints it', () => {
  const omega = [1, 0, 0, 0.5, -2, 1, 0, 3, 0, -1, 1, 1, 0, 0, 2];
  return at(`${uneven}&time=2.9&omega=${omega.join('_')}`, async (tab, n) => {
    for (const m of ['hermite', 'gltf'])
      row(n, m).forEach((x, i) => near(x, omega[9 + i], 1e-5, `${m} ${i}`));
    assert.deepEqual(await printed(tab), n);
  });
});

test('evenly spaced keys: only slerp has corners', () => at('', (_, n) => {
  for (const m of methods)
    row(n, `${m}_key`).forEach((x, k) => m === 'slerp' ? assert.ok(x > 10) : near(x, 0, 0.01, `${m} ${k + 1}`));
}));

test('unevenly spaced keys: squad and the B-spline have corners', () => at(`${uneven}&time=2.25`, async (tab, n) => {
  for (const m of ['squad', 'bspline'])
    assert.ok(Math.max(...row(n, `${m}_key`)) > 5, m);
  for (const m of ['gltf', 'hermite'])
    row(n, `${m}_key`).forEach((x, k) => near(x, 0, 0.01, `${m} ${k + 1}`));
  assert.deepEqual(await printed(tab), n);
}));

test('keys by yaw alone: the velocity is that of the angles', async () => {
  const query = 'keys=0_0_0_0_30_0_0_50_0_0_90_0_0_100_0&time=';
  await at(`${query}2.5`, (_, n) => {
    near(n['slerp.3'], 40, 1e-3, 'slerp'); // from 50 to 90 degrees in a second
    near(n['slerp_key.1'], 20, 1e-3, 'jump');
  });
  await at(`${query}2`, (_, n) => {
    for (const m of ['hermite', 'squad', 'bspline'])
      near(n[`${m}.3`], 30, 1e-3, m); // (90 - 30)/2
  });
});

/* ---- the page ---- */

for (const pointer of ['mouse', 'touch'])
  test(`by ${pointer}: a nose, an angular velocity and a time are dragged, and C prints the new numbers`, () =>
    at('time=1.5', async (tab, first) => {
      await follows(tab, '.space ~ [data-handle="2"]', 20, 25, pointer);
      const turned = await shown(tab);
      assert.notEqual(turned['slerp_key.1'], first['slerp_key.1']);

      await follows(tab, '.space ~ [data-handle="7"]', -30, -20, pointer);
      const pulled = await shown(tab);
      assert.equal(pulled['slerp_key.1'], turned['slerp_key.1']);
      assert.notEqual(pulled['hermite.0'], turned['hermite.0']);
      near(pulled['hermite_key.1'], 0, 0.01, 'the curve stays smooth');

      const { dx, dy } = await drag(tab, '.plot [data-handle="2"]', -40, -9, pointer);
      near(dx, -40, 1.5, 'the time follows the pointer');
      near(dy, 0, 0.1, 'it moves in time alone');
      const late = await shown(tab);
      assert.ok(late['squad_key.1'] > 1);
      assert.deepEqual(await printed(tab), late);
    }, { hasTouch: pointer === 'touch' }));

test('an arrow is the velocity of the nose; its part about the nose stays', () => at('', async tab => {
  const values = () => tab.$$eval('input[data-key="2"]', inputs => inputs.slice(1).map(input => Number(input.value)));
  const keys = [[-25, 0, -20]], nose = rotated(euler('YXZ', keys[0]), [0, 0, -1]), before = await values();
  await tab.focus('.space ~ [data-handle="7"]');
  const from = await centre(tab, '.space ~ [data-handle="7"]');
  await tab.keyboard.press('ArrowRight');
  await settled(tab);
  const now = await values(), change = add(now, before, -1);
  near((await centre(tab, '.space ~ [data-handle="7"]')).x - from.x, 6, 0.5, 'an arrow key');
  assert.ok(Math.hypot(...cross(change, nose)) > 0.02);
  near(dot(change, nose), 0, 2e-3, 'about the nose');
}));

test('times and angular velocities can be typed; a time stays between its neighbours', () => at('', async tab => {
  const field = (key, column) => tab.locator(`input[data-key="${key}"][data-column="${column}"]`);
  const enter = async (key, column, text) => {
    await field(key, column).fill(text);
    await field(key, column).press('Enter');
    await field(key, column).blur();
    await settled(tab);
  };
  await enter(4, 0, '6.5');
  assert.equal(await tab.getAttribute('.time', 'max'), '6.5');
  await enter(1, 0, '5');
  assert.equal(await field(1, 0).inputValue(), '1.9');
  await enter(3, 2, '-1.5');
  assert.equal(await field(3, 2).inputValue(), '-1.5');
  await tab.waitForURL(/times=0_1.9_2_3_6.5.*omega=/);
  await enter(2, 1, '1e99');
  assert.equal(await field(2, 1).inputValue(), '1000');
  await tab.getByRole('button', { name: /Catmull-Rom/ }).click();
  await settled(tab);
  assert.notEqual(await field(3, 2).inputValue(), '-1.5');
}));

test('the components of one method are drawn instead of the lengths of all', () => at('method=slerp', async tab => {
  const picture = () => tab.$eval('.plot canvas', canvas => canvas.toDataURL()), before = await picture();
  await tab.getByLabel('the plot shows').selectOption({ label: 'its components' });
  await settled(tab);
  assert.notEqual(await picture(), before);
}));

test('an address with an infinite angular velocity has the default', async () => {
  const omega = Array.from({ length: 15 }, (_, i) => i === 4 ? '1e99' : '0').join('_');
  const { tab, problems } = await open(`splines?method=hermite&omega=${omega}`);
  await drawn(tab);
  await settled(tab);
  assert.deepEqual(problems, []);
  await tab.close();
});
