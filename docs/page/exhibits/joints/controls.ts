// SPDX-License-Identifier: MIT
// What is chosen: product, joint, weights, colours; and, folded away, the sliders.
import { field, options } from '../../kit/field';
import { element } from '../../kit/html';
import { note } from '../../kit/note';
import { panel } from '../../kit/panel';
import type { Room } from '../../shell/exhibit';
import { say, type Text } from '../../shell/text';
import { around, joints, rings } from './mesh';
import { most, orderNames, steps, type Order, type State } from './model';
import { axisWords, controls, influenceWords, labels, notes, orderWords, paintWords } from './words';

function products(room: Room<State>) {
  const group = (label: Text, names: Order[]) => element('optgroup', { label: say(label) },
    options(Object.fromEntries(names.map(name => [name, orderWords[name]]))));
  return field(room, 'order', controls.order, [group(controls.steps, steps),
    group(controls.mistakes, orderNames.filter(name => !steps.includes(name)))]);
}

export function choices(room: Room<State>) {
  const bones = Object.fromEntries(Array.from({ length: joints }, (_, j) => [j, labels.joint(j)]));
  room.side.append(products(room), note(room, state => notes[state.order]), element('div', { class: 'fields' }, [
    field(room, 'joint', controls.joint, options(bones)),
    field(room, 'paint', controls.paint, options(paintWords)),
    field(room, 'influence', controls.influence, options(influenceWords)),
  ]));
}

export function sliders(room: Room<State>) {
  const ui = panel(room, controls.title, true);
  ui.choice('axis', controls.axis, axisWords);
  ([0, 1, 2, 3] as const).forEach(i => ui.slider(`angle${i}`, controls.angle(i), -most, most, 0.01));
  ([1, 2, 3] as const).forEach(i => ui.slider(`height${i}`, controls.height(i), 0, 3, 0.01));
  ui.slider('ring', controls.ring, 0, rings - 1, 1);
  ui.slider('column', controls.column, 0, around - 1, 1);
}

export function shortcuts(room: Room<State>) {
  const next = (i: number, by: number, count: number) => (i + by + count) % count;
  const ring = (by: number) => () => room.set({ ring: next(room.state.ring, by, rings) });
  const order = () => room.set({ order: orderNames[next(orderNames.indexOf(room.state.order), 1, orderNames.length)] });
  room.shortcuts([
    { key: 'o', does: controls.nextOrder, run: order },
    { key: 'j', does: controls.nextJoint, run: () => room.set({ joint: next(room.state.joint, 1, joints) }) },
    { key: 'b', does: controls.bindPose, run: () => room.set({ angle0: 0, angle1: 0, angle2: 0, angle3: 0 }) },
    { key: 'u', does: controls.up, run: ring(1) },
    { key: 'd', does: controls.down, run: ring(-1) },
  ]);
}
