// SPDX-License-Identifier: MIT
// Exhibit 3: a Bezier segment whose handles have a time and a value; a handle that runs back, under the policies.
import * as N from 'nakawari/all';
import { list, literal, program } from '../kit/code';
import { colour } from '../kit/colours';
import { numberTable, type Row } from '../kit/numbers';
import { panel } from '../kit/panel';
import { legend, plot, type Handle } from '../kit/plot';
import type { Exhibit, Room } from '../shell/exhibit';
import { choice, number, numbers } from '../shell/state';
import type { Text } from '../shell/text';

/** In the order of nkw_handle_policy. */
const policies = ['none', 'contain', 'ratio', 'start'] as const;
type Policy = typeof policies[number];
const words: Record<Policy, Text> = {
  none: { en: 'none (CSS, Unity)', ja: '制限なし(CSS、Unity)' },
  contain: { en: 'contain (Blender)', ja: '区間内に収める(Blender)' },
  ratio: { en: 'keep the ratio (OpenUSD)', ja: '長さの比を保つ(OpenUSD)' },
  start: { en: 'keep the start (Maya)', ja: '始点側を優先(Maya)' },
};
const texts = {
  value: { en: 'value over time; drag the tips of the handles', ja: '時刻に対する値(ハンドルの先端をドラッグ)' },
  parameter: { en: 'parameter s over time', ja: '時刻に対するパラメータ s' },
  time: { en: 'time, s', ja: '時刻(秒)' },
  chosen: { en: 'chosen policy', ja: '選んだ方針' },
  given: { en: 'dashed: the given handles, by s', ja: '破線:元のハンドルの曲線(s による)' },
};

/** The segment as nkw_handle_segment: time0, value0, out.time, out.value, in.time, in.value, time1, value1. */
interface State { segment: number[]; policy: Policy; time: number }
const back = [0, 0, 1.75, 0.35, -1.05, 0.1, 1, 1], third = [0, 0, 1 / 3, 0, -1 / 3, 0, 1, 1];
const fields = {
  segment: numbers(back, l => l.length === 8 && l[6] > l[0]),
  policy: choice<Policy>('none', policies), time: number(0.4),
};

const limited = (s: State, policy: Policy): Float32Array =>
  N.handleLimit(new Float32Array(8), s.segment, policies.indexOf(policy));

/** Value and velocity at a time, and the parameter. */
function pointOf(segment: ArrayLike<number>, time: number): number[] {
  const [value, first] = N.handlePoint(new Float32Array(3), segment, time);
  return [value, first, N.handleParameter(segment, time)];
}

/* ---- drawing ---- */

// The range of both axes of the first plot.
const least = -0.5, most = 2, low = -0.5, high = 1.5;
const x = Array.from({ length: 501 }, (_, i) => least + (i * (most - least)) / 500);

/** Value (0) or parameter (2) over time, for all policies and the chosen one. */
function curves(s: State, which: 0 | 2): number[][] {
  return [...policies, s.policy].map(policy => {
    const segment = limited(s, policy);
    return x.map(t => t >= s.segment[0] && t <= s.segment[6] ? pointOf(segment, t)[which] : NaN);
  });
}

/** The points of the given segment by its parameter: time, value, s. */
function given([t0, v0, ot, ov, it, iv, t1, v1]: ArrayLike<number> & Iterable<number>): number[][] {
  return Array.from({ length: 101 }, (_, i) => [N.bezier(t0, t0 + ot, t1 + it, t1, i / 100),
    N.bezier(v0, v0 + ov, v1 + iv, v1, i / 100), i / 100]);
}

type Plot = ReturnType<typeof plot>;

