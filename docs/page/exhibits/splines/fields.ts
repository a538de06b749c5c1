// SPDX-License-Identifier: MIT
// The time and the angular velocity of each key, as numbers that can be edited.
import { element } from '../../kit/html';
import type { Room } from '../../shell/exhibit';
import { say } from '../../shell/text';
import { count, withOmega, withTime, type Curves, type State } from './model';

const columns = [{ en: 'time (s)', ja: '時刻（秒）' }, 'ω x', 'ω y', 'ω z'];
const title = { en: 'Keys: time, and ω in rad/s for Hermite and glTF',
  ja: 'キーの時刻と ω（rad/s。Hermite と glTF で使用）' };

function change(room: Room<State>, omegas: number[][], k: number, column: number, value: number) {
  const omega = omegas[k].map((x, i) => i === column - 1 ? value : x);
  return column === 0 ? withTime(room.state, k, value) : withOmega(room.state, k, omega);
}

export function fields(room: Room<State>, curves: Curves) {
  const valuesOf = (k: number) => {
    const { times, omegas } = curves.of(room.state);
    return [times[k], ...omegas[k]];
  };
  const field = (k: number, column: number) => {
    const input = element('input', { type: 'number', step: '0.1', 'data-key': `${k}`, 'data-column': `${column}`,
      'aria-label': `${say({ en: 'key', ja: 'キー' })} ${k}: ${say(columns[column])}` });
    input.addEventListener('change', () => {
      const next = input.value === '' ? undefined : change(room, curves.of(room.state).omegas, k, column, +input.value);
      input.setAttribute('aria-invalid', String(!next));
      room.set(next ?? {});
    });
    input.addEventListener('blur', room.refresh);
    return input;
  };
  const inputs = Array.from({ length: count }, (_, k) => columns.map((_, column) => field(k, column)));
  room.side.append(element('table', { class: 'numbers' }, [
    element('caption', {}, say(title)),
    element('thead', {}, element('tr', {}, ['', ...columns].map(text => text === '' ? element('td')
      : element('th', { scope: 'col' }, say(text))))),
    element('tbody', {}, inputs.map((row, k) => element('tr', {}, [element('th', { scope: 'row' }, String(k)),
      ...row.map(input => element('td', {}, input))]))),
  ]));
  room.draw(() => inputs.forEach((row, k) => row.forEach((input, i) => {
    const text = String(+valuesOf(k)[i].toFixed(3));
    if (input !== document.activeElement && input.value !== text)
      input.value = text;
  })));
}
