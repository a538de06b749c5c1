// SPDX-License-Identifier: CC0-1.0
// A minimal implementation in binary64, as an example of an adapter for run.mjs.
const dot = (a, b) => a.reduce((sum, x, i) => sum + x * b[i], 0);
const scale = (a, s) => a.map((x) => x * s);
const add = (a, b) => a.map((x, i) => x + b[i]);
const unit = (a) => scale(a, 1 / Math.hypot(...a));

export function hermite(p0, v0, p1, v1, t) {
  const s = 1 - t;
  return [(1 + 2 * t) * s * s * p0 + t * s * s * v0 + t * t * (3 - 2 * t) * p1 - t * t * s * v1];
}

export function bezier(p0, p1, p2, p3, t) {
  const s = 1 - t;
  return [s * s * s * p0 + 3 * s * s * t * p1 + 3 * s * t * t * p2 + t * t * t * p3];
}

export function quat_mul([ax, ay, az, aw], [bx, by, bz, bw]) {
  return [[
    aw * bx + ax * bw + ay * bz - az * by,
    aw * by - ax * bz + ay * bw + az * bx,
    aw * bz + ax * by - ay * bx + az * bw,
    aw * bw - ax * bx - ay * by - az * bz,
  ]];
}

export function quat_rotate(q, v) {
  const [turned] = quat_mul(quat_mul(q, [...v, 0])[0], [-q[0], -q[1], -q[2], q[3]]);
  return [turned.slice(0, 3)];
}

export function nlerp(a, b, t) {
  return [unit(add(scale(a, 1 - t), scale(b, dot(a, b) < 0 ? -t : t)))];
}

export function slerp(a, b, t) {
  const c = dot(a, b) < 0 ? scale(b, -1) : b;
  // The angle from the chords: exact for small angles and near a half turn too.
  const h = 2 * Math.atan2(Math.hypot(...add(a, scale(c, -1))), Math.hypot(...add(a, c)));
  if (h === 0) return [a];
  return [scale(add(scale(a, Math.sin((1 - t) * h)), scale(c, Math.sin(t * h))), 1 / Math.sin(h))];
}
