
/** The local transforms of all joints (pose.h): ten component arrays of `stride` floats. It begins as the identity. */
export class Pose extends Floats {
  get _data() { return 'nkw_pose'; }
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
    x.nkw_pose_get(p, this._view(10), number(joint));
    return r(out, 0, 10);
  }
  set(joint, trs) {
    check('nkw_pose_set', x.nkw_pose_set(this._view(10), number(joint), w(0, trs, 10)), () => joint);
  }
}
