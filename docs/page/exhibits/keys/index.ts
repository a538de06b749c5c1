// SPDX-License-Identifier: MIT
// One curve through keys that can be dragged, by all methods; value, velocity and acceleration.
import { button, element, html } from '../../kit/html';
import { legend, type Legend } from '../../kit/legend';
import { numberTable, type Row } from '../../kit/numbers';
import { panel } from '../../kit/panel';
import { plot } from '../../kit/plot';
import { remembered, samples } from '../../kit/samples';
import type { Exhibit, Room, Shortcut } from '../../shell/exhibit';
import { say } from '../../shell/text';
import { curve, fields, joint, keysOf, methods, tangentsOf, velocities, words, type State } from './curves';
import { add, handles, remove } from './edit';
import { code } from './program';

const texts = {
  value: { en: 'value', ja: '値' },
  velocity: { en: 'velocity, per second', ja: '速度（毎秒）' },
  acceleration: { en: 'acceleration, per second²', ja: '加速度（毎秒²）' },
  time: { en: 'time (s)', ja: '時刻（秒）' },
  chosen: { en: 'chosen method', ja: '選んだ方法' },
  other: { en: 'its tangents, read the other way', ja: '同じ接線をもう一方の尺度で読んだ曲線' },
  trap: {
    en: 'The scaling trap: read per segment, a tangent is divided by the duration of each segment, so one tangent ' +
      'becomes two velocities wherever the durations differ.',
    ja: '尺度の取り違え：1区間あたりと読むと、接線は前後の区間の長さでそれぞれ割られるため、' +
      '区間の長さが異なるキーでは、1つの接線が2つの速度になります。',
  },
};

/* ---- the plots ---- */

const palette = ['c0', 'c1', 'c3', 'c4', 'c5', 'c6', 'c7'];
const series = [
  ...methods.map((name, i) => (
    { name, label: words[name], colour: palette[i % 7], width: 1, dash: i < 7 ? undefined : [4, 2] })),
  { name: 'other', label: texts.other, colour: 'x', width: 2, dash: [7, 4] },
  { name: 'chosen', label: texts.chosen, colour: 'ink', width: 2.5 },
];

/** Value, velocity and acceleration of all curves, each for a plot. */
function sampled(state: State) {
  const s = keysOf(state), other = s.scale === 'second' ? 'segment' : 'second', gap = [NaN, NaN, NaN];
  const f = [...methods.map(m => curve(s, m)),
    tangentsOf(s) ? curve(s, s.method, other) : () => gap, curve(s, s.method)];
  const { x, y } = samples(time => f.flatMap(one => one(time)), s.times[0], s.times[s.times.length - 1]);
  return [0, 1, 2].map(i => ({ x, y: f.map((_, k) => y[3 * k + i]) }));
}

function plots(room: Room<State>, curves: Legend) {
  const data = remembered(sampled), lines = () => keysOf(room.state).times;
  const domain = (): [number, number] => {
    const times = lines(), [start, end] = [times[0], times[times.length - 1]], margin = (end - start) / 20;
    return [start - margin, end + margin];
  };
  [texts.value, texts.velocity, texts.acceleration].forEach((label, i) => plot(room, {
    label, series: curves, x: i === 2 ? texts.time : undefined, share: i ? 1 : 1.4, domain, lines,
    data: () => data(room.state)[i],
    time: () => room.state.time,
    ...(i ? {} : { handles: () => handles(room), add: (x, y) => add(room, x, y) }),
  }));
}

/* ---- numbers ---- */

/** The rows of key k. */
function trapRows({ k, ...state }: State & { k: number }): Row[] {
  const s = keysOf(state), tangents = tangentsOf(s);
  const times = Float32Array.from(s.times), duration = (i: number) => Math.fround(times[i + 1] - times[i]);
  const row = (name: string, en: string, ja: string, values: number[]) =>
    ({ name, label: { en, ja }, values, digits: 3 });
  const before = row('duration', 'duration of the segment, s', '区間の長さ（秒）', [duration(k - 1), duration(k)]);
  return !tangents ? [before, row('velocity', 'velocity', '速度', velocities(s, k, 'second'))] : [
    before,
    row('tangent', 'tangent', '接線', [tangents.before[k], tangents.after[k]].map(Math.fround)),
    row('second', 'velocity, read per second', '速度（1秒あたりと読む）', velocities(s, k, 'second')),
    row('segment', 'velocity, read per segment', '速度（1区間あたりと読む）', velocities(s, k, 'segment'))];
}

