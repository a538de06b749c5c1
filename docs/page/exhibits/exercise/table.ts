// SPDX-License-Identifier: MIT
// Tables of numbers with the letters of the blanks.
import { element, html } from '../../kit/html';
import { exact, minus } from '../../kit/numbers';
import { clamp } from '../../kit/values';
import { say, type Text } from '../../shell/text';
import type { Numbers } from './numbers';
import { labels } from './words';

/** A number by its name, `name.index`, or a text. */
export type Cell = { name: string } | string;
export interface Line {
  letter: string;
  /** HTML. */
  label: Text | string;
  cells: Cell[];
  /** The columns that the label takes. */
  columns?: number;
}

/** At most six decimals. */
export const trimmed = (x: number) => minus(String(+x.toFixed(6)));
const lengths = /^(control\d|position|matrix\.1[234])/;

/** Six decimals of weights, four of other numbers; lengths are of the size of the layout. */
function text(x: number, name: string, unit: number): string {
  const digits = lengths.test(name) ? 4 - Math.round(Math.log10(unit)) : name.startsWith('weight') ? 6 : 4;
  return minus(x.toFixed(clamp(digits, 0, 20)));
}

/** Writes a number into an element, with its name and its exact value. */
export function show(cell: HTMLElement, name: string, numbers: Numbers, write: (x: number) => string) {
  const [group, index] = name.split('.'), value = numbers[group][+index];
  cell.dataset.name = name;
  cell.dataset.value = cell.title = exact(value);
  cell.textContent = write(value);
}

function heading({ letter, label, columns }: Line) {
  const name = `${say(labels.blank)} ${letter}`, blank = element('b', { class: 'blank', title: name }, letter);
  const made = element('th', { scope: 'row' }, [...(letter ? [blank] : []), html('span', say(label))]);
  made.colSpan = columns ?? 1;
  return made;
}

/** A table that is made again when its lines change, and filled at each drawing. */
export function liveTable(head: (string | Text)[] = []) {
  const caption = element('caption'), body = element('tbody');
  const cells = [element('td'), ...head.map(h => element('th', { scope: 'col' }, say(h)))];
  const top = head.length ? [element('thead', {}, element('tr', {}, cells))] : [];
  const table = element('table', { class: 'numbers' }, [caption, ...top, body]);
  let shape = '';
  const update = (title: Text, lines: Line[], numbers: Numbers, unit: number) => {
    const next = JSON.stringify([title, lines]);
    if (next !== shape) {
      caption.textContent = say(title);
      body.replaceChildren(...lines.map(l => element('tr', {}, [heading(l),
        ...l.cells.map(cell => element('td', {}, typeof cell === 'string' ? cell : ''))])));
    }
    shape = next;
    lines.forEach((l, k) => l.cells.forEach((cell, i) => {
      if (typeof cell !== 'string')
        show(body.rows[k].cells[i + 1], cell.name, numbers, x => text(x, cell.name, unit));
    }));
  };
  return { table, update };
}
