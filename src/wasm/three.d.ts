// SPDX-License-Identifier: MIT
import { Clip, Pose, Skeleton, Track } from './characters.js';
import type { ClipFormat, ClipTarget, Crowd, FloatArray, Palette, SkinSource } from './characters.js';

/** What the adapter takes of objects of three.js. */
export interface Vector3Like { set(x: number, y: number, z: number): unknown; toArray(): number[] }
export interface QuaternionLike { set(x: number, y: number, z: number, w: number): unknown; toArray(): number[] }
export interface Matrix4Like {
  elements: ArrayLike<number>;
  clone(): Matrix4Like;
  compose(position: any, quaternion: any, scale: any): Matrix4Like;
  multiply(by: any): Matrix4Like;
  invert(): Matrix4Like;
}
export interface ObjectLike {
  uuid: string;
  name: string;
  parent: ObjectLike | null;
  position: Vector3Like;
  quaternion: QuaternionLike;
  scale: Vector3Like;
  matrix: Matrix4Like;
  matrixWorld: Matrix4Like;
  morphTargetInfluences?: number[];
  morphTargetDictionary?: { [name: string]: number };
  updateWorldMatrix(parents: boolean, children: boolean): void;
  traverse(callback: (object: any) => void): void;
}
export interface KeyframesLike {
  name: string;
  times: ArrayLike<number>;
  values: ArrayLike<number>;
  createInterpolant?: unknown;
  getInterpolation(): number | undefined;
}
export interface SkeletonLike {
  bones: ObjectLike[];
  boneInverses: { toArray(): number[] }[];
  boneMatrices: Float32Array | null;
  boneTexture: any;
  update(): void;
  computeBoneTexture(): unknown;
}
export interface MaterialLike {
  onBeforeCompile: (shader: any, ...more: any[]) => void;
  customProgramCacheKey(): string;
  needsUpdate: boolean;
}

/** A tree of objects as a skeleton: joint i is objects[i], parents first. */
export interface Rig {
  readonly objects: ObjectLike[];
  /** the joint above each joint, -1 for the first */
  readonly parents: number[];
  readonly jointOf: Map<ObjectLike, number>;
  /** by uuid and by name */
  readonly named: Map<string, ObjectLike>;
  readonly skeleton: Skeleton;
  readonly rest: Pose;
  /** the objects with morph targets, and the first of their separate floats */
  readonly morphs: { object: ObjectLike; first: number }[];
  readonly restFloats: number[];
  readonly floatCount: number;
  /** the inverse of the root's matrix at rest */
  readonly restInverse: Matrix4Like;
  /** whether a clip of the rig, or poseToObjects, has set the root; otherwise the root may be moved */
  rootIsAnimated: boolean;
}

/**
 * The rest pose is the present state of the objects. With `wanted`, for example the bones of a skeleton, only these and
 * the objects above them are joints.
 */
export function rigFromObject(root: ObjectLike, wanted?: ObjectLike[]): Rig;
/**
 * The track of a KeyframeTrack, for a Clip; null if it animates nothing of the rig. With `additive`, the values are
 * differences from the rest pose of the rig, and are added to it.
 */
export function trackFromKeyframes(rig: Rig, from: KeyframesLike, additive?: boolean):
  { target: ClipTarget; index: number; track: Track } | null;
/**
 * The clip of an AnimationClip. An additive one is added to the rest pose; poseAdditiveBuild(pose, rig.rest, ...) of its
 * poses has the differences again. `skipped` receives the names of the tracks that animate nothing of the rig.
 */
export function clipFromAnimation(rig: Rig, animation: { tracks: KeyframesLike[]; blendMode?: number },
  options?: { format?: ClipFormat; skipped?: string[] }): Clip;
/** The skin of a three.js Skeleton, for a Palette or a Crowd. */
export function skinFromSkeleton(rig: Rig, skeleton: SkeletonLike):
  SkinSource & { joints: number[]; inverseBind: number[] };
/**
 * Writes a pose into the objects, as an AnimationMixer does; three.js then computes the matrices. A root that no clip
 * of the rig animates remains where it is.
 */
export function poseToObjects(rig: Rig, pose: Pose): void;
/** Writes the separate floats of a clip into the morph target influences. */
export function floatsToObjects(rig: Rig, floats: FloatArray): void;
/**
 * Fills the bone matrices of a three.js Skeleton with a Palette. Its bones have no effect on them from here on. The
 * figure is where the parents of the rig's root, and the root, are now: call it after they have been moved.
 */
export function fillSkeleton(skeleton: SkeletonLike, palette: Pick<Palette, 'array'>): void;
/**
 * Gives a three.js Skeleton a bone texture with the matrices of all characters of a Crowd, a row each: the memory of
 * the crowd, not a copy. Call it after each Crowd.play. For a SkinnedMesh with an InstancedBufferGeometry and a
 * material of instanceMaterial.
 */
export function fillInstances(skeleton: SkeletonLike, crowd: Pick<Crowd, 'array' | 'jointCount' | 'count'>): void;
/** Lets a material of the WebGLRenderer, also one for shadows, take the matrices of fillInstances. */
export function instanceMaterial<T extends MaterialLike>(material: T): T;
