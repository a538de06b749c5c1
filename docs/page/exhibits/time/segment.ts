// SPDX-License-Identifier: MIT
// A segment whose handles have a time and a value, under the policies.
import * as N from 'nakawari/all';
import { choice, flag, number, numbers, some } from '../../shell/state';
import type { Text } from '../../shell/text';

/** In the order of nkw_handle_policy. */
export const policies = ['none', 'contain', 'ratio', 'start'] as const;
type Policy = typeof policies[number];
export const names: Record<Policy, Text> = {
  none: { en: 'none', ja: '制限なし' },
  contain: { en: 'contain', ja: '区間内に収める' },
  ratio: { en: 'keep the ratio', ja: '長さの比を保つ' },
  start: { en: 'keep the start', ja: '始点側を優先' },
};
const tools: Record<Policy, string> = { none: 'CSS, Unity', contain: 'Blender', ratio: 'OpenUSD', start: 'Maya' };
/** The names with the tools that have the policy. */
export const words = Object.fromEntries(policies.map(p => [p,
  { en: `${names[p].en} (${tools[p]})`, ja: `${names[p].ja}（${tools[p]}）` }])) as Record<Policy, Text>;
export const meanings: Record<Policy, Text> = {
  none: {
    en: 'None: the value at a time is the first that the curve reaches; it jumps over the part that runs back.',
    ja: '制限なし：曲線が最初にその時刻に達したときの値をとります。逆行する部分は飛び越え、値はそこで不連続になります。',
  },
  contain: {
    en: 'Contain: each handle that is longer than the segment is shortened to its duration, and keeps its slope.',
    ja: '区間内に収める：区間より長いハンドルを、傾きを保ったまま、それぞれ区間の長さまで縮めます。',
  },
  ratio: {
    en: 'Keep the ratio: both handles are shortened by one factor, until the curve is vertical in one point only.',
    ja: '長さの比を保つ：曲線が1点でだけ垂直になるまで、両方のハンドルを同じ倍率で縮めます。',
  },
  start: {
    en: 'Keep the start: the handle of the first key stays, up to 4/3 of the duration; that of the last key is shortened.',
    ja: '始点側を優先：始点のハンドルは区間の長さの 4/3 まで保たれ、終点のハンドルの長さを変えて合わせます。',
  },
};

/** The segment as nkw_handle_segment: time0, value0, out.time, out.value, in.time, in.value, time1, value1. */
export interface State {
  segment: number[]; policy: Policy; split: boolean; hidden: (Policy | 'given' | 'chosen')[]; time: number;
}
export const back = [0, 0, 1.75, 0.35, -1.05, 0.1, 1, 1], third = [0, 0, 1 / 3, 0, -1 / 3, 0, 1, 1];
export const fields = {
  segment: numbers(back, l => l.length === 8 && l[6] > l[0]),
  policy: choice<Policy>('none', policies), split: flag(false),
  hidden: some<State['hidden'][number]>([], [...policies, 'given', 'chosen']), time: number(0.4),
};

export const limited = (s: State, policy = s.policy): Float32Array =>
  N.handleLimit(new Float32Array(8), s.segment, policies.indexOf(policy));

/** Value and velocity at a time, and the parameter. */
export function pointOf(segment: ArrayLike<number>, time: number): number[] {
  const [value, first] = N.handleSample(new Float32Array(3), segment, time);
  return [value, first, N.handleParameter(segment, time)];
}

/** The two segments of the chosen policy that have a key at the present time. */
export function halves(s: State): [Float32Array, Float32Array] {
  const left = new Float32Array(8), right = new Float32Array(8);
  N.handleSplit(limited(s), s.time, left, right);
  return [left, right];
}

/** The points of the given segment by its parameter: time, value, s. */
export function given({ segment: [t0, v0, ot, ov, it, iv, t1, v1] }: State): number[][] {
  return Array.from({ length: 257 }, (_, i) => i / 256).map(s =>
    [N.bezier(t0, t0 + ot, t1 + it, t1, s), N.bezier(v0, v0 + ov, v1 + iv, v1, s), s]);
}
