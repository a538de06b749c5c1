// SPDX-License-Identifier: MIT
// Loop and events: the head is dragged and thrown, and each key is passed once, whatever happens at the
// ends of the clip.
import assert from 'node:assert/strict';
import { after, test } from 'node:test';
import { axe, close, drawn, long, open, printed, shown } from './models.mjs';

after(close);
const exhibit = async (query = '', options) => {
  const { tab } = await open(`loop?${query}`, options);
  await tab.waitForSelector('main[data-drawn] [data-name]', { state: 'attached' });
  return tab;
};
const counted = async tab => Number(await tab.textContent('.counted'));
const now = tab => tab.$eval('[data-name="step.1"]', cell => Number(cell.dataset.value));
const beyond = (tab, time, way = 1) => tab.waitForFunction(([time, way]) =>
  (Number(document.querySelector('[data-name="step.1"]').dataset.value) - time) * way > 0, [time, way]);
const reaches = (tab, time) => tab.waitForFunction(time =>
  document.querySelector('[data-name="step.1"]').dataset.value === String(time), time);

/** Waits until the head stays where it is for 15 frames. */
const rest = tab => tab.evaluate(() => new Promise(resolve => {
  let last = NaN, same = 0;
  const look = () => {
    const value = document.querySelector('[data-name="step.1"]').dataset.value;
    same = value === last ? same + 1 : 0;
    last = value;
    if (same < 15)
      requestAnimationFrame(look);
    else
      resolve();
  };
  look();
}));

/* ---- passings by brute force: [time, key] in binary64 ---- */

const parts = [0, 0.25, 0.5, 0.625], duration = 2, cycles = Array.from({ length: 80 }, (_, n) => n - 40);
const all = {
  once: () => parts.map((part, k) => [part * duration, k]),
  twice: () => [0, 1].flatMap(n => parts.map((part, k) => [(n + part) * duration, k])),
  loop: () => cycles.flatMap(n => parts.map((part, k) => [(n + part) * duration, k])),
  pingpong: () => cycles.flatMap(n => parts.flatMap((part, k) =>
    [part, ...part > 0 ? [2 - part] : []].map(p => [(2 * n + p) * duration, k]))),
};
function between(wrap, from, to) {
  const inside = all[wrap]().filter(([t]) => to > from ? t > from && t <= to : t >= to && t < from);
  return inside.sort((a, b) => (a[0] - b[0]) * Math.sign(to - from));
}
function clipTime(wrap, t) {
  const end = { once: duration, twice: 2 * duration }[wrap] ?? Infinity;
  if (end < Infinity && (t <= 0 || t >= end))
    return t <= 0 ? 0 : duration;
  const cycle = Math.floor(t / duration), within = t - cycle * duration;
  return wrap === 'pingpong' && cycle % 2 !== 0 ? duration - within : within;
}

// On keys, at ends, and at times without a pattern; both ways.
const ways = [[0, 0.5], [0.5, 0], [1, 1], [0.3, 1.25], [1.25, 1.24], [-0.9, 3.7], [3.7, 0.1], [1.99, 2.01], [2, 1.5],
  [1.1, 2.9], [2.9, -0.4], [0.1, 4]];
const far = [[-11.3, 17.2], [30, 3.25], [-4, -2]];

for (const wrap of Object.keys(all))
  test(`loop: keys and times of the clip by brute force, ${wrap}`, async () => {
    const tab = await exhibit();
    for (const [from, to] of [...ways, ...wrap.match(/loop|ping/) ? far : []]) {
      await tab.evaluate(hash => { location.hash = hash; }, `loop?wrap=${wrap}&from=${from}&to=${to}`);
      await tab.waitForFunction(([a, b]) => ['step.0', 'step.1'].map(name => Number(document.querySelector(
        `[data-name="${name}"]`)?.dataset.value)).join() === `${Math.fround(a)},${Math.fround(b)}`, [from, to]);
      const n = await shown(tab), keys = between(wrap, Math.fround(from), Math.fround(to)).map(([, key]) => key);
      assert.equal(n['passed.0'], keys.length, `${from} ${to}`);
      keys.slice(0, 5).forEach((key, i) => assert.equal(n[`key.${i}`], key, `${from} ${to}: ${keys}`));
      assert.ok(Math.abs(n['head.0'] - clipTime(wrap, Math.fround(to))) < 1e-6, `${from} ${to}: ${n['head.0']}`);
    }
    await tab.close();
  });

