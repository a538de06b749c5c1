
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
    x.nkw_fcurve_sample(p, this._use()._p, number(time), 0);
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
      check('nkw_fcurve_insert', x.nkw_fcurve_insert(this._use()._p, number(time), keys, words(0, 0)));
      return { index: u32[at], keys: Array.from({ length: n }, (_, i) => get($nkw_fcurve_key, keys + i * size)) };
    });
  }
}

/** The tangents of a spline through keys (spline.h): { times, values, width, method, ends, ... }, per second. */
export function splineTangents(spline, tangentsIn, tangentsOut) {
  $t(() => {
    const { count = spline.times.length, width = 1 } = spline, from = $i($nkw_spline, spline);
    const [a, b] = [0, 0].map(() => temporary(4 * count * width));
    check('nkw_spline_tangents', x.nkw_spline_tangents(from, words(0, a, b, width), badAt(), $work(24 * count)), bad);
    $v('f', tangentsIn, a, count * width);
    $v('f', tangentsOut, b, count * width);
  });
}

/** The track at a uniform rate (nkw_track_resample). */
export function trackResample(track, rate) {
  return $t(() => {
    const from = $i($nkw_track, track), to = temporary($nkw_track[0]), sampled = (...span) =>
      x.nkw_track_resample(from, number(rate), words(0, ...span), to, words(8, 0));
    let result = sampled(0, 0, 0, 0);
    const count = u32[at + 8]; // of no arrays
    if (count > 0)
      result = sampled(temporary(4 * count), temporary(4 * count * (track.width ?? 1)), 0, count);
    check('nkw_track_resample', result);
    return trackAt(to);
  });
}

// The track that a function writes, in arrays for `count` keys.
function trackFrom([count, width], f) {
  return $t(() => {
    const span = temporary(16), to = temporary($nkw_track[0]);
    const arrays = [4 * count, 12 * count * width, count].map(temporary); // may move the memory
    u32.set([...arrays, count], span >> 2);
    f(span, to);
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
  get _data() { return 'nkw_pose_velocity'; }
  constructor(jointCount) {
    super(9 * 16 * Math.ceil(jointCount / 16));
    this.jointCount = jointCount;
  }
}

/** The state of a transition by inertialisation (transition.h). */
export class PoseInertia extends Floats {
  get _data() { return 'nkw_pose_inertia'; }
  constructor(jointCount) {
    super(30 * 16 * Math.ceil(jointCount / 16));
    this.jointCount = jointCount;
  }
}

/** The state of a dead blend (transition.h); its times are in seconds. */
export class PoseDeadBlend extends Floats {
  get _data() { return 'nkw_pose_dead_blend'; }
  constructor(jointCount, halfLife, duration) {
    super(23 * 16 * Math.ceil(jointCount / 16));
    Object.assign(this, { jointCount, halfLife, duration });
  }
}

const reduceWork = ({ tracks = [], jointCount = 0, floatCount = 0 }) =>
  8 * (40 * tracks.length + 34 * jointCount + 160 * Math.ceil(jointCount / 16) + 6 * floatCount + 16);

// Structures of two words, of memory of `owner`: its address and its bytes.
const memoryOf = (owner, bytes) => store(owner, [owner._take(bytes + 16), bytes], Uint32Array);

// Calls f with the addresses of a source, of a reduction, and of working memory, which is enough for `others` too.
function withReduction(source, reduction, others, f) {
  return $t(() => during(owner => {
    for (const name of ['parents', 'tolerances', 'distances'])
      need(name, reduction[name]?.length ?? Infinity, source.jointCount ?? 0);
    const bytes = Math.max(...[source, ...others].map(reduceWork));
    return f(owner, clipSource(owner, source), $i($nkw_clip_reduction, reduction), memoryOf(owner, bytes));
  }));
}

// Calls reduce(block) without a block, which sets the word `bytes`, and with one of as many bytes; returns its address.
function withBlock(owner, name, bytes, reduce) {
  const asked = reduce(words(0, 0, 0)), count = u32[bytes >> 2];
  if (!count)
    check(name, asked, bad);
  const block = owner._take(count);
  check(name, reduce(words(0, block, count)), bad);
  return block;
}

/** The smallest clip within a tolerance (nkw_clip_reduce). `reduced` receives what it reached. */
export function clipReduce(source, reduction, reduced = null) {
  return withReduction(source, reduction, [], (owner, from, by, work) => {
    const to = temporary($nkw_clip_reduced[0]);
    const block = withBlock(owner, 'nkw_clip_reduce', to, span => x.nkw_clip_reduce(from, by, span, to, badAt(), work));
    const made = $g($nkw_clip_reduced, reduced ?? {}, to);
    return Clip.open(u8.slice(block, block + made.bytes));
  });
}

/** The source of a clip with as few keys as a tolerance permits (nkw_clip_source_reduce). */
export function clipSourceReduce(source, reduction, reduced = null) {
  return withReduction(source, reduction, [], (owner, from, by, work) => {
    const made = temporary(60); // the source, 36 bytes; what was reached, 20; bytes
    withBlock(owner, 'nkw_clip_source_reduce', made + 56,
      span => x.nkw_clip_source_reduce(from, by, span, made, badAt(), work));
    $g($nkw_reduced, reduced, made + 36);
    const list = u32[made >> 2];
    return { ...source, tracks: source.tracks.map((_, i) => trackOfClip(list + 36 * i)) };
  });
}

/** How far the tracks of another source are from those of a source (nkw_clip_source_difference). */
export function clipSourceDifference(source, other, reduction, difference) {
  withReduction(source, reduction, [other], (owner, from, by, work) => {
    const to = temporary($nkw_reduced[0]);
    check('nkw_clip_source_difference', x.nkw_clip_source_difference(from, clipSource(owner, other), by, to, work));
    $g($nkw_reduced, difference, to);
  });
}

/** How far a clip is from its source (nkw_clip_difference): { translation, rotation, scale, floats }. */
export function clipDifference(clip, source, error) {
  expect(Clip, clip);
  $t(() => during(owner => {
    const count = 160 * Math.ceil(clip.jointCount / 16) + 2 * clip.floatCount, to = temporary($nkw_clip_error[0]);
    check('nkw_clip_difference', x.nkw_clip_difference(expect(Clip, clip)._p, clipSource(owner, source), to,
      memoryOf(owner, 4 * count)));
    $g($nkw_clip_error, error, to);
  }));
}

const trackOfClip = place =>
  ({ target: u32[place >> 2], index: u32[(place >> 2) + 1], track: trackAt(place + 8) });

/** The tracks that a clip was built from, with its stored values (nkw_clip_track_get). */
export function clipTracks(clip) {
  return Array.from({ length: expect(Clip, clip).trackCount }, (_, i) => $t(() => during(owner => {
    const shape = temporary(36), work = memoryOf(owner, 640 * Math.ceil(clip.jointCount / 16) + 4 * clip.floatCount);
    x.nkw_clip_track_get(clip._p, i, words(0, 0, 0, 0, 0), shape, work); // without arrays: the shape
    const { count: keys, width } = get($nkw_track, shape + 8);
    const arrays = [temporary(4 * keys), temporary(12 * keys * width), temporary(keys)], memory = temporary(16);
    u32.set([...arrays, keys], memory >> 2);
    check('nkw_clip_track_get', x.nkw_clip_track_get(clip._p, i, memory, shape, work));
    return trackOfClip(shape);
  })));
}
