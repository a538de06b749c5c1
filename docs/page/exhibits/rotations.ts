// SPDX-License-Identifier: MIT
// Two rotations: the ways from one to the other, on one object, on the sphere, and their angular speeds.
import * as N from 'nakawari/all';
import { list, literal, program } from '../kit/code';
import { colour } from '../kit/colours';
import type { Ray, View } from '../kit/eye';
import { gripHost, grips, onSphere } from '../kit/grips';
import { numberTable } from '../kit/numbers';
import { panel } from '../kit/panel';
import { dart, dot, line } from '../kit/picture';
import { plot } from '../kit/plot';
import { space, turnFields, type Turn } from '../kit/space';
import { curve, globe } from '../kit/sphere';
import { whole } from '../kit/whole';
import type { Exhibit, Room } from '../shell/exhibit';
import { choice, flag, number } from '../shell/state';

const names = ['euler', 'nlerp', 'slerp', 'long', 'turns', 'given'] as const;
type Method = typeof names[number];

interface State extends Turn {
  method: Method;
  turns: number;
  flip: boolean;
  ax: number; ay: number; az: number;
  bx: number; by: number; bz: number;
  time: number;
}

const words = {
  euler: { en: 'Euler angles', ja: 'オイラー角' },
  nlerp: { en: 'nlerp', ja: 'nlerp(正規化線形補間)' },
  slerp: { en: 'slerp', ja: 'slerp(球面線形補間)' },
  long: { en: 'slerp, long arc', ja: 'slerp(長い弧)' },
  turns: { en: 'slerp, k more turns', ja: 'slerp(k 回転を追加)' },
  given: { en: 'slerp, signs as given', ja: 'slerp(符号を調整しない)' },
};
const colours: Record<Method, string> = { euler: 'c1', nlerp: 'c4', slerp: 'c0', long: 'c3', turns: 'c5', given: 'c6' };

/* ---- the library ---- */

const seconds = 2, step = 1 / 64, order = N.EULER_YXZ;

function keysOf({ ax, ay, az, bx, by, bz, flip }: State) {
  const angles = [[ax, ay, az], [bx, by, bz]].map(degrees => degrees.map(N.radiansFromDegrees));
  const [a, b] = angles.map(e => N.quatFromEuler([0, 0, 0, 0], e, order));
  return { angles, a, b: flip ? N.quatNegate([0, 0, 0, 0], b) : b };
}
type Keys = ReturnType<typeof keysOf>;

function orientation({ angles, a, b }: Keys, method: Method, turns: number, t: number): number[] {
  const out = [0, 0, 0, 0];
  switch (method) {
    case 'euler': return N.quatFromEuler(out, N.eulerLerp([0, 0, 0], angles[0], angles[1], t, N.UNWRAP_NONE), order);
    case 'nlerp': return N.quatNlerp(out, a, b, t);
    case 'slerp': return N.quatSlerp(out, a, b, t);
    case 'long': return N.quatSlerpPath(out, a, b, t, N.PATH_LONG, 0);
    case 'turns': return N.quatSlerpPath(out, a, b, t, N.PATH_SHORT, turns);
    case 'given': return N.quatSlerpPath(out, a, b, t, N.PATH_AS_GIVEN, 0);
  }
}

/** Degrees per second between two orientations. */
const speed = (before: number[], after: number[], duration: number) =>
  N.degreesFromRadians(N.vec3Length(N.quatAngularVelocity([0, 0, 0], before, after, duration)));

const nose = (q: number[]) => N.quatRotate([0, 0, 0], q, [0, 0, -1]);

/** The curves of a method: the nose on the sphere, and the angular speed in the middle of each step. */
function sampled(keys: Keys, method: Method, turns: number) {
  const all = Array.from({ length: 97 }, (_, i) => orientation(keys, method, turns, i / 96));
  return { points: all.map(nose), speeds: all.slice(1).map((q, i) => speed(all[i], q, seconds / 96)) };
}
type Curves = Record<Method, ReturnType<typeof sampled>>;

function curvesOf() {
  let made = '', curves: Curves;
  return (state: State) => {
    const keys = keysOf(state), next = JSON.stringify([keys, state.turns]);
    if (next !== made)
      curves = Object.fromEntries(names.map(m => [m, sampled(keys, m, state.turns)])) as Curves;
    made = next;
    return curves;
  };
}

/* ---- the sphere ---- */

