// SPDX-License-Identifier: MIT
// Exhibit 1: the exercise, as its program is used.
import { button, element } from '../../kit/html';
import type { Exhibit, Room, Shortcut } from '../../shell/exhibit';
import { say, type Text } from '../../shell/text';
import { keyTable } from './keytable';
import { LayoutError, read, write, type Layout } from './layout';
import {
  addKey, deleteKey, fields, keysOf, nextOf, orientations, positions, range, setKeys, setScene, taught, views, type State,
} from './model';
import { code } from './program';
import { report } from './report';
import { scenes } from './scenes';
import { stage } from './stage';
import { labels, orientationWords, positionWords, viewWords } from './words';

/* ---- controls ---- */

type Name<T> = { [K in keyof State]: State[K] extends T ? K : never }[keyof State];

function select<K extends 'scene' | 'position' | 'orientation' | 'view'>(room: Room<State>, name: K, words: [string, Text | string][],
  change: (word: string) => Partial<State>) {
  const made = element('select', { 'data-field': name }, words.map(([word, text]) => element('option', { value: word }, say(text))));
  made.addEventListener('change', () => room.set(change(made.value)));
  room.draw(() => { made.value = String(room.state[name]); });
  return element('label', {}, [`${say(labels[name])} `, made]);
}

function check(room: Room<State>, name: Name<boolean> & ('axes' | 'local' | 'program')) {
  const made = element('input', { type: 'checkbox', 'data-field': name });
  made.addEventListener('change', () => room.set({ [name]: made.checked }));
  room.draw(() => { made.checked = room.state[name]; });
  return element('label', {}, [made, ` ${say(labels[name])}`]);
}

function number(room: Room<State>, name: 'yaw' | 'pitch' | 'distance' | 'fov') {
  const made = element('input', { type: 'number', step: 'any', 'data-field': name, style: 'width: 5em' });
  made.addEventListener('change', () => {
    const value = made.value === '' ? undefined : fields[name].read(made.value);
    if (value !== undefined)
      room.set({ [name]: value });
  });
  room.draw(() => {
    if (made !== document.activeElement)
      made.value = String(+room.state[name].toPrecision(4));
  });
  return element('label', {}, [`${say(labels[name])} `, made]);
}

const entries = <T extends string>(list: readonly T[], words: Record<T, Text>) => list.map(w => [w, words[w]] as [string, Text]);

/* ---- layouts ---- */

function save(room: Room<State>) {
  const url = URL.createObjectURL(new Blob([write(`scene${room.state.scene}`, keysOf(room.state))], { type: 'application/json' }));
  element('a', { href: url, download: 'layout.json' }).click();
  setTimeout(() => URL.revokeObjectURL(url), 1000);
}

function load(room: Room<State>) {
  const message = element('p', { role: 'status' }), choices = element('span');
  const file = element('input', { type: 'file', accept: '.json,.csv', 'aria-label': say(labels.load), 'data-field': 'load' });
  const use = ({ keys }: Layout) => room.set(setKeys(keys));
  const open = async () => {
    message.textContent = '';
    try {
      const layouts = read(await file.files![0].text());
      use(layouts[0]);
      choices.replaceChildren(...(layouts.length > 1 ? layouts.map(l => button(l.name, () => use(l))) : []));
    } catch (error) {
      message.textContent = error instanceof LayoutError ? say(error.text) : String(error);
    }
    file.value = '';
  };
  file.addEventListener('change', () => { if (file.files?.length) open(); });
  return [element('label', {}, [`${say(labels.load)} `, file]), choices, message];
}

/* ---- keys and buttons ---- */

function shortcuts(room: Room<State>): Shortcut[] {
  const now = () => room.state, keys = () => keysOf(now());
  return [
    ...scenes.map((scene, i) => ({ key: String(i + 1), does: scene.title, run: () => room.set(setScene(i + 1)) })),
    { key: 's', does: labels.stop, run: () => room.clock.toggle() },
    { key: ' ', does: labels.play, run: () => room.clock.playing ? room.clock.stop() : room.clock.restart() },
    { key: 'p', does: labels.position, run: () => room.set({ position: nextOf(taught.positions, now().position) }) },
    { key: 'o', does: labels.orientation, run: () => room.set({ orientation: nextOf(taught.orientations, now().orientation) }) },
    { key: 'f', does: labels.view, run: () => room.set({ view: nextOf(views, now().view) }) },
    { key: 'a', does: labels.add, run: () => room.set(addKey(keys())) },
    { key: 'd', does: labels.remove, run: () => room.set(deleteKey(keys(), now())) },
    { key: 't', does: labels.axes, run: () => room.set({ axes: !now().axes }) },
  ];
}

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
  const reason = element('p', { class: 'reason' }), note = element('p', { class: 'note' });
  const words = scenes.map((scene, i) => [String(i + 1), { en: `${i + 1} ${scene.title.en}`, ja: `${i + 1} ${scene.title.ja}` }] as [string, Text]);
  dropRest(room);
  stage(room);
  const run = (key: string) => {
    const { does, run: f } = list.find(s => s.key === key)!, made = button(say(does), f);
    made.dataset.shortcut = key;
    return made;
  };
  room.side.append(
    element('div', { class: 'tools' }, [
      select(room, 'scene', words, word => setScene(Number(word))),
      select(room, 'position', entries(positions, positionWords), word => ({ position: word as State['position'] })),
      select(room, 'orientation', entries(orientations, orientationWords), word => ({ orientation: word as State['orientation'] })),
      select(room, 'view', entries(views, viewWords), word => ({ view: word as State['view'] })),
    ]),
    reason,
    element('div', { class: 'tools' }, [run(' '), run('s'), run('a'), run('d'), button(say(labels.save), () => save(room))]),
    element('div', { class: 'tools' }, load(room)),
    element('div', { class: 'tools' }, [check(room, 'axes'), check(room, 'local'), check(room, 'program')]),
    note,
  );
  report(room);
  keyTable(room);
  room.side.append(element('fieldset', {}, [element('legend', {}, say(labels.camera)),
    ...(['yaw', 'pitch', 'distance', 'fov'] as const).map(name => number(room, name))]));
  room.draw(() => {
    reason.textContent = say(scenes[room.state.scene - 1].reason);
    reason.hidden = room.state.keys.length > 0;
    note.textContent = room.state.program ? say(labels.programNote) : '';
  });
  room.shortcuts(list);
}

export const exercise: Exhibit<State> = {
  lead: {
    en: 'Choose a key, move it by its arrows and squares, turn it by its rings; every number follows. The keyboard is ' +
      'that of the exercise’s program.',
    ja: 'キーを選び、矢印と四角で移動し、輪で回転してください。すべての数値がすぐに変わります。' +
      'キーボードの操作は演習のプログラムと同じです。',
  },
  fields,
  range: state => range(keysOf(state)),
  mount,
  code,
};
