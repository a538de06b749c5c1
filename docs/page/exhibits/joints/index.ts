// SPDX-License-Identifier: MIT
// Exhibit 7: the lesson's capsule on four joints: T J T^-1 in numbers, and the wrong orders of the product.
import * as N from 'nakawari/all';
import { colour } from '../../kit/colours';
import type { View } from '../../kit/eye';
import { element } from '../../kit/html';
import { numberTable, type Row } from '../../kit/numbers';
import { panel } from '../../kit/panel';
import { dot, line, type Shape } from '../../kit/picture';
import { mix, rgb, skinned, vertex } from '../../kit/skinned';
import { space } from '../../kit/space';
import type { Exhibit, Room } from '../../shell/exhibit';
import { say } from '../../shell/text';
import { code } from './code';
import { faces, front, joints, positions, rings, weightsOf } from './mesh';
import { chain, factors, fields, heights, row, type Factor, type Joint, type State } from './model';
import { axisWords, controls, influenceWords, labels, notes, orderWords, paintWords } from './words';

function buildMesh(influence: State['influence']) {
  const weights = weightsOf(influence), count = positions.length / 3;
  const mesh = new N.Mesh({ positions, weights, influenceCount: joints,
    joints: Uint16Array.from({ length: count * joints }, (_, i) => i % joints) });
  return { mesh, weights };
}

/** The skinned vertices of a state; the meshes, one for each way to weigh, live as long as the exhibit. */
function skinner(room: Room<State>) {
  const built = { smooth: buildMesh('smooth'), hard: buildMesh('hard') };
  const palette = new N.Palette({ jointCount: joints, format: N.PALETTE_MAT4 }), models = new N.Matrices(joints);
  room.closed(() => [built.smooth.mesh, built.hard.mesh, palette, models].forEach(owner => owner.dispose()));
  return () => {
    const list = chain(room.state), { mesh, weights } = built[room.state.influence];
    models.array.set(list.flatMap(joint => joint.M));
    return { list, weights, positions: mesh.skinLinear(palette.update(models)).skinned.positions! };
  };
}

/* ---- the picture ---- */

type Skinned = ReturnType<ReturnType<typeof skinner>>;

function colours(state: State, weights: Uint16Array): (face: number) => number[] {
  const of = (face: number) => Array.from({ length: joints }, (_, j) =>
    faces[face].reduce((sum, v) => sum + weights[v * joints + j], 0) / 65535 / faces[face].length);
  const bones = Array.from({ length: joints }, (_, j) => rgb(`c${j}`)), pale = rgb('line');
  return state.paint === 'all' ? face => mix(bones, of(face)) : face => {
    const share = of(face)[state.joint];
    return mix([bones[state.joint], pale], [share, 1 - share]);
  };
}

/** The joints where their matrices move them, before everything else. */
function bones(c: CanvasRenderingContext2D, view: View, state: State, list: Joint[]): Shape[] {
  const at = heights(state).map((h, i) => N.mat4TransformPoint([0, 0, 0], list[i].M, [0, h, 0]));
  const over = (shape: Shape) => ({ ...shape, distance: -1 });
  return [
    ...at.slice(1).map((p, i) => line(c, view, at[i], p, colour('ink'), 2)),
    ...at.flatMap((p, i) => (['x', 'y', 'z'] as const).map((name, k) => {
      const tip = N.vec3Add([0, 0, 0], p, N.mat4TransformDirection([0, 0, 0], list[i].M,
        [0, 1, 2].map(n => n === k ? 0.3 : 0)));
      return line(c, view, p, tip, colour(name), i === state.joint ? 4 : 2);
    })),
    ...at.map(p => dot(c, view, p, colour('ink'))),
  ].map(over);
}

function floor(c: CanvasRenderingContext2D, view: View): Shape[] {
  const lines = [-2, -1, 0, 1, 2].flatMap(k => [[[k, 0, -2], [k, 0, 2]], [[-2, 0, k], [2, 0, k]]]);
  return lines.map(([a, b]) => ({ ...line(c, view, a, b, colour('line'), 1), distance: 1e6 }));
}

