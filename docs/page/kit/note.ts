// SPDX-License-Identifier: MIT
// A sentence that follows the state.
import type { Room } from '../shell/exhibit';
import { say, type Text } from '../shell/text';
import { element } from './html';

/** Screen readers read it when it changes. */
export function note<S>(room: Room<S>, text: (state: Readonly<S>) => Text | string): HTMLElement {
  const made = element('p', { class: 'note', role: 'status' });
  room.draw(() => {
    const now = say(text(room.state));
    if (made.textContent !== now)
      made.textContent = now;
  });
  return made;
}
