// SPDX-License-Identifier: MIT
// Rotations in binary64, x y z w: the formulas by which the numbers of the page are checked.
export const degrees = 180 / Math.PI;
export const dot = (a, b) => a.reduce((sum, x, i) => sum + x * b[i], 0);
export const scale = (a, s) => a.map(x => x * s);
export const cross = ([a, b, c], [x, y, z]) => [b * z - c * y, c * x - a * z, a * y - b * x];

export const product = ([x, y, z, w], [a, b, c, d]) => [w * a + x * d + y * c - z * b, w * b + y * d + z * a - x * c,
  w * c + z * d + x * b - y * a, w * d - x * a - y * b - z * c];
export const inverse = ([x, y, z, w]) => [-x, -y, -z, w];
export const rotated = (q, v) => product(product(q, [...v, 0]), inverse(q)).slice(0, 3);

const about = (axis, angle) => [0, 1, 2, 3].map(i =>
  i === 3 ? Math.cos(angle / 2 / degrees) : i === axis ? Math.sin(angle / 2 / degrees) : 0);
/** The rotation of angles x y z in degrees, the factors in the order of the letters. */
export const euler = (order, angles) => [...order].map(letter => 'XYZ'.indexOf(letter))
  .reduce((q, axis) => product(q, about(axis, angles[axis])), [0, 0, 0, 1]);

/** The half angle times the axis. */
export function log([x, y, z, w]) {
  const length = Math.hypot(x, y, z);
  return scale([x, y, z], length > 0 ? Math.atan2(length, w) / length : 1);
}
export function exp(v) {
  const length = Math.hypot(...v);
  return [...scale(v, length > 0 ? Math.sin(length) / length : 1), Math.cos(length)];
}
export const nearer = (a, b) => dot(a, b) < 0 ? scale(b, -1) : b;
export const slerp = (a, b, t) => product(exp(scale(log(product(b, inverse(a))), t)), a);

/** The angular velocity of q(t), by a difference of binary64. */
export function velocity(q, t, h = 1e-5) {
  const [before, after] = [q(t - h), q(t + h)];
  return scale(log(product(nearer(before, after), inverse(before))), 1 / h);
}
