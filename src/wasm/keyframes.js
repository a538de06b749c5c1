
// nkw_keyframe_options behind the results.
const keyframeOptions = ({ position = 0, orientation = 0, rule = 0 }) =>
  words(128, number(position), number(orientation), number(rule));

/** The keys of the university exercise (keyframe.h): eight floats each, time, position x y z, orientation x y z w. */
export class Keyframes extends Floats {
  constructor(keys) {
    super(keys.length);
    this.array.set(keys);
    this.keyCount = Math.floor(keys.length / 8);
    try {
      this.validate();
    } catch (error) {
      this.dispose();
      throw error;
    }
  }
  /** Throws for keys that nkw_keyframes_validate rejects; call it after a change of `array`. */
  validate() {
    check('nkw_keyframes_validate', x.nkw_keyframes_validate(this._use()._p, this.keyCount, badAt()), bad);
  }
  /** The matrix at `time`, 16 floats. */
  sample(time, position, orientation, out) {
    check('nkw_keyframes_sample',
      x.nkw_keyframes_sample(this._use()._p, this.keyCount, number(time), number(position), number(orientation), p));
    return r(out, 0, 16);
  }
  /** The matrix at `time` by the methods and the rule of nkw_keyframe_options. */
  sampleAs(time, options, out) {
    check('nkw_keyframes_sample_as',
      x.nkw_keyframes_sample_as(this._use()._p, this.keyCount, number(time), keyframeOptions(options), p));
    return r(out, 0, 16);
  }
  /** All numbers of one matrix, so that a reader can check it by hand (nkw_keyframe_trace). */
  trace(time, options) {
    check('nkw_keyframes_trace',
      x.nkw_keyframes_trace(this._use()._p, this.keyCount, number(time), keyframeOptions(options), p));
    const f = (i, n) => [...f32.subarray(at + i, at + i + n)], n = u32[at + 3];
    return {
      segment: u32[at], t: f32[at + 1], parameter: f32[at + 2], key: [...u32.subarray(at + 4, at + 4 + n)],
      control: Array.from({ length: n }, (_, i) => f(8 + 3 * i, 3)), weight: f(20, n),
      orientation: [f(24, 4), f(28, 4)],
      angles: [f(32, 3), f(35, 3)], halfAngle: f32[at + 38], orientationWeight: f(39, 2), angularVelocity: f(41, 3),
      position: f(44, 3), rotation: f(47, 9),
    };
  }
}
