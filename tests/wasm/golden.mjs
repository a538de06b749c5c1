// SPDX-License-Identifier: MIT
// The hashes of tests/golden/golden.txt from the package's functions: the rows of kernels.h that are calls of them are
// read as JavaScript. Runs in Node and in browsers.
import { rowsOfFunctions } from './golden-rows.mjs';

const F = Math.fround, mask = (1n << 64n) - 1n;

// xoshiro256** and what tests/support/random.c makes of it.
function randomFrom(seed) {
  const s = [];
  for (let i = 0; i < 4; i++) {
    seed = (seed + 0x9E3779B97F4A7C15n) & mask;
    let z = ((seed ^ (seed >> 30n)) * 0xBF58476D1CE4E5B9n) & mask;
    z = ((z ^ (z >> 27n)) * 0x94D049BB133111EBn) & mask;
    s.push(z ^ (z >> 31n));
  }
  const left = (x, k) => ((x << k) | (x >> (64n - k))) & mask;
  return () => {
    const result = (left((s[1] * 5n) & mask, 7n) * 9n) & mask, t = (s[1] << 17n) & mask;
    s[2] ^= s[0];
    s[3] ^= s[1];
    s[1] ^= s[2];
    s[0] ^= s[3];
    s[2] ^= t;
    s[3] = left(s[3], 45n);
    return result;
  };
}

class Random {
  constructor(seed, N) {
    [this.bits, this.N] = [randomFrom(seed), N];
    this.view = new DataView(new ArrayBuffer(8));
  }
  number() { return Number(this.bits() >> 40n) * 2 ** -24; }
  unit() { return F(this.number()); }
  between(low, high) { return F(low + (high - low) * this.number()); }
  scaled(low, high) {
    const b = this.bits();
    const scale = ((b >> 32n) % BigInt(high - low) + BigInt(low + 1023)) << 52n;
    this.view.setBigUint64(0, ((b >> 31n) & 1n) << 63n | scale | (b & 0x7FFFFFn) << 29n);
    return F(this.view.getFloat64(0));
  }
  finite() {
    let b;
    do
      b = Number(this.bits() >> 32n);
    while ((b & 0x7F800000) === 0x7F800000);
    this.view.setUint32(0, b);
    return this.view.getFloat32(0);
  }
  vec(n, low, high) { return Array.from({ length: n }, () => this.between(low, high)); }
  static square(v) {
    const q = v.map(x => F(x * x));
    return v.length === 3 ? F(F(q[0] + q[1]) + q[2]) : F(F(q[0] + q[1]) + F(q[2] + q[3]));
  }
  ball(n) {
    let v, square;
    do {
      v = this.vec(n, -1, 1);
      square = Random.square(v);
    } while (square > 1 || square < 2 ** -10);
    return [v, square];
  }
  direction() {
    const [v, square] = this.ball(3), length = this.N.sqrt(square);
    return v.map(x => F(x / length));
  }
  static toUnit(q, N) {
    const [xx, yy, zz, ww] = q.map(x => x * x), length = N.sqrt(F((xx + yy) + (zz + ww)));
    return q.map(x => F(x / length));
  }
  rotation() { return Random.toUnit(this.ball(4)[0], this.N); }
  near([x, y, z, w], angle) {
    const [vx, vy, vz] = this.direction(), s = this.N.sin(angle), c = this.N.cos(angle);
    return Random.toUnit([
      F(c * x + s * (w * vx + (y * vz - z * vy))), F(c * y + s * (w * vy + (z * vx - x * vz))),
      F(c * z + s * (w * vz + (x * vy - y * vx))), F(c * w + s * -((x * vx + y * vy) + z * vz))], this.N);
  }
}

function someRotation(r, near, kind) {
  if (kind === 0)
    return near;
  if (kind === 1)
    return near.map(x => -x);
  return kind < 5 ? r.near(near, F(kind === 2 ? 1e-5 : kind === 3 ? 1e-2 : 0.3)) : r.rotation();
}

// `draw` of golden.c.
function draw(r, N) {
  const i = { x: [], s: [], cubic: [], q: [], keys: [] };
  for (let k = 0; k < 8; k++) {
    i.x.push(r.finite());
    i.s.push(r.scaled(-6, 3));
    i.cubic[k % 4] = i.s[k];
  }
  const bits = r.bits(), part = (shift, n) => Number((bits >> BigInt(shift)) % BigInt(n));
  i.t = part(0, 16) === 0 ? 0 : part(0, 16) === 1 ? 1 : r.unit();
  [i.order, i.path, i.unwrap] = [part(8, 6), part(16, 3), part(24, 3)];
  i.v = Array.from({ length: 4 }, () => r.vec(3, -4, 4));
  i.q.push(r.rotation());
  for (let k = 1; k < 4; k++)
    i.q.push(someRotation(r, i.q[0], part(32 + 4 * k, 2 ** 32) % 8));
  i.trs = [...r.vec(3, -100, 100), ...i.q[3], ...r.vec(3, -2, 2)];
  i.r = N.mat3FromQuat([], i.q[2]);
  const linear = i.r.map(x => F(x * r.between(F(0.9), F(1.1))));
  i.m = N.mat4FromMat3([], linear, i.trs.slice(0, 3));
  i.n = r.vec(16, -3, 3);
  let time = -2;
  for (let k = 0; k < 5; k++) {
    time = F(time + (k % 2 ? r.unit() : 1));
    i.keys.push([time, ...r.vec(3, -4, 4), ...r.rotation()]);
  }
  i.times = i.keys.slice(0, 4).map(key => key[0]);
  return i;
}

