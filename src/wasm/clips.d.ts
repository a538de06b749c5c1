/** Key values over time (track.h). The arrays are copied. Throws for keys that nkw_track_validate rejects. */
export class Track extends Owner {
  constructor(source: {
    times: ArrayLike<number>;
    /** times.length * width numbers, three times as many for INTERPOLATION_CUBICSPLINE */
    values: ArrayLike<number>;
    width?: number;
    kind?: TrackKind;
    interpolation?: Interpolation;
    keyInterpolation?: ArrayLike<number>;
  });
  readonly width: number;
  readonly count: number;
  readonly kind: TrackKind;
  readonly interpolation: Interpolation;
  /** The key times, and the values: not copies. */
  readonly times: Float32Array;
  readonly values: Float32Array;
  /** The value at `time`, in the `width` first elements of out. */
  sample<T extends FloatArray>(time: number, out: T): T;
  /** Value, velocity and acceleration at `time`, of a track of numbers. */
  sampleDerivatives(time: number, value: FloatArray, velocity: FloatArray, acceleration: FloatArray): void;
}

/** The local transforms of all joints (pose.h): ten component arrays of `stride` floats. It begins as the identity. */
export class Pose extends Floats {
  constructor(jointCount: number);
  readonly jointCount: number;
  readonly stride: number;
  identity(): this;
  /** The ten floats of a joint: translation x y z, rotation x y z w, scale x y z. */
  get<T extends FloatArray>(joint: number, out: T): T;
  set(joint: number, trs: ArrayLike<number>): void;
}

export interface ClipSource {
  jointCount?: number;
  floatCount?: number;
  /** What each track animates: a joint, or the first of the separate floats. */
  tracks?: { target: ClipTarget; index: number; track: Track }[];
  rest?: Pose;
  restFloats?: ArrayLike<number>;
  format?: ClipFormat;
  /** A name for each joint, jointCount of them. */
  names?: { clip?: string; joints?: ArrayLike<string> };
}

/** Many tracks, sampled at one time into one pose (clip.h). The tracks may be disposed after the clip is built. */
export class Clip extends Owner {
  constructor(source: ClipSource);
  /** Opens a block that nkw_clip_build made, in C or here. The bytes are copied and checked. */
  static open(bytes: Uint8Array): Clip;
  readonly jointCount: number;
  readonly floatCount: number;
  readonly start: number;
  readonly end: number;
  readonly size: number;
  /** The name of the clip, and of a joint; '' without names. */
  readonly name: string;
  jointName(joint: number): string;
  /** The block, not a copy: the same bytes on every machine of this byte order. */
  readonly bytes: Uint8Array;
  /** The pose at `time`, and the separate floats. Either may be null. */
  sample(time: number, pose: Pose | null, floats?: FloatArray | null): void;
}
