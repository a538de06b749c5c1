// SPDX-License-Identifier: MIT
// The blanks of the report, A to E: the formula, the names of its numbers (numbers.ts), and the code with vecmath.
import type { Text } from '../../shell/text';

export interface Blank {
  /** A letter, or nothing for a line that is no blank. */
  letter: string;
  /** HTML. */
  label: Text | string;
  /** The weight, and the index of the value that it multiplies; or the names of the numbers. */
  weight?: number;
  names?: string[];
}

export interface Section { title: Text; blanks: Blank[]; code: string[] }

const term = (letter: string, label: string, weight: number): Blank => ({ letter, label, weight });
const line = (letter: string, label: Text | string, ...names: string[]): Blank => ({ letter, label, names });

const sum = line('E', tex`p = a_0 p_0 + a_1 p_1 + a_2 p_2 + a_3 p_3`, 'position');
const sumCode = 'p.scale( a0, p0 ); p.scaleAdd( a1, p1, p ); p.scaleAdd( a2, p2, p ); p.scaleAdd( a3, p3, p )';

const hermite: Section = {
  title: { en: '2.1 Hermite curve', ja: '2.1 Hermite 曲線' },
  blanks: [
    term('A', tex`a = 2t^3 - 3t^2 + 1`, 0), term('B', tex`b = -2t^3 + 3t^2`, 2),
    term('C', tex`c = t^3 - 2t^2 + t`, 1), term('D', tex`d = t^3 - t^2`, 3),
    line('E', tex`p = a\,p_0 + b\,p_1 + c\,v_0 + d\,v_1`, 'position'),
  ],
  code: ['a = 2*t*t*t - 3*t*t + 1', 'b = -2*t*t*t + 3*t*t', 'c = t*t*t - 2*t*t + t', 'd = t*t*t - t*t',
    'p.scale( a, p0 ); p.scaleAdd( b, p1, p ); p.scaleAdd( c, v0, p ); p.scaleAdd( d, v1, p )'],
};

const bezier: Section = {
  title: { en: '2.2 Bézier curve', ja: '2.2 Bézier 曲線' },
  blanks: [
    term('A', tex`a_0 = (1-s)^3`, 0), term('B', tex`a_1 = 3(1-s)^2 s`, 1), term('C', tex`a_2 = 3(1-s)s^2`, 2),
    term('D', tex`a_3 = s^3`, 3), sum,
  ],
  code: ['a0 = (1-s)*(1-s)*(1-s)', 'a1 = 3*(1-s)*(1-s)*s', 'a2 = 3*(1-s)*s*s', 'a3 = s*s*s', sumCode],
};

const bspline: Section = {
  title: { en: '2.3 B-spline curve', ja: '2.3 B スプライン曲線' },
  blanks: [
    term('A', tex`a_0 = \tfrac16(-t^3 + 3t^2 - 3t + 1)`, 0), term('B', tex`a_1 = \tfrac16(3t^3 - 6t^2 + 4)`, 1),
    term('C', tex`a_2 = \tfrac16(-3t^3 + 3t^2 + 3t + 1)`, 2), term('D', tex`a_3 = \tfrac16 t^3`, 3), sum,
  ],
  code: ['a0 = (-t*t*t + 3*t*t - 3*t + 1) / 6', 'a1 = (3*t*t*t - 6*t*t + 4) / 6',
    'a2 = (-3*t*t*t + 3*t*t + 3*t + 1) / 6', 'a3 = t*t*t / 6', sumCode],
};

const linearSum = line('', 'p = ' + tex`(1 - t)\,p_0 + t\,p_1`, 'position');
const linear: Section = {
  title: { en: '1.8 Linear', ja: '1.8 線形補間' },
  blanks: [term('', 'w0 = ' + tex`1 - t`, 0), term('', 'w1 = ' + tex`t`, 1), linearSum],
  code: [],
};

const evenly = line('', 'w = ' + tex`1 - t,\ t`, 'share');

const slerp: Section = {
  title: { en: '2.4 Quaternions, slerp', ja: '2.4 四元数の球面線形補間' },
  blanks: [
    line('A', { en: 'q0 of o0 (x y z w)', ja: 'o0 の四元数 q0（x y z w）' }, 'q0'),
    line('A', { en: 'q1 of o1', ja: 'o1 の四元数 q1' }, 'q1key'),
    line('', { en: 'q0·q1; if &lt; 0, blank B', ja: 'q0·q1（負なら空欄 B）' }, 'dot'),
    line('B', { en: 'q1 after blank B', ja: '空欄 B の後の q1' }, 'q1'),
    line('', { en: 'θ (rad), turn 2θ (°)', ja: 'θ（rad）、回転角 2θ（°）' }, 'theta', 'turn'),
    line('', '(17) ' + tex`\tfrac{\sin (1-t)\theta}{\sin\theta},\ \tfrac{\sin t\theta}{\sin\theta}`, 'share'),
    line('C', { en: 'q, the sum', ja: '和 q' }, 'q'),
  ],
  code: ['q0.set( o0 ); q1.set( o1 )', 'q1.negate()', 'q.interpolate( q0, q1, t )', 'o.set( q )'],
};

const nlerp: Section = {
  ...slerp, title: { en: 'Quaternions, nlerp', ja: '四元数の nlerp' },
  blanks: slerp.blanks.map(b => b.names?.[0] === 'share' ? evenly
    : b.letter === 'C' ? line('', { en: 'the sum; q is its direction', ja: '和（q はその向き）' }, 'q')
    : { ...b, letter: '' }),
  code: [],
};

const euler: Section = {
  title: { en: '1.9 Euler angles: pitch, yaw, roll (rad)', ja: '1.9 オイラー角補間（仰角、方位角、旋回角、rad）' },
  blanks: [
    line('', { en: 'angles of o0 (± 2π)', ja: 'o0 の角度（±2π）' }, 'angles0'),
    line('', { en: 'angles of o1', ja: 'o1 の角度' }, 'angles1'), evenly,
    line('', { en: 'the sum', ja: '和' }, 'angles'),
  ],
  code: [],
};

export const positionSections: Record<string, Section> = { linear, hermite, bezier, bspline };
export const orientationSections: Record<string, Section> =
  { quat: slerp, nlerp, euler, 'euler-unwrapped': euler };

/** Methods that are not in the exercise, and Bézier with fewer than four keys: the weights by number. */
export function otherPosition(count: number, title: Text): Section {
  const weights = Array.from({ length: count }, (_, i) => term('', `w${i}`, i));
  return { title, code: [], blanks: [...weights, line('', 'p', 'position')] };
}
