/** Component arrays for the functions named ...N: `width` arrays of `count` floats; x, y, z, w are the first. */
export class Columns extends Floats {
  constructor(width: number, count: number);
  readonly width: number;
  readonly length: number;
  column(i: number): Float32Array;
  readonly x: Float32Array;
  readonly y: Float32Array;
  readonly z: Float32Array;
  readonly w: Float32Array;
}
