// SPDX-License-Identifier: MIT
// The ticks and the samples of plots, by the modules of the kit themselves.
import assert from 'node:assert/strict';
import { createRequire } from 'node:module';
import { test } from 'node:test';

const { NKW_BUILD: build, NKW_ROOT: root } = process.env;
const { outputFiles } = createRequire(`${build}/`)('esbuild').buildSync({
  bundle: true, format: 'esm', write: false,
  stdin: {
    contents: `export * from './ticks'; export * from './samples'; export { exact, minus } from './numbers';`,
    resolveDir: `${root}/docs/page/kit`,
  },
});
globalThis.document = { documentElement: { lang: 'en' } }; // the language of the page
const { ticks, logTicks, tickTexts, samples, remembered, exact, minus } =
  await import(`data:text/javascript;base64,${Buffer.from(outputFiles[0].contents).toString('base64')}`);

test('ticks are multiples of one step, at least as many as wanted, within the range', () => {
  for (let i = 0; i < 2000; i++) {
    const size = 10 ** (i % 13 - 6), least = Math.sin(i) * size * 3, most = least + size * (1.1 + Math.cos(7 * i));
    const wanted = 2 + i % 7, list = ticks(least, most, wanted), step = list[1] - list[0];
    assert.ok(list.length >= wanted && list.length <= 4 * wanted, `${least} ${most}: ${list}`);
    list.forEach((x, k) => {
      assert.ok(x >= least - 1e-6 * step && x <= most + 1e-6 * step, `${x} is not in ${least} ${most}`);
      assert.ok(Math.abs(x / step - Math.round(x / step)) < 1e-3 && (k === 0 || x > list[k - 1]));
    });
    assert.equal(new Set(tickTexts(list)).size, list.length, `${tickTexts(list)}`);
  }
});

test('ticks of a logarithmic axis', () => {
  assert.deepEqual(logTicks(0.9, 110, 2), [1, 10, 100]);
  assert.deepEqual(logTicks(0.9, 11, 3), [1, 2, 5, 10]);
  assert.ok(logTicks(3, 4, 2).length >= 2);
});

test('ticks of a logarithmic axis reach both ends and not beyond', () => {
  for (let low = -6; low < 6; low++)
    for (let high = low + 1; high < 7; high++) {
      const least = 10 ** low, most = 10 ** high;
      for (const [from, to] of [[least, most], [least * 1.01, most * 0.99], [least * 0.99, most * 1.01]]) {
        const list = logTicks(from, to, 2);
        assert.ok(list.length >= 2, `${from} ${to}: ${list}`);
        assert.ok(list.every(x => x >= from * (1 - 1e-8) && x <= to * (1 + 1e-8)), `${from} ${to}: ${list}`);
        for (let power = low; power <= high; power++)
          if (10 ** power >= from && 10 ** power <= to)
            assert.ok(list.some(x => Math.abs(x / 10 ** power - 1) < 1e-9), `${power}, ${from} ${to}: ${list}`);
      }
    }
});

test('texts of ticks', () => {
  assert.deepEqual(tickTexts([-0.5, 0, 0.5, 1]), ['−0.5', '0', '0.5', '1']);
  assert.deepEqual(tickTexts([0.25, 0.5]), ['0.25', '0.5']);
  assert.deepEqual(tickTexts([-1000, 0, 1000]), ['−1,000', '0', '1,000']);
});

test('a zero has no minus sign, whatever its decimals; other numbers have one', () => {
  for (let digits = 0; digits < 7; digits++) {
    const zero = (0).toFixed(digits);
    assert.equal(minus((-1e-9).toFixed(digits)), zero);
    assert.equal(minus((-0).toFixed(digits)), zero);
    assert.equal(minus(`-${zero}`), zero);
    assert.equal(minus((-10).toFixed(digits)), `−${(10).toFixed(digits)}`);
    assert.equal(minus((-1).toFixed(digits)), `−${(1).toFixed(digits)}`);
  }
  assert.deepEqual(tickTexts([-2, -1, -0, 1]), ['−2', '−1', '0', '1']);
  assert.deepEqual([exact(-0), exact(0), exact(-3)], ['-0', '0', '-3']);
});

test('samples are dense where a curve bends or jumps, and only there', () => {
  const curve = x => [x < 1 ? 0 : 1, Math.sqrt(Math.abs(x - 1)), x];
  const { x, y: [step, root, line] } = samples(curve, 0, 3), far = x.filter(t => t > 2);
  assert.equal(x[0], 0);
  assert.equal(x.at(-1), 3);
  x.forEach((t, i) => assert.deepEqual([step[i], root[i], line[i]], curve(t)));
  const jump = x.findIndex(t => t >= 1);
  assert.ok(x[jump] - x[jump - 1] < 3 / 96 / 60, `${x[jump] - x[jump - 1]}`);
  assert.ok(far.length <= 2 * 33 && x.length < 300, `${x.length}`);
});

test('a function of the state is remembered until something else than the time changes', () => {
  let calls = 0;
  const f = remembered(({ a }) => { calls++; return [a]; }), first = f({ a: 1, time: 0 });
  assert.equal(f({ a: 1, time: 0.5 }), first);
  assert.deepEqual(f({ a: 2, time: 0.5 }), [2]);
  assert.equal(calls, 2);
});
