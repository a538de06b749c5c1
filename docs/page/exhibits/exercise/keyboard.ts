// SPDX-License-Identifier: MIT
// The keyboard: the keys of the exercise's program for the whole exhibit, and those of the canvas.
import * as N from 'nakawari/all';
import { clamp, zeros } from '../../kit/values';
import type { Room, Shortcut } from '../../shell/exhibit';
import {
  addKey, deleteKey, keysOf, moved, nextOf, nextOperation, range, replaceKey, setScene, taught, turned,
  views, type State,
} from './model';
import { scenes } from './scenes';
import { labels } from './words';

const steps = { move: 0.1, turn: 5, time: 0.1 };

/* ---- the keys of the program, and of the times ---- */

/** Space plays from the start, as in the exercise: all frames are left. */
function play({ clock, state, set }: Room<State>) {
  if (clock.playing)
    return clock.stop();
  set({ view: state.view === 'frames' ? 'plain' : state.view });
  clock.restart();
}

function stepTime({ state, set }: Room<State>, by: number) {
  const { start, end } = range(keysOf(state));
  set({ time: clamp(Math.fround(state.time + by), start, end) });
}

/** The time of the chosen key, in whole steps; the library refuses times that do not ascend. */
function stepKey({ state, set }: Room<State>, by: number) {
  const keys = keysOf(state), key = keys[state.selected];
  if (key)
    set(replaceKey(keys, state.selected, { time: Math.fround(+(key.time + by).toFixed(6)) }) ?? {});
}

export function shortcuts(room: Room<State>): Shortcut[] {
  const { set } = room, now = () => room.state;
  return [
    ...scenes.map(({ title, reason }, i) => ({
      key: String(i + 1), does: { en: `${title.en}. ${reason.en}`, ja: `${title.ja}。${reason.ja}` },
      run: () => set(setScene(i + 1)),
    })),
    { key: 's', does: labels.stop, run: () => room.clock.toggle() },
    { key: ' ', does: labels.play, run: () => play(room) },
    { key: 'p', does: labels.position, run: () => set({ position: nextOf(taught.positions, now().position) }) },
    { key: 'o', does: labels.orientation,
      run: () => set({ orientation: nextOf(taught.orientations, now().orientation) }) },
    { key: 'f', does: labels.view, run: () => set({ view: nextOf(views, now().view) }) },
    { key: 'a', does: labels.titles.add, run: () => set(addKey(keysOf(now()))) },
    { key: 'd', does: labels.titles.remove, run: () => set(deleteKey(keysOf(now()), now())) },
    { key: 't', does: labels.titles.axes, run: () => set({ axes: !now().axes }) },
    { key: 'm', does: labels.operation, run: () => set(now().clicks ? nextOperation(now()) : { clicks: true }) },
    { key: ',', does: labels.earlier, run: () => stepTime(room, -steps.time) },
    { key: '.', does: labels.later, run: () => stepTime(room, steps.time) },
    { key: '-', does: labels.keyEarlier, run: () => stepKey(room, -steps.time) },
    { key: '+', does: labels.keyLater, run: () => stepKey(room, steps.time) },
  ];
}

/* ---- the canvas ---- */

const directions: Record<string, number[]> = {
  ArrowRight: [1, 0, 0], ArrowLeft: [-1, 0, 0], PageUp: [0, 1, 0], PageDown: [0, -1, 0], ArrowDown: [0, 0, 1],
  ArrowUp: [0, 0, -1],
};
const spins: Record<string, number[]> = {
  ArrowLeft: [0, 1, 0], ArrowRight: [0, -1, 0], ArrowUp: [1, 0, 0], ArrowDown: [-1, 0, 0], PageUp: [0, 0, 1],
  PageDown: [0, 0, -1],
};

/** The state after a key of the canvas, or undefined. With Shift, or if clicks turn, keys turn; with Shift, Tab goes back. */
function pressed(state: State, key: string, shift: boolean): Partial<State> | undefined {
  const keys = keysOf(state), chosen = keys[state.selected], next = state.selected + (shift ? -1 : 1);
  if (key === 'Tab')
    return keys[next] && { selected: next };
  if (key === 'Escape')
    return { selected: -1 };
  const turns = shift || (state.clicks && state.turns), way = (turns ? spins : directions)[key];
  if (!chosen || !way)
    return undefined;
  const by = N.vec3Scale(zeros(3), way, steps.move * state.unit);
  const change = turns ? turned(chosen, way, N.radiansFromDegrees(steps.turn), state.local)
    : moved(chosen, state.local ? N.quatRotate(by, chosen.orientation, by) : by);
  return replaceKey(keys, state.selected, change) ?? {};
}

export function canvasKeys(room: Room<State>, canvas: HTMLCanvasElement) {
  canvas.addEventListener('keydown', e => {
    const change = pressed(room.state, e.key, e.shiftKey);
    if (!change)
      return;
    e.preventDefault();
    room.set(change);
  });
}
