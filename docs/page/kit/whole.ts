// SPDX-License-Identifier: MIT
import { type Field, number } from '../shell/state';

/** A whole number of the state in [least, most]. */
export function whole(initial: number, least: number, most: number): Field<number> {
  const field = number(initial, least, most);
  return {
    ...field,
    read(text) {
      const x = field.read(text);
      return x === undefined ? x : Math.round(x);
    },
  };
}
