/** An array that receives numbers. */
export type FloatArray = Float32Array | number[];
/** True if this program can run WebAssembly. */
export const supported: boolean;
/** Resolves when the functions may be called. */
export const ready: Promise<void>;
/** Which build runs: 'simd128' or 'plain'; '' before `ready`. */
export function build(): '' | 'simd128' | 'plain';
/** An error of the library: `result` is its number, `index` the first offender (a key, a joint, a track) or -1. */
export class NakawariError extends Error {
  readonly result: number;
  readonly index: number;
}
