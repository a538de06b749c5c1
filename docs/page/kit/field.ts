// SPDX-License-Identifier: MIT
// Lists of words of which the state has one, with a label above them.
import type { Room } from '../shell/exhibit';
import { say, type Text } from '../shell/text';
import { element } from './html';

export const options = (words: Record<string, Text>) => Object.entries(words).map(([value, text]) =>
  element('option', { value }, say(text)));

/** A list for the field `name`; `content` are its options. */
export function field<S>(room: Room<S>, name: keyof S & string, label: Text, content: HTMLElement[]) {
  const made = element('select', {}, content);
  made.addEventListener('change', () => room.set({
    [name]: typeof room.state[name] === 'number' ? Number(made.value) : made.value } as Partial<S>));
  room.draw(() => { made.value = String(room.state[name]); });
  return element('label', { class: 'field' }, [say(label), made]);
}
