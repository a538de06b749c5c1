
export interface MorphTarget {
  positions?: ArrayLike<number>;
  normals?: ArrayLike<number>;
  tangents?: ArrayLike<number>;
  bitangents?: ArrayLike<number>;
  /** The vertices of a sparse target. */
  indices?: ArrayLike<number>;
}

/** Morph targets of a mesh (morph.h): differences of its vectors. Make it before the first `apply` of another one. */
export class Morph extends Owner {
  constructor(mesh: Mesh, targets: MorphTarget[]);
  readonly mesh: Mesh;
  readonly targetCount: number;
  /** Writes the vectors of the mesh: those it was made of, and the differences by their weights. */
  apply(weights: ArrayLike<number>): this;
}

/** Checks the joints and weights of a mesh: the index of the error is a vertex (nkw_skin_validate). */
export function skinValidate(mesh: Mesh, jointCount: number): void;
export type Weights = Uint8Array | Uint16Array | Float32Array;
/** Weights that sum to 1 exactly (nkw_skin_normalize_weights); `out` may have another format. */
export function skinNormalizeWeights(weights: Weights, out: Weights, influenceCount: number, vertexCount: number): void;
/** The keepCount largest weights of each vertex of a mesh, and their joints (nkw_skin_prune). */
export function skinPrune(mesh: Mesh, keepCount: number,
  joints: Uint8Array | Uint16Array | Uint32Array | Float32Array,
  weights: Weights): void;

/** The boxes of the joints in the bind pose, and one of the vertices without influence (nkw_box_from_skin). */
export function boxFromSkin(mesh: Mesh, boxes: Partial<Box>[], jointCount: number): void;

export interface Partition {
  parts: Part[];
  joints: Uint16Array;
  /** The triangles of the mesh by part, then the rejected ones. */
  triangles: Uint32Array;
  indices: Uint32Array;
  vertices: Uint32Array;
  jointSlots: Uint16Array;
  weights: Float32Array;
  rejectedCount: number;
}

/** Partitions a mesh into parts of at most maxJointCount joints (nkw_partition_build). */
export function partitionBuild(mesh: PartitionMesh, maxJointCount: number): Partition;
