export interface ClipSource {
  jointCount?: number;
  floatCount?: number;
  /** What each track animates: a joint, or the first of the separate floats. */
  tracks?: { target: ClipTarget; index: number; track: Track }[];
  rest?: Pose;
  restFloats?: ArrayLike<number>;
  format?: ClipFormat;
  /** A name for each joint, jointCount of them. */
  names?: { clip?: string; joints?: ArrayLike<string>; floats?: ArrayLike<string> };
}

