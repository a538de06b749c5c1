// SPDX-License-Identifier: MIT
// Many rotations: five curves through or near the same keys, and the corners in their angular velocity.
import * as N from 'nakawari/all';
import { choosing, thick } from '../../kit/chosen';
import { element } from '../../kit/html';
import { legend, type Legend } from '../../kit/legend';
import { note } from '../../kit/note';
import { numberTable } from '../../kit/numbers';
import { panel } from '../../kit/panel';
import { plot } from '../../kit/plot';
import { scene, turnFields } from '../../kit/space';
import type { Exhibit, Room } from '../../shell/exhibit';
import { choice, number, numbers, some } from '../../shell/state';
import { say } from '../../shell/text';
import { code } from './code';
import { fields } from './fields';
import { ascending, colours, count, curvesOf, degrees, names, shownOf, usesOmega, velocity, withTime, words,
  type Curves, type Method, type State } from './model';
import { sphere } from './sphere';

/* ---- the plot ---- */

const axes = ['x', 'y', 'z'];
const parts = axes.map(axis => ({ label: `ω${axis}`, colour: axis, width: 2 }));

/** The lengths of ω of all methods, or the components of one. */
function dataOf(curves: Curves) {
  let kept: { x: number[]; y: number[][] }, before: unknown, of: Method;
  return (state: State) => {
    const all = curves.of(state);
    if (all !== before || of !== state.method)
      kept = { x: all.x, y: [...all.lengths, ...axes.map((_, i) =>
        all.motions[state.method].map(motion => degrees(velocity(motion)[i])))] };
    [before, of] = [all, state.method];
    return kept;
  };
}

/** The angular velocity on both sides of each inner key where it jumps. */
function marks(state: State, curves: Curves) {
  const { corners } = curves.of(state), components = state.plot === 'components';
  return (components ? [state.method] : shownOf(state)).flatMap(m => corners[m].filter(({ jump }) => jump > 0.5)
    .flatMap(({ k, before, after }) => [before, after].flatMap(w => (components ? axes : [colours[m]]).map(
      (colour, i) => ({ x: state.times[k], y: degrees(components ? w[i] : N.vec3Length(w)), colour })))));
}

function extent(rows: number[][]): [number, number] {
  const all = rows.flat(), least = Math.min(...all, 0), most = Math.max(...all, 1), span = most - least;
  return [least - 0.25 * span, most + 0.1 * span];
}

function speeds(room: Room<State>, curves: Curves, methods: Legend) {
  const data = dataOf(curves), components = () => room.state.plot === 'components';
  const range = () => extent(data(room.state).y.filter((_, i) => shows(i)));
  const shows = (i: number) => i < names.length ? !components() && methods.shows(i) : components();
  let held: [number, number] = [0, 1];
  const made = plot(room, {
    label: { en: 'Angular velocity ω: its length or its components (°/s)', ja: '角速度 ω の大きさまたは成分（°/s）' },
    x: { en: 'time (s)', ja: '時刻（秒）' },
    series: { ...methods, series: [...methods.series, ...parts], shows },
    data: () => data(room.state),
    range,
    time: () => room.state.time,
    lines: () => room.state.times,
    marks: () => marks(room.state, curves),
    handles: () => {
      held = made.over.querySelector('[data-held]') ? held : range();
      return room.state.times.map((time, k) => ({ label: { en: `time of key ${k}`, ja: `キー ${k} の時刻` },
        text: String(k), x: time, y: held[0] + 0.09 * (held[1] - held[0]),
        move: (x: number) => room.set(withTime(room.state, k, x) ?? {}) }));
    },
  });
  thick(room, made, 2, () => names.indexOf(room.state.method));
}

/* ---- numbers ---- */

