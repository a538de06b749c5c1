// SPDX-License-Identifier: MIT
// The numbers of the present time: the blanks of the report with their weights, and the trace.
import { element, html } from '../../kit/html';
import { exact } from '../../kit/numbers';
import type { Room } from '../../shell/exhibit';
import { say, type Text } from '../../shell/text';
import { keysOf, type State } from './model';
import { numbersOf, type Numbers } from './numbers';
import { trace } from './sample';
import { labels } from './words';

/** A row: the blank, the formula or label (HTML), and the names of the numbers, `name` or `name.index`. */
interface Row { blank?: string; label: Text | string; names: string[] }

const row = (blank: string, label: Text | string, ...names: string[]): Row => ({ blank, label, names });

const hermite = [
  row('A', tex`a = H_0(t) = 2t^3 - 3t^2 + 1`, 'weight.0'), row('B', tex`b = H_1(t) = -2t^3 + 3t^2`, 'weight.2'),
  row('C', tex`c = h_0(t) = t^3 - 2t^2 + t`, 'weight.1'), row('D', tex`d = h_1(t) = t^3 - t^2`, 'weight.3'),
  row('E', tex`p = a\,p_0 + b\,p_1 + c\,v_0 + d\,v_1`, 'position'),
];
const sum = row('E', tex`p = a_0 p_0 + a_1 p_1 + a_2 p_2 + a_3 p_3`, 'position');
const bezier = [
  row('A', tex`a_0 = (1-s)^3`, 'weight.0'), row('B', tex`a_1 = 3(1-s)^2 s`, 'weight.1'),
  row('C', tex`a_2 = 3(1-s)s^2`, 'weight.2'), row('D', tex`a_3 = s^3`, 'weight.3'), sum,
];
const bspline = [
  row('A', tex`a_0 = -\tfrac16 t^3 + \tfrac12 t^2 - \tfrac12 t + \tfrac16`, 'weight.0'),
  row('B', tex`a_1 = \tfrac12 t^3 - t^2 + \tfrac23`, 'weight.1'),
  row('C', tex`a_2 = -\tfrac12 t^3 + \tfrac12 t^2 + \tfrac12 t + \tfrac16`, 'weight.2'),
  row('D', tex`a_3 = \tfrac16 t^3`, 'weight.3'), sum,
];
const slerp = [
  row('A', { en: 'q0 of the first key', ja: '最初のキーの四元数 q0' }, 'q0'),
  row('B', { en: 'q0·q1 of the keys; if negative, q1 = −q1', ja: 'キーの内積 q0·q1。負なら q1 = −q1' }, 'dot'),
  row('B', { en: 'q1 after it', ja: '処理後の q1' }, 'q1'),
  row('C', { en: 'θ, radians; the turn 2θ, degrees', ja: 'θ（ラジアン）、回転角 2θ（度）' }, 'theta', 'turn'),
  row('C', tex`\tfrac{\sin (1-t)\theta}{\sin\theta},\ \tfrac{\sin t\theta}{\sin\theta}`, 'share'),
  row('C', { en: 'q, the sum', ja: '和 q' }, 'q'),
  row('D', { en: 'the matrix, below', ja: '下の行列' }),
];
const euler = [
  row('', { en: 'first key: pitch, yaw, roll, radians', ja: '最初のキー：仰角、方位角、旋回角（ラジアン）' }, 'angles0'),
  row('', { en: 'second key', ja: '次のキー' }, 'angles1'),
  row('', { en: 'weights ' + tex`1 - t,\ t`, ja: '重み ' + tex`1 - t,\ t` }, 'share'),
  row('', { en: 'the angles', ja: '補間した角度' }, 'angles'),
];

function positionRows({ position }: State, numbers: Numbers): Row[] {
  const four = numbers.weight.length === 4;
  const found = four ? ({ hermite, bezier, bspline } as Record<string, Row[]>)[position] : undefined;
  return found ?? [...numbers.weight.map((_, i) => row('', `w${i}`, `weight.${i}`)), row('', 'p', 'position')];
}

function controlRows({ position }: State, numbers: Numbers): Row[] {
  const names = position === 'hermite' && numbers.key.length === 4 ? ['p0', 'v0', 'p1', 'v1'] : ['p0', 'p1', 'p2', 'p3'];
  const word = say(labels.key);
  return numbers.key.map((k, i) => row('', `${names[i]} (${word} ${k})`, `control${i}`));
}

function rowsOf(state: State, numbers: Numbers): Row[] {
  const turn = state.orientation === 'quat' || state.orientation === 'nlerp' ? slerp
    : state.orientation.startsWith('euler') ? euler : [];
  return [
    row('', { en: 'segment', ja: '区間' }, 'segment'), row('', 't', 't'),
    ...(state.position === 'bezier' ? [row('', 's', 'parameter')] : []),
    ...controlRows(state, numbers), ...positionRows(state, numbers), ...turn,
    ...[0, 1, 2, 3].map(r => row('', { en: `matrix, row ${r}`, ja: `行列の第 ${r + 1} 行` },
      ...[0, 1, 2, 3].map(c => `matrix.${4 * c + r}`))),
  ];
}

/** The cells of a name: all its numbers, or one. */
function cellsOf(name: string, numbers: Numbers): [string, number][] {
  const [group, index] = name.split('.'), values = numbers[group] ?? [];
  return index === undefined ? values.map((x, i) => [`${group}.${i}`, x]) : [[name, values[+index]]];
}

const text = (x: number) => String(+(x + 0).toPrecision(9)).replace('-', '−');

export function report(room: Room<State>) {
  const body = element('tbody');
  const table = element('table', { class: 'numbers trace' }, [element('caption', {}, say(labels.trace)), body]);
  const note = element('p', { role: 'note' });
  room.side.append(element('div', { style: 'overflow-x: auto', tabindex: '0', role: 'group', 'aria-label': say(labels.trace) }, table), note);
  let shape = '';
  room.draw(() => {
    const { state } = room, keys = keysOf(state), t = trace(keys, state.time, state);
    note.textContent = t ? '' : say(labels.one);
    const numbers = t && numbersOf(keys, t, state), rows = numbers ? rowsOf(state, numbers) : [];
    const cells = rows.map(r => r.names.flatMap(name => cellsOf(name, numbers!)));
    const next = JSON.stringify([rows.map(r => [r.blank, r.label]), cells.map(list => list.map(([name]) => name))]);
    if (next !== shape)
      body.replaceChildren(...rows.map((r, k) => element('tr', {}, [
        element('th', { scope: 'row' }, [...(r.blank ? [`${say(labels.blank)} ${r.blank} `] : []), html('span', say(r.label))]),
        ...cells[k].map(() => element('td'))])));
    shape = next;
    cells.forEach((list, k) => list.forEach(([name, value], i) => {
      const cell = body.rows[k].cells[i + 1];
      cell.dataset.name = name;
      cell.dataset.value = exact(value);
      cell.textContent = text(value);
    }));
  });
}
