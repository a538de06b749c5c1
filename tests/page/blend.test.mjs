// SPDX-License-Identifier: MIT
// Blend and change: the numbers of each mode beside formulas in binary64, the copied C, drags by mouse and finger.
import assert from 'node:assert/strict';
import { after, test } from 'node:test';
import { axe, close, near, open, printed, row, shown } from './models.mjs';

after(close);
const drawn = tab =>
  tab.waitForSelector('main[data-drawn]:not(:has([data-loading])) [data-name]', { state: 'attached' });
const exhibit = async (query, options) => {
  const { tab, problems } = await open(`blend?${query}`, options);
  await drawn(tab);
  return { tab, problems, n: await shown(tab) };
};

/* ---- rotations in binary64: x y z w ---- */

const mul = ([a, b, c, d], [x, y, z, w]) => [
  d * x + w * a + b * z - c * y, d * y + w * b + c * x - a * z, d * z + w * c + a * y - b * x,
  d * w - a * x - b * y - c * z];
const conj = ([x, y, z, w]) => [-x, -y, -z, w];
const unit = q => q.map(c => c / Math.hypot(...q));
const log = q => { // the rotation vector, shorter arc
  const [x, y, z, w] = q[3] < 0 ? q.map(c => -c) : q, s = Math.hypot(x, y, z);
  return [x, y, z].map(c => s ? 2 * Math.atan2(s, w) * c / s : 0);
};
const exp = v => {
  const angle = Math.hypot(...v);
  return [...v.map(c => angle ? Math.sin(angle / 2) * c / angle : 0), Math.cos(angle / 2)];
};
const combine = (...terms) => terms[0][1].map((_, i) => terms.reduce((sum, [s, v]) => sum + s * v[i], 0));
const rate = (p, q, h) => log(mul(q, conj(p))).map(c => c / h);

/** The literals of an array in the copied program. */
const arrayOf = (code, name) => code.match(new RegExp(`\\b${name}(?:\\[\\w*\\])? = ([^;]*);`))[1]
  .match(/-?[\d.]+(?:e[-+]?\d+)?(?=f)/g).map(Number);
const chunks = (list, size) =>
  Array.from({ length: list.length / size }, (_, i) => unit(list.slice(i * size, (i + 1) * size)));
async function program(tab) {
  await tab.click('.code');
  const code = await tab.textContent('.program');
  await tab.keyboard.press('Escape');
  return code;
}

/* ---- all modes ---- */

const queries = ['mode=change&time=0.7', 'mode=change&time=0.2&smooth=1&from=hop&to=walk&joint=thigh.L',
  'mode=change&time=1.9&joint=forearm.R&duration=0.0625&coast=1',
  'mode=pair&time=0.9&weight=0.3&phase=0.4&joint=shin.L',
  'mode=additive&time=1.1&weight=1.2', 'mode=additive&reference=rest&side=parent&joint=spine&time=0.4',
  'mode=springs&time=2.3&ratio=1.5',
  'mode=springs&time=1.2&goals=0.1_1_0.15_0.8_0.3_-1_0.7_0.2_1.9_0', 'mode=springs&time=0.1'];
for (const query of queries)
  test(`blend: the copied C prints the numbers of the page, ${query}`, async () => {
    const { tab, n, problems } = await exhibit(query), of = await printed(tab);
    for (const [name, value] of Object.entries(n))
      assert.ok(Object.is(of[name], value), `${name}: ${value}, C prints ${of[name]}`);
    assert.deepEqual(problems, []);
    await tab.close();
  });

test('blend: axe in all modes, which the digits choose', async () => {
  const { tab } = await exhibit('lang=ja');
  for (const [i, mode] of ['change', 'pair', 'additive', 'springs'].entries()) {
    await tab.keyboard.press(String(i + 1));
    await tab.waitForSelector(`.to-${mode}[aria-pressed=true]`);
    await tab.waitForFunction(name => location.hash.includes(`mode=${name}`) === (name !== 'change'), mode);
    assert.deepEqual(await axe(tab), [], mode);
  }
  await tab.close();
});

/* ---- change ---- */

/** The quintic with value x, rate v and acceleration a at 0, and value, rate and acceleration 0 at 1. */
const quintic = (x, v, a, u) => combine([1 - 10 * u ** 3 + 15 * u ** 4 - 6 * u ** 5, x],
  [u - 6 * u ** 3 + 8 * u ** 4 - 3 * u ** 5, v], [(u ** 2 - 3 * u ** 3 + 3 * u ** 4 - u ** 5) / 2, a]);

