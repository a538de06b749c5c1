
/** Many tracks, sampled at one time into one pose (clip.h). */
export class Clip extends Owner {
  /** Builds a clip: { jointCount, floatCount, tracks: [{ target, index, track }], rest, restFloats, format, names }. */
  constructor(source) {
    super();
    try {
      if (source instanceof Uint8Array)
        this.#open(source);
      else
        during(owner => buildClip(this, { tracks: [], ...source }, owner));
      x.nkw_clip_describe(words(0), this._p);
      [this.jointCount, this.floatCount, this.trackCount, this.cursorCount] = u32.subarray(at, at + 4);
      [this.start, this.end] = f32.subarray(at + 6, at + 8);
      this.name = text(u32[at + 8]);
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
  /** The name of a joint; '' without names. */
  jointName(joint) {
    return text(x.nkw_clip_joint_name(this._use()._p, number(joint)));
  }
  /** The name of a separate float; '' without names. */
  floatName(index) {
    return text(x.nkw_clip_float_name(this._use()._p, number(index)));
  }
  /** The block, not a copy: the same bytes on every machine of this byte order. */
  get bytes() {
    return new Uint8Array(f32.buffer, this._use()._p, this.size);
  }
  /** The pose at `time`, and the separate floats. Either may be null. */
  sample(time, pose, floats = null) {
    const span = words(0, addressOf(Pose, pose), pose?.jointCount ?? 0);
    check('nkw_clip_sample', x.nkw_clip_sample(this._use()._p, number(time), 0, span, floats ? this._floats : 0));
    for (let k = 0, from = this._floats >> 2; floats && k < this.floatCount; k++)
      floats[k] = f32[from + k];
  }
}
