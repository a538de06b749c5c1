
/** A curve of keys with handles (fcurve.h). Change `keys` by making another one. */
export class FCurve extends Owner {
  get _type() { return 'nkw_fcurve'; }
  constructor(source) {
    super();
    try {
      this.keyCount = source.keys.length;
      /** @internal */
      this._p = this._take($nkw_fcurve[0]);
      this._keys = this._take(Math.max(1, $nkw_fcurve_key[0] * this.keyCount));
      $t(() => {
        put($nkw_fcurve, this._p, { ...source, keys: null, keyCount: this.keyCount });
        source.keys.forEach((key, i) => put($nkw_fcurve_key, this._keys + $nkw_fcurve_key[0] * i, key));
      });
      u32[this._p >> 2] = this._keys;
      check('nkw_fcurve_validate', x.nkw_fcurve_validate(this._p, badAt()), bad);
    } catch (error) {
      this.dispose();
      throw error;
    }
  }
  /** Value, velocity and acceleration at `time`. */
  sample(time, out) {
    x.nkw_fcurve_sample(p, this._use()._p, time);
    return r(out, 0, 3);
  }
  /** Copies of the keys. */
  get keys() {
    this._use();
    return Array.from({ length: this.keyCount }, (_, i) => get($nkw_fcurve_key, this._keys + $nkw_fcurve_key[0] * i));
  }
  /** The keys with one more at `time`, of the same curve. */
  insert(time) {
    return $t(() => {
      const n = this.keyCount + 1, size = $nkw_fcurve_key[0], keys = temporary(n * size);
      check('nkw_fcurve_insert', x.nkw_fcurve_insert(this._use()._p, time, keys, words(0, 0)));
      return { index: u32[at], keys: Array.from({ length: n }, (_, i) => get($nkw_fcurve_key, keys + i * size)) };
    });
  }
}

/** The tangents of a spline through keys (spline.h): { times, values, width, method, ends, ... }, per second. */
export function splineTangents(spline, tangentsIn, tangentsOut) {
  $t(() => {
    const { count = spline.times.length, width = 1 } = spline, from = $i($nkw_spline, spline);
    const [a, b] = [0, 0].map(() => temporary(4 * count * width));
    check('nkw_spline_tangents', x.nkw_spline_tangents(from, words(0, a, b, width), badAt(), temporary(24 * count),
      3 * count), bad);
    $v('f', tangentsIn, a, count * width);
    $v('f', tangentsOut, b, count * width);
  });
}

const trackKeys = (track, rate) => {
  const count = [0];
  trackResampleCount(track, rate, count);
  return count[0];
};

// The track that a function writes, in memory for `count` keys.
function trackFrom(edit, [count, width], f) {
  return $t(() => {
    const memory = temporary(20), to = temporary($nkw_track[0]), tall = count * 3 * width;
    const times = temporary(4 * count), values = temporary(4 * tall), each = temporary(count);
    const workCount = count * (width + 5) + 2 * width, space = temporary(8 * workCount);
    u32.set(edit ? [times, values, each, count] : [times, values, count, space, workCount], memory >> 2);
    f(memory, to);
    return trackAt(to);
  });
}

// A Track of the struct at an address.
function trackAt(place) {
  const { count, width, kind, interpolation } = get($nkw_track, place), [times, values, , , , , each] =
    u32.subarray(place >> 2, (place >> 2) + 7);
  const tall = interpolation === INTERPOLATION_CUBICSPLINE ? 3 : 1;
  return new Track({ width, kind, interpolation,
    times: new Float32Array(f32.buffer, times, count).slice(),
    values: new Float32Array(f32.buffer, values, count * width * tall).slice(),
    keyInterpolation: each ? new Uint8Array(f32.buffer, each, count).slice() : undefined });
}

/** The velocities of the joints of a pose (transition.h). */
export class PoseVelocity extends Floats {
  constructor(jointCount) {
    super(9 * 16 * Math.ceil(jointCount / 16));
    this.jointCount = jointCount;
  }
}

/** The state of a transition by inertialisation (transition.h). */
export class PoseInertia extends Floats {
  constructor(jointCount) {
    super(30 * 16 * Math.ceil(jointCount / 16));
    this.jointCount = jointCount;
  }
}

/** The state of a dead blend (transition.h); its times are in seconds. */
export class PoseDeadBlend extends Floats {
  constructor(jointCount, halfLife, duration) {
    super(23 * 16 * Math.ceil(jointCount / 16));
    Object.assign(this, { jointCount, halfLife, duration });
  }
}
