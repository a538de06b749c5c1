// SPDX-License-Identifier: MIT
// The play bar by itself: its time, its speed, and its range, without a page.
import assert from 'node:assert/strict';
import { createRequire } from 'node:module';
import { test } from 'node:test';

const { NKW_BUILD: build, NKW_ROOT: root } = process.env;
const contents = 'export const wrap = (x, period) => x - Math.floor(x / period) * period;';
const wrap = { name: 'wrap', setup(b) {
  b.onResolve({ filter: /^nakawari/ }, () => ({ path: 'wrap', namespace: 'wrap' }));
  b.onLoad({ filter: /.*/, namespace: 'wrap' }, () => ({ contents }));
} };
const { outputFiles } = await createRequire(`${build}/`)('esbuild').build({
  bundle: true, format: 'esm', write: false, plugins: [wrap],
  stdin: { contents: `export * from './clock';`, resolveDir: `${root}/docs/page/shell` },
});

/** What the bar needs of an element. */
class Part {
  constructor(tag) { Object.assign(this, { tag, parts: [], listeners: {}, attributes: {}, dataset: {} }); }
  append(...parts) { this.parts.push(...parts); }
  setAttribute(name, value) { this.attributes[name] = value; }
  addEventListener(type, f) { this.listeners[type] = f; }
}
globalThis.document = { documentElement: { lang: 'en' }, createElement: tag => new Part(tag) };
const { makeClock } =
  await import(`data:text/javascript;base64,${Buffer.from(outputFiles[0].contents).toString('base64')}`);
const made = (start, end) => {
  const times = [], { clock, bar } = makeClock(() => ({ start, end }), time => times.push(time), () => {});
  return { clock, times, part: tag => bar.parts.find(p => p.tag === tag) };
};

test('the time after some seconds is that of the speed, wrapped into the range', () => {
  const { clock, part } = made(1, 4), rates = part('select');
  assert.equal(clock.next(1.5, 0.25), 1.75);
  for (const rate of [0.1, 0.25, 0.5, 1, 2]) {
    rates.value = String(rate);
    rates.listeners.change();
    assert.equal(clock.rate, rate);
    for (const seconds of [0, 0.125, 0.5, 1, 10]) {
      const want = 1 + (0.5 + seconds * rate) % 3;
      assert.ok(Math.abs(clock.next(1.5, seconds) - want) < 1e-12, `${rate} ${seconds}`);
    }
  }
});

test('a range without a duration stays at its start; restart begins there and plays', () => {
  assert.equal(made(2, 2).clock.next(5, 1), 2);
  assert.equal(made(2, 1).clock.next(5, 1), 2);
  const { clock, times } = made(3, 9);
  clock.restart();
  assert.deepEqual([times, clock.playing], [[3], true]);
  clock.toggle();
  assert.equal(clock.playing, false);
});

test('the slider sets the time', () => {
  const { times, part } = made(0, 1), slider = part('input');
  slider.value = '0.75';
  slider.listeners.input();
  assert.deepEqual(times, [0.75]);
});
