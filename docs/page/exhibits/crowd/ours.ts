// SPDX-License-Identifier: MIT
// The characters that play one clip: a Crowd, and the instanced meshes of three.js that it fills.
import { Crowd } from 'nakawari/all';
import { fillInstances, instanceMaterial } from 'nakawari/all/three';
import type * as Three from '../../kit/three';
import type { Library } from '../../kit/view3';
import { type Cast, placeOf, timeOf } from './cast';

export interface Group {
  clip: number;
  /** The numbers of its characters: first, first + step, ... */
  members: number[];
  crowd: Crowd;
  times: Float32Array;
  roots: Float32Array;
  meshes: Three.SkinnedMesh[];
  setTimes(time: number): void;
  /** Shows matrices: those of the crowd, or others in the same order. */
  fill(array: { array: Float32Array }): void;
  dispose(): void;
}

function instances(three: Library, cast: Cast, mesh: Three.SkinnedMesh, count: number) {
  const geometry = new three.InstancedBufferGeometry().copy(mesh.geometry as Three.InstancedBufferGeometry);
  const index = geometry.getAttribute('skinIndex').clone(), first = cast.first.get(mesh.skeleton)!;
  for (let i = 0; i < index.count; i++)
    for (let k = 0; k < 4; k++)
      index.setComponent(i, k, index.getComponent(i, k) + first);
  geometry.setAttribute('skinIndex', index);
  geometry.morphAttributes = {};
  geometry.instanceCount = count;
  const made = new three.SkinnedMesh(geometry, instanceMaterial((mesh.material as Three.Material).clone()));
  made.frustumCulled = false;
  return made;
}

/** Every `step`-th of `count` characters from `clip` on, or all of them for a step of 1. */
export function makeGroup(three: Library, cast: Cast, clip: number, from: number, step: number, count: number): Group {
  const members = Array.from({ length: Math.ceil((count - from) / step) }, (_, k) => from + step * k);
  const { joints, inverseBind } = cast, jointCount = joints.length;
  const crowd = new Crowd({ skeleton: cast.rig.skeleton, count: members.length, joints, inverseBind });
  const times = new Float32Array(members.length), roots = new Float32Array(16 * members.length);
  members.forEach((i, k) => roots.set(placeOf(i, count), 16 * k));
  const skeleton = new three.Skeleton(cast.bones, cast.bones.map(() => new three.Matrix4()));
  const meshes = cast.meshes.map(mesh => instances(three, cast, mesh, members.length));
  meshes.forEach(mesh => mesh.bind(skeleton, new three.Matrix4()));
  return {
    clip, members, crowd, times, roots, meshes,
    setTimes: time => members.forEach((i, k) => { times[k] = timeOf(cast.clips[clip], time, i); }),
    fill: ({ array }) => fillInstances(skeleton, { array, jointCount, count: members.length }),
    dispose() {
      crowd.dispose();
      skeleton.dispose();
      for (const mesh of meshes) {
        mesh.geometry.dispose();
        (mesh.material as Three.Material).dispose();
        mesh.removeFromParent();
      }
    },
  };
}
