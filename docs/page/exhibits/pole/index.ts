// SPDX-License-Identifier: MIT
// The pole of Euler angles: three gimbals in the six orders, and an object that passes near the pole.
import * as N from 'nakawari/all';
import { note } from '../../kit/note';
import { numberTable } from '../../kit/numbers';
import { panel } from '../../kit/panel';
import { plot } from '../../kit/plot';
import { remembered } from '../../kit/samples';
import { scene, turnFields } from '../../kit/space';
import type { Exhibit, Room } from '../../shell/exhibit';
import { choice, number } from '../../shell/state';
import type { Text } from '../../shell/text';
import { code } from './code';
import { gimbals, lost } from './gimbals';
import { degrees, euler, gimbalsOf, hasSpeeds, inOrder, letters, orders, passOf, passSpeed, poseOf, seconds, speedsOf,
  times, withAngles, withMiddle, type Order, type State } from './model';
import { orderBars } from './orders';

/* ---- the plot ---- */

const names = { x: 'X', y: 'Y', z: 'Z' };

function angles(room: Room<State>) {
  const data = remembered(({ order, miss }: Pick<State, 'order' | 'miss'>) =>
    ({ x: times, y: passOf({ ...room.state, order, miss }) }));
  plot(room, {
    label: { en: 'Play: the angles while the object passes the pole (°)', ja: '再生：特異点の近くを通るときの角度（°）' },
    x: { en: 'time (s)', ja: '時刻（秒）' },
    series: [
      ...letters.map(axis => ({ label: { en: `${names[axis]}, continued`, ja: `${names[axis]}（連続化）` },
        colour: axis, width: 1.5, dash: [5, 4] })),
      ...letters.map((axis, i) => ({ label: names[axis], colour: axis, width: [3.5, 4.5, 2][i] })),
    ],
    data: () => data({ order: room.state.order, miss: room.state.miss }),
    time: () => room.state.time,
  });
}

/* ---- numbers ---- */

function gimbalTable(room: Room<State>) {
  numberTable(room, { en: 'The gimbals', ja: 'ジンバル' }, () => {
    const { state } = room, { order } = state, { angles, q } = poseOf(state);
    const [outer, middle, inner] = gimbalsOf(angles, order);
    return [
      { name: 'angles', label: { en: 'angles x y z (°)', ja: '角度 x y z（°）' }, values: degrees(angles), digits: 2 },
      ...hasSpeeds(state) ? [{ name: 'speed', label: { en: 'their speeds (°/s)', ja: '角度の変化の速さ（°/s）' },
        values: speedsOf(state, angles), digits: 2 }] : [],
      { name: 'other', label: { en: 'the other angles (°)', ja: 'もう一組の角度（°）' },
        values: degrees(N.eulerAlternate([0, 0, 0], angles, euler(order))), digits: 2 },
      { name: 'outer', label: { en: 'outer axis', ja: '外側の軸' }, values: outer.axis },
      { name: 'middle', label: { en: 'middle axis', ja: '中間の軸' }, values: middle.axis },
      { name: 'inner', label: { en: 'inner axis', ja: '内側の軸' }, values: inner.axis },
      { name: 'between', label: { en: 'outer to inner (°)', ja: '外側と内側の軸の角度（°）' },
        values: [N.degreesFromRadians(N.vec3Angle(outer.axis, inner.axis))], digits: 2 },
      { name: 'q', label: 'q', values: q },
    ];
  });
}

const orderTable = (room: Room<State>) => numberTable(room,
  { en: 'This orientation in the six orders: x y z and the distance to the pole (°)',
    ja: 'この向きを6つの順序で表した角度 x y z と、特異点までの角度（°）' }, () => {
    const { q } = poseOf(room.state);
    return orders.map(order => {
      const { angles, distance } = inOrder(q, order);
      return { name: order, label: order, digits: 2, values: [...angles, distance] };
    });
  });

/* ---- the exhibit ---- */

