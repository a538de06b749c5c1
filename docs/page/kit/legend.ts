// SPDX-License-Identifier: MIT
// Legends: a toggle button for each curve, which shows or hides it.
import type { Room } from '../shell/exhibit';
import { say, type Text } from '../shell/text';
import { button, element } from './html';

export interface Series {
  /** Its name in the state. */
  name?: string;
  label: Text | string;
  /** A CSS variable: c0 to c7, x, y, z, ink. */
  colour: string;
  width?: number;
  dash?: number[];
}

export interface Legend {
  readonly series: Series[];
  /** All buttons. A plot puts them above itself, unless they have a place already. */
  readonly element: HTMLElement;
  /** One of them, to be placed elsewhere, for instance in a table of numbers. */
  readonly entries: HTMLButtonElement[];
  shows(i: number): boolean;
}

type Lists<S> = { [K in keyof S]: S[K] extends string[] ? K : never }[keyof S] & string;

function entry(series: Series, toggle: () => void) {
  const made = button('', toggle, 'curve'), { colour, dash } = series;
  made.append(element('span', { class: dash ? 'stroke dashed' : 'stroke', style: `color: var(--${colour})` }),
    say(series.label));
  return made;
}

/** The legend of some curves, for one plot or several. `field`: the list in the state of the names that are hidden. */
export function legend<S>(room: Room<S>, series: Series[], field?: Lists<S>): Legend {
  let own: string[] = [];
  const hidden = () => field ? room.state[field] as string[] : own, name = (i: number) => series[i].name ?? String(i);
  const shows = (i: number) => !hidden().includes(name(i));
  const toggle = (i: number) => {
    const next = shows(i) ? [...hidden(), name(i)] : hidden().filter(word => word !== name(i));
    own = next;
    room.set((field ? { [field]: next } : {}) as Partial<S>);
  };
  const entries = series.map((s, i) => entry(s, () => toggle(i)));
  room.draw(() => entries.forEach((made, i) => made.setAttribute('aria-pressed', String(shows(i)))));
  const attributes = { class: 'legend', role: 'group', 'aria-label': say({ en: 'Curves', ja: '曲線' }) };
  return { series, element: element('div', attributes, entries), entries, shows };
}
