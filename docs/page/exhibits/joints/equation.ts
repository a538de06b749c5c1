// SPDX-License-Identifier: MIT
// The product of the chosen joint as one equation of 4x4 blocks.
import { element, html } from '../../kit/html';
import { exact } from '../../kit/numbers';
import type { Room } from '../../shell/exhibit';
import { say } from '../../shell/text';
import { angles, factors, row, type Factor, type State } from './model';
import type { Skinned } from './skin';
import { blockWords, labels } from './words';

type Name = Factor | 'M';
const symbols: Record<Name, (i: number) => string> = {
  M: i => `M<sub>${i}</sub>`, P: i => i ? `M<sub>${i - 1}</sub>` : '1', T: i => `T<sub>${i}</sub>`,
  J: i => `J<sub>${i}</sub>`, I: i => `T<sub>${i}</sub><sup>−1</sup>`,
};

/** Whole numbers without decimals, so that ones and zeros are seen at once. */
const short = (x: number, digits: number) => (Number.isInteger(x) ? String(x) : x.toFixed(digits)).replace('-', '−')
  .replace(/^−(0(\.0*)?)$/, '$1');

function block(name: Name, joint: number, note: string) {
  const rows = [0, 1, 2, 3].map(() => element('tr', {}, [0, 1, 2, 3].map(() => element('td'))));
  const made = element('table', { class: 'matrix' },
    [html('caption', `${symbols[name](joint)} <small>${note}</small>`), element('tbody', {}, rows)]);
  return { made, show: (m: number[], digits: number) => rows.forEach((tr, r) => row(m, r).forEach((x, k) => {
    const cell = tr.cells[k];
    cell.dataset.name = `${name}${r}.${k}`;
    cell.dataset.value = exact(x);
    cell.textContent = short(x, digits);
  })) };
}

const narrow = matchMedia('(max-width: 30rem)');
const sign = (text: string) => element('span', { 'aria-hidden': 'true' }, text);

export function equation(room: Room<State>, now: () => Skinned) {
  const host = element('div', { class: 'equation', role: 'group', 'aria-label': say(labels.matrices) });
  let shape = '', blocks: [Name, ReturnType<typeof block>][] = [];
  const build = ({ order, joint }: State) => {
    const inner = factors(order), flip = order === 'transposed';
    blocks = (['M', ...inner] as Name[]).map(name =>
      [name, block(name, joint, say(name === 'P' && !joint ? labels.noParent : blockWords[name]))]);
    host.replaceChildren(...blocks.flatMap(([, { made }], i) =>
      [...(i ? [sign(i > 1 ? '·' : flip ? '= (' : '=')] : []), made]), ...(flip ? [sign(')ᵀ')] : []));
  };
  room.stage.after(host);
  room.draw(() => {
    const { state } = room, next = `${state.order} ${state.joint}`, digits = narrow.matches ? 2 : 3;
    if (next !== shape)
      build(state);
    shape = next;
    const turned = blocks.find(([name]) => name === 'J')![1].made.querySelector('small')!;
    turned.textContent = labels.turned(state, angles(state)[state.joint]);
    blocks.forEach(([name, { show }]) => show(now().list[state.joint][name], digits));
  });
}
