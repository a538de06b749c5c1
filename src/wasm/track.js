
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
      if (!(values.length >= times.length * width * tall && (keyInterpolation?.length ?? Infinity) >= times.length))
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
    x.nkw_track_sample(this._use()._p, number(time), 0, this._out);
    return this.#read(out, 0);
  }
  /** Value, velocity and acceleration at `time`; of a rotation the orientation, and three numbers each. */
  sampleMotion(time, value, velocity, acceleration) {
    const o = this._out, step = 4 * this.width, span = words(0, o, o + step, o + 2 * step);
    check('nkw_track_sample_motion', x.nkw_track_sample_motion(this._use()._p, number(time), span));
    [value, velocity, acceleration].forEach((out, i) => out && this.#read(out, i));
  }
  #read(out, i) {
    const from = (this._out >> 2) + i * this.width, length = i && this.kind !== TRACK_FLOATS ? 3 : this.width;
    for (let k = 0; k < length; k++)
      out[k] = f32[from + k];
    return out;
  }
}