for (const query of ['wrap=once&to=1.7', 'wrap=twice&from=3.7&to=0.1', 'wrap=pingpong&from=-3.3&to=5',
  'wrap=loop&to=1'])
  test(`loop: the copied C prints the numbers of the page, ${query}`, async () => {
    const tab = await exhibit(query), n = await shown(tab), of = await printed(tab);
    for (const [name, value] of Object.entries(n))
      assert.ok(Object.is(of[name], value), `${name}: ${value}, C prints ${of[name]}`);
    await tab.close();
  });

/* ---- the half-open rule ---- */

test('loop: a step passes a key that it arrives at, and not one that it leaves, in both directions', async () => {
  for (const wrap of Object.keys(all))
    for (const time of [0, 1]) {
      const tab = await exhibit(`wrap=${wrap}&from=${time}&to=${time}`), n = await shown(tab);
      assert.equal(n['at.0'], time);
      assert.deepEqual(['forwards_to', 'forwards_from', 'backwards_to', 'backwards_from'].map(name => n[`${name}.0`]),
        [[time - 0.2, time], [time, time + 0.2], [time + 0.2, time], [time, time - 0.2]]
          .map(([from, to]) => between(wrap, from, to).length));
      await tab.close();
    }
});

test('loop: a head that turns round on a key does not pass it again', async () => {
  const tab = await exhibit('from=0.75&to=0.75');
  for (const [key, time, passed] of [['.', 1, 2], [',', 0.5, 1]]) {
    await tab.keyboard.press(key);
    await reaches(tab, time);
    const n = await shown(tab);
    assert.deepEqual([n['passed.0'], n['key.0']], [1, passed]);
  }
  await tab.close();
});

/* ---- drags and throws ---- */

const mouse = { Start: 'mousePressed', Move: 'mouseMoved', End: 'mouseReleased' };
/** A drag along the ring with the times of its events, by mouse or by finger. `hold`: seconds before the release. */
async function drag(tab, angles, { finger = false, hold = 0 } = {}) {
  const { x, y, r } = JSON.parse(await tab.getAttribute('canvas', 'data-place'));
  const box = await (await tab.$('canvas')).boundingBox(), session = await tab.context().newCDPSession(tab);
  let timestamp = Date.now() / 1000;
  const send = (kind, angle) => {
    const at = { x: box.x + x + r * Math.sin(angle), y: box.y + y - r * Math.cos(angle) };
    return finger ? session.send('Input.dispatchTouchEvent', { type: `touch${kind}`, timestamp,
      touchPoints: kind === 'End' ? [] : [at] })
      : session.send('Input.dispatchMouseEvent', { ...at, type: mouse[kind], timestamp, button: 'left', buttons: 1,
        clickCount: 1 });
  };
  await send('Start', angles[0]);
  for (const angle of angles) {
    timestamp += 0.02;
    await send('Move', angle);
  }
  timestamp += hold + 0.001;
  await send('End', angles.at(-1));
}

test('loop: a drag of a turn and a half passes the keys of a turn and a half', async () => {
  const tab = await exhibit('from=0.1&to=0.1');
  await drag(tab, Array.from({ length: 31 }, (_, i) => 0.314 + i * 0.314159265), { hold: 1 });
  await rest(tab);
  const n = await shown(tab);
  assert.ok(Math.abs(n['step.1'] - 3.1) < 0.02, `${n['step.1']}`);
  assert.equal(n['passed.0'], between('loop', n['step.0'], n['step.1']).length);
  assert.equal(await counted(tab), n['passed.0']);
  await tab.close();
});