test('blend: inertialisation is the quintic of the boundary conditions, in binary64', async () => {
  const { tab, n } = await exhibit('mode=change&time=0.8'), code = await program(tab), h = 1 / 128, duration = 0.375;
  const since = arrayOf(code, 'since'), [a, b] = ['a', 'b'].map(name => chunks(arrayOf(code, name), 4));
  const at = since.indexOf(0), offset = i => log(mul(a[i], conj(b[i])));
  const [wa, wb] = [a, b].map(q => rate(q[at - 1], q[at], h));
  // The rate of the offset, of both rotations with their angular velocities.
  const beside = t => log(mul(mul(exp(wa.map(w => w * t)), a[at]), conj(mul(exp(wb.map(w => w * t)), b[at]))));
  const x = offset(at), v = combine([duration / 2e-4, beside(1e-4)], [-duration / 2e-4, beside(-1e-4)]);
  const along = combine([1, v], [0, x]).reduce((sum, c, i) => sum + c * x[i], 0) / Math.hypot(...x) ** 2;
  assert.ok(along > -2.5, 'no acceleration is added, and the duration is not reduced');
  const result = i => since[i] < 0 ? a[i] : since[i] >= duration ? b[i]
    : mul(exp(quintic(x, v, [0, 0, 0], since[i] / duration)), b[i]);
  const [before, now] = [0.175 - h, 0.175].map(time => since.findIndex(t => Math.abs(t - time) < 1e-6));
  const expected = rate(result(before), result(now), h);
  row(n, 'velocity_inertia').forEach((value, i) => near(value, expected[i], 2e-3, 'xyz'[i]));
  await tab.close();
});

test('blend: the velocity of the straight cross-fade jumps at both ends, that of the others and of the smooth one less',
  async () => {
    const { tab, n } = await exhibit('mode=change'), jump = name => row(n, `jump_${name}`, 2);
    for (const end of [0, 1])
      for (const name of ['inertia', 'dead'])
        assert.ok(jump('fade')[end] > 5 * jump(name)[end], `${jump('fade')} ${jump(name)}`);
    await tab.close();
    const smooth = await exhibit('mode=change&smooth=1');
    for (const end of [0, 1])
      assert.ok(jump('fade')[end] > 4 * smooth.n[`jump_fade.${end}`]);
    await smooth.tab.close();
  });

test('blend: all methods end in the new clip', async () => {
  const { tab, n } = await exhibit('mode=change&time=1.5');
  for (const name of ['fade', 'inertia', 'dead'])
    assert.deepEqual(row(n, `velocity_${name}`), row(n, 'velocity_new'));
  await tab.close();
});

/* ---- two clips, additive ---- */

const degrees = q => log(q).map(c => c * 180 / Math.PI);

test('blend: the mean of two clips is the normalised mean of their rotations, in binary64', async () => {
  const { tab, n } = await exhibit('mode=pair&time=0.8&weight=0.3&joint=thigh.L&phase=0.1'), code = await program(tab);
  const [a, b] = chunks(arrayOf(code, 'a'), 4); // both are in one declaration
  const sign = a.reduce((sum, c, i) => sum + c * b[i], 0) < 0 ? -1 : 1;
  degrees(unit(combine([0.7, a], [0.3 * sign, b]))).forEach((value, i) => near(row(n, 'mean')[i], value, 1e-4));
  near(n['times.2'], 0.7 * 1 + 0.3 * 1.6, 1e-6); // the durations of walk and hop
  near(n['times.0'], 0.8 / 1.18, 1e-6);
  near(n['times.1'], (0.8 / 1.18 - 0.1) * 1.6, 1e-6);
  await tab.close();
});

test('blend: the whole difference is added on the side of the joint or of its parent, in binary64', async () => {
  for (const side of ['local', 'parent']) {
    const { tab, n } = await exhibit(`mode=additive&time=0.6&weight=1&joint=arm.R&side=${side}`);
    const code = await program(tab);
    const [base, clip, reference] = chunks(arrayOf(code, 'joint'), 10).map((_, i) =>
      unit(arrayOf(code, 'joint').slice(10 * i + 3, 10 * i + 7)));
    const sum = side === 'local' ? mul(base, mul(conj(reference), clip)) : mul(mul(clip, conj(reference)), base);
    degrees(sum).forEach((value, i) => near(row(n, 'sum')[i], value, 1e-3, side));
    await tab.close();
  }
});

/* ---- springs ---- */

/** omega for which (1 + y) exp(-y) = 1/2 after the half-life. */
function criticalOmega(half) {
  let [low, high] = [0, 10];
  for (let i = 0; i < 60; i++) {
    const y = (low + high) / 2;
    [low, high] = (1 + y) * Math.exp(-y) > 0.5 ? [y, high] : [low, y];
  }
  return low / half;
}

function follow(solve, goals, time) {
  let motion = [0, 0];
  goals.forEach(([start, goal], k) => {
    const t = Math.min(time, goals[k + 1]?.[0] ?? Infinity) - start;
    if (t > 0)
      motion = solve(motion[0] - goal, motion[1], t).map((c, i) => i ? c : c + goal);
  });
  return motion;
}

