/** A curve of keys with handles (fcurve.h). Change `keys` by making another one. */
export class FCurve extends Owner {
  constructor(source: {
    keys: FcurveKey[];
    before?: FcurveOutside;
    after?: FcurveOutside;
    beforeCycles?: number;
    afterCycles?: number;
    policy?: HandlePolicy;
  });
  readonly keyCount: number;
  /** Copies of the keys. */
  readonly keys: FcurveKey[];
  /** Value, velocity and acceleration at `time`. */
  sample<T extends FloatArray>(time: number, out: T): T;
  /** The keys with one more at `time`, of the same curve. */
  insert(time: number): { index: number; keys: FcurveKey[] };
}

/** The tangents of a spline through keys (spline.h), per second: width numbers for each key. */
export function splineTangents(spline: Spline, tangentsIn: FloatArray | null, tangentsOut: FloatArray | null): void;

/** The velocities of the joints of a pose (transition.h). */
export class PoseVelocity extends Floats {
  constructor(jointCount: number);
  readonly jointCount: number;
}

/** The state of a transition by inertialisation (transition.h). */
export class PoseInertia extends Floats {
  constructor(jointCount: number);
  readonly jointCount: number;
}

/** The state of a dead blend (transition.h); its times are in seconds. */
export class PoseDeadBlend extends Floats {
  constructor(jointCount: number, halfLife: number, duration: number);
  readonly jointCount: number;
  halfLife: number;
  duration: number;
}