function tables(room: Room<State>, curves: Curves) {
  numberTable(room, { en: 'Jump of ω at the keys 1, 2, 3 (°/s)', ja: 'キー 1、2、3 での ω の不連続量（°/s）' }, () =>
    names.map(m => ({ name: `${m}_key`, label: words[m], digits: 2,
      values: curves.of(room.state).corners[m].map(({ jump }) => jump) })));
  numberTable(room, { en: 'ω now: x y z (rad/s) and its length (°/s)', ja: '現在の ω：x y z（rad/s）と大きさ（°/s）' }, () =>
    names.map(m => {
      const w = velocity(curves.of(room.state).at(m, room.state.time));
      return { name: m, label: words[m], values: [...w, degrees(N.vec3Length(w))], digits: 2 };
    }));
}

/* ---- the exhibit ---- */

const notes = {
  omega: { en: 'Arrows: where the nose goes at the ω of its key, the longer the faster. Drag their tips.',
    ja: '矢印：キーの ω で機首が進む向きです。速いほど長くなります。矢印の先をドラッグできます。' },
  circles: { en: 'Circles in the plot: ω before and after a key where it jumps.',
    ja: 'グラフの丸印：ω が不連続なキーの直前と直後の値です。' },
};

function mount(room: Room<State>) {
  const curves = curvesOf(), { host, beside } = scene(room.stage, 2);
  room.closed(curves.dispose);
  const series = names.map(name => ({ name, label: words[name], colour: colours[name], width: 2 }));
  const methods = legend(room, series, 'hidden');
  const components = element('p', { class: 'note' }, parts.flatMap(({ label, colour }) =>
    [element('span', { style: `color: var(--${colour})` }, '━'), ` ${label} `]));
  beside.append(methods.element, components, element('p', { class: 'note' }, say(notes.circles)),
    note(room, state => usesOmega(state.method) ? notes.omega : ''));
  room.draw(() => { components.hidden = room.state.plot !== 'components'; });
  sphere(room, curves, host);
  speeds(room, curves, methods);
  const controls = panel(room, { en: 'Curves through five keys', ja: '5つのキーを結ぶ曲線' });
  controls.choice('method', { en: 'the object turns by', ja: '物体の補間方法' }, words)
    .onChange((method: Method) => room.set(choosing(method, room.state)));
  controls.choice('plot', { en: 'the plot shows', ja: 'グラフの内容' }, {
    length: { en: 'the length of ω', ja: 'ω の大きさ' },
    components: { en: 'its components', ja: 'ω の成分' } });
  controls.action({ en: 'ω of the keys by Catmull-Rom', ja: 'キーの ω を Catmull-Rom に戻す' },
    () => room.set({ omega: [] }));
  fields(room, curves);
  tables(room, curves);
}

const triples = (list: number[]) => list.length === 3 * count;

export const splines: Exhibit<State> = {
  lead: {
    en: '1. Choose slerp and play: at each key its angular velocity ω jumps. Where the direction of ω changes and ' +
      'not its length, only the components show it. 2. Drag the time of key 2 in the plot: squad and the B-spline, ' +
      'smooth for evenly spaced keys, now jump too. 3. Choose Hermite, and drag an arrow: ω of a key is yours.',
    ja: '1. slerp を選んで再生してください。各キーで角速度 ω が不連続になります。大きさが同じで向きだけが変わるときは、' +
      '成分を見ないとわかりません。2. グラフでキー 2 の時刻をドラッグしてください。' +
      'キーが等間隔なら滑らかな squad と B スプラインも不連続になります。' +
      '3. Hermite を選び、矢印をドラッグしてください。キーの ω を自由に決められます。',
  },
  fields: {
    method: choice<Method>('hermite', names), time: number(0.5, 0, 20), times: numbers([0, 1, 2, 3, 4], ascending),
    keys: numbers([-10, -70, 0, 45, -35, 40, -25, 0, -20, 40, 35, 60, 0, 80, 0], triples),
    omega: numbers([], list => list.length === 0 || triples(list)),
    plot: choice<State['plot']>('length', ['length', 'components']), hidden: some([], names),
    ...turnFields(180, -12),
  },
  range: ({ times }) => ({ start: times[0], end: times[count - 1] }),
  mount,
  code,
};