test('blend: springs are the closed form in binary64, whatever the steps', async () => {
  const goals = [[0.25, 1], [1.25, -0.5], [2, 0.5]], half = 0.15;
  for (const time of [0.4, 1.6, 2.75]) {
    const { tab, n } = await exhibit(`mode=springs&time=${time}`), w = criticalOmega(half);
    const critical = (x, v, t) => {
      const c = v + w * x, e = Math.exp(-w * t);
      return [(x + c * t) * e, (v - w * c * t) * e];
    };
    const [k, d] = row(n, 'spring', 2), a = d / 2, wd = Math.sqrt(k - a * a);
    const under = (x, v, t) => {
      const s = (v + a * x) / wd, [sin, cos, e] = [Math.sin(wd * t), Math.cos(wd * t), Math.exp(-a * t)];
      return [e * (x * cos + s * sin), e * ((s * wd - a * x) * cos - (x * wd + a * s) * sin)];
    };
    follow(critical, goals, time).forEach((value, i) => near(n[`critical.${i}`], value, 1e-5, 'critical'));
    for (const name of ['chosen', 'whole', 'thirty', 'sixty'])
      follow(under, goals, time).forEach((value, i) => near(n[`${name}.${i}`], value, 5e-5, name));
    await tab.close();
  }
});

test('blend: a spring from rest has half of its way after the half-life, for every damping ratio', async () => {
  for (const ratio of [0.25, 1, 2.5]) {
    const { tab, n } = await exhibit(`mode=springs&time=0.4&half=0.15&ratio=${ratio}`);
    near(n['chosen.0'], 0.5, 1e-6, `${ratio}`);
    await tab.close();
  }
});

/* ---- drags ---- */

const value = (tab, name) => tab.$eval(`[data-name="${name}"]`, cell => cell.dataset.value);
const changed = (tab, name, before) => tab.waitForFunction(([name, before]) =>
  document.querySelector(`[data-name="${name}"]`).dataset.value !== before, [name, before]);
async function middle(tab, i) {
  await tab.hover(`[data-handle="${i}"]`); // waits until it rests
  const box = await (await tab.$(`[data-handle="${i}"]`)).boundingBox();
  return [box.x + box.width / 2, box.y + box.height / 2];
}

test('blend: a drag by the mouse moves the start of the change', async () => {
  const { tab } = await exhibit('mode=change'), [x, y] = await middle(tab, 0), before = await value(tab, 'jump_fade.0');
  await tab.mouse.down();
  await tab.mouse.move(x + 60, y, { steps: 4 });
  await tab.mouse.up();
  await changed(tab, 'jump_fade.0', before);
  await tab.waitForFunction(() => Number(new URLSearchParams(location.hash.split('?')[1]).get('at')) > 0.7);
  await tab.close();
});

test('blend: a point at the edge of the plot is dragged by its outer half', async () => {
  const { tab } = await exhibit('mode=pair'), [x, y] = await middle(tab, 0), before = await value(tab, 'mean.0');
  await tab.mouse.move(x - 5, y);
  await tab.mouse.down();
  await tab.mouse.move(x + 60, y, { steps: 4 });
  await tab.mouse.up();
  await changed(tab, 'mean.0', before);
  await tab.close();
});

test('blend: a drag by a finger moves the goal of the springs', async () => {
  const { tab } = await exhibit('mode=springs&time=1', { hasTouch: true }), [x, y] = await middle(tab, 1);
  const before = await value(tab, 'critical.0'), session = await tab.context().newCDPSession(tab);
  const touch = (type, points) => session.send('Input.dispatchTouchEvent', { type, touchPoints: points });
  await touch('touchStart', [{ x, y }]);
  for (const part of [0.25, 0.5, 1])
    await touch('touchMove', [{ x, y: y + 30 * part }]);
  await touch('touchEnd', []);
  await changed(tab, 'critical.0', before);
  assert.ok(Number(await value(tab, 'critical.0')) < Number(before));
  await tab.close();
});

test('blend: the goal is dragged while it plays, and what was dragged stays in the address', async () => {
  const { tab } = await exhibit('mode=springs&time=0.5');
  const goals = () => tab.evaluate(() =>
    (new URLSearchParams(location.hash.split('?')[1]).get('goals') ?? '').split('_').length / 2);
  await tab.selectOption('.bar select', '0.1');
  await tab.hover('[data-handle="0"]');
  await tab.click('.play');
  const box = await (await tab.$('[data-handle="0"]')).boundingBox();
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await tab.mouse.move(x, y);
  await tab.mouse.down();
  for (let i = 0; await goals() < 6; i++) {
    await tab.mouse.move(x, y + 30 * Math.sin(i + 1));
    await tab.waitForFunction(before => Math.abs(Number(document.querySelector('.time').value) - before) > 0.02,
      await tab.$eval('.time', slider => Number(slider.value)));
  }
  await tab.mouse.up();
  await tab.close();
});

test('blend: arrow keys move the start of the change', async () => {
  const { tab } = await exhibit('mode=change'), before = await value(tab, 'jump_fade.0');
  await tab.focus('[data-handle="0"]');
  await tab.keyboard.press('ArrowRight');
  await changed(tab, 'jump_fade.0', before);
  await tab.close();
});
