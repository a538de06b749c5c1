/** Many tracks, sampled at one time into one pose (clip.h). The tracks may be disposed after the clip is built. */
export class Clip extends Owner {
  constructor(source: ClipSource);
  /** Opens a block that nkw_clip_build made, in C or here. The bytes are copied and checked. */
  static open(bytes: Uint8Array): Clip;
  readonly jointCount: number;
  readonly floatCount: number;
  /** The tracks whose values change. */
  readonly trackCount: number;
  readonly start: number;
  readonly end: number;
  readonly size: number;
  /** The name of the clip, of a joint, and of a separate float; '' without names. */
  readonly name: string;
  jointName(joint: number): string;
  floatName(index: number): string;
  /** The block, not a copy: the same bytes on every machine of this byte order. */
  readonly bytes: Uint8Array;
  /** The pose at `time`, and the separate floats. Either may be null. */
  sample(time: number, pose: Pose | null, floats?: FloatArray | null): void;
}

