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

/** The track at a uniform rate (nkw_track_resample). */
export function trackResample(track: Track, rate: number): Track;

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

/** A small clip within a tolerance (nkw_clip_reduce). `reduced` receives what it reached. */
export function clipReduce(source: ClipSource, reduction: ClipReduction, reduced?: Partial<ClipReduced> | null): Clip;
/** The source of a clip with as few keys as a tolerance permits (nkw_clip_source_reduce), of new tracks. */
export function clipSourceReduce(source: ClipSource, reduction: ClipReduction, reduced?: Partial<Reduced> | null):
  ClipSource;
/** How far the tracks of another source are from those of a source (nkw_clip_source_difference). */
export function clipSourceDifference(source: ClipSource, other: ClipSource, reduction: ClipReduction,
  difference: Partial<Reduced>): void;
/** How far a clip is from its source (nkw_clip_difference). */
export function clipDifference(clip: Clip, source: ClipSource, error: Partial<ClipError>): void;
/** The tracks that a clip was built from, with its stored values (nkw_clip_track_get), new ones. */
export function clipTracks(clip: Clip): { target: ClipTarget; index: number; track: Track }[];
