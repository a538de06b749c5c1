// SPDX-License-Identifier: MIT
// The state of the exhibit: one of four modes, and what they show.
import { turnFields, type Turn } from '../../kit/space';
import { clamp } from '../../kit/values';
import type { Room } from '../../shell/exhibit';
import { choice, flag, number, numbers, some } from '../../shell/state';
import type { Rig } from './rig';

export const modes = ['change', 'pair', 'additive', 'springs'] as const;
export type Mode = typeof modes[number];
export const clipNames = ['walk', 'wave', 'hop'] as const;
type ClipName = typeof clipNames[number];
export const axisNames = ['x', 'y', 'z'] as const;
const jointNames = ['hips', 'spine', 'chest', 'neck', 'head', 'arm.L', 'forearm.L', 'hand.L', 'arm.R', 'forearm.R',
  'hand.R', 'thigh.L', 'shin.L', 'foot.L', 'thigh.R', 'shin.R', 'foot.R'];

const curveNames = ['old', 'new', 'fade', 'inertia', 'dead', 'from', 'mean', 'to', 'base', 'clip', 'sum', 'goal',
  'chosen', 'critical', 'over'];

export interface State extends Turn {
  mode: Mode;
  /** The curves that are not shown. */
  hidden: string[];
  time: number;
  from: ClipName;
  to: ClipName;
  /** The second clip of the mean. */
  other: ClipName;
  joint: string;
  axis: typeof axisNames[number];
  /* change: when it begins, where the new clip begins, seconds */
  at: number;
  start: number;
  duration: number;
  coast: number;
  smooth: boolean;
  /* pair and additive */
  weight: number;
  phase: number;
  reference: 'first' | 'rest';
  side: 'local' | 'parent';
  /* springs: time and value of each goal */
  half: number;
  ratio: number;
  goals: number[];
}

/** What a mode is: it mounts itself once, and returns its range of time and its program. */
export interface ModeOf {
  mount(room: Room<State>, rig: Rig): void;
  end(state: State, rig: Rig): number;
  code(state: State, rig: Rig): string;
}

/** The step of the curves, in seconds: exact in binary. */
export const step = 1 / 128;
export const snap = (x: number, least: number, most: number) =>
  clamp(Math.round(x / step) * step, least, most);

export const limits = { at: [0.25, 1.25], start: [0, 1], duration: [0.0625, 0.625] } as const;
export const goalTimes = (goals: number[]) => goals.filter((_, i) => i % 2 === 0);
export const mostGoals = 60;
const ascending = (goals: number[]) => goals.length > 0 && goals.length % 2 === 0 && goals.length <= 2 * mostGoals &&
  goalTimes(goals).every((t, i, all) => t >= 0 && t <= 3 && !(t <= all[i - 1]));

export const fields = {
  mode: choice<Mode>('change', modes), hidden: some([], curveNames), time: number(0.75, 0, 4),
  from: choice<ClipName>('walk', clipNames), to: choice<ClipName>('wave', clipNames),
  other: choice<ClipName>('hop', clipNames),
  joint: choice('arm.R', jointNames), axis: choice<State['axis']>('z', axisNames),
  at: number(0.625, ...limits.at), start: number(0.25, ...limits.start), duration: number(0.375, ...limits.duration),
  coast: number(0.125, 0, 1), smooth: flag(false),
  weight: number(0.5, 0, 1.5), phase: number(0, 0, 1),
  reference: choice<State['reference']>('first', ['first', 'rest']),
  side: choice<State['side']>('local', ['local', 'parent']),
  half: number(0.15, 0.02, 1), ratio: number(0.25, 0, 3), goals: numbers([0.25, 1, 1.25, -0.5, 2, 0.5], ascending),
  ...turnFields(35, 8),
};
