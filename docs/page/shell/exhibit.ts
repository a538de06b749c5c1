// SPDX-License-Identifier: MIT
// What an exhibit is, and what it is given.
import type { Clock } from './clock';
import type { Fields } from './state';
import type { Text } from './text';

/** An entry of the list of exhibits. */
export interface Entry {
  /** The name in the address and of its files. */
  id: string;
  title: Text;
  open(): Promise<Exhibit<object>>;
}

export interface Exhibit<S> {
  /** One or two sentences: what to try, and what to see. HTML. */
  lead: Text;
  fields: Fields<S>;
  /** With a field `time`: the range of the clock, in seconds. The frame then shows the play bar. */
  range?(state: S): { start: number; end: number };
  mount(room: Room<S>): void;
  /** A C program that prints the numbers that the exhibit shows (kit/code.ts). */
  code?(state: S): string;
}

/** The name of a key as in KeyboardEvent.key, what it does, and the function. */
export interface Shortcut {
  key: string;
  does: Text;
  run(): void;
}

/** An exhibit that is open: its state, its parts of the page, its frames. */
export interface Room<S> {
  readonly state: Readonly<S>;
  /** Changes the state: the address follows, and everything is drawn in the next frame. */
  set(change: Partial<S>): void;
  /** Where the exhibit draws, and where its controls and numbers are. */
  readonly stage: HTMLElement;
  readonly side: HTMLElement;
  /** Adds a function that is called in the next frame, after each change of the state, and in each frame of play. */
  draw(f: (seconds: number) => void): void;
  /** Asks for a frame without a change of the state. */
  refresh(): void;
  shortcuts(list: Shortcut[]): void;
  readonly clock: Clock;
  /** Calls f when the exhibit is left. */
  closed(f: () => void): void;
  /** Reads a message to users of screen readers, and shows it for a moment. */
  announce(text: Text): void;
}
