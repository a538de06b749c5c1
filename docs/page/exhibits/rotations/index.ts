// SPDX-License-Identifier: MIT
// Two rotations: the ways from one to the other, on one object, on the sphere, and their angular velocities.
import * as N from 'nakawari/all';
import { choosing, thick } from '../../kit/chosen';
import { legend } from '../../kit/legend';
import { note } from '../../kit/note';
import { numberTable } from '../../kit/numbers';
import { panel } from '../../kit/panel';
import { plot } from '../../kit/plot';
import { scene, turnFields } from '../../kit/space';
import type { Exhibit, Room } from '../../shell/exhibit';
import { choice, flag, number, some, whole } from '../../shell/state';
import { code } from './code';
import { colours, curvesOf, isWrongWay, keysOf, names, seconds, speed, words, type CurvesOf, type Method,
  type State } from './model';
import { sphere } from './sphere';

const opposite = {
  en: 'A·B is negative: q and −q are one rotation, but on the way from A to B the signs count. The pale object takes ' +
    'them as given, and turns the long way.',
  ja: 'A·B が負です。q と −q は同じ回転ですが、A から B への経路は符号によって変わります。' +
    '淡い色の物体は符号を調整せずに補間しており、長い弧を通ります。',
};

function numbersOf(state: State, curvesAt: CurvesOf) {
  const { keys, curves } = curvesAt(state), t = Math.fround(state.time / seconds);
  const all = names.map(m => curves[m].at(t)), slerp = all[names.indexOf('slerp')].q;
  return { keys, mine: all[names.indexOf(state.method)],
    rows: all.map(motion => [speed(motion), N.degreesFromRadians(N.quatAngle(motion.q, slerp))]) };
}

function tables(room: Room<State>, curves: CurvesOf) {
  let now: ReturnType<typeof numbersOf>;
  room.draw(() => { now = numbersOf(room.state, curves); });
  numberTable(room, { en: 'Angular velocity: its length (°/s), and the angle from slerp (°)',
    ja: '角速度の大きさ（°/s）と、slerp との角度の差（°）' },
    () => now.rows.map((values, i) =>
      ({ name: names[i], label: words[names[i]], values, digits: 2 })));
  numberTable(room, { en: 'Keys and object: quaternions x y z w', ja: 'キーと物体の四元数（x y z w）' }, () => {
    const { keys: { a, b }, mine: { q, w } } = now;
    return [
      { name: 'a', label: 'A', values: a }, { name: 'b', label: 'B', values: b },
      { name: 'q', label: 'q', values: q }, { name: 'w', label: { en: 'ω (rad/s)', ja: 'ω（rad/s）' }, values: w },
      { name: 'dot', label: 'A·B', values: [N.quatDot(a, b)] },
      { name: 'arc', label: { en: 'short arc (°)', ja: '短い弧（°）' },
        values: [N.degreesFromRadians(N.quatAngle(a, b))], digits: 2 },
    ];
  });
}

function controls(room: Room<State>) {
  const box = panel(room, { en: 'From A to B', ja: 'A から B へ' });
  box.choice('method', { en: 'the object turns by', ja: '物体の補間方法' }, words)
    .onChange((method: Method) => room.set(choosing(method, room.state)));
  box.check('flip', { en: 'B with the other sign, −B', ja: 'B の符号を反転（−B）' });
  box.slider('turns', { en: 'k, whole turns', ja: 'k（追加の回転数）' }, -3, 3, 1)
    .onChange((turns: number) => room.set({ turns, hidden: room.state.hidden.filter(m => m !== 'turns') }));
  const axes = { y: { en: 'yaw', ja: 'ヨー' }, x: { en: 'pitch', ja: 'ピッチ' }, z: { en: 'roll', ja: 'ロール' } };
  for (const key of ['a', 'b'] as const)
    for (const axis of ['y', 'x', 'z'] as const)
      box.slider(`${key}${axis}`, { en: `${key.toUpperCase()}: ${axes[axis].en} (°)`,
        ja: `${key.toUpperCase()}：${axes[axis].ja}（°）` }, -180, 180, 0.5);
}

function mount(room: Room<State>) {
  const curves = curvesOf(), { host, beside } = scene(room.stage);
  const shown = legend(room, names.map(name => ({ name, label: words[name], colour: colours[name], width: 2,
    dash: name === 'given' ? [6, 6] : undefined })), 'hidden');
  beside.append(shown.element, note(room, state => isWrongWay(keysOf(state)) ? opposite : ''));
  sphere(room, curves, host);
  const made = plot(room, {
    label: { en: 'Length of the angular velocity ω at each time (°/s, logarithmic axis)',
      ja: '各時刻の角速度 ω の大きさ（°/s、対数目盛）' },
    x: { en: 'time (s)', ja: '時刻（秒）' },
    series: shown, log: true,
    data: () => curves(room.state).data,
    time: () => room.state.time,
  });
  thick(room, made, 2, () => names.indexOf(room.state.method));
  controls(room);
  tables(room, curves);
}

const angle = (initial: number) => number(initial, -360, 360);

export const rotations: Exhibit<State> = {
  lead: {
    en: '1. Play, and choose nlerp: it stays on the arc of slerp, but is slower at both ends. Euler angles leave the ' +
      'arc. 2. Drag A and B: the farther apart, the greater the differences. 3. Change the sign of B: the ' +
      'rotation is the same, but a method that takes the signs as given now turns the long way (pale object).',
    ja: '1. nlerp を選んで再生してください。slerp と同じ弧を通りますが、両端で遅くなります。オイラー角の補間は弧から外れます。' +
      '2. A と B をドラッグしてください。離れているほど違いが大きくなります。' +
      '3. B の符号を反転してください。回転は同じですが、符号を調整しない方法は長い弧を通ります（淡い色の物体）。',
  },
  fields: {
    method: choice<Method>('slerp', names), turns: whole(1, -3, 3), flip: flag(false),
    ax: angle(-15), ay: angle(-55), az: angle(50), bx: angle(15), by: angle(70), bz: angle(-70),
    hidden: some(['turns'], names), time: number(0.6, 0, seconds), ...turnFields(180, 25),
  },
  range: () => ({ start: 0, end: seconds }),
  mount,
  code,
};