function polyline(u: Plot, points: number[][], style: string, dash: number[]) {
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

/** The handles of a segment as lines from its keys. */
function sticks(u: Plot, [t0, v0, ot, ov, it, iv, t1, v1]: Float32Array | number[], style: string) {
  polyline(u, [[t0, v0], [t0 + ot, v0 + ov]], style, []);
  polyline(u, [[t1, v1], [t1 + it, v1 + iv]], style, []);
}

const clamp = (value: number, from: number, to: number) => Math.min(Math.max(value, from), to);

function handles(room: Room<State>): Handle[] {
  const change = (from: number, a: number, b: number) => room.set({ segment: room.state.segment.map((old, i) =>
    i === from ? a : i === from + 1 ? b : old) });
  const [t0, v0, ot, ov, it, iv, t1, v1] = room.state.segment;
  const now = () => room.state.segment, within = (t: number) => clamp(t, least, most);
  return [
    { label: { en: 'first key', ja: '始点のキー' }, x: t0, y: v0,
      move: (t, v) => change(0, clamp(t, least, now()[6] - 0.1), clamp(v, low, high)) },
    { label: { en: 'last key', ja: '終点のキー' }, x: t1, y: v1,
      move: (t, v) => change(6, clamp(t, now()[0] + 0.1, most), clamp(v, low, high)) },
    { label: { en: 'handle of the first key', ja: '始点のハンドル' }, x: t0 + ot, y: v0 + ov, small: true,
      move: (t, v) => change(2, Math.max(within(t) - now()[0], 0), clamp(v, low, high) - now()[1]) },
    { label: { en: 'handle of the last key', ja: '終点のハンドル' }, x: t1 + it, y: v1 + iv, small: true,
      move: (t, v) => change(4, Math.min(within(t) - now()[6], 0), clamp(v, low, high) - now()[7]) },
  ];
}

const series = [
  ...policies.map((p, i) => ({ label: words[p], colour: ['c1', 'c0', 'c3', 'c5'][i], width: 1.5 })),
  { label: texts.chosen, colour: 'ink', width: 2.5 },
  { label: texts.given, colour: 'soft' },
];

function plots(room: Room<State>) {
  const none = x.map(() => NaN), shared = legend(room, series);
  const rows = (which: 0 | 2) => ({ x, y: [...curves(room.state, which), none] });
  const values = plot(room, { label: texts.value, series: shared, share: 3, data: () => rows(0), range: () => [low, high],
    time: () => room.state.time, handles: () => handles(room) });
  const parameters = plot(room, { label: texts.parameter, series: shared, x: texts.time, data: () => rows(2),
    range: () => [-0.1, 1.1], time: () => room.state.time });
  values.hooks.draw!.push(u => {
    polyline(u, given(room.state.segment), 'soft', [5, 4]);
    sticks(u, room.state.segment, 'soft');
    sticks(u, limited(room.state, room.state.policy), 'ink');
  });
  parameters.hooks.draw!.push(u => polyline(u, given(room.state.segment).map(([t, , s]) => [t, s]), 'soft', [5, 4]));
}

/* ---- numbers ---- */

const points = (s: State): Row[] => policies.map(p => (
  { name: p, label: words[p], values: pointOf(limited(s, p), Math.fround(s.time)), digits: 3 }));
const lengths = (s: State): Row[] => policies.map(p => (
  { name: `${p}_handles`, label: words[p], values: limited(s, p).slice(2, 6), digits: 3 }));
const regression = (s: State): Row[] => [{ name: 'runs_back', digits: 0, values: [N.handleRunsBack(s.segment)],
  label: { en: 'runs back (1) or not (0)', ja: '逆行する(1)/しない(0)' } }];

const code = (s: State) => program(`
static const char *const names[] = {"none", "contain", "ratio", "start"};
static const char *const handles[] = {"none_handles", "contain_handles", "ratio_handles", "start_handles"};
const float given[8] = ${list(s.segment)}, time = ${literal(s.time)};
const nkw_handle_segment segment = {given[0], given[1], {given[2], given[3]}, {given[4], given[5]}, given[6], given[7]};
for (int i = 0; i < 4; i++) {
    const nkw_handle_segment limited = nkw_handle_limit(&segment, (nkw_handle_policy)i);
    const nkw_curve_point point = nkw_handle_point(&limited, time);
    const float shown[3] = {point.value, point.first, nkw_handle_parameter(&limited, time)};
    const float lengths[4] = {limited.out.time, limited.out.value, limited.in.time, limited.in.value};
    show_floats(names[i], 3, shown);
    show_floats(handles[i], 4, lengths);
}
show("runs_back", 0, nkw_handle_runs_back(&segment));`);

function mount(room: Room<State>) {
  plots(room);
  const controls = panel(room, { en: 'Segment', ja: '区間' });
  controls.choice('policy', texts.chosen, words);
  controls.action({ en: 'A handle that runs back', ja: '逆行するハンドル' }, () => room.set({ segment: back }));
  controls.action({ en: 'Handles of a third: s = time', ja: '長さ 1/3 のハンドル:s = 時刻' },
    () => room.set({ segment: third }));
  numberTable(room, { en: 'The given handles', ja: '元のハンドル' }, () => regression(room.state));
  numberTable(room, { en: 'Value, velocity, s at the time', ja: '現在時刻の値・速度・s' }, () => points(room.state));
  numberTable(room, { en: 'Handles: out time, value; in time, value', ja: 'ハンドル:始点の時間・値、終点の時間・値' },
    () => lengths(room.state));
}

export const time: Exhibit<State> = {
  lead: {
    en: 'Handles have a time and a value, so the time itself is a cubic of s. Pull a handle far enough and the curve ' +
      'runs back: it has three values at one time. Each tool answers by a policy of its own.',
    ja: 'ハンドルは時間と値を持つので、時刻そのものが s の3次式になります。ハンドルを長く引くと曲線は時間を逆行し、' +
      '一つの時刻に値が三つ生じます。どう扱うかの方針は、ツールごとに異なります。',
  },
  fields,
  range: ({ segment }) => ({ start: segment[0], end: segment[6] }),
  mount,
  code,
};
