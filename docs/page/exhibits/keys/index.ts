// SPDX-License-Identifier: MIT
// Exhibit 2: one curve through keys that can be dragged, by all methods; value, velocity and acceleration.
import { numberTable, type Row } from '../../kit/numbers';
import { panel } from '../../kit/panel';
import { legend, plot, type Handle } from '../../kit/plot';
import type { Exhibit, Room } from '../../shell/exhibit';
import { curve, fields, methods, tangentsOf, words, type State } from './curves';
import { code } from './program';

const texts = {
  value: { en: 'value', ja: '値' },
  velocity: { en: 'velocity, per second', ja: '速度(毎秒)' },
  acceleration: { en: 'acceleration, per second²', ja: '加速度(毎秒²)' },
  time: { en: 'time, s', ja: '時刻(秒)' },
  chosen: { en: 'chosen method', ja: '選んだ方式' },
  other: { en: 'the same tangents, read the other way', ja: '同じ接線をもう一方の尺度で読んだ曲線' },
};
const steps = 240;

/* ---- samples ---- */

type Sampled = { x: number[]; y: number[][] }[];

/** For value, velocity and acceleration the rows of all methods, of the other scale, and of the chosen method. */
function sample(s: State): Sampled {
  const start = s.times[0], step = (s.times[s.times.length - 1] - start) / steps;
  const x = Array.from({ length: steps + 1 }, (_, i) => start + i * step);
  const none = () => [NaN, NaN, NaN], other = s.scale === 'second' ? 'segment' : 'second';
  const f = [...methods.map(m => s.all ? curve(s, m) : none),
    tangentsOf(s, s.method) ? curve(s, s.method, other) : none, curve(s, s.method)];
  const points = f.map(one => x.map(one));
  return [0, 1, 2].map(i => ({ x, y: points.map(row => row.map(p => p[i])) }));
}

/** Samples again only if something else than the time has changed. */
function memory(): (s: State) => Sampled {
  let before = '', kept: Sampled;
  return s => {
    const now = JSON.stringify({ ...s, time: 0 });
    if (now !== before)
      kept = sample(s);
    before = now;
    return kept;
  };
}

/* ---- handles ---- */

const arm = 0.2;
const replaced = (list: ArrayLike<number>, k: number, x: number) => Array.from(list, (old, i) => i === k ? x : old);

function keyHandle(room: Room<State>, k: number): Handle {
  const { times, values } = room.state;
  return {
    label: { en: `key ${k}`, ja: `キー ${k}` }, x: times[k], y: values[k],
    move(x, y) {
      const now = room.state, least = (now.times[k - 1] ?? -0.1) + 0.1, most = (now.times[k + 1] ?? 8.1) - 0.1;
      room.set({ times: replaced(now.times, k, Math.min(Math.max(x, least), most)),
        values: replaced(now.values, k, y) });
    },
  };
}

/** A drag of a tangent makes the present tangents the reader's own. That of the last key points back. */
function tangentHandle(room: Room<State>, k: number): Handle {
  const { state } = room, last = k === state.times.length - 1, side = last ? -1 : 1;
  const shown = (s: State) => tangentsOf(s, s.method)?.[last ? 'before' : 'after'] ?? s.tangents;
  return {
    label: { en: `tangent of key ${k}`, ja: `キー ${k} の接線` }, small: true,
    x: state.times[k] + side * arm, y: state.values[k] + side * arm * shown(state)[k],
    move(x, y) {
      const now = room.state, along = x - now.times[k];
      if (side * along > 0.02)
        room.set({ method: 'own', tangents: replaced(shown(now), k, (y - now.values[k]) / along) });
    },
  };
}

const handles = (room: Room<State>) => [keyHandle, tangentHandle].flatMap(make =>
  room.state.times.map((_, k) => make(room, k)));

/* ---- plots and numbers ---- */

const palette = ['c0', 'c1', 'c3', 'c4', 'c5', 'c6', 'c7'];
const series = [
  ...methods.map((m, i) => ({ label: words[m], colour: palette[i % 7], width: 1, dash: i < 7 ? undefined : [4, 2] })),
  { label: texts.other, colour: 'x', width: 2, dash: [7, 4] },
  { label: texts.chosen, colour: 'ink', width: 2.5 },
];

function plots(room: Room<State>) {
  const sampled = memory(), curves = legend(room, series);
  [texts.value, texts.velocity, texts.acceleration].forEach((label, i) => plot(room, {
    label, series: curves, x: i === 2 ? texts.time : undefined, share: i ? 1 : 2,
    data: () => sampled(room.state)[i],
    time: () => room.state.time,
    handles: i === 0 ? () => handles(room) : undefined,
  }));
}

const rows = (s: State): Row[] =>
  methods.map(m => ({ name: m, label: words[m], values: curve(s, m)(Math.fround(s.time)), digits: 3 }));

function keyRows(s: State): Row[] {
  const tangents = tangentsOf(s, s.method);
  return tangents ? [
    { name: 'before', label: { en: 'before', ja: '前' }, values: Float32Array.from(tangents.before), digits: 3 },
    { name: 'after', label: { en: 'after', ja: '後' }, values: Float32Array.from(tangents.after), digits: 3 },
  ] : [];
}

function mount(room: Room<State>) {
  plots(room);
  const controls = panel(room, { en: 'Curve', ja: '曲線' });
  controls.choice('method', texts.chosen, words);
  controls.choice('scale', { en: 'tangents are read', ja: '接線の尺度' }, {
    second: { en: 'per second', ja: '1秒当たり' }, segment: { en: 'per segment', ja: '1区間当たり' } });
  controls.check('all', { en: 'all methods', ja: 'すべての方式' });
  controls.slider('tension', { en: 'tension', ja: 'テンション' }, -1, 1, 0.05);
  controls.slider('continuity', { en: 'continuity', ja: '連続性' }, -1, 1, 0.05);
  controls.slider('bias', { en: 'bias', ja: 'バイアス' }, -1, 1, 0.05);
  numberTable(room, { en: 'Value, velocity, acceleration at the time', ja: '現在時刻の値・速度・加速度' },
    () => rows(room.state));
  numberTable(room, { en: 'Tangents at keys 0 to 4, chosen method', ja: 'キー0〜4の接線(選んだ方式)' },
    () => keyRows(room.state));
}

export const keys: Exhibit<State> = {
  lead: {
    en: 'Drag the keys and the small dots, which are tangents. The durations differ: read the tangents per segment ' +
      'instead of per second, and the velocity jumps at each key although its tangent is one number.',
    ja: 'キーと、接線を表す小さな点をドラッグしてください。キーの間隔は等しくありません。接線を1秒当たりではなく' +
      '1区間当たりと読むと、接線の数値はキーの前後で同じでも、速度はキーで不連続になります。',
  },
  fields,
  range: ({ times }) => ({ start: times[0], end: times[times.length - 1] }),
  mount,
  code,
};
