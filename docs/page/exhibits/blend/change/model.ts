// SPDX-License-Identifier: MIT
// The poses of a change from one clip to another, by three methods, and the velocity of a joint.
import * as N from 'nakawari/all';
import { type Rig, rotationOf, sampleLoop } from '../rig';
import { limits, snap, type State, step } from '../state';

export const kinds = ['old', 'new', 'fade', 'inertia', 'dead'] as const;
export const end = 2;
const F = Math.fround;

/** When the change begins, how long it takes, and where the new clip begins, in whole steps. */
export const timesOf = ({ at, start, duration }: State) => ({
  at: snap(at, ...limits.at), start: snap(start, ...limits.start), duration: snap(duration, ...limits.duration),
});

function makePoses(count: number) {
  const pose = () => new N.Pose(count), speed = () => new N.PoseVelocity(count);
  return {
    shown: kinds.map(pose), oldBefore: pose(), oldAt: pose(), newBefore: pose(), newAt: pose(),
    oldVelocity: speed(), newVelocity: speed(), offset: new N.PoseInertia(count),
    blend: new N.PoseDeadBlend(count, 0, 0),
  };
}
let made: ReturnType<typeof makePoses> | undefined;

// Begins both transitions, from two poses of each clip.
function begin(state: State, rig: Rig) {
  const { at, start, duration } = timesOf(state), { from, to } = state, poses = made ??= makePoses(rig.names.length);
  const { oldBefore, oldAt, newBefore, newAt, oldVelocity, newVelocity, offset, blend } = poses;
  N.poseVelocityFromPoses(sampleLoop(rig.clips[from], at - step, oldBefore), sampleLoop(rig.clips[from], at, oldAt),
    step, oldVelocity);
  N.poseVelocityFromPoses(sampleLoop(rig.clips[to], start - step, newBefore), sampleLoop(rig.clips[to], start, newAt),
    step, newVelocity);
  N.poseInertiaBegin(offset, { pose: oldAt, velocity: oldVelocity }, { pose: newAt, velocity: newVelocity }, duration);
  Object.assign(blend, { halfLife: state.coast, duration });
  N.poseDeadBlendBegin(blend, { pose: oldAt, velocity: oldVelocity });
  return poses;
}

/** Calls `each` with the poses of all kinds at ascending times. They are the same objects each time. */
export function walk(state: State, rig: Rig, times: number[], each: (poses: N.Pose[]) => void) {
  const { at, start, duration } = timesOf(state), { shown, offset, blend } = begin(state, rig);
  const [a, b, fade, inertia, dead] = shown;
  for (const t of times) {
    const since = t - at, part = N.clamp(F(F(since) / F(duration)), 0, 1);
    sampleLoop(rig.clips[state.from], t, a);
    sampleLoop(rig.clips[state.to], since + start, b);
    N.poseBlend(a, b, state.smooth ? N.smoothstep(part) : part, fade);
    if (since >= 0) {
      N.poseInertiaEvaluate(offset, b, since, inertia);
      N.poseDeadBlendEvaluate(blend, b, since, dead);
    }
    each(since < 0 ? [a, b, fade, a, a] : shown);
  }
}

/** The rotations of the joint: for each of the times, one for each kind. */
export function rotations(state: State, rig: Rig, times: number[]): number[][][] {
  const joint = rig.names.indexOf(state.joint), list: number[][][] = [];
  walk(state, rig, times, poses => list.push(poses.map(pose => rotationOf(pose, joint))));
  return list;
}

export const velocity = (before: number[], now: number[]) => N.quatAngularVelocity([0, 0, 0], before, now, step);

/** The times that the numbers need: about the start, about the end, and now; and which of them these are. */
export function instants(state: State) {
  const { at, duration } = timesOf(state), now = F(state.time), around = (t: number) => [t - step, t, t + step];
  const wanted = [around(at), around(at + duration), [now - step, now]];
  const times = [...new Set(wanted.flat())].sort((x, y) => x - y);
  const [first, last, here] = wanted.map(list => list.map(t => times.indexOf(t)));
  return { times, first, last, here };
}

/** For each kind the velocity now, and its jumps at the start and at the end. */
export function numbersOf(state: State, rig: Rig) {
  const { times, first, last, here: [before, now] } = instants(state), all = rotations(state, rig, times);
  const rate = (k: number, i: number, j: number) => velocity(all[i][k], all[j][k]);
  const jump = (k: number, [i, j, l]: number[]) => N.vec3Distance(rate(k, i, j), rate(k, j, l));
  return {
    now: kinds.map((_, k) => rate(k, before, now)),
    jumps: kinds.map((_, k) => [jump(k, first), jump(k, last)]),
  };
}

export const grid = Array.from({ length: end / step + 1 }, (_, i) => i * step);

/** The velocities of all kinds at the times of the grid. */
export function velocities(state: State, rig: Rig): number[][][] {
  const all = rotations(state, rig, [-step, ...grid]);
  return kinds.map((_, k) => grid.map((_t, g) => velocity(all[g][k], all[g + 1][k])));
}
