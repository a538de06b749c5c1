// SPDX-License-Identifier: MIT
// Exhibit 9: the change from one motion to another, by a cross-fade and by inertialisation.
import * as N from 'nakawari/all';
import { list, literal, program } from '../kit/code';
import { numberTable } from '../kit/numbers';
import { panel } from '../kit/panel';
import { plot } from '../kit/plot';
import type { Exhibit, Room } from '../shell/exhibit';
import { number } from '../shell/state';
import type { Text } from '../shell/text';

interface State { time: number; at: number; duration: number; low: number; high: number }

const words = {
  value: { en: 'Value', ja: '値' },
  velocity: { en: 'Velocity (1/s)', ja: '速度 (1/s)' },
  seconds: { en: 'time (s)', ja: '時刻 (s)' },
  from: { en: 'old motion', ja: '元の動き' },
  to: { en: 'new motion', ja: '新しい動き' },
  fade: { en: 'cross-fade', ja: 'クロスフェード' },
  inertia: { en: 'inertialisation', ja: '慣性化（inertialisation）' },
  numbers: { en: 'Now: value, velocity', ja: '現在の値と速度' },
  change: { en: 'The change', ja: '切り替え' },
  at: { en: 'begins at (s)', ja: '開始時刻 (s)' },
  duration: { en: 'duration (s)', ja: '長さ (s)' },
  low: { en: 'new motion at 0 s', ja: '新しい動きの 0 秒での値' },
  high: { en: 'new motion at 1 s', ja: '新しい動きの 1 秒での値' },
} satisfies Record<string, Text>;

const fields = {
  time: number(0.5, 0, 1), at: number(0.4, 0.1, 0.6), duration: number(0.3, 0.05, 0.4), low: number(1.6, -2, 3),
  high: number(-0.5, -2, 3),
};
const F = Math.fround;

// Hermite segments of one second, as {value, velocity}.
const old = [0, 0, 2, 4];
const next = ({ low, high }: State) => [low, 0, high, 0];
const motion = (segment: number[], t: number) => N.cubicPoint([0, 0, 0], N.CUBIC_HERMITE, segment, t).slice(0, 2);

/** The straight cross-fade: (1 - w) a + w b, and its rate with that of w. */
function fade(state: State, a: number[], b: number[], t: number): number[] {
  const { at, duration } = state, w = N.saturate(F(F(t - F(at)) / F(duration)));
  const rate = w > 0 && w < 1 ? F(1 / F(duration)) : 0;
  return [N.lerp(a[0], b[0], w), N.weightedSum([1, rate, -rate, 0], N.lerp(a[1], b[1], w), b[0], a[0], 0)];
}

function inertia(state: State, a: number[], b: number[], time: number): number[] {
  const t = F(time - F(state.at)), segment = next(state);
  const begin = N.inertiaBegin([0, 0, 0, 0], motion(old, state.at), motion(segment, state.at), state.duration);
  return t < 0 ? a : N.inertiaEvaluate([0, 0], begin, b, t);
}

function motions(state: State, time: number): number[][] {
  const t = F(time), a = motion(old, t), b = motion(next(state), t);
  return [a, b, fade(state, a, b, t), inertia(state, a, b, t)];
}

const code = (state: State) => program(`
const float t = ${literal(state.time)}, at = ${literal(state.at)}, duration = ${literal(state.duration)};
const float old[4] = ${list(old)}, next[4] = ${list(next(state))};
const nkw_curve_point a = nkw_cubic_point(NKW_CUBIC_HERMITE, old, t), b = nkw_cubic_point(NKW_CUBIC_HERMITE, next, t);
const nkw_curve_point a0 = nkw_cubic_point(NKW_CUBIC_HERMITE, old, at), b0 = nkw_cubic_point(NKW_CUBIC_HERMITE, next, at);
const nkw_motion from = {a0.value, a0.first}, to = {b0.value, b0.first}, now = {b.value, b.first};
const nkw_inertia inertia = nkw_inertia_begin(from, to, duration);
nkw_motion m = {a.value, a.first};
if (t - at >= 0.0f)
    m = nkw_inertia_evaluate(inertia, now, t - at);
const float w = nkw_saturate((t - at) / duration), rate = w > 0.0f && w < 1.0f ? 1.0f / duration : 0.0f;
const nkw_weights weights = {{1.0f, rate, -rate, 0.0f}};
show("from", 0, (double)a.value);
show("from", 1, (double)a.first);
show("to", 0, (double)b.value);
show("to", 1, (double)b.first);
show("fade", 0, (double)nkw_lerp(a.value, b.value, w));
show("fade", 1, (double)nkw_weighted_sum(weights, nkw_lerp(a.first, b.first, w), b.value, a.value, 0.0f));
show("inertia", 0, (double)m.value);
show("inertia", 1, (double)m.velocity);
`);

const names = ['from', 'to', 'fade', 'inertia'] as const;
const colours = ['soft', 'c2', 'c1', 'c0'];

function mount(room: Room<State>) {
  const x = Array.from({ length: 201 }, (_, i) => i / 200);
  const series = names.map((name, i) => ({ label: words[name], colour: colours[i], width: i < 2 ? 1 : 2.5,
    ...(i < 2 ? { dash: [6, 4] } : {}) }));
  const curves = (k: number) => {
    const all = x.map(t => motions(room.state, t));
    return { x, y: names.map((_, i) => all.map(m => m[i][k])) };
  };
  const time = () => room.state.time;
  plot(room, { label: words.value, series, data: () => curves(0), time, handles: () => [
    { label: words.low, x: 0, y: room.state.low, move: (_, y) => room.set({ low: fields.low.read(String(y)) }) },
    { label: words.high, x: 1, y: room.state.high, move: (_, y) => room.set({ high: fields.high.read(String(y)) }) },
  ] });
  plot(room, { label: words.velocity, x: words.seconds, series, data: () => curves(1), time });
  numberTable(room, words.numbers, () => {
    const now = motions(room.state, room.state.time);
    return names.map((name, i) => ({ name, label: words[name], values: now[i] }));
  });
  const made = panel(room, words.change);
  made.slider('at', words.at, 0.1, 0.6, 0.01);
  made.slider('duration', words.duration, 0.05, 0.4, 0.01);
}

export const blend: Exhibit<State> = {
  lead: {
    en: 'Both ways lead from the old motion to the new one. The velocity of the cross-fade jumps at its ends; ' +
      'inertialisation begins with the velocity of the old motion and reduces the difference. Drag the ends of the new motion.',
    ja: 'どちらの方法も、元の動きから新しい動きへ移ります。クロスフェードの速度は両端で跳びますが、慣性化は元の動きの速度から始めて、' +
      '差を減らしていきます。新しい動きの両端をドラッグしてください。',
  },
  fields,
  range: () => ({ start: 0, end: 1 }),
  mount,
  code,
};
