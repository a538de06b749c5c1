// SPDX-License-Identifier: MIT
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { bits, both, numbers, rotation } from './support.mjs';

const [[, values]] = await both('values');
const outOf = f => (...args) => f([], ...args);

test('values: the small part has the bits of the large one', async () => {
  const [[, math]] = await both('math');
  const next = numbers(1);
  for (let k = 0; k < 100; k++) {
    const [a, b, t, u, v] = [rotation(next), rotation(next), next(), ...[0, 1].map(() => [next(), next(), next()])];
    for (const [name, args] of [['quatSlerp', [a, b, t]], ['quatNlerp', [a, b, t]], ['quatMul', [a, b]],
      ['vec3Cross', [u, v]], ['vec3Hermite', [u, v, v, u, t]], ['quatRotate', [a, v]], ['quatLog', [a]]])
      assert.deepEqual(bits(outOf(values[name])(...args)), bits(outOf(math[name])(...args)), name);
    assert.equal(values.sin(100 * t), math.sin(100 * t));
  }
});

for (const [build, math] of await both('math')) {
  test(`${build}: an array may be argument and result of one call`, () => {
    const a = Float32Array.of(1, 2, 3), b = [0, 1, 0];
    assert.equal(math.vec3Cross(a, a, b), a);
    assert.deepEqual([...a], [-3, 0, 1]);
  });

  test(`${build}: component arrays have the bits of single values`, () => {
    const n = 37, next = numbers(2), [a, b, out] = [1, 2, 3].map(() => new math.Columns(4, n));
    const t = new math.Columns(1, n);
    const q = Array.from({ length: n }, () => [rotation(next), rotation(next), next()]);
    q.forEach(([p, r, s], i) => {
      for (let c = 0; c < 4; c++)
        [a.column(c)[i], b.column(c)[i]] = [p[c], r[c]];
      t.x[i] = s;
    });
    math.quatSlerpN(a, b, t, out, n);
    q.forEach(([p, r, s], i) =>
      assert.deepEqual(bits([out.x[i], out.y[i], out.z[i], out.w[i]]), bits(math.quatSlerp([], p, r, s))));
    assert.throws(() => math.quatSlerpN(a, b, t, out, n + 1), RangeError);
    assert.throws(() => math.quatSlerpN(a, t, t, out, n), RangeError);
    [a, b, out, t].forEach(columns => columns.dispose());
    assert.throws(() => math.quatSlerpN(a, b, t, out, n), /disposed/);
  });

  test(`${build}: arrays with a count are read and written`, () => {
    const angles = [3.1, 0, 0, -3.1, 0, 0], out = new Float32Array(6);
    math.eulerFilter(angles, 2, math.EULER_XYZ, out);
    assert.ok(Math.abs(out[3] - (2 * Math.PI - 3.1)) < 1e-5);
    assert.throws(() => math.eulerFilter(angles, 3, math.EULER_XYZ, out), RangeError);
    assert.deepEqual(math.quatMean([], [0, 0, 0, 1, 0, 0, 0, 1], 2, null), [0, 0, 0, 1]);
    assert.equal(math.memory().blocks, 0);
  });

  test(`${build}: keyframes and their trace`, () => {
    const keys = new math.Keyframes([0, 1, 2, 3, 0, 0, 0, 1, 2, 3, 2, 3, 0, 1, 0, 0]);
    const m = keys.sample(1, math.POSITION_LINEAR, math.ORIENTATION_SLERP, []);
    assert.deepEqual(m.slice(12), [2, 2, 3, 1]);
    const trace = keys.trace(1, { orientation: math.ORIENTATION_SLERP });
    assert.deepEqual([trace.segment, trace.t, trace.key, trace.weight], [0, 0.5, [0, 1], [0.5, 0.5]]);
    assert.deepEqual(trace.position, [2, 2, 3]);
    assert.deepEqual(trace.rotation, [0, 1, 2, 4, 5, 6, 8, 9, 10].map(k => m[k]));
    assert.deepEqual([0, 1].map(rule => keys.sampleAs(2, { position: math.POSITION_STEP, rule }, [])[12]), [3, 1]);
    assert.throws(() => new math.Keyframes([0, 0, 0, 0, 0, 0, 0, 2]), error => error instanceof math.NakawariError);
    keys.dispose();
    assert.equal(math.memory().blocks, 0);
  });
}
