// SPDX-License-Identifier: MIT
// The pole of Euler angles: three gimbals in the six orders, and an object that passes near the pole.
import * as N from 'nakawari/all';
import { list, literal, program } from '../kit/code';
import { colour } from '../kit/colours';
import type { Ray, View } from '../kit/eye';
import { grips, scene, type Grip } from '../kit/grips';
import { numberTable } from '../kit/numbers';
import { panel } from '../kit/panel';
import { dart, line } from '../kit/picture';
import { plot } from '../kit/plot';
import { space, turnFields, type Turn } from '../kit/space';
import { curve, ring } from '../kit/sphere';
import type { Exhibit, Room } from '../shell/exhibit';
import { choice, number } from '../shell/state';

const orders = ['XYZ', 'XZY', 'YXZ', 'YZX', 'ZXY', 'ZYX'] as const;
type Order = typeof orders[number];

interface State extends Turn {
  order: Order;
  by: 'angles' | 'pass';
  x: number; y: number; z: number;
  miss: number;
  time: number;
}

/* ---- the library ---- */

const unit = (i: number) => [0, 1, 2].map(k => k === i ? 1 : 0);
/** The axes of the three gimbals in their own frames, from the outermost. */
const axesOf = (order: Order) => [...order].map(letter => 'XYZ'.indexOf(letter));
const euler = (order: Order) => orders.indexOf(order) as N.EulerOrder;
const radians = (degrees: number[]) => degrees.map(N.radiansFromDegrees);
const degrees = (angles: number[]) => angles.map(N.degreesFromRadians);
const quat = (angles: number[], order: Order) => N.quatFromEuler([0, 0, 0, 0], angles, euler(order));

/** How far the object has turned about the middle axis, in degrees. */
const turnAt = (time: number) => 30 + 60 * time;

/** An orientation of the pass: a turn about the middle axis, after one of `miss` degrees about the outer axis. */
function passing({ order, miss }: State, time: number): number[] {
  const [i, j] = axesOf(order), about = (axis: number, angle: number) =>
    N.quatFromAxisAngle([0, 0, 0, 0], unit(axis), N.radiansFromDegrees(angle));
  return N.quatMul([0, 0, 0, 0], about(j, turnAt(time)), about(i, miss));
}

function poseOf(state: State): { angles: number[]; q: number[] } {
  const { order, by, x, y, z, time } = state;
  if (by === 'pass') {
    const q = passing(state, time);
    return { q, angles: N.eulerFromQuat([0, 0, 0], q, euler(order)) };
  }
  const angles = radians([x, y, z]);
  return { angles, q: quat(angles, order) };
}

/** The frames in which the gimbals are, from the outermost: each one turns by its angle in the frame before it. */
function framesOf(angles: number[], order: Order): number[][] {
  const axes = axesOf(order);
  return [0, 1, 2, 3].map(n => quat(angles.map((angle, axis) => axes.slice(0, n).includes(axis) ? angle : 0), order));
}

/** For each gimbal its axis, and the axis that it carries. */
function gimbalsOf(angles: number[], order: Order) {
  const frames = framesOf(angles, order), axes = axesOf(order);
  const turned = (n: number, axis: number) => N.quatRotate([0, 0, 0], frames[n], unit(axis));
  return axes.map((axis, n) => ({ axis: turned(n, axis), carries: turned(n + 1, axes[(n + 1) % 3]) }));
}

/* ---- the gimbals ---- */

const letters = ['x', 'y', 'z'] as const;
const radii = [1, 0.84, 0.68];

/** The angle about an axis from `from` to where a ray meets its plane, or 0 if that is seen edge on. */
function turnTo({ origin, direction }: Ray, axis: number[], from: number[]): number {
  const slope = N.vec3Dot(direction, axis);
  if (Math.abs(slope) < 0.08)
    return 0;
  const at = N.vec3AddScaled([0, 0, 0], origin, direction, -N.vec3Dot(origin, axis) / slope);
  return N.degreesFromRadians(N.quatTwistAngle(N.quatFromVectors([0, 0, 0, 0], from, at), axis));
}

const wrapped = (angle: number) => +(N.wrap(angle + 180, 360) - 180).toFixed(2);

function gripsOf(room: Room<State>): Grip[] {
  const { angles } = poseOf(room.state), order = axesOf(room.state.order);
  return gimbalsOf(angles, room.state.order).map(({ axis, carries }, n) => {
    const at = N.vec3Scale([0, 0, 0], carries, radii[n]), which = order[n];
    const label = { en: `gimbal about ${'XYZ'[which]}`, ja: `${'XYZ'[which]} 軸まわりのジンバル` };
    const move = (ray: Ray) => {
      const next = degrees(angles);
      next[which] += turnTo(ray, axis, at);
      room.set({ by: 'angles', x: wrapped(next[0]), y: wrapped(next[1]), z: wrapped(next[2]) });
    };
    return { label, mark: 'XYZ'[which], colour: letters[which], at, move };
  });
}