// The key `name` turned by the shortest rotation that brings its nose to p.
function turned(state: State, name: 'a' | 'b', p: number[]): Partial<State> {
  const q = keysOf(state)[name], turn = N.quatFromVectors([0, 0, 0, 0], nose(q), p);
  const angles = N.eulerFromQuat([0, 0, 0], N.quatMul([0, 0, 0, 0], turn, q), order).map(N.degreesFromRadians);
  return Object.fromEntries(['x', 'y', 'z'].map((axis, i) => [name + axis, +angles[i].toFixed(2)])) as Partial<State>;
}

const matrix = (q: number[]) => N.mat4FromMat3(Array<number>(16).fill(0),
  N.mat3FromQuatScale(Array<number>(9).fill(0), q, [1.6, 1.6, 1.6]), [0, 0, 0]);

function sphere(room: Room<State>, curves: (state: State) => Curves) {
  const host = gripHost();
  const show = grips(host);
  room.stage.append(host);
  const paint = (c: CanvasRenderingContext2D, view: View) => {
    const { state } = room, { method, turns, time } = state, keys = keysOf(state), all = curves(state);
    const now = names.map(m => orientation(keys, m, turns, time / seconds)), mine = now[names.indexOf(method)];
    const grip = (name: 'a' | 'b', label: string) => ({
      label: { en: `${label}: the nose of the key`, ja: `${label}: キーの先端` }, mark: label, colour: 'ink',
      at: nose(keys[name]),
      move: (ray: Ray) => room.set(turned(room.state, name, onSphere(ray, nose(keys[name])))),
    });
    show(view, [grip('a', 'A'), grip('b', 'B')]);
    globe(c, view);
    return [
      dart(c, view, matrix(mine)), line(c, view, [0, 0, 0], nose(mine), colour('ink'), 1.5),
      ...names.flatMap(m => curve(c, view, all[m].points, colour(colours[m]), m === method ? 3.5 : 1.5)),
      ...names.map((m, i) => dot(c, view, nose(now[i]), colour(colours[m]))),
    ];
  };
  space(room, { label: { en: 'The object, and the curves of its nose on the sphere. Arrow keys turn the camera.',
    ja: '物体と、その先端が球面上に描く曲線。矢印キーでカメラが回ります。' }, distance: 2.9, parent: host, paint });
}

/* ---- numbers ---- */

function numbersOf(state: State) {
  const keys = keysOf(state), t = Math.fround(state.time / seconds);
  const at = (method: Method) => [t - step, t, t + step].map(x => orientation(keys, method, state.turns, x));
  const slerp = at('slerp')[1];
  return { keys, q: at(state.method)[1], rows: names.map(m => {
    const [before, now, after] = at(m);
    return [speed(before, after, 2 * step * seconds), N.degreesFromRadians(N.quatAngle(now, slerp))];
  }) };
}

function tables(room: Room<State>) {
  numberTable(room, { en: 'Keys (x y z w), and the orientation of the object', ja: 'キー(x y z w)と物体の向き' }, () => {
    const { keys: { a, b }, q } = numbersOf(room.state);
    return [
      { name: 'a', label: 'A', values: a }, { name: 'b', label: 'B', values: b },
      { name: 'q', label: 'q', values: q },
      { name: 'dot', label: 'A·B', values: [N.quatDot(a, b)] },
      { name: 'arc', label: { en: 'short arc, °', ja: '短い弧(°)' },
        values: [N.degreesFromRadians(N.quatAngle(a, b))], digits: 2 },
    ];
  });
  numberTable(room, { en: 'Angular speed, °/s, and angle from slerp, °',
    ja: '角速度の大きさ(°/s)と、slerp との角度の差(°)' },
    () => numbersOf(room.state).rows.map((values, i) => ({ name: names[i], label: words[names[i]], values, digits: 2 })));
}

/* ---- C ---- */

