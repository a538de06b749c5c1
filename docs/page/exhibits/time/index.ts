// SPDX-License-Identifier: MIT
// A Bezier segment whose handles have a time and a value; a handle that runs back, under the policies.
import * as N from 'nakawari/all';
import { colour } from '../../kit/colours';
import { legend, type Legend } from '../../kit/legend';
import { note } from '../../kit/note';
import { numberTable, type Row } from '../../kit/numbers';
import { panel } from '../../kit/panel';
import { plot } from '../../kit/plot';
import type { Handle } from '../../kit/points';
import { remembered, samples } from '../../kit/samples';
import { clamp } from '../../kit/values';
import type { Exhibit, Room } from '../../shell/exhibit';
import type { Text } from '../../shell/text';
import { code } from './program';
import { back, fields, given, halves, limited, meanings, names, pointOf, policies, third, words,
  type State } from './segment';

const texts = {
  value: { en: 'value over time', ja: '時刻に対する値' },
  parameter: { en: 'parameter s over time', ja: '時刻に対するパラメータ s' },
  time: { en: 'time (s)', ja: '時刻（秒）' },
  chosen: { en: 'chosen policy', ja: '選んだポリシー' },
  given: { en: 'given handles, by s', ja: '元のハンドルの曲線（s による）' },
};

/* ---- handles ---- */

// How far keys and the tips of handles can be dragged, for both axes.
const far = 4, shortest = 0.1;

function handles(room: Room<State>): Handle[] {
  const [t0, v0, ot, ov, it, iv, t1, v1] = room.state.segment, now = () => room.state.segment;
  const change = (from: number, a: number, b: number) => {
    const segment = now().map((old, i) => i === from ? a : i === from + 1 ? clamp(b, -far, far) : old);
    room.set({ segment, time: clamp(room.state.time, segment[0], segment[6]) });
  };
  const handle = (en: string, ja: string, x: number, y: number, move: Handle['move'], small = false) =>
    ({ label: { en, ja }, x, y, move, small });
  return [
    handle('first key', '始点のキー', t0, v0, (t, v) => change(0, clamp(t, -far, now()[6] - shortest), v)),
    handle('last key', '終点のキー', t1, v1, (t, v) => change(6, clamp(t, now()[0] + shortest, far), v)),
    handle('handle of the first key', '始点のハンドル', t0 + ot, v0 + ov,
      (t, v) => change(2, clamp(t - now()[0], 0, far), v - now()[1]), true),
    handle('handle of the last key', '終点のハンドル', t1 + it, v1 + iv,
      (t, v) => change(4, clamp(t - now()[6], -far, 0), v - now()[7]), true),
  ];
}

/* ---- plots ---- */

type Plot = ReturnType<typeof plot>;

function polyline(u: Plot, points: number[][], style: string, dash: number[] = []) {
  const { ctx } = u, ratio = devicePixelRatio;
  ctx.save();
  ctx.strokeStyle = colour(style);
  ctx.lineWidth = 1.5 * ratio;
  ctx.setLineDash(dash.map(d => d * ratio));
  ctx.beginPath();
  points.forEach(([a, b]) => ctx.lineTo(u.valToPos(a, 'x', true), u.valToPos(b, 'y', true)));
  ctx.stroke();
  ctx.restore();
}

/** The ends of the handles of a segment, each after its key. */
const sticks = ([t0, v0, ot, ov, it, iv, t1, v1]: Float32Array | number[]) =>
  [[[t0, v0], [t0 + ot, v0 + ov]], [[t1, v1], [t1 + it, v1 + iv]]];

/** Values and parameters over time, for all policies and the chosen one. */
function sampled(s: State) {
  const segments = [...policies, s.policy].map(policy => limited(s, policy));
  const { x, y } = samples(time => segments.flatMap(segment => {
    const [value, , parameter] = pointOf(segment, time);
    return [value, parameter];
  }), s.segment[0], s.segment[6]);
  const gap = x.map(() => NaN), row = (which: number) => ({ x, y: [gap, ...segments.map((_, i) => y[2 * i + which])] });
  return { values: row(0), parameters: row(1) };
}

const dashes = [5, 4];
const series = [
  { name: 'given', label: texts.given, colour: 'soft', dash: dashes },
  ...policies.map((name, i) => ({ name, label: words[name], colour: ['c1', 'c0', 'c3', 'c5'][i], width: 1.5 })),
  { name: 'chosen', label: texts.chosen, colour: 'ink', width: 2.5 },
];

/** The range of x has the tips of all handles. */
function domain({ segment: [t0, , ot, , it, , t1] }: State): [number, number] {
  const all = [t0, t0 + ot, t1 + it, t1], least = Math.min(...all), most = Math.max(...all);
  const margin = (most - least) / 20;
  return [least - margin, most + margin];
}