const matrix = (q: number[]) => N.mat4FromMat3(Array<number>(16).fill(0),
  N.mat3FromQuatScale(Array<number>(9).fill(0), q, [0.9, 0.9, 0.9]), [0, 0, 0]);

/** The circle of a gimbal contains its axis and the axis that it carries. */
const circle = (axis: number[], carries: number[], radius: number) => ring((c, s) =>
  N.vec3AddScaled([0, 0, 0], N.vec3Scale([0, 0, 0], axis, radius * c), carries, radius * s));

function gimbals(room: Room<State>) {
  const { host } = scene(room.stage), show = grips(host);
  const paint = (c: CanvasRenderingContext2D, view: View) => {
    const { angles, q } = poseOf(room.state), order = axesOf(room.state.order);
    show(view, gripsOf(room));
    return [dart(c, view, matrix(q)), ...gimbalsOf(angles, room.state.order).flatMap(({ axis, carries }, n) => {
      const style = colour(letters[order[n]]), end = (length: number) => N.vec3Scale([0, 0, 0], axis, length);
      return [...curve(c, view, circle(axis, carries, radii[n]), { style, width: 3, horizon: 0 }),
        ...[1, -1].map(side => line(c, view, end(side * radii[n]), end(side * (radii[n] + 0.16)), style, 6))];
    })];
  };
  space(room, { label: { en: 'An object in three gimbals. Arrow keys turn the camera.',
    ja: '三重のジンバルの中の物体。矢印キーでカメラが回ります。' }, distance: 3.2, parent: host, paint });
}

/* ---- the plot ---- */

const steps = 240;
const times = Array.from({ length: steps + 1 }, (_, i) => (2 * i) / steps);

/** The angles of the pass in degrees, as the library returns them and continued from one to the next. */
function passOf(state: State): number[][] {
  const all = times.flatMap(time => N.eulerFromQuat([0, 0, 0], passing(state, time), euler(state.order)));
  const filtered = Array<number>(all.length).fill(0);
  N.eulerFilter(all, euler(state.order), filtered, times.length);
  return [all, filtered].flatMap(angles =>
    [0, 1, 2].map(axis => times.map((_, i) => N.degreesFromRadians(angles[3 * i + axis]))));
}

function angles(room: Room<State>) {
  const names = { x: 'X', y: 'Y', z: 'Z' };
  plot(room, {
    label: { en: 'Angles while the object passes the pole, degrees', ja: '極のそばを通るときの角度(度)' },
    x: { en: 'time, s', ja: '時刻(秒)' },
    series: [
      ...letters.map(axis => ({ label: names[axis], colour: axis, width: 2 })),
      ...letters.map(axis => ({ label: { en: `${names[axis]}, continued`, ja: `${names[axis]}(連続化)` },
        colour: axis, width: 1.5, dash: [5, 4] })),
    ],
    data: () => ({ x: times, y: passOf(room.state) }),
    time: () => room.state.time,
  });
}

/* ---- numbers ---- */

function tables(room: Room<State>) {
  numberTable(room, { en: 'The gimbals', ja: 'ジンバル' }, () => {
    const { angles, q } = poseOf(room.state), { order } = room.state, [outer, middle, inner] = gimbalsOf(angles, order);
    return [
      { name: 'angles', label: { en: 'angles x y z, °', ja: '角度 x y z(°)' }, values: degrees(angles), digits: 2 },
      { name: 'other', label: { en: 'the other angles, °', ja: 'もう一組の角度(°)' },
        values: degrees(N.eulerAlternate([0, 0, 0], angles, euler(order))), digits: 2 },
      { name: 'outer', label: { en: 'outer axis', ja: '外側の軸' }, values: outer.axis },
      { name: 'middle', label: { en: 'middle axis', ja: '中間の軸' }, values: middle.axis },
      { name: 'inner', label: { en: 'inner axis', ja: '内側の軸' }, values: inner.axis },
      { name: 'between', label: { en: 'outer to inner, °', ja: '外側と内側の軸の角度(°)' },
        values: [N.degreesFromRadians(N.vec3Angle(outer.axis, inner.axis))], digits: 2 },
      { name: 'q', label: 'q', values: q },
    ];
  });
  numberTable(room, { en: 'This orientation in the six orders: x y z, °', ja: 'この向きを六つの順序で表した角度 x y z(°)' },
    () => {
      const { q } = poseOf(room.state);
      return orders.map(order => ({ name: order, label: order, digits: 2,
        values: degrees(N.eulerFromQuat([0, 0, 0], q, euler(order))) }));
    });
}

/* ---- C ---- */

const axisText = (axis: number) => `{${unit(axis).map(literal).join(', ')}}`;

