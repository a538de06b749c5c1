// SPDX-License-Identifier: MIT
// The numbers of the present time, as in the report: segment and parameter, the blanks with their weights, the matrix.
import { element } from '../../kit/html';
import type { Room } from '../../shell/exhibit';
import { say } from '../../shell/text';
import { orientationSections, otherPosition, positionSections, type Blank, type Section } from './blanks';
import { keysOf, type Key, type State } from './model';
import { numbersOf, type Numbers } from './numbers';
import { trace } from './sample';
import { liveTable, show, trimmed, type Cell, type Line } from './table';
import { labels, orientationWords, positionWords } from './words';

/* ---- lines ---- */

const all = (name: string, numbers: Numbers): Cell[] => numbers[name].map((_, i) => ({ name: `${name}.${i}` }));

/** A weight with the value that it multiplies, or the sum of them under the values. */
function positionLine(blank: Blank, numbers: Numbers, names: string[]): Line {
  const i = blank.weight;
  return i === undefined ? { ...blank, cells: all('position', numbers), columns: 3 }
    : { ...blank, cells: [{ name: `weight.${i}` }, `${names[i]}: ${numbers.key[i]}`, ...all(`control${i}`, numbers)] };
}

function sectionOf({ position }: State, { weight }: Numbers): Section {
  const found = positionSections[position];
  const fits = found?.blanks.filter(b => b.weight !== undefined).length === weight.length;
  return fits ? found : otherPosition(weight.length, positionWords[position]);
}

function positionLines(state: State, numbers: Numbers, { blanks }: Section): Line[] {
  const hermite = state.position === 'hermite' && numbers.key.length === 4;
  const names = hermite ? ['p0', 'v0', 'p1', 'v1'] : ['p0', 'p1', 'p2', 'p3'];
  return blanks.map(blank => positionLine(blank, numbers, names));
}

const turnSection = ({ orientation }: State): Section =>
  orientationSections[orientation] ?? { title: orientationWords[orientation], blanks: [], code: [] };

function matrixLines(blankD: boolean): Line[] {
  return [0, 1, 2, 3].map(r => ({
    letter: blankD && r === 0 ? 'D' : '', label: { en: `matrix, row ${r}`, ja: `行列の第 ${r + 1} 行` },
    cells: [0, 1, 2, 3].map(c => ({ name: `matrix.${4 * c + r}` })),
  }));
}

const turnLines = (state: State, numbers: Numbers, { blanks }: Section): Line[] => [
  ...blanks.map(blank => ({ ...blank, cells: blank.names!.flatMap(name => all(name, numbers)) })),
  ...matrixLines(state.orientation === 'quat'),
];

/* ---- the segment ---- */

/** ` = (3.25 − 3) / (4 − 3) = `, with an arrow if the parameter is held within 0 and 1. */
function quotient(time: number, from: Key, to: Key | undefined, value: number): string {
  if (!to)
    return ' = ';
  const held = (time < from.time || time > to.time) && value >= 0 && value <= 1;
  return ` = (${trimmed(time)} − ${trimmed(from.time)}) / (${trimmed(to.time)} − ${trimmed(from.time)}) ` +
    (held ? '→ ' : '= ');
}

/** `segment 3  t = (3.25 − 3) / (4 − 3) = 0.25`, and in another line the parameter s of a Bézier curve. */
function place() {
  const line = element('p', { class: 'place' });
  const update = ({ time, position }: State, keys: Key[], numbers: Numbers) => {
    const output = (name: string) => {
      const made = element('b');
      show(made, name, numbers, trimmed);
      return made;
    };
    const { segment: [k], t: [t], parameter: [s], key: [first, , , last] } = numbers;
    const bezier = [element('br'), 's', quotient(time, keys[first], keys[last], s), output('parameter.0')];
    line.replaceChildren(`${say(labels.segment)} `, output('segment.0'), '　t', quotient(time, keys[k], keys[k + 1], t),
      output('t.0'), ...(position === 'bezier' ? bezier : []));
  };
  return { line, update };
}

/* ---- the code of the blanks ---- */

/** The lines that the report asks for, with vecmath; only for curves and slerp. */
function answers() {
  const body = element('pre');
  const made = element('details', { class: 'answers' }, [element('summary', {}, say(labels.answers)), body]);
  const update = (sections: Section[]) => {
    const lines = sections.filter(s => s.code.length).flatMap(s =>
      [`// ${say(s.title)}`, ...s.code.map((code, i) => `${'ABCDE'[i]}  ${code};`)]);
    made.hidden = lines.length === 0;
    if (body.textContent !== lines.join('\n'))
      body.textContent = lines.join('\n');
  };
  return { made, update };
}

export function report(room: Room<State>) {
  const where = place(), code = answers(), note = element('p', { class: 'note' });
  const position = liveTable([labels.weight, labels.control, 'x', 'y', 'z']), turn = liveTable();
  const numbers = element('div', { class: 'report', tabindex: '0', role: 'group', 'aria-label': say(labels.trace) },
    [where.line, position.table, turn.table]);
  room.side.append(numbers, note, code.made);
  room.draw(() => {
    const { state } = room, keys = keysOf(state), t = trace(keys, state.time, state);
    note.textContent = !t ? say(labels.one) : state.program ? say(labels.programNote) : '';
    numbers.hidden = !t;
    if (!t)
      return numbers.querySelectorAll('[data-name]').forEach(cell => cell.removeAttribute('data-name'));
    const of = numbersOf(keys, t, state), curve = sectionOf(state, of), rotation = turnSection(state);
    where.update(state, keys, of);
    position.update(curve.title, positionLines(state, of, curve), of, state.unit);
    turn.update(rotation.title, turnLines(state, of, rotation), of, state.unit);
    code.update([curve, rotation]);
  });
}
