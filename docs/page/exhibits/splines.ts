// SPDX-License-Identifier: MIT
// Many rotations: five curves through or near the same keys, and the corners in their angular velocity.
import * as N from 'nakawari/all';
import { list, literal, program } from '../kit/code';
import { colour } from '../kit/colours';
import type { Ray, View } from '../kit/eye';
import { gripHost, grips, onSphere } from '../kit/grips';
import { numberTable } from '../kit/numbers';
import { panel } from '../kit/panel';
import { dart, dot } from '../kit/picture';
import { plot } from '../kit/plot';
import { space, turnFields, type Turn } from '../kit/space';
import { curve, globe } from '../kit/sphere';
import type { Exhibit, Room } from '../shell/exhibit';
import { choice, number, numbers } from '../shell/state';

const names = ['slerp', 'squad', 'gltf', 'hermite', 'bspline'] as const;
type Method = typeof names[number];

interface State extends Turn {
  method: Method;
  /** Angles x y z of each key in degrees, in the order YXZ. */
  keys: number[];
  /** The time of the middle key. */
  middle: number;
  time: number;
}

const words = {
  slerp: { en: 'slerp', ja: 'slerp(球面線形補間)' },
  squad: { en: 'squad', ja: 'squad' },
  gltf: { en: 'glTF cubic', ja: 'glTF の CUBICSPLINE' },
  hermite: { en: 'Hermite with ω', ja: 'ω を使う Hermite 補間' },
  bspline: { en: 'B-spline', ja: 'B スプライン' },
};
const colours: Record<Method, string> = { slerp: 'c1', squad: 'c4', gltf: 'c3', hermite: 'c0', bspline: 'c2' };

/* ---- the library ---- */

const count = 5, mid = 2;
const timesOf = (state: State) => [0, 1, state.middle, 3, 4];
const zeros = (n: number) => Array<number>(n).fill(0);

/** The keys, each with the sign nearer to the one before it. */
function keysOf({ keys }: State): number[][] {
  const made: number[][] = [];
  for (let k = 0; k < count; k++) {
    const angles = keys.slice(3 * k, 3 * k + 3).map(N.radiansFromDegrees);
    const q = N.quatFromEuler(zeros(4), angles, N.EULER_YXZ);
    made.push(k > 0 && N.quatDot(made[k - 1], q) < 0 ? N.quatNegate(zeros(4), q) : q);
  }
  return made;
}

const around = (k: number) => [Math.max(k - 1, 0), k, k + 1, Math.min(k + 2, count - 1)];

function segmentOf(method: Exclude<Method, 'gltf'>, keys: number[][], times: number[], k: number): N.RotationSegment {
  const four = around(k).map(i => keys[i]), duration = Math.fround(Math.fround(times[k + 1]) - Math.fround(times[k]));
  switch (method) {
    case 'slerp': return N.rotationSlerp({}, keys[k], keys[k + 1], N.PATH_SHORT, 0, duration);
    case 'squad': return N.rotationSquad({}, four, duration);
    case 'hermite': return N.rotationCatmullRom({}, four, around(k).map(i => times[i]));
    case 'bspline': return N.rotationBspline({}, four, duration);
  }
}

/** The first n keys as a CUBICSPLINE track: its tangents are those of the angular velocities of the Hermite curve. */
function trackOf(keys: number[][], times: number[], n: number): N.Track {
  const values = keys.slice(0, n).flatMap((q, k) => {
    const { velocity } = segmentOf('hermite', keys, times, Math.min(k, count - 2));
    const w = Array.from(velocity).slice(k < count - 1 ? 0 : 3);
    const tangent = N.quatScale(zeros(4), N.quatMul(zeros(4), [w[0], w[1], w[2], 0], q), 0.5);
    return [...tangent, ...q, ...tangent];
  });
  return new N.Track({ times: times.slice(0, n), values, width: 4, kind: N.TRACK_ROTATION,
    interpolation: N.INTERPOLATION_CUBICSPLINE });
}

