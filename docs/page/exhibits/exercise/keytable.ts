// SPDX-License-Identifier: MIT
// The list of keys with a field for each number: what the handles do, for the keyboard and for screen readers.
import * as N from 'nakawari/all';
import { button, element } from '../../kit/html';
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

export function keyTable(room: Room<State>) {
  const message = element('p', { role: 'status', class: 'keys-message' });
  const body = element('tbody'), list = element('table', { class: 'numbers' }, [
    element('caption', {}, say(labels.keys)),
    element('thead', {}, element('tr', {}, [...[labels.key, ...heads].map(h => element('th', { scope: 'col' }, say(h))),
      element('td')])), body]);
  room.side.append(element('div', { class: 'key-table', tabindex: '0', role: 'group', 'aria-label': say(labels.keys) },
    list), message);

  const change = (k: number, next: Partial<Key>) => {
    const made = replaceKey(keysOf(room.state), k, next);
    const keys = made && keysOf({ ...room.state, ...made });
    const fits = keys && range(keys).end - range(keys).start <= limits.seconds;
    message.textContent = fits ? '' : say(labels.refused);
    if (fits)
      room.set(made);
    return !!fits;
  };
  const field = (k: number, i: number) => {
    const input = element('input', { type: 'number', step: i === 0 || i > 3 ? 'any' : '0.1', 
      'aria-label': `${say(labels.key)} ${k} ${say(heads[i])}`, 'data-key': `${k}`, 'data-column': columns[i] });
    input.addEventListener('change', () => {
      const valid = input.value !== '' && change(k, edited(keysOf(room.state)[k], i, Number(input.value)));
      input.setAttribute('aria-invalid', String(!valid));
    });
    return element('td', {}, input);
  };
  const row = (k: number) => {
    const choose = button(String(k), () => room.set({ selected: k }));
    choose.setAttribute('aria-label', `${say(labels.key)} ${k}`);
    const negate = button('−q', () => {
      const { orientation } = keysOf(room.state)[k];
      change(k, { orientation: N.quatNegate([0, 0, 0, 0], orientation) });
    });
    negate.setAttribute('aria-label', `−q ${say(labels.key)} ${k}: ${say(labels.negate)}`);
    return element('tr', {}, [element('th', { scope: 'row' }, choose), ...columns.map((_, i) => field(k, i)),
      element('td', {}, negate)]);
  };
  room.draw(() => {
    const keys = keysOf(room.state);
    if (body.rows.length !== keys.length)
      body.replaceChildren(...keys.map((_, k) => row(k)));
    keys.forEach((key, k) => {
      body.rows[k].querySelector('button')!.setAttribute('aria-pressed', String(k === room.state.selected));
      body.rows[k].querySelectorAll('input').forEach((input, i) => {
        const text = shown(valuesOf(key)[i], i);
        if (input !== document.activeElement && input.value !== text)
          input.value = text;
      });
    });
  });
}