const arc = Array.from({ length: 12 }, (_, i) => 2.3 + i * 0.15);
for (const finger of [false, true])
  test(`loop: the head rests after a drag with a pause, and goes on after a throw, ${finger ? 'finger' : 'mouse'}`,
    async () => {
      const tab = await exhibit('friction=0.2', { hasTouch: finger });
      await drag(tab, arc, { finger, hold: 1 });
      await rest(tab);
      const held = await now(tab);
      assert.ok(Math.abs(held - 0.75 - 11 * 0.15 / Math.PI) < 0.03, `${held}`);
      await drag(tab, arc, { finger });
      await rest(tab);
      // 0.15 radians in 0.02 s are 2.4 seconds of the loop in a second; the throw leads 2.4 * 0.2 / ln 2 further.
      const way = await now(tab) - held - 11 * 0.15 / Math.PI, reach = 0.15 / 0.02 / Math.PI * 0.2 / Math.LN2;
      assert.ok(way > 0.6 * reach && way < 1.4 * reach, `${way} ${reach}`);
      await tab.close();
    });

test('loop: the steps of a throw add up to one step, and its friction does not depend on the frames', long,
  async () => {
  const tab = await exhibit('friction=0.4');
  for (const [key, way] of [['t', 1], ['b', -1]]) {
    const before = await now(tab);
    await tab.keyboard.press(key);
    await beyond(tab, before + way, way);
    await rest(tab);
    const n = await shown(tab);
    assert.ok(Math.abs(n['step.1'] - before - way * 6 * 0.4 / Math.LN2) < 1e-3, `${before} ${n['step.1']}`);
    assert.equal(n['passed.0'], between('loop', n['step.0'], n['step.1']).length);
    assert.equal(await counted(tab), n['passed.0']);
  }
  await tab.close();
});

test('loop: a clip that plays once holds its end', async () => {
  const tab = await exhibit('wrap=once&friction=0.2&to=0.5');
  for (const time of [2, 2.999]) { // the running time ends half of the duration behind the end of the clip
    await tab.keyboard.press('t');
    await beyond(tab, time);
  }
  const n = await shown(tab);
  assert.deepEqual([n['step.1'], n['head.0']], [3, 2]);
  assert.equal(n['passed.0'], between('once', n['step.0'], 3).length);
  await tab.close();
});

test('loop: with reduced motion a throw arrives at once, and a drag does not throw', async () => {
  const tab = await exhibit('friction=1', { reducedMotion: 'reduce' }), before = await now(tab);
  await tab.keyboard.press('t');
  await reaches(tab, Math.fround(before + 6 / Math.LN2));
  const n = await shown(tab);
  assert.equal(n['passed.0'], between('loop', n['step.0'], n['step.1']).length);
  await drag(tab, arc);
  await rest(tab);
  assert.ok(Math.abs(await now(tab) - n['step.1'] - 11 * 0.15 / Math.PI) < 0.03);
  await tab.close();
});

/* ---- the log ---- */

test('loop: the log has the last keys; the live region speaks once, when the head rests', async () => {
  const tab = await exhibit('from=0.75&to=0.75');
  await tab.evaluate(() => {
    globalThis.spoken = [];
    const live = document.querySelector('.passings');
    new MutationObserver(() => globalThis.spoken.push(live.textContent)).observe(live, { childList: true });
  });
  for (const [key, time] of [['.', 1], ['.', 1.25], ['.', 2], [',', 1.25]]) {
    await tab.keyboard.press(key);
    await reaches(tab, time);
  }
  await tab.waitForFunction(() => globalThis.spoken.join().includes('2, 3, 0, 3'));
  assert.ok((await tab.evaluate(() => globalThis.spoken)).length <= 2);
  const rows = await tab.$$eval('.log tbody tr', list => list.map(row => [...row.cells].map(cell => cell.textContent)));
  assert.deepEqual(rows.map(([time, key]) => `${time} ${key}`), ['1.250 3', '2.000 0', '1.250 3', '1.000 2']);
  assert.match(rows[0][2], /backwards/);
  assert.match(rows[1][2], /forwards/);
  assert.deepEqual(await axe(tab), []);
  await tab.close();
});

test('loop: an address without keys is drawn with the default', async () => {
  const { tab, problems } = await open('loop?keys=');
  await drawn(tab);
  assert.match(await tab.textContent('main'), /0\.500/); // the key at a quarter of 2 s
  assert.deepEqual(problems, []);
  await tab.close();
});