/** Orientation x y z w and angular velocity x y z. */
type Motion = number[];

/** The motion of each method at a time, and before and after the middle key. */
function curvesAt(state: State) {
  const keys = keysOf(state), times = timesOf(state), track = trackOf(keys, times, count);
  const sampled = (from: N.Track, time: number): Motion => {
    const out = new Float32Array(10);
    N.trackSampleRotation(from, time, out);
    return Array.from(out);
  };
  const segments = Object.fromEntries(names.filter(m => m !== 'gltf').map(m =>
    [m, [0, 1, 2, 3].map(k => segmentOf(m, keys, times, k))]));
  const at = (method: Method, time: number): Motion => {
    if (method === 'gltf')
      return sampled(track, time);
    const { index, t } = N.segmentFind({}, times, count, time), k = Math.min(index, count - 2);
    return N.rotationEvaluate(zeros(10), segments[method][k], index > k ? 1 : t);
  };
  const sides = (method: Method): Motion[] => {
    if (method !== 'gltf')
      return [0, 1].map(side => N.rotationEvaluate(zeros(10), segments[method][mid - 1 + side], 1 - side));
    const first = trackOf(keys, times, mid + 1), both = [sampled(first, times[mid]), sampled(track, times[mid])];
    first.dispose();
    return both;
  };
  return { keys, times, at, sides, dispose: () => track.dispose() };
}

const velocity = (motion: Motion) => motion.slice(4, 7);
const degrees = (x: number) => N.degreesFromRadians(x);
const nose = (q: number[]) => N.quatRotate(zeros(3), q.slice(0, 4), [0, 0, -1]);

/* ---- what is drawn ---- */

const steps = 160;
const abscissae = Array.from({ length: steps + 1 }, (_, i) => (4 * i) / steps);

// The curves of the present keys, made again when these change.
function memory(room: Room<State>) {
  let made = '', curves: ReturnType<typeof curvesAt> | undefined;
  let lines: Record<Method, { points: number[][]; speeds: number[] }>;
  room.closed(() => curves?.dispose());
  return () => {
    const { keys, middle } = room.state, next = JSON.stringify([keys, middle]);
    if (next !== made) {
      curves?.dispose();
      const { at } = curves = curvesAt(room.state);
      lines = Object.fromEntries(names.map(m => {
        const all = abscissae.map(time => at(m, time));
        return [m, { points: all.map(nose), speeds: all.map(s => degrees(N.vec3Length(velocity(s)))) }];
      })) as typeof lines;
      made = next;
    }
    return { ...curves!, lines };
  };
}
type Memory = ReturnType<typeof memory>;

// Key k turned by the shortest rotation that brings its nose to p.
function turned(state: State, k: number, p: number[]): Partial<State> {
  const q = keysOf(state)[k], turn = N.quatFromVectors(zeros(4), nose(q), p);
  const angles = N.eulerFromQuat(zeros(3), N.quatMul(zeros(4), turn, q), N.EULER_YXZ);
  return { keys: state.keys.map((x, i) => Math.floor(i / 3) === k ? +degrees(angles[i % 3]).toFixed(2) : x) };
}

const matrix = (q: number[]) => N.mat4FromMat3(zeros(16), N.mat3FromQuatScale(zeros(9), q.slice(0, 4), [1.6, 1.6, 1.6]),
  [0, 0, 0]);