const code = (state: State) => {
  const { ax, ay, az, bx, by, bz, flip, turns, method, time } = state;
  return program(`
const float a_degrees[] = ${list([ax, ay, az])}, b_degrees[] = ${list([bx, by, bz])};
const float t = ${literal(time / seconds)}, step = ${literal(step)}, at[] = {t - step, t, t + step};
float ea[3], eb[3];
for (int i = 0; i < 3; i++) {
    ea[i] = nkw_radians_from_degrees(a_degrees[i]);
    eb[i] = nkw_radians_from_degrees(b_degrees[i]);
}
const nkw_vec3 a_angles = {ea[0], ea[1], ea[2]}, b_angles = {eb[0], eb[1], eb[2]};
const nkw_quat a = nkw_quat_from_euler(a_angles, NKW_EULER_YXZ);
const nkw_quat b = ${flip ? 'nkw_quat_negate(' : ''}nkw_quat_from_euler(b_angles, NKW_EULER_YXZ)${flip ? ')' : ''};

enum {${names.map(m => m.toUpperCase()).join(', ')}, METHODS};
const char *const names[] = {${names.map(m => `"${m}"`).join(', ')}};
nkw_quat q[METHODS][3];
for (int i = 0; i < 3; i++) {
    const nkw_vec3 angles = nkw_euler_lerp(a_angles, b_angles, at[i], NKW_UNWRAP_NONE);
    q[EULER][i] = nkw_quat_from_euler(angles, NKW_EULER_YXZ);
    q[NLERP][i] = nkw_quat_nlerp(a, b, at[i]);
    q[SLERP][i] = nkw_quat_slerp(a, b, at[i]);
    q[LONG][i] = nkw_quat_slerp_path(a, b, at[i], NKW_PATH_LONG, 0);
    q[TURNS][i] = nkw_quat_slerp_path(a, b, at[i], NKW_PATH_SHORT, ${turns});
    q[GIVEN][i] = nkw_quat_slerp_path(a, b, at[i], NKW_PATH_AS_GIVEN, 0);
}

const nkw_quat keys[] = {a, b, q[${method.toUpperCase()}][1]};
const char *const key_names[] = {"a", "b", "q"};
for (int i = 0; i < 3; i++) {
    show(key_names[i], 0, keys[i].x);
    show(key_names[i], 1, keys[i].y);
    show(key_names[i], 2, keys[i].z);
    show(key_names[i], 3, keys[i].w);
}
show("dot", 0, nkw_quat_dot(a, b));
show("arc", 0, nkw_degrees_from_radians(nkw_quat_angle(a, b)));
for (int m = 0; m < METHODS; m++) {
    const nkw_vec3 w = nkw_quat_angular_velocity(q[m][0], q[m][2], ${literal(2 * step * seconds)});
    show(names[m], 0, nkw_degrees_from_radians(nkw_vec3_length(w)));
    show(names[m], 1, nkw_degrees_from_radians(nkw_quat_angle(q[m][1], q[SLERP][1])));
}`);
};

/* ---- the exhibit ---- */

function mount(room: Room<State>) {
  const curves = curvesOf();
  sphere(room, curves);
  plot(room, {
    label: { en: 'Angular speed, degrees per second', ja: '角速度の大きさ(度/秒)' },
    x: { en: 'time, s', ja: '時刻(秒)' },
    series: names.map(m => ({ label: words[m], colour: colours[m], width: 2 })),
    data: () => ({ x: Array.from({ length: 96 }, (_, i) => (i + 0.5) * seconds / 96),
      y: names.map(m => curves(room.state)[m].speeds) }),
    time: () => room.state.time,
  });
  const controls = panel(room, { en: 'From A to B', ja: 'A から B へ' });
  controls.choice('method', { en: 'the object turns by', ja: '物体の補間方法' }, words);
  controls.slider('turns', { en: 'k, whole turns', ja: 'k(追加の回転数)' }, -3, 3, 1);
  controls.check('flip', { en: 'B with the other sign, −B', ja: 'B の符号を反転(−B)' });
  const axes = { y: { en: 'yaw', ja: 'ヨー' }, x: { en: 'pitch', ja: 'ピッチ' }, z: { en: 'roll', ja: 'ロール' } };
  for (const key of ['a', 'b'] as const)
    for (const axis of ['y', 'x', 'z'] as const)
      controls.slider(`${key}${axis}`, { en: `${key.toUpperCase()}: ${axes[axis].en}, °`,
        ja: `${key.toUpperCase()}: ${axes[axis].ja}(°)` }, -180, 180, 0.5);
  tables(room);
}

const angle = (initial: number) => number(initial, -360, 360);

export const rotations: Exhibit<State> = {
  lead: {
    en: 'Drag the two noses on the sphere. nlerp follows the arc of slerp at another speed; Euler angles (yaw, pitch, ' +
      'roll) leave the arc. Change the sign of B: the rotation is the same, and only the method that takes the signs ' +
      'as given goes the other way.',
    ja: '球面上の二つの先端をドラッグしてください。nlerp は slerp と同じ弧を異なる速さで進み、' +
      'オイラー角(ヨー、ピッチ、ロール)の補間は弧から外れます。B の符号を反転しても回転は同じですが、符号を調整しない方法だけは反対側の弧を通ります。',
  },
  fields: {
    method: choice<Method>('slerp', names), turns: whole(1, -3, 3), flip: flag(false),
    ax: angle(65), ay: angle(-70), az: angle(0), bx: angle(40), by: angle(80), bz: angle(-60),
    time: number(0, 0, seconds), ...turnFields(25, -20),
  },
  range: () => ({ start: 0, end: seconds }),
  mount,
  code,
};