function plots(room: Room<State>, curves: Legend) {
  const data = remembered(sampled);
  const common = { series: curves, domain: () => domain(room.state), time: () => room.state.time };
  const marks = () => room.state.split
    ? halves(room.state).flatMap(half => sticks(half).flat().map(([x, y]) => ({ x, y, colour: 'y' }))) : [];
  const values = plot(room, { ...common, label: texts.value, share: 3, marks, data: () => data(room.state).values,
    handles: () => handles(room) });
  const parameters = plot(room, { ...common, label: texts.parameter, x: texts.time, range: () => [-0.06, 1.06],
    data: () => data(room.state).parameters });
  values.hooks.drawAxes!.push(u => {
    if (curves.shows(0))
      polyline(u, given(room.state), 'soft', dashes);
    sticks(room.state.segment).forEach(stick => polyline(u, stick, 'soft'));
    sticks(limited(room.state)).forEach(stick => polyline(u, stick, 'ink'));
  });
  values.hooks.draw!.push(u => {
    if (room.state.split)
      halves(room.state).flatMap(sticks).forEach(stick => polyline(u, stick, 'y'));
  });
  parameters.hooks.drawAxes!.push(u => {
    if (curves.shows(0))
      polyline(u, given(room.state).map(([t, , s]) => [t, s]), 'soft', dashes);
  });
}

/* ---- numbers ---- */

const points = (s: State, curves: Legend): Row[] => policies.map((name, i) => (
  { name, label: curves.entries[i + 1], values: pointOf(limited(s, name), Math.fround(s.time)), digits: 3 }));
const lengths = (s: State): Row[] => [
  { name: 'runs_back', digits: 0, values: [N.handleRunsBack(s.segment)],
    label: { en: 'given: runs back (1)', ja: '元のハンドル：逆行する（1）' } },
  ...policies.map(p => (
    { name: `${p}_handles`, label: names[p], values: limited(s, p).slice(2, 6), digits: 3 }))];

function halfRows(s: State): Row[] {
  const [left, right] = halves(s);
  const row = (name: string, label: Text, values: Float32Array) => ({ name, label, values, digits: 3 });
  return [row('key', { en: 'new key: time, value', ja: '新しいキーの時刻・値' }, right.slice(0, 2)),
    row('left', { en: 'before it: handles', ja: '前の区間のハンドル' }, left.slice(2, 6)),
    row('right', { en: 'after it: handles', ja: '後の区間のハンドル' }, right.slice(2, 6))];
}

function tables(room: Room<State>, curves: Legend) {
  numberTable(room, { en: 'Value, velocity, s at the time', ja: '現在時刻の値・速度・s' },
    () => points(room.state, curves));
  numberTable(room, { en: 'Handles: out time, value; in time, value', ja: 'ハンドル：始点の時間・値、終点の時間・値' },
    () => lengths(room.state));
  const split = numberTable(room, { en: 'The split: the curve stays, the handles change',
    ja: '分割：曲線は変わらず、ハンドルが変わります' }, () => room.state.split ? halfRows(room.state) : []);
  room.draw(() => { split.hidden = !room.state.split; });
}

function mount(room: Room<State>) {
  const curves = legend(room, series, 'hidden'), controls = panel(room, { en: 'Segment', ja: '区間' });
  const split = () => room.set({ split: !room.state.split });
  controls.choice('policy', texts.chosen, words);
  controls.check('split', { en: 'split at the time', ja: '現在時刻で分割' });
  controls.action({ en: 'A handle that runs back', ja: '逆行するハンドル' }, () => room.set({ segment: back }));
  controls.action({ en: 'Handles of a third: s = time', ja: '長さ 1/3 のハンドル：s = 時刻' },
    () => room.set({ segment: third }));
  room.shortcuts([{ key: 's', does: { en: 'splits at the time', ja: '現在時刻で分割' }, run: split }]);
  room.side.append(note(room, state => meanings[state.policy]));
  tables(room, curves);
  plots(room, curves);
}

export const time: Exhibit<State> = {
  lead: {
    en: 'Handles have a time and a value, so the time itself is a cubic of s. Drag the small dots: pull a handle far ' +
      'enough and the curve runs back, with three values at one time. Each tool answers by a policy of its own.',
    ja: 'ハンドルは時間と値を持つので、時刻そのものが s の3次式になります。小さな点をドラッグしてハンドルを長く引くと、' +
      '曲線は時間を逆行し、1つの時刻に値が3つ生じます。どう扱うかのポリシーは、ツールごとに異なります。',
  },
  fields,
  range: ({ segment }) => ({ start: segment[0], end: segment[6] }),
  mount,
  code,
};
