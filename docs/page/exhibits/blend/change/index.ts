// SPDX-License-Identifier: MIT
// A change from one clip to another: by cross-fade, by inertialisation, by dead blending.
import type { Pose } from 'nakawari/all';
import { html } from '../../../kit/html';
import { legend } from '../../../kit/legend';
import { numberTable } from '../../../kit/numbers';
import { panel } from '../../../kit/panel';
import { plot } from '../../../kit/plot';
import { remembered } from '../../../kit/samples';
import type { Room } from '../../../shell/exhibit';
import { say, type Text } from '../../../shell/text';
import { clipControl, jointControls } from '../controls';
import { figures } from '../figures';
import type { Rig } from '../rig';
import { axisNames, limits, type ModeOf, snap, type State, step } from '../state';
import { words } from '../words';
import { changeCode } from './code';
import { end, grid, instants, kinds, numbersOf, timesOf, velocities, walk } from './model';

const own = {
  note: {
    en: 'Drag the points at the start and the end. The velocity of a straight cross-fade jumps there; the others ' +
      'keep it, and need only the new clip.',
    ja: '開始と終了の点をドラッグしてください。重みを直線的に変えるクロスフェードでは、そこで速度が不連続になります。ほかの方法では連続で、開始後に必要なのは新しいクリップだけです。',
  },
  picture: { en: 'The character by each of the three methods', ja: '3つの方法によるキャラクター' },
  old: { en: 'old clip', ja: '元のクリップ' },
  new: { en: 'new clip', ja: '新しいクリップ' },
  fade: { en: 'cross-fade', ja: 'クロスフェード' },
  inertia: { en: 'inertialisation', ja: '慣性化' },
  dead: { en: 'dead blending', ja: 'デッドブレンディング' },
  velocity: { en: 'Angular velocity of the joint about the axis (rad/s, differences over 1/128 s)',
    ja: '関節の軸まわりの角速度（rad/s、1/128 秒ごとの差分）' },
  differences: {
    en: 'All velocities are differences over 1/128 s. So a velocity that is continuous has small jumps here, too: ' +
      'its change within 1/128 s.',
    ja: '速度はすべて 1/128 秒間の差分です。そのため、連続な速度でも、1/128 秒間の変化が小さな不連続として現れます。',
  },
  now: { en: 'Angular velocity now, x y z (rad/s)', ja: '現在の角速度 x y z（rad/s）' },
  jumps: { en: 'Jump of the angular velocity at the start and the end (rad/s)', ja: '開始時と終了時の角速度の不連続な変化（rad/s）' },
  at: { en: 'begins at (s)', ja: '開始時刻（秒）' },
  start: { en: 'new clip from (s)', ja: '新しいクリップの開始位置（秒）' },
  duration: { en: 'duration (s)', ja: '長さ（秒）' },
  coast: { en: 'half-life of the velocity (s)', ja: '速度の半減期（秒）' },
  smooth: { en: 'smooth weight of the cross-fade', ja: 'クロスフェードの重みを滑らかにする' },
} satisfies Record<string, Text>;
const colours = ['soft', 'c2', 'c1', 'c0', 'c4'];

function plotVelocity(room: Room<State>, rig: Rig) {
  const index = (t: number) => Math.round(t / step);
  const data = remembered((state: State) => {
    const k = axisNames.indexOf(state.axis);
    return { x: grid, y: velocities(state, rig).map(curve => curve.map(v => v[k])) };
  });
  plot(room, {
    label: own.velocity, x: words.seconds, time: () => room.state.time, data: () => data(room.state),
    series: legend(room, kinds.map((name, i) => ({ name, label: own[name], colour: colours[i], width: i < 2 ? 1 : 2,
      ...(i < 2 ? { dash: [6, 4] } : {}) })), 'hidden'),
    handles: () => {
      const { at, duration } = timesOf(room.state), last = at + duration, { y } = data(room.state);
      return [
        { label: own.at, x: at, y: y[0][index(at)], move: x => room.set({ at: snap(x, ...limits.at) }) },
        { label: own.duration, x: last, y: y[1][index(last)], small: true,
          move: x => room.set({ duration: snap(x - at, ...limits.duration) }) },
      ];
    },
  });
}

function controls(room: Room<State>, rig: Rig) {
  const made = panel(room, words.change);
  clipControl(made, 'from', own.old);
  clipControl(made, 'to', own.new);
  made.slider('at', own.at, ...limits.at, step);
  made.slider('duration', own.duration, ...limits.duration, step);
  made.slider('start', own.start, ...limits.start, step);
  made.slider('coast', own.coast, 0, 1, 0.005);
  made.check('smooth', own.smooth);
  jointControls(made, rig);
}

function mount(room: Room<State>, rig: Rig) {
  room.stage.append(html('p', say(own.note), { class: 'note' }));
  figures(room, rig, own.picture, 3, () => {
    const { times, here } = instants(room.state);
    let now: Pose[] = [];
    walk(room.state, rig, times.slice(0, here[1] + 1), poses => { now = poses; });
    return [2, 3, 4].map(k => ({ pose: now[k], colour: colours[k], label: own[kinds[k]] }));
  });
  plotVelocity(room, rig);
  let shown: ReturnType<typeof numbersOf>;
  room.draw(() => { shown = numbersOf(room.state, rig); });
  const rows = (name: 'jumps' | 'now', prefix: string) => kinds.map((kind, k) =>
    ({ name: `${prefix}_${kind}`, label: own[kind], values: shown[name][k] }));
  numberTable(room, own.jumps, () => rows('jumps', 'jump').filter((_, k) => k !== 1));
  room.side.append(html('p', say(own.differences), { class: 'note' }));
  numberTable(room, own.now, () => rows('now', 'velocity'));
  controls(room, rig);
}

export const change: ModeOf = { mount, end: () => end, code: changeCode };
