// SPDX-License-Identifier: MIT
// Samples of curves for plots, denser where a curve bends or jumps.

/** Abscissae in ascending order, and for each curve its values. */
export interface Samples { x: number[]; y: number[][] }

interface Sample { x: number; y: number[] }

/** Halves a step until every curve is straight there to `tolerance`, at most `depth` times. */
function refine(f: (x: number) => number[], a: Sample, b: Sample, tolerance: number[], depth: number): Sample[] {
  const x = (a.x + b.x) / 2, middle = { x, y: f(x) };
  const straight = middle.y.every((y, i) => !(Math.abs(y - (a.y[i] + b.y[i]) / 2) > tolerance[i]));
  return depth === 0 || straight ? [middle]
    : [...refine(f, a, middle, tolerance, depth - 1), middle, ...refine(f, middle, b, tolerance, depth - 1)];
}

const finite = (list: number[]) => list.filter(Number.isFinite);

/** The curves f(x)[i] from `from` to `to`: `count` equal steps, halved where a curve is not straight. */
export function samples(f: (x: number) => number[], from: number, to: number, count = 96): Samples {
  const at = (i: number) => i === count ? to : from + (i * (to - from)) / count;
  const points = Array.from({ length: count + 1 }, (_, i) => ({ x: at(i), y: f(at(i)) }));
  const tolerance = points[0].y.map((_, i) => {
    const all = finite(points.map(p => p.y[i]));
    return Math.max(Math.max(...all) - Math.min(...all), 0) / 400;
  });
  const all = points.flatMap((p, k) => k === 0 ? [p] : [...refine(f, points[k - 1], p, tolerance, 6), p]);
  return { x: all.map(p => p.x), y: tolerance.map((_, i) => all.map(p => p.y[i])) };
}

/** f of the state, called again only if something else than the time has changed. */
export function remembered<S extends object, T>(f: (state: S) => T): (state: S) => T {
  let before: string | undefined, kept: T;
  return state => {
    const now = JSON.stringify({ ...state, time: 0 });
    if (now !== before)
      kept = f(state);
    before = now;
    return kept;
  };
}