function sphere(room: Room<State>, curves: Memory) {
  const host = gripHost(), show = grips(host);
  room.stage.append(host);
  const paint = (c: CanvasRenderingContext2D, view: View) => {
    const { method, time } = room.state, { keys, at, lines } = curves();
    show(view, keys.map((q, k) => ({
      label: { en: `${k}: the nose of the key`, ja: `${k}: キーの先端` }, mark: String(k), colour: 'ink', at: nose(q),
      move: (ray: Ray) => room.set(turned(room.state, k, onSphere(ray, nose(keysOf(room.state)[k])))),
    })));
    globe(c, view);
    return [dart(c, view, matrix(at(method, time))),
      ...names.flatMap(m => curve(c, view, lines[m].points, colour(colours[m]), m === method ? 3.5 : 1.5)),
      ...names.map(m => dot(c, view, nose(at(m, time)), colour(colours[m])))];
  };
  space(room, { label: { en: 'The object, and the curves of its nose on the sphere. Arrow keys turn the camera.',
    ja: '物体と、その先端が球面上に描く曲線。矢印キーでカメラが回ります。' }, distance: 2.9, parent: host, paint });
}

function tables(room: Room<State>, curves: Memory) {
  numberTable(room, { en: 'Angular velocity x y z, rad/s, and its length, °/s', ja: '角速度 x y z(rad/s)と大きさ(°/s)' }, () =>
    names.map(m => {
      const w = velocity(curves().at(m, room.state.time));
      return { name: m, label: words[m], values: [...w, degrees(N.vec3Length(w))], digits: 2 };
    }));
  numberTable(room, { en: 'At key 2: speed before, after, and jump of ω, °/s', ja: 'キー 2 の前後の大きさと、ω の差(°/s)' }, () =>
    names.map(m => {
      const [before, after] = curves().sides(m).map(velocity);
      return { name: `${m}_key`, label: words[m], digits: 2,
        values: [N.vec3Length(before), N.vec3Length(after), N.vec3Distance(before, after)].map(degrees) };
    }));
}

/* ---- C ---- */

const code = ({ keys, middle, time }: State) => program(`
enum {COUNT = ${count}, MIDDLE = ${mid}, SLERP = 0, SQUAD, GLTF, HERMITE, BSPLINE, METHODS};
const char *const names[] = {${names.map(m => `"${m}"`).join(', ')}};
const char *const key_names[] = {${names.map(m => `"${m}_key"`).join(', ')}};
const float degrees[] = ${list(keys)};
const float times[] = ${list([0, 1, middle, 3, 4])}, time = ${literal(time)};
nkw_quat keys[COUNT];
for (int k = 0; k < COUNT; k++) {
    const nkw_vec3 angles = {nkw_radians_from_degrees(degrees[3 * k]), nkw_radians_from_degrees(degrees[3 * k + 1]),
                             nkw_radians_from_degrees(degrees[3 * k + 2])};
    keys[k] = nkw_quat_from_euler(angles, NKW_EULER_YXZ);
    if (k > 0 && nkw_quat_dot(keys[k - 1], keys[k]) < 0.0f)
        keys[k] = nkw_quat_negate(keys[k]);
}

nkw_rotation_segment segments[METHODS][COUNT - 1];
for (int k = 0; k + 1 < COUNT; k++) {
    const int before = k > 0 ? k - 1 : 0, after = k + 2 < COUNT ? k + 2 : COUNT - 1;
    const nkw_quat four[] = {keys[before], keys[k], keys[k + 1], keys[after]};
    const float four_times[] = {times[before], times[k], times[k + 1], times[after]};
    const float duration = times[k + 1] - times[k];
    segments[SLERP][k] = nkw_rotation_slerp(keys[k], keys[k + 1], NKW_PATH_SHORT, 0, duration);
    segments[SQUAD][k] = nkw_rotation_squad(four, duration);
    segments[GLTF][k] = segments[HERMITE][k] = nkw_rotation_catmull_rom(four, four_times);
    segments[BSPLINE][k] = nkw_rotation_bspline(four, duration);
}

/* Tangent in, value, tangent out: dq/dt = (w/2) q */
nkw_quat values[3 * COUNT];
for (int k = 0; k < COUNT; k++) {
    const nkw_vec3 w = k + 1 < COUNT ? segments[HERMITE][k].velocity[0] : segments[HERMITE][k - 1].velocity[1];
    const nkw_quat v = {w.x, w.y, w.z, 0.0f}, tangent = nkw_quat_scale(nkw_quat_mul(v, keys[k]), 0.5f);
    values[3 * k] = values[3 * k + 2] = tangent;
    values[3 * k + 1] = keys[k];
}
const nkw_track track = {times, &values[0].x, COUNT, 4, NKW_TRACK_ROTATION, NKW_INTERPOLATION_CUBICSPLINE, NULL};
nkw_track first = track;
first.count = MIDDLE + 1;

const nkw_segment now = nkw_segment_find(times, COUNT, time);
const size_t k = now.index < COUNT - 1 ? now.index : COUNT - 2;
for (int m = 0; m < METHODS; m++) {
    nkw_rotation_state at = nkw_rotation_evaluate(&segments[m][k], now.index > k ? 1.0f : now.t);
    nkw_rotation_state before = nkw_rotation_evaluate(&segments[m][MIDDLE - 1], 1.0f);
    nkw_rotation_state after = nkw_rotation_evaluate(&segments[m][MIDDLE], 0.0f);
    if (m == GLTF && (nkw_track_sample_rotation(&track, time, &at) != NKW_OK ||
                      nkw_track_sample_rotation(&first, times[MIDDLE], &before) != NKW_OK ||
                      nkw_track_sample_rotation(&track, times[MIDDLE], &after) != NKW_OK))
        return 1;
    show(names[m], 0, at.velocity.x);
    show(names[m], 1, at.velocity.y);
    show(names[m], 2, at.velocity.z);
    show(names[m], 3, nkw_degrees_from_radians(nkw_vec3_length(at.velocity)));
    show(key_names[m], 0, nkw_degrees_from_radians(nkw_vec3_length(before.velocity)));
    show(key_names[m], 1, nkw_degrees_from_radians(nkw_vec3_length(after.velocity)));
    show(key_names[m], 2, nkw_degrees_from_radians(nkw_vec3_distance(before.velocity, after.velocity)));
}`);

