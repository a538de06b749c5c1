// SPDX-License-Identifier: MIT
// The mean of two clips that run in step, by their weights.
import * as N from 'nakawari/all';
import { html } from '../../kit/html';
import { list, literal, program } from '../../kit/code';
import { legend } from '../../kit/legend';
import { numberTable } from '../../kit/numbers';
import { panel } from '../../kit/panel';
import { plot } from '../../kit/plot';
import { remembered, samples } from '../../kit/samples';
import { clamp } from '../../kit/values';
import type { Room } from '../../shell/exhibit';
import { say, type Text } from '../../shell/text';
import { clipControl, jointControls } from './controls';
import { figures } from './figures';
import { angles, anglesInC, type Rig, lengthOf, rotationOf } from './rig';
import { axisNames, type ModeOf, type State } from './state';
import { words } from './words';

const own = {
  note: {
    en: 'Both clips take the mean of their durations. Drag the point, the start of the second clip: where the clips ' +
      'are out of step, the mean loses their motion.',
    ja: 'どちらのクリップも、平均した長さで1周します。点（2つ目の開始位置）をドラッグしてください。位相がずれると、平均では動きが失われます。',
  },
  picture: { en: 'The first clip, the mean pose, the second clip', ja: '1つ目のクリップ、平均のポーズ、2つ目のクリップ' },
  mean: { en: 'mean pose', ja: '平均のポーズ' },
  phase: { en: 'start of the second clip (cycles)', ja: '2つ目の開始位置（周）' },
  times: { en: 'Time in each clip, duration of the cycle (s)', ja: '各クリップ内の時刻、1周の長さ（秒）' },
  clock: { en: 'first, second, cycle', ja: '1つ目、2つ目、1周' },
} satisfies Record<string, Text>;
const kinds = ['from', 'mean', 'to'] as const, texts = [words.from, own.mean, words.to], colours = ['c2', 'c0', 'c1'];
const F = Math.fround;

const weightOf = ({ weight }: State) => Math.min(weight, 1);
const cycleOf = (state: State, rig: Rig) =>
  N.lerp(lengthOf(rig.clips[state.from]), lengthOf(rig.clips[state.other]), weightOf(state));

/** The time in each clip at a part of the cycle. */
function clipTimes(state: State, rig: Rig, part: number): number[] {
  const at = (name: string, parts: number) => {
    const clip = rig.clips[name], length = lengthOf(clip);
    return N.playbackHead([0, 0], N.PLAYBACK_LOOP, clip.start, length, F(clip.start + F(parts * length)))[0];
  };
  return [at(state.from, F(part)), at(state.other, F(F(part) - F(state.phase)))];
}

let made: N.Pose[] | undefined;
/** The poses of the first clip, the mean and the second clip. They are the same objects each time. */
function posesAt(state: State, rig: Rig, part: number): N.Pose[] {
  const poses = made ??= kinds.map(() => new N.Pose(rig.names.length)), [from, to] = clipTimes(state, rig, part);
  rig.clips[state.from].sample(from, poses[0]);
  rig.clips[state.other].sample(to, poses[2]);
  N.poseBlend(poses[0], poses[2], weightOf(state), poses[1]);
  return poses;
}
const rotationsAt = (state: State, rig: Rig, part: number) =>
  posesAt(state, rig, part).map(pose => rotationOf(pose, rig.names.indexOf(state.joint)));
const partOf = (state: State, rig: Rig) => F(F(state.time) / cycleOf(state, rig));

function plotAngles(room: Room<State>, rig: Rig) {
  const axis = (state: State) => axisNames.indexOf(state.axis);
  const data = remembered((state: State) => {
    const cycle = cycleOf(state, rig);
    return samples(t => rotationsAt(state, rig, t / cycle).map(q => angles(q)[axis(state)]), 0, cycle);
  });
  plot(room, {
    label: words.angle, x: words.seconds, data: () => data(room.state),
    time: () => partOf(room.state, rig) % 1 * cycleOf(room.state, rig),
    series: legend(room, kinds.map((name, i) => ({ name, label: texts[i], colour: colours[i],
      width: i === 1 ? 2.5 : 1.5 })), 'hidden'),
    handles: () => {
      const { phase } = room.state, cycle = cycleOf(room.state, rig);
      return [{ label: own.phase, x: phase * cycle, y: angles(rotationsAt(room.state, rig, phase)[2])[axis(room.state)],
        move: x => room.set({ phase: clamp(x / cycle, 0, 1) }) }];
    },
  });
}

function mount(room: Room<State>, rig: Rig) {
  room.stage.append(html('p', say(own.note), { class: 'note' }));
  figures(room, rig, own.picture, 3, () => posesAt(room.state, rig, partOf(room.state, rig))
    .map((pose, i) => ({ pose, colour: colours[i], label: texts[i] })));
  plotAngles(room, rig);
  numberTable(room, words.angles, () => rotationsAt(room.state, rig, partOf(room.state, rig)).map((q, i) =>
    ({ name: kinds[i], label: texts[i], values: angles(q), digits: 2 })));
  numberTable(room, own.times, () => [{ name: 'times', label: own.clock,
    values: [...clipTimes(room.state, rig, partOf(room.state, rig)), cycleOf(room.state, rig)] }]);
  const made = panel(room, words.pair);
  clipControl(made, 'from', words.from);
  clipControl(made, 'other', words.to);
  made.slider('weight', words.weight, 0, 1, 0.01);
  made.slider('phase', own.phase, 0, 1, 0.01);
  jointControls(made, rig);
}

function code(state: State, rig: Rig): string {
  const [a, , b] = rotationsAt(state, rig, partOf(state, rig));
  const clips = [rig.clips[state.from], rig.clips[state.other]];
  return program(`
/* The clips, first and second: their starts and durations, and the rotations of ${state.joint} at these times. */
static const float start[2] = ${list(clips.map(clip => clip.start))}, duration[2] = ${list(clips.map(lengthOf))};
const nkw_quat a = ${list(a)}, b = ${list(b)};
const float weight = ${literal(weightOf(state))}, time = ${literal(state.time)}, phase = ${literal(state.phase)};
const float cycle = nkw_lerp(duration[0], duration[1], weight), part = time / cycle;
const float parts[2] = {part, part - phase};
for (int i = 0; i < 2; i++)
    show("times", i, (double)nkw_playback_head(NKW_PLAYBACK_LOOP, start[i], duration[i],
                                              start[i] + parts[i] * duration[i]).time);
show("times", 2, (double)cycle);
const nkw_quat shown[3] = {a, nkw_quat_nlerp(a, b, weight), b};
static const char *const names[3] = {"from", "mean", "to"};
for (int i = 0; i < 3; i++) {
    ${anglesInC('shown[i]')}
}
`);
}

export const pair: ModeOf = { mount, end: cycleOf, code };
