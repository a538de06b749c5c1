/** `count` matrices of sixteen floats, column by column. */
export class Matrices extends Floats {
  constructor(count: number);
  readonly matrixCount: number;
}

/** The parent of each joint, or -1; a parent comes before its children (skeleton.h). */
export class Skeleton extends Owner {
  constructor(parents: ArrayLike<number>);
  readonly jointCount: number;
  /** Model matrices of a pose; `root`, 16 floats or null, places the whole skeleton. */
  models(pose: Pose, out: Matrices, root?: ArrayLike<number> | null): Matrices;
}

/** A weight for each joint (blend.h), 1 at first. */
export class Mask extends Floats {
  constructor(jointCount: number);
  readonly jointCount: number;
}

/** Poses between two: t = 0 is a, t = 1 is b; nlerp for rotations. */
export function poseBlend(a: Pose, b: Pose, t: number, out: Pose, mask?: Mask | null): Pose;
/** The same by slerp. */
export function poseBlendSlerp(a: Pose, b: Pose, t: number, out: Pose, mask?: Mask | null): Pose;
/** The difference of a pose from a reference, for poseAdditiveApply. */
export function poseAdditiveBuild(a: Pose, reference: Pose, side: Additive, out: Pose): Pose;
/** A pose with a share of a difference. */
export function poseAdditiveApply(base: Pose, delta: Pose, weight: number, side: Additive, out: Pose,
  mask?: Mask | null): Pose;

export interface SkinSource {
  /** The joint of the skeleton of each joint of the skin; without: 0, 1, 2 ... */
  joints?: ArrayLike<number>;
  /** 16 floats for each joint of the skin */
  inverseBind?: ArrayLike<number>;
  jointCount?: number;
}

/** The joint matrices of a skin (palette.h). */
export class Palette extends Owner {
  constructor(source: SkinSource & { globalInverse?: ArrayLike<number>; format?: PaletteFormat });
  readonly jointCount: number;
  readonly format: PaletteFormat;
  /** Computes the palette from model matrices. */
  update(models: Matrices): this;
  /** The elements, not a copy. */
  readonly array: Float32Array;
}

/**
 * `count` characters of one skeleton and skin, each at its own time of one clip. `array`, not a copy, receives 16
 * floats for each joint of each character, one character after the other.
 */
export class Crowd extends Owner {
  constructor(source: SkinSource & { skeleton: Skeleton; count: number });
  readonly count: number;
  readonly jointCount: number;
  readonly array: Float32Array;
  /** Samples the clip at times[i] for character i. `roots`: 16 floats for each character, or null. */
  play(clip: Clip, times: Float32Array, roots?: Float32Array | null): this;
}

export interface MeshSource {
  positions: ArrayLike<number>;
  normals?: ArrayLike<number>;
  tangents?: ArrayLike<number>;
  bitangents?: ArrayLike<number>;
  joints: Uint8Array | Uint16Array | Uint32Array | Float32Array;
  weights: Uint8Array | Uint16Array | Float32Array;
  influenceCount?: number;
}

/** What skinLinear computes otherwise (nkw_skin_options). */
export interface SkinOptions {
  /** Directions are not normalized. */
  keepLength?: boolean;
  /** Normals by the inverse transpose of the blended matrix. */
  inverseNormals?: boolean;
  /** Positions are divided by the sum of their weights. */
  divideByWeights?: boolean;
}

/** Vertices and their influences (skin.h), vectors of three floats. */
export class Mesh extends Owner {
  constructor(source: MeshSource);
  readonly vertexCount: number;
  /** The vectors of the bind pose, not copies; null where the mesh has none. */
  readonly vectors: Record<'positions' | 'normals' | 'tangents' | 'bitangents', Float32Array | null>;
  /** The skinned vectors, not copies; null where the mesh has none. */
  readonly skinned: Record<'positions' | 'normals' | 'tangents' | 'bitangents', Float32Array | null>;
  /** Linear blend skinning by a Palette of PALETTE_MAT4. */
  skinLinear(palette: Palette, options?: SkinOptions): this;
  /** Dual-quaternion skinning by a Palette of PALETTE_DUAL_QUAT. */
  skinDualQuat(palette: Palette): this;
}
