// SPDX-License-Identifier: MIT
// The controls above the canvas: scene, methods, view, buttons, switches, layouts; and the camera.
import { button, element } from '../../kit/html';
import type { Room, Shortcut } from '../../shell/exhibit';
import { say, type Text } from '../../shell/text';
import { LayoutError, read, write, type Layout } from './layout';
import { fields, keysOf, orientations, positions, setKeys, setScene, views, type State } from './model';
import { isObject, ownObject, readObject, showObject, type Own } from './object';
import { scenes } from './scenes';
import { labels, objectText, orientationWords, positionWords, viewWords } from './words';

type Change = Partial<State>;
const { titles } = labels;

function titled<T extends HTMLElement>(made: T, title: Text): T {
  made.title = say(title);
  return made;
}

/* ---- one control ---- */

interface Choice {
  name: 'scene' | 'position' | 'orientation' | 'view';
  words: [string, Text][];
  change(word: string): Change;
}

function select(room: Room<State>, { name, words, change }: Choice) {
  const options = words.map(([word, text]) => element('option', { value: word }, say(text)));
  const made = element('select', { 'data-field': name }, options);
  let byPointer = false;
  made.addEventListener('pointerdown', () => { byPointer = true; });
  made.addEventListener('keydown', () => { byPointer = false; });
  made.addEventListener('change', () => {
    room.set(change(made.value));
    if (byPointer)
      made.blur(); // the next key is one of the exercise again
  });
  room.draw(() => { made.value = String(room.state[name]); });
  return element('label', {}, [say(labels[name]), made]);
}

function check(room: Room<State>, name: 'axes' | 'local' | 'clicks' | 'program', title: Text) {
  const made = element('input', { type: 'checkbox', 'data-field': name });
  made.addEventListener('change', () => room.set({ [name]: made.checked }));
  room.draw(() => { made.checked = room.state[name]; });
  return element('label', { title: say(title) }, [made, ` ${say(labels[name])}`]);
}

function number(room: Room<State>, name: 'time' | 'yaw' | 'pitch' | 'distance' | 'fov') {
  const made = element('input', { type: 'number', step: name === 'time' ? '0.05' : 'any', 'data-field': name });
  made.addEventListener('change', () => {
    const value = made.value === '' ? undefined : fields[name].read(made.value);
    if (value !== undefined)
      room.set({ [name]: value });
  });
  room.draw(() => {
    if (made !== document.activeElement)
      made.value = String(+room.state[name].toFixed(3));
  });
  return element('label', {}, [`${say(labels[name])} `, made]);
}

/* ---- layouts ---- */

function save({ state }: Room<State>) {
  const text = write(`scene${state.scene}`, keysOf(state));
  const url = URL.createObjectURL(new Blob([text], { type: 'application/json' }));
  element('a', { href: url, download: 'layout.json' }).click();
  setTimeout(() => URL.revokeObjectURL(url), 1000);
}

/** Files that are dropped anywhere on the page. */
function onDrop(room: Room<State>, open: (files: File[]) => void) {
  const over = (event: DragEvent) => event.preventDefault();
  const drop = (event: DragEvent) => {
    event.preventDefault();
    open([...event.dataTransfer?.files ?? []]);
  };
  addEventListener('dragover', over);
  addEventListener('drop', drop);
  room.closed(() => {
    removeEventListener('dragover', over);
    removeEventListener('drop', drop);
  });
}

/** The button that loads a layout or a model, and the line that says what is wrong with a file, or what it has. */
function loading(room: Room<State>) {
  const message = element('span'), choices = element('span');
  const file = element('input', { type: 'file', accept: '.json,.csv,.obj,.mtl', multiple: '', hidden: '',
    'data-field': 'load' });
  const use = ({ keys }: Layout) => room.set(setKeys(keys));
  const useObject = (own: Own | undefined) => {
    showObject(own);
    message.textContent = own ? objectText(own) : '';
    choices.replaceChildren(...(own ? [button(say(labels.dart), () => useObject(undefined))] : []));
    room.refresh();
  };
  const openAll = async (files: File[]) => {
    if (isObject(files))
      return useObject(await readObject(files));
    const layouts = read(await files[0].text());
    use(layouts[0]);
    choices.replaceChildren(...(layouts.length > 1 ? layouts.map(l => button(l.name, () => use(l))) : []));
  };
  const open = async (files: File[]) => {
    if (!files.length)
      return;
    message.textContent = '';
    choices.replaceChildren();
    try {
      await openAll(files);
    } catch (error) {
      message.textContent = `${files[0].name}: ${error instanceof LayoutError ? say(error.text) : String(error)}`;
    }
    file.value = '';
  };
  file.addEventListener('change', () => void open([...file.files ?? []]));
  onDrop(room, files => void open(files));
  useObject(ownObject());
  return {
    buttons: [titled(button(say(labels.load), () => file.click()), titles.load), file],
    line: element('p', { role: 'status', class: 'layout' }, [message, ' ', choices]),
  };
}

/* ---- all ---- */

const entries = <T extends string>(list: readonly T[], words: Record<T, Text>) =>
  list.map(word => [word, words[word]] as [string, Text]);

const choices: Choice[] = [
  { name: 'scene', change: word => setScene(Number(word)),
    words: scenes.map(({ title: { en, ja } }, i) => [`${i + 1}`, { en: `${i + 1} ${en}`, ja: `${i + 1} ${ja}` }]) },
  { name: 'position', words: entries(positions, positionWords), change: word => ({ position: word } as Change) },
  { name: 'orientation', words: entries(orientations, orientationWords),
    change: word => ({ orientation: word } as Change) },
  { name: 'view', words: entries(views, viewWords), change: word => ({ view: word } as Change) },
];

/** A button for a key of the keyboard. */
function keyButton({ key, does, run }: Shortcut, label: Text) {
  const made = titled(button(say(label), run), does);
  made.dataset.shortcut = key;
  made.setAttribute('aria-keyshortcuts', key === ' ' ? 'Space' : key);
  made.append(' ', element('kbd', { 'aria-hidden': 'true' }, key === ' ' ? say(labels.space) : key));
  return made;
}

const reasonOf = ({ scene, loaded }: State): Text => loaded ? labels.loaded : scenes[scene - 1].reason;

export function controls(room: Room<State>, list: Shortcut[]) {
  const keyed = (key: string, label: Text) => keyButton(list.find(s => s.key === key)!, label);
  const layouts = loading(room), reason = element('p', { class: 'reason' });
  room.draw(() => { reason.textContent = say(reasonOf(room.state)); });
  room.stage.append(
    element('div', { class: 'choices-grid' }, choices.map(choice => select(room, choice))),
    element('div', { class: 'tools' }, [
      keyed(' ', labels.play), keyed('a', labels.add), keyed('d', labels.remove),
      titled(button(say(labels.save), () => save(room)), titles.save), ...layouts.buttons,
      check(room, 'axes', titles.axes), check(room, 'local', titles.local), check(room, 'clicks', titles.clicks),
      check(room, 'program', labels.programNote),
      titled(number(room, 'time'), titles.time),
    ]));
  room.side.append(layouts.line, reason);
}

export function camera(room: Room<State>) {
  room.side.append(element('fieldset', { class: 'camera' }, [element('legend', {}, say(labels.camera)),
    ...(['yaw', 'pitch', 'distance', 'fov'] as const).map(name => number(room, name))]));
}
