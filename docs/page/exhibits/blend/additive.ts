// SPDX-License-Identifier: MIT
// A base clip plus a share of the difference of another clip from a reference pose.
import * as N from 'nakawari/all';
import { list, literal, program } from '../../kit/code';
import { html } from '../../kit/html';
import { legend } from '../../kit/legend';
import { numberTable } from '../../kit/numbers';
import { panel } from '../../kit/panel';
import { plot } from '../../kit/plot';
import { remembered, samples } from '../../kit/samples';
import type { Room } from '../../shell/exhibit';
import { say, type Text } from '../../shell/text';
import { clipControl, jointControls } from './controls';
import { figures } from './figures';
import { angles, anglesInC, lengthOf, type Rig, rotationOf, sampleLoop } from './rig';
import { axisNames, type ModeOf, type State } from './state';
import { words } from './words';

const own = {
  note: {
    en: 'The difference of a clip from a reference is added to the base. From the rest pose it lowers an arm once ' +
      'more, which the base has lowered already.',
    ja: 'クリップと基準ポーズとの差を、ベースのポーズに加えます。レストポーズを基準にすると、ベースですでに下ろした腕を、差がもう一度下げてしまいます。',
  },
  picture: { en: 'The base, the clip, the sum', ja: 'ベース、クリップ、和' },
  base: { en: 'base', ja: 'ベース' },
  clip: { en: 'clip', ja: 'クリップ' },
  sum: { en: 'sum', ja: '和' },
  difference: { en: 'difference', ja: '差' },
  reference: { en: 'reference', ja: '基準' },
  first: { en: 'first frame', ja: '最初のフレーム' },
  rest: { en: 'rest pose', ja: 'レストポーズ' },
  side: { en: 'axes of the difference', ja: '差を表す軸' },
  local: { en: 'of the joint', ja: '関節の軸' },
  parent: { en: 'of its parent', ja: '親の軸' },
} satisfies Record<string, Text>;
const kinds = ['base', 'clip', 'sum', 'difference'] as const;
const colours = ['c2', 'c1', 'c0', 'c4'];

const sideOf = ({ side }: State) => side === 'local' ? N.ADDITIVE_LOCAL : N.ADDITIVE_PARENT;

let made: N.Pose[] | undefined;
/** Base, clip, sum, difference and reference at a time. They are the same objects each time. */
function posesAt(state: State, rig: Rig, time: number): N.Pose[] {
  const poses = made ??= Array.from({ length: 5 }, () => new N.Pose(rig.names.length));
  const [base, clip, sum, difference, first] = poses, source = rig.clips[state.to], side = sideOf(state);
  sampleLoop(rig.clips[state.from], time, base);
  sampleLoop(source, time, clip);
  source.sample(source.start, first);
  const reference = state.reference === 'first' ? first : rig.rest;
  N.poseAdditiveBuild(clip, reference, side, difference);
  N.poseAdditiveApply(base, difference, state.weight, side, sum);
  return [base, clip, sum, difference, reference];
}
const rotationsAt = (state: State, rig: Rig, time: number) =>
  posesAt(state, rig, time).map(pose => rotationOf(pose, rig.names.indexOf(state.joint)));

const end = (state: State, rig: Rig) => Math.max(lengthOf(rig.clips[state.from]), lengthOf(rig.clips[state.to]));

function plotAngles(room: Room<State>, rig: Rig) {
  const data = remembered((state: State) => {
    const k = axisNames.indexOf(state.axis);
    return samples(t => rotationsAt(state, rig, t).slice(0, 3).map(q => angles(q)[k]), 0, end(state, rig));
  });
  plot(room, {
    label: words.angle, x: words.seconds, time: () => room.state.time, data: () => data(room.state),
    series: legend(room, kinds.slice(0, 3).map((name, i) => ({ name, label: own[name], colour: colours[i],
      width: i === 2 ? 2.5 : 1.5 })), 'hidden'),
  });
}

function mount(room: Room<State>, rig: Rig) {
  room.stage.append(html('p', say(own.note), { class: 'note' }));
  figures(room, rig, own.picture, 3, () => posesAt(room.state, rig, room.state.time).slice(0, 3)
    .map((pose, i) => ({ pose, colour: colours[i], label: own[kinds[i]] })));
  plotAngles(room, rig);
  numberTable(room, words.angles, () => rotationsAt(room.state, rig, room.state.time).slice(0, 4).map((q, i) =>
    ({ name: kinds[i], label: own[kinds[i]], values: angles(q), digits: 2 })));
  const controls = panel(room, words.additive);
  clipControl(controls, 'from', own.base);
  clipControl(controls, 'to', own.clip);
  controls.slider('weight', words.weight, 0, 1.5, 0.01);
  controls.choice('reference', own.reference, { first: own.first, rest: own.rest });
  controls.choice('side', own.side, { local: own.local, parent: own.parent });
  jointControls(controls, rig);
}

function code(state: State, rig: Rig): string {
  const [base, clip, , , reference] = posesAt(state, rig, state.time).map(pose =>
    pose.get(rig.names.indexOf(state.joint), new Float32Array(10)));
  const trs = (v: Float32Array) => `{${[v.slice(0, 3), v.slice(3, 7), v.slice(7)].map(list).join(', ')}}`;
  return program(`
/* ${state.joint} in the base, in the clip and in the reference: translation, rotation, scale. */
static const nkw_trs joint[3] = {
    ${trs(base)},
    ${trs(clip)},
    ${trs(reference)},
};
enum { BASE, CLIP, SUM, DIFFERENCE, REFERENCE, COUNT };
static float floats[COUNT][NKW_POSE_FLOATS(1)];
nkw_pose_span poses[COUNT];
nkw_pose_view views[COUNT];
for (int i = 0; i < COUNT; i++) {
    poses[i] = (nkw_pose_span){floats[i], 1};
    nkw_pose_identity(poses[i]);
    views[i] = NKW_VIEW(nkw_pose, poses[i]);
}
nkw_pose_set(poses[BASE], 0, &joint[0]);
nkw_pose_set(poses[CLIP], 0, &joint[1]);
nkw_pose_set(poses[REFERENCE], 0, &joint[2]);
const nkw_additive side = ${state.side === 'local' ? 'NKW_ADDITIVE_LOCAL' : 'NKW_ADDITIVE_PARENT'};
const nkw_mask_view all = {NULL, 1};
nkw_pose_additive_build(views[CLIP], views[REFERENCE], side, poses[DIFFERENCE]);
nkw_pose_additive_apply(views[BASE], views[DIFFERENCE], ${literal(state.weight)}, all, side, poses[SUM]);
static const char *const names[] = {"base", "clip", "sum", "difference"};
for (int i = BASE; i <= DIFFERENCE; i++) {
    ${anglesInC('nkw_pose_get(views[i], 0).rotation')}
}
`);
}

export const additive: ModeOf = { mount, end, code };
