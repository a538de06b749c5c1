// SPDX-License-Identifier: MIT
// The numbers of one time, by the rule of the library or of the exercise's program (nkw_keyframe_rule).
import * as N from 'nakawari/all';
import { zeros } from '../../kit/values';
import { memoized, orientationMethod, pack, positionMethod, type Key, type State } from './model';

export type Trace = N.KeyframeTrace;
export type Methods = Pick<State, 'position' | 'orientation' | 'program'>;

/** A copy of the keys in the memory of the library, kept until other keys are asked for. */
let copy: N.Keyframes | undefined;
const keyframesOf = memoized((keys: Key[]) => {
  copy?.dispose();
  copy = new N.Keyframes(pack(keys));
  return copy;
});

const optionsOf = ({ position, orientation, program }: Methods): N.KeyframeOptions => ({
  position: positionMethod[position], orientation: orientationMethod[orientation],
  rule: program ? N.KEYFRAME_RULE_EXERCISE : N.KEYFRAME_RULE_LIBRARY,
});

/** The exercise's program writes no matrix for one key. */
const isWritten = (keys: Key[], { program }: Methods) => keys.length > (program ? 1 : 0);

const traceAt = memoized((keys: Key[], time: number, position: Methods['position'],
  orientation: Methods['orientation'], program: boolean): Trace | undefined => {
  const methods = { position, orientation, program };
  return isWritten(keys, methods) ? keyframesOf(keys).trace(time, optionsOf(methods)) : undefined;
});

/** Undefined where the exercise's program writes no matrix. */
export const trace = (keys: Key[], time: number, { position, orientation, program }: Methods) =>
  traceAt(keys, time, position, orientation, program);

/** The matrix by columns. */
export const matrixOf = ({ rotation, position }: Trace): number[] => N.mat4FromMat3(zeros(16), rotation, position);

/** The matrices at each of the times. */
export function matricesOf(keys: Key[], times: number[], methods: Methods): number[][] {
  if (!isWritten(keys, methods))
    return [];
  const all = keyframesOf(keys), options = optionsOf(methods);
  return times.map(time => all.sampleAs(time, options, zeros(16)));
}