const notes = {
  lost: { en: 'The outer and the inner axis coincide, or nearly: no gimbal turns the object about the dashed line.',
    ja: '外側と内側の軸がほぼ重なっています。破線のまわりに物体を回せるジンバルはありません。' },
  pass: { en: `The object turns evenly, ${passSpeed}° in a second. Beside the pole, the outer and the inner gimbal ` +
    'turn by half a turn in a moment.',
    ja: `物体は毎秒 ${passSpeed}° の一定の速さで回ります。特異点の近くでは、外側と内側のジンバルが一瞬で半回転します。` },
  through: { en: 'Through the pole itself, the angles that the Euler filter continues (dashed) change evenly.',
    ja: '特異点そのものを通るとき、オイラーフィルタで連続化した角度（破線）は一様に変わります。' },
};

function noteOf(state: State): Text | string {
  if (state.by === 'pass')
    return state.miss > 0 ? notes.pass : notes.through;
  return inOrder(poseOf(state).q, state.order).distance < lost ? notes.lost : '';
}

/** The pass begins when the time changes; during it the angles of the state are those of the pass. */
function followTime(room: Room<State>) {
  let { time } = room.state;
  room.draw(() => {
    if (room.state.time !== time && room.state.by !== 'pass')
      room.set({ by: 'pass' });
    time = room.state.time;
    const next = withAngles(degrees(poseOf(room.state).angles));
    if (room.state.by === 'pass' && letters.some(axis => next[axis] !== room.state[axis]))
      room.set(next);
  });
}

function controls(room: Room<State>) {
  const box = panel(room, { en: 'Gimbals', ja: 'ジンバル' });
  const turn = (change: Partial<State>) => {
    room.clock.stop();
    room.set({ by: 'angles', ...change });
  };
  box.choice('order', { en: 'order, outer to inner', ja: '順序（外側から）' },
    Object.fromEntries(orders.map(order => [order, { en: order, ja: order }])));
  box.action({ en: 'to the pole', ja: '特異点へ' }, () => turn(withMiddle(room.state, true)));
  box.action({ en: 'away from the pole', ja: '特異点から離す' }, () => turn(withMiddle(room.state, false)));
  box.choice('by', { en: 'the object is turned by', ja: '物体の動かし方' }, {
    angles: { en: 'the three angles', ja: '3つの角度' }, pass: { en: 'the pass over time', ja: '特異点の近くを通る動き' } });
  for (const axis of letters)
    box.slider(axis, { en: `${axis} (°)`, ja: `${axis}（°）` }, -180, 180, 0.5)
      .onChange((value: number) => turn({ [axis]: value }));
  box.slider('miss', { en: 'the pass misses by (°)', ja: '特異点との最小の角度（°）' }, 0, 30, 0.1);
}

function mount(room: Room<State>) {
  const { host, beside } = scene(room.stage);
  gimbals(room, host);
  orderBars(room, beside);
  beside.append(note(room, noteOf));
  followTime(room);
  angles(room);
  controls(room);
  gimbalTable(room);
  orderTable(room);
}

const angle = (initial: number) => number(initial, -360, 360);

export const pole: Exhibit<State> = {
  lead: {
    en: '1. Turn the gimbals by their letters, then press “to the pole”: at a middle angle of ±90° the outer and the ' +
      'inner axis coincide, and a direction is lost. 2. Each order has its own pole: choose one that is far away. ' +
      '3. Play: the object passes a pole evenly, its angles do not.',
    ja: '1. 文字をドラッグしてジンバルを回し、「特異点へ」を押してください。中間の角度が ±90° になると外側と内側の軸が重なり、' +
      '回せない方向が生じます。2. 特異点は順序ごとに異なります。特異点から遠い順序を選んでください。' +
      '3. 再生してください。物体は特異点の近くを一定の速さで通りますが、角度は急に変わります。',
  },
  fields: {
    order: choice<Order>('YXZ', orders), by: choice<State['by']>('angles', ['angles', 'pass']),
    x: angle(60), y: angle(30), z: angle(20), miss: number(2, 0, 30), time: number(0, 0, seconds),
    ...turnFields(-20, 25),
  },
  range: () => ({ start: 0, end: seconds }),
  mount,
  code,
};
