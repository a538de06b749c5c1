// SPDX-License-Identifier: MIT
// The state of an exhibit is in the address of the page: #ID?name=value&... A default is left out.

/** How a value of the state is written in the address. `read` returns undefined for a text that is not a value. */
export interface Field<T> {
  initial: T;
  read(text: string): T | undefined;
  write(value: T): string;
}
export type Fields<S> = { [K in keyof S]: Field<S[K]> };

/** A number in [least, most]. */
export const number = (initial: number, least = -Infinity, most = Infinity): Field<number> => ({
  initial,
  read: text => {
    const x = text.trim() === '' ? NaN : Number(text);
    return Number.isFinite(x) ? Math.min(Math.max(x, least), most) : undefined;
  },
  write: x => String(+x.toPrecision(9)),
});

/** A whole number in [least, most]. */
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

/** One of a list of words. */
export const choice = <T extends string>(initial: T, words: readonly T[]): Field<T> => ({
  initial,
  read: text => words.find(word => word === text),
  write: word => word,
});

export const flag = (initial: boolean): Field<boolean> => ({
  initial,
  read: text => text === '1' ? true : text === '0' ? false : undefined,
  write: on => on ? '1' : '0',
});

/** Some words of a list, none of which contains an underscore. */
export const some = <T extends string>(initial: T[], words: readonly T[]): Field<T[]> => ({
  initial,
  read: text => {
    const list = text.split('_').filter(Boolean) as T[];
    return list.every(word => words.includes(word)) ? list : undefined;
  },
  write: list => list.join('_'),
});

/** A list of numbers; `valid` refuses lists of a wrong shape. */
export const numbers = (initial: number[], valid: (list: number[]) => boolean = () => true): Field<number[]> => ({
  initial,
  read: text => {
    const list = text === '' ? [] : text.split('_').map(part => part === '' ? NaN : Number(part));
    return list.every(x => Math.abs(x) <= 1e6) && valid(list) ? list : undefined;
  },
  write: list => list.map(x => String(+x.toPrecision(9))).join('_'),
});

/** The values that `query` has, and the defaults for the rest. */
export function read<S>(fields: Fields<S>, query: URLSearchParams): S {
  const one = <K extends keyof S>(name: K): S[K] => {
    const text = query.get(name as string);
    return (text === null ? undefined : fields[name].read(text)) ?? fields[name].initial;
  };
  return Object.fromEntries((Object.keys(fields) as (keyof S)[]).map(name => [name, one(name)])) as S;
}

/** Writes the values that are not the defaults into `query`. */
export function write<S>(fields: Fields<S>, state: S, query: URLSearchParams) {
  for (const name of Object.keys(fields) as (keyof S)[]) {
    const field = fields[name], text = field.write(state[name]);
    if (text !== field.write(field.initial))
      query.set(name as string, text);
  }
}

/** The present address: the exhibit, and what follows the question mark. */
export function address(): { id: string; query: URLSearchParams } {
  const [id, query] = location.hash.slice(1).split('?');
  return { id, query: new URLSearchParams(query) };
}

let waiting = 0;
/** Shows a state in the address. */
export function show(id: string, query: URLSearchParams) {
  clearTimeout(waiting);
  history.replaceState(null, '', `#${id}?${query}`);
}

/** The same a quarter of a second after the last change: browsers refuse more. */
export function showLater(id: string, query: () => URLSearchParams) {
  clearTimeout(waiting);
  waiting = setTimeout(() => show(id, query()), 250);
}

/** The change that waits is not shown. */
export const forget = () => clearTimeout(waiting);
