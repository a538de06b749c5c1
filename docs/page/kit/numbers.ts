// SPDX-License-Identifier: MIT
// Tables of numbers. Each cell has its exact value in data-value and its name in data-name, as C prints them.
import type { Room } from '../shell/exhibit';
import { say, type Text } from '../shell/text';
import { element, html } from './html';

export interface Row {
  /** The name in the C program; the values are name.0, name.1, ... */
  name: string;
  /** HTML, or an element. */
  label: Text | string | HTMLElement;
  values: ArrayLike<number>;
  digits?: number;
}

/** The text that reads back as the same number, -0 included. */
export const exact = (value: number) => Object.is(value, -0) ? '-0' : String(value);

/** The text of a number with a minus sign, and without one for zero. */
export const minus = (digits: string) => digits.replace(/^-(0\.?0*)$/, '$1').replace('-', '−');

function fill(cell: HTMLElement, row: Row, i: number) {
  const value = row.values[i], text = value === undefined ? '' : value.toFixed(row.digits ?? 4);
  cell.dataset.name = `${row.name}.${i}`;
  cell.dataset.value = exact(value);
  cell.textContent = minus(text).replace('Infinity', '∞');
}

const heading = (label: Row['label']) => label instanceof HTMLElement
  ? element('th', { scope: 'row' }, label) : html('th', say(label), { scope: 'row' });

/** A table with a row of values for each name; `rows` is called for each drawing. Returns the table. */
export function numberTable<S>(room: Room<S>, caption: Text, rows: () => Row[]): HTMLTableElement {
  const body = element('tbody'), table = element('table', { class: 'numbers' },
    [html('caption', say(caption)), body]);
  let shape = '';
  room.side.append(table);
  room.draw(() => {
    const list = rows(), next = JSON.stringify(list.map(r => [r.name, r.label, r.values.length]));
    if (next !== shape)
      body.replaceChildren(...list.map(row => element('tr', {}, [heading(row.label),
        ...Array.from(row.values, () => element('td'))])));
    shape = next;
    list.forEach((row, k) => {
      for (let i = 0; i < row.values.length; i++)
        fill(body.rows[k].cells[i + 1], row, i);
    });
  });
  return table;
}