function paint(c: CanvasRenderingContext2D, view: View, state: State, now: Skinned): Shape[] {
  const chosen = { ...dot(c, view, vertex(now.positions, front(state.ring)), colour('c6')), distance: -2 };
  return [...floor(c, view), ...skinned(c, view, now.positions, faces, colours(state, now.weights)),
    ...bones(c, view, state, now.list), chosen];
}

/* ---- the numbers ---- */

const symbol: Record<Factor, (i: number) => string> = {
  P: i => i ? `M<sub>${i - 1}</sub>` : '1', T: i => `T<sub>${i}</sub>`, J: i => `J<sub>${i}</sub>`,
  I: i => `T<sub>${i}</sub><sup>−1</sup>`,
};

function matrixRows(state: State, { list }: Skinned): Row[] {
  const { joint: i } = state, names = { ...symbol, M: () => `M<sub>${i}</sub>` };
  return (['P', 'T', 'J', 'I', 'M'] as const).flatMap(name => [0, 1, 2, 3].map(r => ({
    name: `${name}${r}`, label: r ? labels.row(r) : name === 'P' && !i ? say(labels.noParent) : names[name](i),
    values: row(list[i][name], r) })));
}

function vertexRows(state: State, now: Skinned): Row[] {
  const v = front(state.ring);
  return [
    { name: 'weights', label: labels.weights, values: now.weights.subarray(v * joints, (v + 1) * joints), digits: 0 },
    { name: 'vertex', label: labels.vertex, values: vertex(positions, v) },
    { name: 'moved', label: labels.moved, values: vertex(now.positions, v) },
  ];
}

/* ---- the exhibit ---- */

function sliders(room: Room<State>) {
  const ui = panel(room, controls.title);
  ui.choice('order', controls.order, orderWords);
  ui.choice('axis', controls.axis, axisWords);
  ([0, 1, 2, 3] as const).forEach(i => ui.slider(`angle${i}`, controls.angle(i), -3.2, 3.2, 0.01));
  ([1, 2, 3] as const).forEach(i => ui.slider(`height${i}`, controls.height(i), 0, 3, 0.01));
  ui.choice('influence', controls.influence, influenceWords);
  ui.choice('paint', controls.paint, paintWords);
  ui.slider('joint', controls.joint, 0, joints - 1, 1);
  ui.slider('ring', controls.ring, 0, rings - 1, 1);
}

function mount(room: Room<State>) {
  const skin = skinner(room), formula = element('p', { class: 'formula' }), note = element('p', { class: 'note', role: 'status' });
  const legend = element('div', { class: 'legend', 'aria-hidden': 'true' }, Array.from({ length: joints }, (_, j) =>
    element('span', {}, [element('span', { style: `background: var(--c${j}); padding: 0 0.5em; margin-right: 0.3em` }), `${say(labels.joint(j))}`])));
  let now: Skinned;
  room.draw(() => {
    const { order, joint } = room.state, text = say(notes[order]);
    now = skin();
    formula.innerHTML = `M<sub>${joint}</sub> = ${factors(order).map(f => symbol[f](joint)).join(' · ')}`;
    if (note.textContent !== text)
      note.textContent = text;
  });
  room.stage.append(legend);
  const far = () => room.state.order === 'noInverse'; // the parts reach the height 9
  space(room, {
    label: labels.picture,
    get distance() { return far() ? 14 : 6.5; },
    get aim() { return [0, far() ? 4.5 : 1.5, 0]; },
    paint: (c, view) => paint(c, view, room.state, now),
  });
  sliders(room);
  room.side.append(formula, note);
  numberTable(room, labels.matrices, () => matrixRows(room.state, now));
  numberTable(room, labels.vertexTable, () => vertexRows(room.state, now));
}

export const jointChain: Exhibit<State> = {
  id: 'joints',
  title: { en: 'Joints', ja: '関節' },
  lead: {
    en: 'Turn the joints, and look at the product of a joint: T · J · T⁻¹ behind the matrix of the joint before. Choose ' +
      'one of the wrong orders to recognise it in a program of your own.',
    ja: '関節を回して、1つ前の関節の行列に T · J · T⁻¹ を掛けた積を見てください。よくある間違った順序も選べますので、' +
      '自分のプログラムの表示と見比べることができます。',
  },
  fields,
  mount,
  code,
};
