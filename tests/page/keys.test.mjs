// SPDX-License-Identifier: MIT
// The Hermite curve by its basis, per second and per segment, and the tangents of PCHIP, both by formulas of
// their own; keys and tangents that are dragged, added, deleted, and curves that are hidden.
import assert from 'node:assert/strict';
import { after, test } from 'node:test';
import { centre, drag } from './drags.mjs';
import { close, near, printed, shown, start } from './models.mjs';

after(close);
/** The numbers after a change of one of them. */
const changed = async (tab, before, name) => {
  await tab.waitForFunction(([key, value]) => {
    const cell = document.querySelector(`[data-name="${key}"]`);
    return cell && cell.dataset.value !== value;
  }, [name, String(before[name])]);
  return shown(tab);
};

/* ---- the numbers ---- */

const times = [0, 0.5, 2, 2.5, 4], values = [0, 1, 2, -0.5, 0.5], tangents = [3, 1.5, -3, -2, 1];

/** Value, velocity and acceleration in the segment of the default keys that begins with key k. */
function hermite(time, scale, k) {
  const h = times[k + 1] - times[k], t = (time - times[k]) / h, p = values.slice(k);
  const v = tangents.slice(k).map(x => scale === 'second' ? x * h : x);
  const sum = w => w[0] * p[0] + w[1] * v[0] + w[2] * p[1] + w[3] * v[1];
  return [sum([2 * t ** 3 - 3 * t ** 2 + 1, t ** 3 - 2 * t ** 2 + t, 3 * t ** 2 - 2 * t ** 3, t ** 3 - t ** 2]),
    sum([6 * t * t - 6 * t, 3 * t * t - 4 * t + 1, 6 * t - 6 * t * t, 3 * t * t - 2 * t]) / h,
    sum([12 * t - 6, 6 * t - 4, 6 - 12 * t, 6 * t - 2]) / h ** 2];
}

for (const scale of ['second', 'segment'])
  test(`the Hermite curve, tangents per ${scale}`, async () => {
    const { tab, problems } = await start(`keys?time=0.75&scale=${scale}`), numbers = await shown(tab);
    hermite(0.75, scale, 1).forEach((x, i) => near(numbers[`own.${i}`], x));
    near(numbers['linear.0'], 1 + 1 / 6);
    assert.equal(numbers['step.0'], 1);
    for (const read of ['second', 'segment'])
      [0, 1].forEach(i => near(numbers[`${read}.${i}`], hermite(0.5, read, i)[1]));
    assert.deepEqual([numbers['duration.0'], numbers['duration.1']], [0.5, 1.5]);
    assert.deepEqual(await printed(tab), numbers);
    assert.deepEqual(problems, []);
    await tab.close();
  });

test('the velocity jumps at a key if tangents are read per segment', async () => {
  const { tab } = await start('keys?time=2&scale=segment'), numbers = await shown(tab);
  near(numbers['segment.0'], -3 / 1.5);
  near(numbers['segment.1'], -3 / 0.5);
  near(numbers['own.1'], -3 / 0.5);
  assert.deepEqual([numbers['second.0'], numbers['second.1']], [-3, -3]);
  await tab.close();
});

test('the tangents of PCHIP: 0 at extremes, elsewhere the weighted harmonic mean', async () => {
  const list = [0, 0, 1, 1, 3, 2, 4, 4, 4.5, 3]; // times and values: key 3 is an extreme
  const [t, v] = [0, 1].map(offset => list.filter((_, i) => i % 2 === offset));
  const keys = t.flatMap((time, k) => [time, v[k], 0]).join('_');
  const { tab } = await start(`keys?method=pchip&keys=${keys}`), numbers = await shown(tab);
  const slope = k => (v[k + 1] - v[k]) / (t[k + 1] - t[k]);
  for (let k = 1; k < 4; k++) {
    const [h, g] = [t[k] - t[k - 1], t[k + 1] - t[k]], [a, b] = [slope(k - 1), slope(k)];
    near(numbers[`key${k}.3`], a * b <= 0 ? 0 : 3 * (h + g) / ((2 * g + h) / a + (g + 2 * h) / b));
  }
  assert.deepEqual(await printed(tab), numbers);
  await tab.close();
});

for (const method of ['step', 'linear', 'bspline', 'tcb'])
  test(`the C program of ${method}, with eight keys and with two`, async () => {
    for (const keys of ['0_1_0_1_2_0_1.5_0_0_2_1_0_3_5_0_3.5_1_0_4_2_0_5_0_0', '0_1_2_1_3_-1']) {
      const { tab, problems } = await start(`keys?time=0.9&tension=0.3&bias=-0.5&method=${method}&keys=${keys}`);
      assert.deepEqual(await printed(tab), await shown(tab));
      assert.deepEqual(problems, []);
      await tab.close();
    }
  });

