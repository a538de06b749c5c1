// SPDX-License-Identifier: MIT
// The state.
import { turnFields } from '../../kit/space';
import { choice, number } from '../../shell/state';
import { motions, type Mode } from './bar';

export const fields = {
  ...turnFields(25, 12),
  mode: choice<Mode>('twist', ['twist', 'bend']),
  twist: number(170, 0, motions.twist.most),
  bend: number(110, 0, motions.bend.most),
  joints: choice<'3' | '5'>('3', ['3', '5']),
};
export type State = { [K in keyof typeof fields]: typeof fields[K]['initial'] };

/** The angle of the end. */
export const degreesOf = (state: State) => state[state.mode];
