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
  /** Value, velocity and acceleration at `time`; of a rotation the orientation, and three numbers each. */
  sampleMotion(time: number, value: FloatArray | null, velocity: FloatArray | null, acceleration: FloatArray | null):
    void;
}

