// SPDX-License-Identifier: MIT
// The list of keys with a field for each number: what the handles do, for the keyboard and for screen readers.
import * as N from 'nakawari/all';
import { button, element } from '../../kit/html';
import { zeros } from '../../kit/values';
import type { Room } from '../../shell/exhibit';
import { say } from '../../shell/text';
import { degrees, fromDegrees, keysOf, limits, range, replaceKey, type Key, type State } from './model';
import { labels } from './words';

const columns = ['time', 'x', 'y', 'z', 'yaw', 'pitch', 'roll'] as const;
const heads = [labels.time, 'x', 'y', 'z', labels.yaw, labels.pitch, labels.roll];

const valuesOf = (key: Key) => [key.time, ...key.position, ...degrees(key)];

/** Angles have four decimals: those of a quaternion are exact to about 1e-5 degrees. */
const shown = (value: number, column: number) => String(column < 4 ? +value.toPrecision(6) : +value.toFixed(4) + 0);

/** The key with the value of one column changed. */
function edited(key: Key, column: number, value: number): Partial<Key> {
  if (column === 0)
    return { time: Math.fround(value) };
  if (column < 4)
    return { position: key.position.map((x, i) => i === column - 1 ? Math.fround(value) : x) };
  const turn = degrees(key).map((x, i) => i === column - 4 ? value : x);
  return fromDegrees(turn as [number, number, number]);
}

type ChangeKey = (k: number, next: Partial<Key>) => boolean;

function numberField(room: Room<State>, k: number, column: number, change: ChangeKey) {
  const label = `${say(labels.key)} ${k} ${say(heads[column])}`, step = column > 0 && column < 4 ? '0.1' : 'any';
  const input = element('input',
    { type: 'number', step, 'aria-label': label, 'data-key': String(k), 'data-column': columns[column] });
  input.addEventListener('change', () => {
    const valid = input.value !== '' && change(k, edited(keysOf(room.state)[k], column, Number(input.value)));
    input.setAttribute('aria-invalid', String(!valid));
  });
  return input;
}

/** A row: the number of the key, which chooses it, its values, and -q for q. */
function makeRow(room: Room<State>, k: number, change: ChangeKey) {
  const name = `${say(labels.key)} ${k}`, choose = button(String(k), () => room.set({ selected: k }));
  choose.setAttribute('aria-label', name);
  const negate = button('−q', () =>
    change(k, { orientation: N.quatNegate(zeros(4), keysOf(room.state)[k].orientation) }));
  negate.setAttribute('aria-label', `−q ${name}: ${say(labels.negate)}`);
  return element('tr', {}, [element('th', { scope: 'row' }, choose),
    ...columns.map((_, i) => element('td', {}, numberField(room, k, i, change))), element('td', {}, negate)]);
}

function fill(row: HTMLTableRowElement, key: Key, chosen: boolean) {
  row.querySelector('button')!.setAttribute('aria-pressed', String(chosen));
  row.querySelectorAll('input').forEach((input, i) => {
    const text = shown(valuesOf(key)[i], i);
    if (input !== document.activeElement && input.value !== text)
      input.value = text;
  });
}

/** Changes a key if the library takes the keys and they are not too long; says so otherwise. */
function changer(room: Room<State>, message: HTMLElement): ChangeKey {
  return (k, next) => {
    const made = replaceKey(keysOf(room.state), k, next), keys = made && keysOf({ ...room.state, ...made });
    const fits = !!keys && range(keys).end - range(keys).start <= limits.seconds;
    message.textContent = fits ? '' : say(labels.refused);
    if (fits)
      room.set(made!);
    return fits;
  };
}

export function keyTable(room: Room<State>) {
  const message = element('p', { role: 'status', class: 'keys-message' }), change = changer(room, message);
  const head = [labels.key, ...heads].map(h => element('th', { scope: 'col' }, say(h)));
  const body = element('tbody'), table = element('table', { class: 'numbers' }, [
    element('caption', {}, say(labels.keys)),
    element('thead', {}, element('tr', {}, [...head, element('td')])), body]);
  room.side.append(element('div', { class: 'key-table', tabindex: '0', role: 'group', 'aria-label': say(labels.keys) },
    table), message);
  room.draw(() => {
    const keys = keysOf(room.state);
    if (body.rows.length !== keys.length)
      body.replaceChildren(...keys.map((_, k) => makeRow(room, k, change)));
    keys.forEach((key, k) => fill(body.rows[k], key, k === room.state.selected));
  });
}
