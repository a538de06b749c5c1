// SPDX-License-Identifier: MIT
// The exercise, as its program is used.
import { element } from '../../kit/html';
import type { Exhibit, Room } from '../../shell/exhibit';
import { say } from '../../shell/text';
import { camera, controls } from './controls';
import { keyTable } from './keytable';
import { shortcuts } from './keyboard';
import { fields, keysOf, range, type State } from './model';
import { code } from './program';
import { report } from './report';
import { stage } from './stage';
import { labels } from './words';
import './exercise.css';

/** The exercise's program sets the time to 0 at the last key: the rest of the step is dropped. */
function dropRest(room: Room<State>) {
  let before = -Infinity;
  room.draw(() => {
    const { time, program } = room.state, { start } = range(keysOf(room.state));
    if (program && room.clock.playing && time < before && time !== start)
      room.set({ time: start });
    before = room.state.time;
  });
}

function mount(room: Room<State>) {
  const list = shortcuts(room);
  dropRest(room);
  controls(room, list);
  stage(room);
  report(room);
  keyTable(room);
  camera(room);
  room.side.append(element('p', { class: 'note' }, say(labels.canvas)));
  room.shortcuts(list);
}

export const exercise: Exhibit<State> = {
  lead: {
    en: 'Choose a key, move it by its arrows and squares, turn it by its rings: every number follows. ' +
      'The keyboard is the exercise’s.',
    ja: 'キーを選び、矢印と四角で移動し、輪で回転してください。数値がすぐに変わります。' +
      'キーボードの操作は演習のプログラムと同じです。',
  },
  fields,
  range: state => range(keysOf(state)),
  mount,
  code,
};
