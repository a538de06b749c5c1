// SPDX-License-Identifier: MIT
// Loop and events: the head is dragged and thrown, and each key is passed once.
import assert from 'node:assert/strict';
import { after, test } from 'node:test';
import { close, open, shown } from './models.mjs';

after(close);
const drawn = async address => {
  const { tab } = await open(address);
  await tab.waitForSelector('main[data-drawn]', { state: 'attached' });
  return tab;
};
const counted = async tab => Number(await tab.textContent('.counted'));

// The keys n + part in (from, to], or in [to, from) for a way back.
const keysIn = (from, to, parts, duration) => {
  let count = 0;
  for (let n = -100; n < 100; n++)
    for (const part of parts) {
      const t = (n + part) * duration;
      count += to > from ? t > from && t <= to : t >= to && t < from;
    }
  return count;
};
const parts = [0, 0.25, 0.5, 0.625];

async function drag(tab, angles, wait) {
  const { x, y, r } = JSON.parse(await tab.getAttribute('canvas', 'data-place'));
  const box = await (await tab.$('canvas')).boundingBox();
  const at = angle => [box.x + x + r * Math.sin(angle), box.y + y - r * Math.cos(angle)];
  await tab.mouse.move(...at(angles[0]));
  await tab.mouse.down();
  for (const angle of angles)
    await tab.mouse.move(...at(angle));
  if (wait)
    await tab.waitForTimeout(wait);
  await tab.mouse.up();
}

test('loop: a drag of a turn and a half passes the keys of a turn and a half', async () => {
  const tab = await drawn('loop?from=0.1&to=0.1');
  await drag(tab, Array.from({ length: 31 }, (_, i) => 0.314 + i * 0.314159265), 300);
  await tab.waitForTimeout(200);
  const n = await shown(tab);
  assert.ok(Math.abs(n['step.1'] - 3.1) < 0.02, `${n['step.1']}`);
  assert.equal(n['passed.0'], keysIn(n['step.0'], n['step.1'], parts, 2));
  assert.equal(await counted(tab), n['passed.0']);
  await tab.close();
});

test('loop: a throw goes on, and the steps of the screen add up to one step', async () => {
  const tab = await drawn('loop');
  for (const [key, way] of [['t', 1], ['b', -1]]) {
    await tab.keyboard.press(key);
    await tab.waitForTimeout(700);
    await tab.keyboard.press('s');
    await tab.waitForTimeout(200);
    const n = await shown(tab);
    assert.ok((n['step.1'] - n['step.0']) * way > 1, `${n['step.0']} ${n['step.1']}`);
    assert.equal(n['passed.0'], keysIn(n['step.0'], n['step.1'], parts, 2));
    assert.equal(await counted(tab), n['passed.0']);
  }
  await tab.close();
});

test('loop: the head stops when a drag rests before its end, and goes on when it does not', async () => {
  for (const [wait, moves] of [[400, false], [0, true]]) {
    const tab = await drawn('loop');
    await drag(tab, Array.from({ length: 12 }, (_, i) => 2.3 + i * 0.15), wait);
    const before = (await shown(tab))['step.1'];
    await tab.waitForTimeout(500);
    assert.equal((await shown(tab))['step.1'] - before > 0.1, moves);
    await tab.close();
  }
});

test('loop: a head that turns round on a key does not pass it again', async () => {
  const tab = await drawn('loop?from=0.75&to=0.75');
  const after = async key => {
    await tab.keyboard.press(key);
    await tab.waitForTimeout(150);
    return shown(tab);
  };
  let n = await after('.');
  assert.deepEqual([n['step.1'], n['passed.0'], n['key.0']], [1, 1, 2]);
  n = await after(',');
  assert.deepEqual([n['step.1'], n['passed.0'], n['key.0']], [0.5, 1, 1]);
  await tab.close();
});