function trapTable(room: Room<State>) {
  const rows = remembered(trapRows), at = () => joint(keysOf(room.state));
  const table = numberTable(room, { en: 'Key', ja: 'キー' }, () => {
    const k = at();
    return k === undefined ? [] : rows({ ...room.state, k });
  });
  const note = html('p', say(texts.trap), { class: 'note' });
  room.side.append(note);
  room.draw(() => {
    const k = at();
    table.caption!.textContent = say({ en: `Key ${k}: before and after it`, ja: `キー ${k} の前と後` });
    table.hidden = k === undefined;
    note.hidden = k === undefined || !tangentsOf(keysOf(room.state));
  });
}

function keyRows(state: State): Row[] {
  const s = keysOf(state), tangents = tangentsOf(s);
  return s.times.map((t, k) => ({ name: `key${k}`, label: String(k), digits: 3,
    values: Float32Array.from([t, s.values[k], ...(tangents ? [tangents.before[k], tangents.after[k]] : [])]) }));
}

function tables(room: Room<State>, curves: Legend) {
  const at = remembered((state: State) => methods.map(m => curve(keysOf(state), m)));
  numberTable(room, { en: 'Value, velocity, acceleration at the time', ja: '現在時刻の値・速度・加速度' },
    () => methods.map((name, i) => (
      { name, label: curves.entries[i], values: at(room.state)[i](Math.fround(room.state.time)), digits: 3 })));
  numberTable(room, { en: 'Keys: time, value, tangents before and after', ja: 'キー：時刻、値、前後の接線' },
    () => keyRows(room.state));
}

/* ---- controls ---- */

function tools(room: Room<State>) {
  const show = (hidden: State['hidden']) => room.set({ hidden });
  const list: Shortcut[] = [
    { key: 'a', does: { en: 'adds a key at the time', ja: '現在時刻にキーを追加' }, run: () => add(room, room.state.time) },
    { key: 'd', does: { en: 'deletes the key nearest to the time', ja: '現在時刻に最も近いキーを削除' },
      run: () => remove(room) },
  ];
  room.shortcuts(list);
  room.side.append(element('div', { class: 'tools' }, [
    button(say({ en: 'Add a key', ja: 'キーを追加' }), list[0].run),
    button(say({ en: 'Delete a key', ja: 'キーを削除' }), list[1].run),
    button(say({ en: 'Show all', ja: 'すべて表示' }), () => show([])),
    button(say({ en: 'Hide all', ja: 'すべて隠す' }), () => show([...methods]))]));
}

function mount(room: Room<State>) {
  const curves = legend(room, series, 'hidden'), controls = panel(room, { en: 'Curve', ja: '曲線' });
  controls.choice('method', texts.chosen, words);
  controls.choice('scale', { en: 'tangents are read', ja: '接線の尺度' }, {
    second: { en: 'per second', ja: '1秒あたり' }, segment: { en: 'per segment', ja: '1区間あたり' } });
  const sliders = [controls.slider('tension', { en: 'tension', ja: 'テンション' }, -1, 1, 0.05),
    controls.slider('continuity', { en: 'continuity', ja: '連続性' }, -1, 1, 0.05),
    controls.slider('bias', { en: 'bias', ja: 'バイアス' }, -1, 1, 0.05)];
  const used = { cardinal: 1, tcb: 3 } as Partial<Record<State['method'], number>>;
  room.draw(() => sliders.forEach((slider, i) => slider.show(i < (used[room.state.method] ?? 0))));
  trapTable(room);
  tools(room);
  tables(room, curves);
  plots(room, curves);
}

export const keys: Exhibit<State> = {
  lead: {
    en: 'Drag the keys, and the small dots, which are tangents. Double-click or double-tap the plot to add a key. ' +
      'The durations differ: read the tangents per segment instead of per second, and the velocity jumps at each key.',
    ja: 'キーと、接線を表す小さな点をドラッグしてください。グラフを2回続けて押すと、キーを追加できます。' +
      'キーの間隔は等しくないため、接線を1秒あたりではなく1区間あたりと読むと、速度が各キーで不連続になります。',
  },
  fields,
  range: state => {
    const { times } = keysOf(state);
    return { start: times[0], end: times[times.length - 1] };
  },
  mount,
  code,
};
