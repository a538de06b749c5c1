/** The local transforms of all joints (pose.h): ten component arrays of `stride` floats. It begins as the identity. */
export class Pose extends Floats {
  constructor(jointCount: number);
  readonly jointCount: number;
  readonly stride: number;
  identity(): this;
  /** The ten floats of a joint: translation x y z, rotation x y z w, scale x y z. */
  get<T extends FloatArray>(joint: number, out: T): T;
  set(joint: number, trs: ArrayLike<number>): void;
}

