// SPDX-License-Identifier: MIT
// The six orders with a bar each: how far the present orientation is from the pole of the order.
import { button, element } from '../../kit/html';
import type { Room } from '../../shell/exhibit';
import { say } from '../../shell/text';
import { inOrder, orders, poseOf, withOrder, type State } from './model';

const title = { en: 'To the pole of each order', ja: '各順序の特異点までの角度' };

export function orderBars(room: Room<State>, parent: HTMLElement) {
  const rows = orders.map(order => {
    const bar = element('span', { class: 'length' }), value = element('span', { class: 'value' });
    const made = button('', () => room.set(withOrder(room.state, order)), 'order');
    made.append(element('span', {}, order), element('span', { class: 'track' }, bar), value);
    return { order, made, bar, value };
  });
  parent.append(element('div', { role: 'group', 'aria-label': say(title) },
    [element('div', {}, say(title)), ...rows.map(row => row.made)]));
  room.draw(() => {
    const { q } = poseOf(room.state);
    for (const { order, made, bar, value } of rows) {
      const { distance } = inOrder(q, order);
      made.setAttribute('aria-pressed', String(order === room.state.order));
      bar.style.width = `${distance / 0.9}%`;
      value.textContent = `${distance.toFixed(1)}°`;
    }
  });
}
