
/** Key values over time (track.h). The arrays are copied. Throws for keys that nkw_track_validate rejects. */
export class Track extends Owner {
  get _type() { return 'nkw_track'; }
  constructor(source) {
    super();
    const { times, values, width = 1, kind = TRACK_FLOATS, interpolation = INTERPOLATION_LINEAR, keyInterpolation } =
      source;
    try {
      Object.assign(this, { width, kind, interpolation, count: times.length });
      const tall = interpolation === INTERPOLATION_CUBICSPLINE ? 3 : 1;
      if (values.length < times.length * width * tall || (keyInterpolation && keyInterpolation.length < times.length))
        throw new RangeError(`nakawari: ${values.length} values for ${times.length} keys of width ${width}`);
      /** @internal */
      this._words = [store(this, times), store(this, values), times.length, width, kind, interpolation,
        store(this, keyInterpolation, Uint8Array)];
      /** @internal */
      this._p = store(this, this._words, Uint32Array);
      check('nkw_track_validate', x.nkw_track_validate(this._p, badAt()), bad);
      /** @internal */
      this._out = this._take(12 * width);
    } catch (error) {
      this.dispose();
      throw error;
    }
  }
  /** The key times, and the values: not copies. */
  get times() {
    return new Float32Array(f32.buffer, this._use()._words[0], this.count);
  }
  get values() {
    const tall = this.interpolation === INTERPOLATION_CUBICSPLINE ? 3 : 1;
    return new Float32Array(f32.buffer, this._use()._words[1], this.count * this.width * tall);
  }
  /** The value at `time`, in the `width` first elements of out. */
  sample(time, out) {
    x.nkw_track_sample(this._use()._p, time, this._out);
    return this.#read(out, 0);
  }
  /** Value, velocity and acceleration at `time`, of a track of numbers. */
  sampleDerivatives(time, value, velocity, acceleration) {
    const o = this._out, step = 4 * this.width;
    check('nkw_track_sample_derivatives',
      x.nkw_track_sample_derivatives(this._use()._p, time, o, o + step, o + 2 * step));
    [value, velocity, acceleration].forEach((out, i) => this.#read(out, i));
  }
  #read(out, i) {
    const from = (this._out >> 2) + i * this.width;
    for (let k = 0; k < this.width; k++)
      out[k] = f32[from + k];
    return out;
  }
}

/** The local transforms of all joints (pose.h): ten component arrays of `stride` floats. It begins as the identity. */
export class Pose extends Floats {
  constructor(jointCount) {
    super(10 * Math.ceil(jointCount / 16) * 16);
    this.jointCount = jointCount;
    this.stride = Math.ceil(jointCount / 16) * 16;
    this.identity();
  }
  /** @internal */
  _view(i) {
    return words(i, this._use()._p, this.jointCount);
  }
  identity() {
    x.nkw_pose_identity(this._view(0));
    return this;
  }
  /** The ten floats of a joint: translation x y z, rotation x y z w, scale x y z. */
  get(joint, out) {
    x.nkw_pose_get(p, this._view(10), joint);
    return r(out, 0, 10);
  }
  set(joint, trs) {
    check('nkw_pose_set', x.nkw_pose_set(this._view(10), joint, w(0, trs, 10)), () => joint);
  }
}

const textAt = (owner, string) => store(owner, new TextEncoder().encode(`${string}\0`), Uint8Array);

function namesAt(owner, { clip = '', joints }, jointCount) {
  need('names of joints', joints?.length ?? jointCount, jointCount);
  const each = joints ? store(owner, joints.map(name => textAt(owner, name)), Uint32Array) : 0;
  return store(owner, [textAt(owner, clip), each], Uint32Array);
}

// The source of a clip, in memory of `owner`.
function clipSource(owner, { jointCount = 0, floatCount = 0, tracks = [], rest, restFloats, format, names }) {
  need('restFloats', restFloats?.length ?? floatCount, floatCount);
  const list = store(owner, tracks.flatMap(t => [t.target, t.index, ...t.track._use()._words]), Uint32Array);
  return store(owner, [list, tracks.length, jointCount, floatCount, addressOf(rest), rest?.jointCount ?? 0,
    store(owner, restFloats), format ?? CLIP_FLOAT32, names ? namesAt(owner, names, jointCount) : 0], Uint32Array);
}

/** Many tracks, sampled at one time into one pose (clip.h). */
export class Clip extends Owner {
  /** Builds a clip: { jointCount, floatCount, tracks: [{ target, index, track }], rest, restFloats, format, names }. */
  constructor(source) {
    super();
    try {
      if (source instanceof Uint8Array)
        this.#open(source);
      else
        during(owner => this.#build({ tracks: [], ...source }, owner));
      this.jointCount = x.nkw_clip_joint_count(this._p);
      this.floatCount = x.nkw_clip_float_count(this._p);
      this.start = x.nkw_clip_start(this._p);
      this.end = x.nkw_clip_end(this._p);
      this.cursorCount = x.nkw_clip_cursor_count(this._p);
      /** @internal */
      this._floats = this._take(4 * this.floatCount);
    } catch (error) {
      this.dispose();
      throw error;
    }
  }
  /** Opens a block that nkw_clip_build made, in C or here. The bytes are copied and checked. */
  static open(bytes) {
    return new Clip(bytes);
  }
  #open(bytes) {
    /** @internal */
    this._p = store(this, bytes, Uint8Array);
    this.size = bytes.length;
    check('nkw_clip_open', x.nkw_clip_open(this._p, bytes.length, words(0, 0)));
  }
  #build(source, owner) {
    const from = clipSource(owner, source), work = owner._take(12 * source.tracks.length + 4);
    const count = 3 * source.tracks.length;
    check('nkw_clip_measure', x.nkw_clip_measure(from, words(0, 0), badAt(), work, count), bad);
    this.size = u32[at];
    this._p = this._take(this.size);
    check('nkw_clip_build', x.nkw_clip_build(from, this._p, this.size, badAt(), work, count), bad);
  }
  /** The name of the clip, and of a joint; '' without names. */
  get name() {
    return text(x.nkw_clip_name(this._use()._p));
  }
  jointName(joint) {
    return text(x.nkw_clip_joint_name(this._use()._p, joint));
  }
  /** The block, not a copy: the same bytes on every machine of this byte order. */
  get bytes() {
    return new Uint8Array(f32.buffer, this._use()._p, this.size);
  }
  /** The pose at `time`, and the separate floats. Either may be null. */
  sample(time, pose, floats = null) {
    const span = words(0, addressOf(pose), pose?.jointCount ?? 0);
    check('nkw_clip_sample', x.nkw_clip_sample(this._use()._p, time, 0, span, floats ? this._floats : 0));
    for (let k = 0, from = this._floats >> 2; floats && k < this.floatCount; k++)
      floats[k] = f32[from + k];
  }
}