/* ---- what can be done ---- */

test('a drag of a key moves its time and every curve, one of a tangent takes the tangents of the method', async () => {
  const { tab, problems } = await start('keys?time=0.75&method=pchip'), before = await shown(tab);
  await drag(tab, '[data-handle="1"]', -20, -20);
  const moved = await changed(tab, before, 'key1.1');
  for (const name of ['step', 'linear', 'catmull', 'pchip', 'c2', 'bspline'])
    assert.ok(moved[`${name}.0`] > before[`${name}.0`], name);
  assert.ok(moved['key1.0'] < before['key1.0']);
  await drag(tab, '[data-handle="6"]', 0, -15);
  const turned = await changed(tab, moved, 'key1.3');
  assert.ok(turned['key1.3'] > moved['key1.3']);
  assert.equal(turned['key3.3'], moved['key3.3']);
  assert.equal(turned['pchip.0'], moved['pchip.0']);
  assert.match(tab.url(), /keys/);
  assert.deepEqual(problems, []);
  await tab.close();
});

test('a finger drags a key', async () => {
  const { tab, problems } = await start('keys', { hasTouch: true, viewport: { width: 390, height: 844 } });
  const before = await shown(tab);
  await drag(tab, '[data-handle="2"]', -10, 30, 'touch');
  const moved = await changed(tab, before, 'key2.1');
  assert.ok(moved['key2.1'] < before['key2.1'] && moved['key2.0'] < before['key2.0']);
  assert.deepEqual(problems, []);
  await tab.close();
});

test('a key is added without a change of the curve, and deleted again', async () => {
  const { tab, problems } = await start('keys?time=1.25'), before = await shown(tab);
  await tab.keyboard.press('a');
  const more = await changed(tab, before, 'key2.0');
  assert.equal(more['key2.0'], 1.25);
  near(more['key2.1'], hermite(1.25, 'second', 1)[0]);
  near(more['key2.2'], hermite(1.25, 'second', 1)[1]);
  [0, 1, 2].forEach(i => near(more[`own.${i}`], hermite(1.25, 'second', 1)[i], 2e-5));
  await tab.keyboard.press('d');
  assert.deepEqual(await changed(tab, more, 'key2.0'), before);
  await tab.focus('[data-handle="4"]');
  await tab.keyboard.press('Delete');
  await tab.waitForFunction(() => !document.querySelector('[data-name="key4.0"]'));
  assert.deepEqual(problems, []);
  await tab.close();
});

for (const [name, press] of [['mouse', (tab, x, y) => tab.mouse.dblclick(x, y)],
  ['touch', async (tab, x, y) => { await tab.touchscreen.tap(x, y); await tab.touchscreen.tap(x, y); }]])
  test(`pressing twice on the plot adds a key there, by ${name}`, async () => {
    const { tab } = await start('keys', { hasTouch: name === 'touch' }), before = await shown(tab);
    const { x, y } = await centre(tab, '[data-handle="1"]');
    await press(tab, x + 60, y + 40);
    const more = await changed(tab, before, 'key2.0');
    assert.ok(more['key2.0'] > 0.5 && more['key2.0'] < 2 && more['key2.1'] < 1);
    assert.equal(more['key5.0'], 4);
    await tab.close();
  });

test('a key that is too close to another is refused with a message', async () => {
  const { tab } = await start('keys?time=0.55'), before = await shown(tab);
  await tab.keyboard.press('a');
  await tab.waitForFunction(() => document.querySelector('.live').textContent !== '');
  assert.deepEqual(await shown(tab), before);
  await tab.close();
});

test('a curve is hidden by its entry of the legend, and the address keeps it', async () => {
  const { tab } = await start('keys'), entry = tab.locator('.curve', { hasText: 'PCHIP' });
  assert.equal(await entry.getAttribute('aria-pressed'), 'true');
  await entry.focus();
  await tab.keyboard.press('Enter');
  await tab.waitForSelector('.curve[aria-pressed=false]');
  await tab.waitForFunction(() => location.hash.includes('hidden=pchip'));
  await tab.reload();
  await tab.waitForSelector('.curve[aria-pressed=false]');
  assert.match(await tab.textContent('.curve[aria-pressed=false]'), /PCHIP/);
  await tab.close();
});
