/** All intermediate values of one matrix (nkw_keyframe_trace). */
export interface KeyframeTrace {
  segment: number;
  t: number;
  parameter: number;
  key: number[];
  control: number[][];
  weight: number[];
  orientation: number[][];
  angles: number[][];
  halfAngle: number;
  orientationWeight: number[];
  angularVelocity: number[];
  position: number[];
  rotation: number[];
}

/** nkw_keyframe_options: linear, step, by the rule of the library, unless stated. */
export interface KeyframeOptions {
  position?: PositionMethod;
  orientation?: OrientationMethod;
  rule?: KeyframeRule;
}

/** The keys of the university exercise (keyframe.h): eight floats each, time, position x y z, orientation x y z w. */
export class Keyframes extends Floats {
  constructor(keys: ArrayLike<number>);
  readonly keyCount: number;
  /** Throws for keys that nkw_keyframes_validate rejects; call it after a change of `array`. */
  validate(): void;
  /** The matrix at `time`, 16 floats. */
  sample<T extends FloatArray>(time: number, position: PositionMethod, orientation: OrientationMethod, out: T): T;
  /** The same by the methods and the rule of `options`; by the exercise's rule, one key alone throws. */
  sampleAs<T extends FloatArray>(time: number, options: KeyframeOptions, out: T): T;
  trace(time: number, options: KeyframeOptions): KeyframeTrace;
}