/* ---- the exhibit ---- */

function mount(room: Room<State>) {
  const curves = memory(room);
  sphere(room, curves);
  plot(room, {
    label: { en: 'Angular speed, degrees per second', ja: '角速度の大きさ(度/秒)' },
    x: { en: 'time, s', ja: '時刻(秒)' },
    series: names.map(m => ({ label: words[m], colour: colours[m], width: 2 })),
    data: () => ({ x: abscissae, y: names.map(m => curves().lines[m].speeds) }),
    time: () => room.state.time,
  });
  const controls = panel(room, { en: 'Curves through five keys', ja: '五つのキーを結ぶ曲線' });
  controls.choice('method', { en: 'the object turns by', ja: '物体の補間方法' }, words);
  controls.slider('middle', { en: 'time of key 2, s', ja: 'キー 2 の時刻(秒)' }, 1.2, 2.8, 0.1);
  tables(room, curves);
}

export const splines: Exhibit<State> = {
  lead: {
    en: 'Drag the five noses. slerp turns a corner at each key: its angular velocity jumps. Squad and the B-spline ' +
      'have none while the keys are evenly spaced in time: move the time of key 2. The B-spline passes near its keys.',
    ja: '五つの先端をドラッグしてください。slerp では各キーで角速度が不連続になります。squad と B スプラインは、' +
      'キーの間隔が等しければ連続ですが、キー 2 の時刻を動かすと不連続になります。B スプラインはキーの近くを通ります。',
  },
  fields: {
    method: choice<Method>('hermite', names), middle: number(2, 1.2, 2.8), time: number(0, 0, 4),
    keys: numbers([-10, -70, 0, 45, -35, 40, -25, 0, -20, 40, 35, 60, 0, 80, 0], values => values.length === 3 * count),
    ...turnFields(180, 10),
  },
  range: () => ({ start: 0, end: 4 }),
  mount,
  code,
};
