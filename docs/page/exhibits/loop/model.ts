// SPDX-License-Identifier: MIT
// A clip with keys that repeats or not, and the running time between the last turn of the play head and now.
import * as N from 'nakawari/all';
import { clamp } from '../../kit/values';
import { choice, number, numbers } from '../../shell/state';

export const wraps = ['once', 'twice', 'loop', 'pingpong'] as const;
export type Wrap = typeof wraps[number];

export interface State {
  wrap: Wrap;
  /** The running time at the last turn, and now. */
  from: number;
  to: number;
  duration: number;
  /** Ascending, in [0, 1): parts of the duration. */
  keys: number[];
  /** The seconds in which a throw loses half of its speed. */
  friction: number;
}

const most = 12;
export const shownKeys = 5;
const ascend = (list: number[]) => list.length <= most && list.every((x, i) => x >= 0 && x < 1 && !(x <= list[i - 1]));
const keyField = numbers([0, 0.25, 0.5, 0.625]), durationField = number(2, 0.25, 8);
const to = (x: number, parts: number) => Math.round(x * parts) / parts;
// In 64ths of a duration of quarters of a second: all times of keys are exact.
export const fields = {
  wrap: choice<Wrap>('loop', wraps), from: number(0, -1000, 1000), to: number(0.75, -1000, 1000),
  duration: { ...durationField, read: (text: string) => to(durationField.read(text) ?? NaN, 4) || undefined },
  keys: { ...keyField, read: (text: string) => {
    const list = keyField.read(text)?.map(x => to(x, 64));
    return list && list.length > 0 && ascend(list) ? list : undefined;
  } },
  friction: number(1, 0.1, 4),
};

export const timesOf = ({ keys, duration }: State) => keys.map(x => Math.fround(x * duration));

export function rangeOf({ wrap, duration }: State): N.PlaybackRange {
  const { PLAYBACK_CLAMP: clamp, PLAYBACK_LOOP: loop, PLAYBACK_PING_PONG: pingpong } = N;
  const mode = { once: clamp, loop, twice: loop, pingpong }[wrap];
  return { start: 0, duration, closing: 0, before: wrap === 'twice' ? clamp : mode, after: mode,
    beforeCycles: 0, afterCycles: wrap === 'twice' ? 1 : 0 };
}
export const headOf = (state: State, time: number) => N.playbackHeadF64({}, rangeOf(state), Math.fround(time));

/** The keys of one period of the running time, and which keys of the clip they are. Period 0: they do not repeat. */
export function unrolled(state: State) {
  const { wrap, duration } = state, times = timesOf(state), index = times.map((_, k) => k);
  const back = index.filter(k => times[k] > 0).reverse();
  if (wrap === 'twice')
    return { times: [...times, ...times.map(t => t + duration)], index: [...index, ...index], period: 0 };
  if (wrap === 'pingpong')
    return { times: [...times, ...back.map(k => 2 * duration - times[k])], index: [...index, ...back],
      period: 2 * duration };
  return { times, index, period: wrap === 'loop' ? duration : 0 };
}

/** A passing of entry `entry` of the unrolled keys in period `cycle`. */
export interface Passing { entry: number; cycle: number; key: number; at: number }

function passing({ times, index, period }: ReturnType<typeof unrolled>, entry: number, cycle: number): Passing {
  return { entry, cycle, key: index[entry], at: N.playbackOffset(times[entry], 0, period, cycle) };
}

/** All passings within a period of a time, or all there are: the nearest first. */
export function around(state: State, time: number): Passing[] {
  const keys = unrolled(state), { times, period } = keys, middle = period ? Math.floor(time / period) : 0;
  const all = (period ? [-1, 0, 1] : [0]).flatMap(n => times.map((_, entry) => passing(keys, entry, middle + n)));
  return all.sort((a, b) => Math.abs(a.at - time) - Math.abs(b.at - time));
}

/** The nearest passing: at a time, or after it in a direction, 1 or -1. */
export const nearest = (state: State, time: number, way = 0): Passing | undefined =>
  around(state, time).find(p => way === 0 || (p.at - time) * way > 0);

/** The keys that a step passes: their number, and the first of them. */
export function passed(state: State, from: number, to: number): { count: number; list: Passing[] } {
  const keys = unrolled(state), { times, period } = keys, room = 4096, entries = new Uint32Array(room), count = new Uint32Array(1);
  N.playbackPassed({ times, keyCount: times.length, duration: period, from, to, includesFrom: 0n }, entries, room, count);
  const way = to < from ? -1 : 1, list: Passing[] = [];
  for (const entry of entries.slice(0, Math.min(count[0], room))) {
    const last = list.at(-1) ?? around(state, from).find(p => p.entry === entry && (p.at - from) * way > 0)!;
    const on = list.length === 0 || (entry - last.entry) * way > 0;
    list.push(passing(keys, entry, last.cycle + (on ? 0 : way)));
  }
  return { count: count[0], list };
}

/** Whether each of four steps passes a passing: forwards to it and from it, backwards to it and from it. */
export function rule(state: State, { entry, at }: Passing): number[] {
  const { times, period } = unrolled(state), step = state.duration / 8, count = new Uint32Array(1);
  return [[at - step, at], [at, at + step], [at + step, at], [at, at - step]].map(([from, to]) => {
    N.playbackPassed({ times: [times[entry]], keyCount: 1, duration: period, from, to, includesFrom: 0n },
      new Uint32Array(8), 8, count);
    return count[0];
  });
}

/** The running times that a clip without end, or with ends, is shown for. */
export function bounds({ wrap, duration }: State): [number, number] {
  const end = { once: duration, twice: 2 * duration, loop: Infinity, pingpong: Infinity }[wrap];
  return end === Infinity ? [-1000, 1000] : [-duration / 2, end + duration / 2];
}

/** The head moves to a time. Where it turns, a new step begins. */
export function moved(state: State, time: number): Partial<State> {
  const { from, to } = state, [least, most] = bounds(state), next = Math.fround(clamp(time, least, most));
  return { from: (next - to) * (to - from) < 0 ? to : from, to: next };
}

/** A key more at the head, to the 64th of the clip; or the last one less. */
export function withKey(state: State): Partial<State> {
  const part = Math.min(Math.floor(headOf(state, state.to).time / state.duration * 64), 63) / 64;
  const next = [...new Set([...state.keys, part])].sort((a, b) => a - b);
  return ascend(next) ? { keys: next } : {};
}
export const withoutKey = ({ keys }: State): Partial<State> => keys.length > 1 ? { keys: keys.slice(0, -1) } : {};
