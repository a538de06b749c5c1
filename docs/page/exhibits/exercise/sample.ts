// SPDX-License-Identifier: MIT
// The numbers of one time: by nkw_keyframes_trace, or by the rules of the exercise's program.
import * as N from 'nakawari/all';
import { zeros } from '../../kit/values';
import { orientationMethod, pack, positionMethod, memoized, type Key } from './model';
import { curveOf, eulerOf, hasProgram, segmentOf, type Methods, type Trace } from './rules';

export type { Methods, Trace };

/** A copy of the keys in the memory of the library, kept until other keys are asked for. */
let copy: N.Keyframes | undefined;
const keyframesOf = memoized((keys: Key[]) => {
  copy?.dispose();
  copy = new N.Keyframes(pack(keys));
  return copy;
});

const libraryTrace = (keys: Key[], time: number, { position, orientation }: Methods): Trace =>
  keyframesOf(keys).trace(time, positionMethod[position], orientationMethod[orientation]);

/** The library's trace of the segment alone has the orientation of the program; without interpolation, of its start. */
function turnOf(keys: Key[], k: number, time: number, orientation: Methods['orientation']): Trace {
  const pair = keys.slice(k, k + (orientation === 'none' ? 1 : 2));
  return libraryTrace(pair, time, { position: 'linear', orientation, program: false });
}

function programTrace(keys: Key[], time: number, { position, orientation }: Methods): Trace {
  const { k, t } = segmentOf(keys, time), euler = orientation === 'euler' ? eulerOf(keys[k], keys[k + 1], t) : {};
  return {
    ...turnOf(keys, k, time, orientation), ...euler, ...curveOf(keys, k, t, time, position), segment: k, t,
  };
}

const traceAt = memoized((keys: Key[], time: number, position: Methods['position'],
  orientation: Methods['orientation'], program: boolean): Trace | undefined => {
  const methods = { position, orientation, program };
  if (!program || !hasProgram(methods))
    return libraryTrace(keys, time, methods);
  return keys.length > 1 ? programTrace(keys, time, methods) : undefined;
});

/** Undefined where the exercise's program writes no matrix. */
export const trace = (keys: Key[], time: number, { position, orientation, program }: Methods) =>
  traceAt(keys, time, position, orientation, program);

/** The matrix by columns. */
export const matrixOf = ({ rotation, position }: Trace): number[] => N.mat4FromMat3(zeros(16), rotation, position);

/** The matrices at each of the times. */
export function matricesOf(keys: Key[], times: number[], methods: Methods): number[][] {
  if (methods.program && hasProgram(methods))
    return times.map(time => trace(keys, time, methods)).filter(t => t !== undefined).map(matrixOf);
  const all = keyframesOf(keys), { position, orientation } = methods;
  return times.map(time => all.sample(time, positionMethod[position], orientationMethod[orientation], zeros(16)));
}
