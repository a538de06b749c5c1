// SPDX-License-Identifier: MIT
// The ticks and the samples of plots, by the modules of the kit themselves.
import assert from 'node:assert/strict';
import { createRequire } from 'node:module';
import { test } from 'node:test';

const { NKW_BUILD: build, NKW_ROOT: root } = process.env;
const { outputFiles } = createRequire(`${build}/`)('esbuild').buildSync({
  bundle: true, format: 'esm', write: false,
  stdin: { contents: `export * from './ticks'; export * from './samples';`, resolveDir: `${root}/docs/page/kit` },
});
globalThis.document = { documentElement: { lang: 'en' } }; // the language of the page
const { ticks, logTicks, tickTexts, samples, remembered } =
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

test('texts of ticks', () => {
  assert.deepEqual(tickTexts([-0.5, 0, 0.5, 1]), ['−0.5', '0', '0.5', '1']);
  assert.deepEqual(tickTexts([0.25, 0.5]), ['0.25', '0.5']);
  assert.deepEqual(tickTexts([-1000, 0, 1000]), ['−1,000', '0', '1,000']);
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
