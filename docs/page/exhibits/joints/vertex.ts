// SPDX-License-Identifier: MIT
// The chosen vertex in numbers: its four weights, what each joint makes of it, and their weighted sum.
import { element, html } from '../../kit/html';
import { exact } from '../../kit/numbers';
import { vertex } from '../../kit/skinned';
import type { Room } from '../../shell/exhibit';
import { say } from '../../shell/text';
import { joints, positions } from './mesh';
import type { State } from './model';
import { chosen, movedBy, type Skinned } from './skin';
import { labels } from './words';

const narrow = matchMedia('(max-width: 30rem)');
interface Cell { name: string; value: number; digits: number }
const cells = (name: string, values: ArrayLike<number>, digits = 4): Cell[] => Array.from(values, (value, i) =>
  ({ name: `${name}.${i}`, value, digits }));

function rows(state: State, now: Skinned): (Cell | undefined)[][] {
  const v = chosen(state), weights = now.weights.subarray(v * joints, (v + 1) * joints);
  const listed = cells('weights', weights, 0), shares = cells('share', Array.from(weights, w => w / 65535));
  const sum = weights.reduce((a, b) => a + b, 0);
  return [
    [undefined, undefined, ...cells('vertex', vertex(positions, v))],
    ...movedBy(state, now).map((p, i) => [listed[i], shares[i], ...cells(`by${i}`, p)]),
    [...cells('sum', [sum], 0), { name: 'sum.1', value: sum / 65535, digits: 4 },
      ...cells('moved', vertex(now.positions, v))],
  ];
}

function fill(td: HTMLElement, cell: Cell | undefined) {
  if (!cell)
    return;
  td.dataset.name = cell.name;
  td.dataset.value = exact(cell.value);
  const digits = Math.min(cell.digits, narrow.matches ? 3 : 4);
  td.textContent = cell.value.toFixed(digits).replace(/^-(0\.?0*)$/, '$1').replace('-', '−');
}

export function vertexTable(room: Room<State>, now: () => Skinned) {
  const names = [labels.bind, ...Array.from({ length: joints }, (_, i) => labels.moves(i)), labels.blended];
  const body = element('tbody', {}, names.map(name => element('tr', {}, [html('th', say(name), { scope: 'row' }),
    ...labels.columns.map(() => element('td'))])));
  const head = element('tr', {}, [element('td'), ...labels.columns.map(name =>
    html('th', name, { scope: 'col', style: 'text-align: right' }))]);
  room.side.append(element('table', { class: 'numbers vertex' },
    [html('caption', say(labels.vertexTable)), element('thead', {}, head), body]));
  room.draw(() => rows(room.state, now()).forEach((list, r) =>
    list.forEach((cell, k) => fill(body.rows[r].cells[k + 1], cell))));
}
