// SPDX-License-Identifier: MIT
// A loop with keys, and the running time between the last turn of the play head and now.
import * as N from 'nakawari/all';
import { list, literal, program } from '../../kit/code';
import { number, numbers } from '../../shell/state';

export interface State {
  /** The running time at the last turn, and now. */
  from: number;
  to: number;
  duration: number;
  /** Ascending, in [0, 1): parts of the duration. */
  keys: number[];
}

const most = 12;
export const shownKeys = 5;
const ascend = (list: number[]) => list.length <= most && list.every((x, i) => x >= 0 && x < 1 && !(x <= list[i - 1]));
export const fields = {
  from: number(0, -1000, 1000), to: number(0.75, -1000, 1000), duration: number(2, 0.25, 8),
  keys: numbers([0, 0.25, 0.5, 0.625], ascend),
};

export const timesOf = ({ keys, duration }: State) => keys.map(x => Math.fround(x * duration));
export const headOf = ({ duration }: State, time: number) =>
  N.playbackHead([0, 0], N.PLAYBACK_LOOP, 0, duration, time);

/** The keys that a step passes: the number, and the first of them. */
export function passed(state: State, from: number, to: number): { count: number; keys: number[] } {
  const keys = new Uint32Array(most), count = new Uint32Array(1);
  const times = timesOf(state);
  N.playbackPassed({ times, keyCount: times.length, duration: state.duration, from, to }, keys, count, most);
  return { count: count[0], keys: [...keys.slice(0, count[0])] };
}

/** The head moves to a time. Where it turns, a new step begins. */
export function moved({ from, to }: State, time: number): Partial<State> {
  const next = Math.fround(Math.min(Math.max(time, -1000), 1000));
  return { from: (next - to) * (to - from) < 0 ? to : from, to: next };
}

/** The running time of the next key in a direction, 1 or -1. */
export function nextKey(state: State, way: number): number {
  const times = timesOf(state), first = Math.floor(state.to / state.duration);
  const all = [-1, 0, 1].flatMap(n => times.map(t => Math.fround(t + (first + n) * state.duration)));
  const ahead = all.filter(t => (t - state.to) * way > 0);
  return ahead.length ? way * Math.min(...ahead.map(t => t * way)) : state.to;
}

/** A key more at the head, to the 64th of the loop; or the last one less. */
export function withKey(state: State): Partial<State> {
  const part = Math.floor(headOf(state, state.to)[0] / state.duration * 64) / 64;
  const next = [...new Set([...state.keys, part])].sort((a, b) => a - b);
  return ascend(next) ? { keys: next } : {};
}
export const withoutKey = ({ keys }: State): Partial<State> => keys.length > 1 ? { keys: keys.slice(0, -1) } : {};

export const code = (state: State) => program(`
static const float times[] = ${list(timesOf(state))};
const float from = ${literal(state.from)}, to = ${literal(state.to)}, duration = ${literal(state.duration)};
const nkw_playback_step step = {times, ${state.keys.length}, duration, from, to};
const nkw_play_head head = nkw_playback_head(NKW_PLAYBACK_LOOP, 0.0f, duration, to);
size_t keys[${shownKeys}], passed;
if (nkw_playback_passed(&step, keys, &passed, ${shownKeys}) != NKW_OK)
    return 1;
show("step", 0, (double)from);
show("step", 1, (double)to);
show("head", 0, (double)head.time);
show("head", 1, (double)head.cycle);
show("passed", 0, (double)passed);
for (size_t i = 0; i < passed && i < ${shownKeys}; i++)
    show("key", (int)i, (double)keys[i]);
`);