// FNV-1a over the bits of floats; 64 bits as two halves, hash * (2^40 + 435).
class Hash {
  constructor() {
    [this.high, this.low] = [0xcbf29ce4, 0x84222325];
    this.word = new DataView(new ArrayBuffer(4));
  }
  add(x) {
    this.word.setFloat32(0, x, true);
    if (x !== x)
      this.word.setUint32(0, 0x7fc00000, true);
    for (let b = 0; b < 4; b++) {
      const low = (this.low ^ this.word.getUint8(b)) >>> 0, product = low * 435;
      this.high = (Math.imul(this.high, 435) + Math.floor(product / 2 ** 32) + (low << 8)) >>> 0;
      this.low = product >>> 0;
    }
  }
  toString() { return [this.high, this.low].map(x => x.toString(16).padStart(8, '0')).join(''); }
}

const hexFloat = (_, whole, fraction, exponent) =>
  String(parseInt(whole + fraction, 16) / 16 ** fraction.length * 2 ** +exponent);

// The JavaScript of a row, or undefined if the row calls more than functions of the package.
function translate(text, N) {
  const js = text
    .replace(/0x(\d+)\.?([0-9a-f]*)p([-+]?\d+)f?/g, hexFloat).replace(/(\d\.\d+)f\b/g, '$1')
    .replace(/\(\w*(?:float|int|int32_t|nkw_ease_jump)\)/g, '').replace(/->/g, '.').replace(/&i\./g, 'i.')
    .replace(/([\d.]+) \* (i\.\w+\[\d\])/g, 'F($1 * $2)').replace(/\bput_\w+\(o,/g, 'put(o,')
    .replace(/\bsample\(o, i,/g, 'put(o, frame(i,').replace(/frame\(.*\)$/, '$&)')
    .replace(/\bNKW_/g, 'N.').replace('NULL', 'null')
    .replace(/\bnkw_(\w+)/g, (_, name) => 'k.' + name);
  const calls = [...js.matchAll(/([\w.]+)\(/g)].map(m => m[1]).filter(name => !['put', 'F', 'frame'].includes(name));
  const known = calls.every(name => name.startsWith('k.') && N[camel(name.slice(2))]);
  if (!known || /o \+|&|i\.s \+|,\s*k\.\w+\s*[,)]|\(double\)/.test(js))
    return undefined;
  return js;
}
const camel = name => name.replace(/_([a-z0-9])/g, (_, c) => c.toUpperCase());

// Compares the package N; returns how many rows were compared, and the names that differ.
export function compareGolden(N, kernels, golden, rounds = 4000) {
  const k = new Proxy({}, {
    get(cache, name) {
      const f = N[camel(name)], out = /^function \w+\(out\b/.test(f.toString());
      const flat = args => args.map(a => Array.isArray(a?.[0]) ? a.flat() : a);
      return cache[name] ??= out ? (...args) => f([], ...flat(args)) : (...args) => f(...flat(args));
    },
  });
  const put = (o, values) => values.forEach((x, c) => { o[c] = x; });
  let held; // one object for the keys of all rounds
  const frame = (i, position, orientation) => {
    held ??= new N.Keyframes(i.keys.flat());
    held.array.set(i.keys.flat());
    return held.sample(i.s[0], position, orientation, []);
  };
  const want = new Map([...golden.matchAll(/^(\S+)\s+([0-9a-f]{16})$/gm)].map(m => [m[1], m[2]]));
  const rows = [];
  for (const [, name, count, text] of kernels.matchAll(/^K\((\w+), (\d+), (.*)\)$/gm)) {
    const js = translate(text, N);
    const made = rowsOfFunctions[name];
    if (made && N.FCurve)
      rows.push({ name, count: +count, hash: new Hash(), run: made.bind(null, N) });
    else if (js && !made) {
      const run = new Function('N, k, put, F, frame, i, o', js).bind(null, N, k, put, F, frame);
      rows.push({ name, count: +count, hash: new Hash(), run });
    }
  }
  const r = new Random(0x6e616b61n, N);
  for (let round = 0; round < rounds; round++) {
    const i = draw(r, N);
    for (const row of rows) {
      const o = new Float32Array(16);
      row.run(i, o, round);
      for (let c = 0; c < row.count; c++)
        row.hash.add(o[c]);
    }
  }
  held?.dispose();
  const different = rows.filter(row => row.hash.toString() !== want.get(row.name)).map(row => row.name);
  return { build: N.build(), rows: rows.length, different };
}
