// SPDX-License-Identifier: MIT
// Two clips, from one to the other, their mean, their sum; springs.
import { button, element } from '../../kit/html';
import type { Exhibit, Room } from '../../shell/exhibit';
import { say } from '../../shell/text';
import { additive } from './additive';
import { change } from './change';
import { pair } from './pair';
import { loadRig, type Rig } from './rig';
import { springs } from './springs';
import { fields, type Mode, modes, type ModeOf, type State } from './state';
import { words } from './words';

const all: Record<Mode, ModeOf> = { change, pair, additive, springs };
let rig: Rig | undefined;

// A room of the room for a mode: parts of its own, and drawings only while it is shown.
function inner(room: Room<State>, mode: Mode): Room<State> {
  const made = Object.create(room) as { -readonly [K in keyof Room<State>]: Room<State>[K] };
  made.stage = element('div', { class: 'mode' });
  made.side = element('div', { class: 'mode' });
  made.draw = f => room.draw(seconds => {
    if (room.state.mode === mode)
      f(seconds);
  });
  return made;
}

/** Shows the mode of the state; a mode is made when it is first shown. */
function switcher(room: Room<State>, character: Rig, stage: HTMLElement, side: HTMLElement) {
  const rooms = new Map<Mode, Room<State>>(), sizes = new ResizeObserver(room.refresh);
  room.closed(() => sizes.disconnect());
  return () => {
    const { mode } = room.state;
    if (!rooms.has(mode)) {
      rooms.set(mode, inner(room, mode));
      all[mode].mount(rooms.get(mode)!, character);
      [...rooms.get(mode)!.stage.children].forEach(part => sizes.observe(part));
    }
    stage.replaceChildren(rooms.get(mode)!.stage);
    side.replaceChildren(rooms.get(mode)!.side);
    room.refresh();
  };
}

function mount(room: Room<State>) {
  const status = element('p', { role: 'status', 'data-loading': '' }, say(words.loading));
  const stage = element('div', { class: 'mode' }, status), side = element('div', { class: 'mode' });
  let show = () => {}, left = false;
  const go = (mode: Mode) => {
    room.set({ mode, ...(rig ? { time: Math.min(room.state.time, all[mode].end(room.state, rig)) } : {}) });
    show();
  };
  const buttons = modes.map(mode => button(say(words[mode]), () => go(mode), `to-${mode}`));
  room.stage.append(element('div', { class: 'tools', role: 'group', 'aria-label': say(words.modes) }, buttons), stage);
  room.side.append(side);
  room.shortcuts(modes.map((mode, i) => ({ key: String(i + 1), does: words[mode], run: () => go(mode) })));
  const press = (made: HTMLElement, on: boolean) => made.setAttribute('aria-pressed', String(on));
  room.draw(() => buttons.forEach((made, i) => press(made, modes[i] === room.state.mode)));
  room.closed(() => { left = true; });
  loadRig().then(character => {
    rig = character;
    if (left)
      return;
    show = switcher(room, character, stage, side);
    show();
  }).catch(error => { status.textContent = say(words.failed) + String(error); });
}

export const blend: Exhibit<State> = {
  lead: {
    en: 'Two motions: from one to the other, their mean, their sum; and springs, by which a value follows a goal.',
    ja: '2つの動きの切り替え、平均、和と、値が目標を追うばねを試せます。',
  },
  fields,
  range: state => ({ start: 0, end: rig ? all[state.mode].end(state, rig) : 1 }),
  mount,
  code: state => rig ? all[state.mode].code(state, rig) : `/* ${say(words.loading)} */\n`,
};