function poseText(state: State): string {
  const { order, by, x, y, z, miss, time } = state, [i, j] = axesOf(order);
  return by === 'pass' ? `
const nkw_vec3 first = ${axisText(i)}, second = ${axisText(j)};
const nkw_quat q = nkw_quat_mul(
    nkw_quat_from_axis_angle(second, nkw_radians_from_degrees(${literal(turnAt(time))})),
    nkw_quat_from_axis_angle(first, nkw_radians_from_degrees(${literal(miss)})));
const nkw_vec3 angles = nkw_euler_from_quat(q, NKW_EULER_${order});` : `
const float given[] = ${list([x, y, z])};
const nkw_vec3 angles = {nkw_radians_from_degrees(given[0]), nkw_radians_from_degrees(given[1]),
                         nkw_radians_from_degrees(given[2])};
const nkw_quat q = nkw_quat_from_euler(angles, NKW_EULER_${order});`;
}

/** The angles of the first n gimbals; the others are 0. */
const partly = (order: Order, n: number) => `{${letters.map((letter, axis) =>
  axesOf(order).slice(0, n).includes(axis) ? `angles.${letter}` : '0.0f').join(', ')}}`;

const code = (state: State) => {
  const { order } = state, axes = axesOf(order);
  return program(`${poseText(state)}
const nkw_vec3 other = nkw_euler_alternate(angles, NKW_EULER_${order});
const nkw_vec3 turned[] = {${[0, 1, 2].map(n => partly(order, n)).join(', ')}};
const nkw_vec3 axes[] = {${axes.map(axisText).join(', ')}};
nkw_vec3 axis[3];
for (int i = 0; i < 3; i++)
    axis[i] = nkw_quat_rotate(nkw_quat_from_euler(turned[i], NKW_EULER_${order}), axes[i]);

const nkw_vec3 sets[] = {angles, other};
const char *const set_names[] = {"angles", "other"};
for (int i = 0; i < 2; i++) {
    show(set_names[i], 0, nkw_degrees_from_radians(sets[i].x));
    show(set_names[i], 1, nkw_degrees_from_radians(sets[i].y));
    show(set_names[i], 2, nkw_degrees_from_radians(sets[i].z));
}
const char *const axis_names[] = {"outer", "middle", "inner"};
for (int i = 0; i < 3; i++) {
    show(axis_names[i], 0, axis[i].x);
    show(axis_names[i], 1, axis[i].y);
    show(axis_names[i], 2, axis[i].z);
}
show("between", 0, nkw_degrees_from_radians(nkw_vec3_angle(axis[0], axis[2])));
show("q", 0, q.x);
show("q", 1, q.y);
show("q", 2, q.z);
show("q", 3, q.w);

const char *const orders[] = {${orders.map(o => `"${o}"`).join(', ')}};
for (int i = 0; i < 6; i++) {
    const nkw_vec3 e = nkw_euler_from_quat(q, (nkw_euler_order)i);
    show(orders[i], 0, nkw_degrees_from_radians(e.x));
    show(orders[i], 1, nkw_degrees_from_radians(e.y));
    show(orders[i], 2, nkw_degrees_from_radians(e.z));
}`);
};

/* ---- the exhibit ---- */

function mount(room: Room<State>) {
  gimbals(room);
  angles(room);
  room.draw(() => {
    if (room.clock.playing && room.state.by !== 'pass')
      room.set({ by: 'pass' });
  });
  const controls = panel(room, { en: 'Gimbals', ja: 'ジンバル' });
  controls.choice('order', { en: 'order, outer to inner', ja: '順序(外側から)' },
    Object.fromEntries(orders.map(order => [order, { en: order, ja: order }])));
  controls.choice('by', { en: 'the object is turned by', ja: '物体の動かし方' }, {
    angles: { en: 'the three angles', ja: '三つの角度' }, pass: { en: 'the pass over time', ja: '時刻に沿った通過' } });
  for (const axis of letters)
    controls.slider(axis, { en: `${axis}, °`, ja: `${axis}(°)` }, -180, 180, 0.5);
  controls.slider('miss', { en: 'the pass misses the pole by, °', ja: '極との最小の角度(°)' }, 0, 30, 0.1);
  tables(room);
}

const angle = (initial: number) => number(initial, -360, 360);

export const pole: Exhibit<State> = {
  lead: {
    en: 'Turn the gimbals by their letters. When the middle angle is ±90°, the outer and the inner axis coincide and ' +
      'only two directions are left. Play: an object that passes near the pole turns evenly, and its angles do not.',
    ja: '文字をドラッグしてジンバルを回してください。中間の角度が ±90° になると外側と内側の軸が重なり、動かせる方向は二つだけになります。' +
      '再生すると、物体は極のそばを一定の速さで通りますが、角度は急に変わります。',
  },
  fields: {
    order: choice<Order>('YXZ', orders), by: choice<State['by']>('angles', ['angles', 'pass']),
    x: angle(60), y: angle(30), z: angle(20), miss: number(2, 0, 30), time: number(0, 0, 2), ...turnFields(25, -20),
  },
  range: () => ({ start: 0, end: 2 }),
  mount,
  code,
};
