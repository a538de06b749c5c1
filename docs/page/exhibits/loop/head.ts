// SPDX-License-Identifier: MIT
// The play head: dragged, thrown with friction, and the keys that it passes.
import * as N from 'nakawari/all';
import type { Room } from '../../shell/exhibit';
import { moved, passed, type Passing, type State } from './model';
import type { Head } from './ring';

export interface PlayHead extends Head {
  /** The keys that the steps of the screen have passed since the last turn. */
  counted(): number;
  recount(): void;
}

/** A throw ends where the speed, which is halved again and again, has led. */
const reach = (speed: number, half: number) => speed * half / Math.LN2;

/** `passes` receives the keys of each step and its direction. `still`: a throw arrives at once. */
export function headIn(room: Room<State>, still: () => boolean,
  passes: (list: Passing[], way: number) => void): PlayHead {
  let goal: number | undefined, last = 0, sum = 0;
  const recount = () => { sum = passed(room.state, room.state.from, room.state.to).count; };
  const to = (time: number) => {
    const { state } = room, next = moved(state, time), step = passed(state, state.to, next.to!);
    sum = next.from === state.from ? sum + step.count : step.count;
    passes(step.list, Math.sign(next.to! - state.to));
    room.set(next);
  };
  const go = (speed: number) => {
    const { friction, to: now } = room.state, end = now + reach(speed, friction);
    [goal, last] = [speed === 0 || still() ? undefined : end, performance.now()];
    if (speed !== 0 && still())
      to(end);
    room.refresh();
  };
  room.draw(() => {
    const now = performance.now(), seconds = (now - last) / 1000, { state } = room;
    last = now;
    if (goal === undefined)
      return;
    const next = N.damperStep(state.to, goal, state.friction, seconds), arrived = Math.abs(goal - next) < 0.002;
    to(arrived ? goal : next);
    if (arrived || room.state.to === state.to && seconds > 0)
      goal = undefined;
  });
  recount();
  return { to, go, recount, by: seconds => to(room.state.to + seconds), counted: () => sum };
}
