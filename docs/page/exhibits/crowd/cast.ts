// SPDX-License-Identifier: MIT
// The example character, as the library and three.js take it: one skeleton, its clips, one skin for all its meshes.
import { type Clip, mat4FromTrs, PLAYBACK_LOOP, playbackHead, quatFromAxisAngle } from 'nakawari/all';
import { clipFromAnimation, type Rig, rigFromObject, skinFromSkeleton } from 'nakawari/all/three';
import type * as Three from '../../kit/three';
import type { Library } from '../../kit/view3';
import { part } from '../../shell/part';

export interface Cast {
  scene: Three.Group;
  meshes: Three.SkinnedMesh[];
  rig: Rig;
  clips: Clip[];
  animations: Three.AnimationClip[];
  /** The bones of all meshes one after the other; a mesh's bone 0 is bone `first` of these. */
  bones: Three.Bone[];
  first: Map<Three.Skeleton, number>;
  joints: number[];
  inverseBind: number[];
}

export async function loadCast(three: Library): Promise<Cast> {
  const bytes = await part<{ default: Uint8Array<ArrayBuffer> }>('character');
  const { scene, animations } = await new three.GLTFLoader().parseAsync(bytes.default.slice().buffer, '');
  const meshes: Three.SkinnedMesh[] = [], first = new Map<Three.Skeleton, number>(), bones: Three.Bone[] = [];
  scene.traverse(object => {
    if ((object as Three.SkinnedMesh).isSkinnedMesh)
      meshes.push(object as Three.SkinnedMesh);
  });
  for (const { skeleton } of meshes)
    if (!first.has(skeleton)) {
      first.set(skeleton, bones.length);
      bones.push(...skeleton.bones);
    }
  const rig = rigFromObject(scene, bones), skins = [...first.keys()].map(skeleton => skinFromSkeleton(rig, skeleton));
  return {
    scene, meshes, rig, bones, first, animations,
    clips: animations.map(animation => clipFromAnimation(rig, animation)),
    joints: skins.flatMap(skin => skin.joints), inverseBind: skins.flatMap(skin => skin.inverseBind),
  };
}

/** Seconds by which character i is ahead. Exact in binary32. */
export const lead = (i: number) => i * 37 % 101 / 16;

/** The time of character i in a clip (crowd/code.ts has the same text in C). */
export function timeOf(clip: Clip, time: number, i: number) {
  const seconds = Math.fround(Math.fround(time) + lead(i));
  return playbackHead([0, 0], PLAYBACK_LOOP, clip.start, clip.end - clip.start, clip.start + seconds)[0];
}

/** Translation, heading and size of character i of `count`: a square, one unit apart. */
export function placeOf(i: number, count: number) {
  const side = Math.ceil(Math.sqrt(count)), column = i % side, row = (i - column) / side;
  const size = (90 + i * 5 % 11 * 2) / 100;
  const heading = quatFromAxisAngle([0, 0, 0, 1], [0, 1, 0], (i * 7 % 11 - 5) / 10);
  return mat4FromTrs(new Float32Array(16),
    [column - (side - 1) / 2, 0, row - (side - 1) / 2, ...heading, size, size, size]);
}
