// SPDX-License-Identifier: MIT
// Twist: the measures against a skin in binary64 and against C, and drags in the plot by mouse, finger and keys.
import assert from 'node:assert/strict';
import { after, test } from 'node:test';
import { drag } from './drags.mjs';
import { close, long, printed, shown, start } from './models.mjs';

after(close);

/* ---- the bar in binary64: 24 sections of 8 vertices ---- */

const sides = [[0.5, 0.5], [0.5, 0], [0.5, -0.5], [0, -0.5], [-0.5, -0.5], [-0.5, 0], [-0.5, 0.5], [0, 0.5]];
const sections = Array.from({ length: 25 }, (_, k) => sides.map(([x, z]) => [x, k / 8, z]));

/** Turned by an angle about y, or about z through (0, 1.5, 0). */
function turned([x, y, z], mode, angle) {
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  return mode === 'twist' ? [c * x + s * z, y, c * z - s * x] : [c * x - s * (y - 1.5), 1.5 + s * x + c * (y - 1.5), z];
}

function moved(p, mode, dual, joints, angle) {
  const u = Math.min(Math.max((p[1] - 1.5) / (mode === 'twist' ? 3 : 1.5) + 0.5, 0), 1) * (joints - 1);
  const k = Math.min(Math.floor(u), joints - 2), part = angle / (joints - 1), t = u - k;
  if (dual) { // all joints rotate about one point: the mean of the quaternions is a rotation about it
    const back = Math.cos(part / 2) < 0 ? -1 : 1, first = k * part / 2, next = first + part / 2;
    return turned(p, mode, 2 * Math.atan2((1 - t) * Math.sin(first) + back * t * Math.sin(next),
      (1 - t) * Math.cos(first) + back * t * Math.cos(next)));
  }
  const [a, b] = [turned(p, mode, k * part), turned(p, mode, (k + 1) * part)];
  return a.map((x, i) => (1 - t) * x + t * b[i]);
}

const det = ([a, b, c], [d, e, f], [g, h, i]) => a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g);
const fan = points => points.slice(2).reduce((sum, p, i) => sum + det(points[0], points[i + 1], p), 0);
const both = points => (fan(points) + fan([...points.slice(1), points[0]])) / 12;
const volume = rows => rows.slice(1).reduce((sum, up, k) => sum + up.reduce((part, _, i) => {
  const j = (i + 1) % 8;
  return part + both([rows[k][i], rows[k][j], up[j], up[i]]);
}, 0), both([...rows[0]].reverse()) + both(rows[24]));

function measured(mode, dual, joints, angle) {
  const rows = sections.map(row => row.map(p => moved(p, mode, dual, joints, angle)));
  const [corner, side] = rows[12];
  return { volume: volume(rows), bulge: Math.max(...rows.slice(0, 13).flat().map(p => p[0])),
    radius: mode === 'twist' ? Math.hypot(corner[0], corner[2]) : Math.hypot(side[0], side[1] - 1.5, side[2]) };
}

test('the box of this test has three cubic metres', () =>
  assert.ok(Math.abs(volume(sections) - 3) < 1e-12));

test('the measures are those of binary64, and the C program prints them', long, async () => {
  for (const [mode, degrees, joints] of [['twist', 0, 3], ['twist', 90, 3], ['twist', 170, 5], ['twist', 300, 3],
    ['bend', 0, 3], ['bend', 60, 5], ['bend', 110, 3], ['bend', 150, 5]]) {
    const { tab, problems } = await start(`twist?mode=${mode}&${mode}=${degrees}&joints=${joints}`);
    const numbers = await shown(tab), angle = degrees * Math.PI / 180, where = `${mode} ${degrees} ${joints}`;
    assert.deepEqual(await printed(tab), numbers);
    const ways = [[false, 2, 0], [false, 2, angle], [true, 2, angle], [false, joints, angle]];
    ways.map(([dual, n, by]) => measured(mode, dual, n, by)).forEach((wanted, i) => {
      for (const name of mode === 'bend' ? ['volume', 'radius', 'bulge'] : ['volume', 'radius'])
        assert.ok(Math.abs(numbers[`${name}.${i}`] - wanted[name]) < 2e-6,
          `${where}, ${name} ${i}: ${numbers[`${name}.${i}`]} ${wanted[name]}`);
    });
    assert.equal(numbers['volume.0'], 3);
    assert.deepEqual(problems, []);
    await tab.close();
  }
});

test('linear blend collapses, dual quaternions keep the distance and bulge, more joints help', async () => {
  const of = async address => {
    const { tab } = await start(address);
    const numbers = await shown(tab);
    await tab.close();
    return numbers;
  };
  const twist = await of('twist?twist=170'), bend = await of('twist?mode=bend&bend=110');
  assert.ok(Math.abs(twist['radius.1'] / twist['radius.0'] - Math.cos(85 * Math.PI / 180)) < 1e-6);
  assert.ok(twist['volume.1'] < 1.1 && twist['volume.2'] > 2.98 && twist['volume.3'] > 2);
  assert.ok(Math.abs(bend['radius.1'] / 0.5 - Math.cos(55 * Math.PI / 180)) < 1e-6);
  assert.ok(Math.abs(bend['radius.2'] - 0.5) < 1e-6);
  assert.ok(bend['bulge.2'] > 0.6 && bend['bulge.3'] < bend['bulge.2'] && Math.abs(bend['bulge.1'] - 0.5) < 1e-6);
  assert.ok(bend['volume.1'] < bend['volume.3'] && bend['volume.3'] < bend['volume.2']);
});

/* ---- drags ---- */

const more = (tab, before) => tab.waitForFunction(old =>
  Number(document.querySelector('[data-name="volume.1"]').dataset.value) > old, before['volume.1']);

test('the point of the plot is dragged to a smaller angle', async () => {
  for (const mode of ['twist', 'bend']) {
    const { tab } = await start(`twist?lang=en&mode=${mode}`);
    const before = await shown(tab);
    await drag(tab, '.handle', -100, 0);
    await more(tab, before);
    const now = await shown(tab);
    assert.equal(now['volume.0'], 3);
    assert.ok(now['volume.1'] > before['volume.1'] + 0.03, `${now['volume.1']}`);
    await tab.close();
  }
});

test('a finger drags the point of the plot', async () => {
  const { tab } = await start('twist?lang=ja', { hasTouch: true, viewport: { width: 390, height: 844 } });
  const before = await shown(tab);
  await drag(tab, '.handle', -70, 0, 'touch');
  await more(tab, before);
  await tab.close();
});

test('arrow keys move the point, and a list changes the motion', async () => {
  const { tab } = await start('twist?lang=en');
  const before = await shown(tab);
  await tab.focus('.handle');
  await tab.keyboard.press('ArrowLeft');
  await more(tab, before);
  await tab.getByLabel('Motion').selectOption('bend');
  await tab.waitForSelector('[data-name="bulge.2"]');
  await tab.close();
});
