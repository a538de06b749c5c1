// SPDX-License-Identifier: MIT
// The model of a file, moved by clips of the library.
import {
  Clip, CLIP_FLOAT32, CLIP_UNORM16, type ClipFormat, clipReduce, mat4TransformPoint, Pose, poseValidate, vec3Length,
} from 'nakawari/all';
import {
  clipFromAnimation, floatsToObjects, type KeyframesLike, poseToObjects, type Rig, rigFromObject, trackFromKeyframes,
} from 'nakawari/all/three';
import type * as Three from '../../kit/three';
import type { Library, View } from '../../kit/view3';
import { accessorBytes, type Loaded } from './read';

export interface Sizes {
  /** Bytes of the arrays of the animation in the file. */
  file: number;
  float32: number;
  unorm16: number;
  /** Packed as 1/10000 of the model's size permits; NaN for more than `most` keys. */
  reduced: number;
}
const most = 20000;

export interface Player {
  rig: Rig;
  /** A clip for each animation, or the error of the library. */
  clips: (Clip | Error)[];
  sizes: Sizes[];
  /** Of the model in the view. */
  height: number;
  show(clip: number, time: number): void;
  dispose(): void;
}

function fileBytes({ json }: Loaded, index: number) {
  const samplers = json.animations![index].samplers, used = new Set(samplers.flatMap(s => [s.input, s.output]));
  return [...used].reduce((sum, accessor) => sum + accessorBytes(json.accessors![accessor]), 0);
}

function attempt(rig: Rig, animation: Three.AnimationClip, format: ClipFormat): Clip | Error {
  try {
    return clipFromAnimation(rig, animation as never, { format });
  } catch (error) {
    return error as Error;
  }
}

// The packed size; the clip itself is not kept.
function packed(rig: Rig, animation: Three.AnimationClip) {
  const clip = attempt(rig, animation, CLIP_UNORM16);
  if (clip instanceof Error)
    return NaN;
  const { size } = clip;
  clip.dispose();
  return size;
}

/** How far the vertices that each joint moves are from it. */
function reachOf(three: Library, rig: Rig, scene: Three.Object3D, size: number) {
  const reach = new Float32Array(rig.objects.length), at = [0, 0, 0];
  const joints = new Map<unknown, number>(rig.objects.map((object, i) => [object, i]));
  const include = (object: Three.Object3D, point: ArrayLike<number>) => {
    const joint = joints.get(object)!;
    reach[joint] = Math.max(reach[joint], vec3Length(point));
  };
  scene.traverse(object => {
    const mesh = object as Three.SkinnedMesh, position = mesh.geometry?.getAttribute('position');
    const place = new three.Vector3();
    for (let v = 0; v < (position?.count ?? 0); v++) {
      const point = place.fromBufferAttribute(position, v).toArray();
      if (!mesh.isSkinnedMesh)
        include(mesh, point);
      else
        for (let k = 0; k < 4; k++)
          if (mesh.geometry.getAttribute('skinWeight').getComponent(v, k) > 0) {
            const bone = mesh.geometry.getAttribute('skinIndex').getComponent(v, k);
            const inverse = mesh.skeleton.boneInverses[bone].elements;
            include(mesh.skeleton.bones[bone], mat4TransformPoint(at, inverse, point));
          }
    }
  });
  return reach.map(x => x || size / 100);
}

// `size`: the diagonal of the model. As `nakawari info --reduced`.
function reduced(rig: Rig, animation: Three.AnimationClip, size: number, distances: Float32Array) {
  if (!(size > 0) || animation.tracks.reduce((sum, track) => sum + track.times.length, 0) > most)
    return NaN;
  const tracks = animation.tracks.map(track => trackFromKeyframes(rig, track as unknown as KeyframesLike))
    .filter(track => track !== null);
  const { rest, restFloats, floatCount, parents } = rig;
  const source = { jointCount: parents.length, floatCount, tracks, rest, restFloats };
  const clip = clipReduce(source, { parents, tolerance: size / 1e4, distance: 0, distances, floatTolerance: 1e-4 });
  const bytes = clip.size;
  [clip, ...tracks.map(t => t.track)].forEach(object => object.dispose());
  return bytes;
}

// A group of about two units of height or width, with the model's foot on the floor.
function frame(three: Library, scene: Three.Group, box: Three.Box3) {
  const made = new three.Group();
  made.add(scene);
  const size = box.getSize(new three.Vector3()), middle = box.getCenter(new three.Vector3());
  const scale = 2 / Math.max(size.x, size.y, size.z);
  if (Number.isFinite(scale) && scale > 0) {
    made.scale.setScalar(scale);
    made.position.set(-middle.x * scale, -box.min.y * scale, -middle.z * scale);
  }
  return made;
}

function free(scene: Three.Object3D) {
  scene.traverse(object => {
    const { geometry, material } = object as Partial<Three.Mesh>;
    geometry?.dispose();
    for (const one of material ? [material].flat() : []) {
      for (const value of Object.values(one) as (Three.Texture | null)[])
        if (value?.isTexture)
          value.dispose();
      one.dispose();
    }
  });
}

export function makePlayer(three: Library, view: View, loaded: Loaded): Player {
  const { scene, animations } = loaded.gltf, rig = rigFromObject(scene);
  poseValidate(rig.rest);
  const box = new three.Box3().setFromObject(scene), diagonal = box.getSize(new three.Vector3()).length();
  const clips = animations.map(animation => attempt(rig, animation, CLIP_FLOAT32));
  const reach = reachOf(three, rig, scene, diagonal);
  const sizes = animations.map((animation, i) => ({
    file: fileBytes(loaded, i), unorm16: packed(rig, animation),
    float32: clips[i] instanceof Clip ? (clips[i] as Clip).size : NaN,
    reduced: clips[i] instanceof Clip ? reduced(rig, animation, diagonal, reach) : NaN,
  }));
  const pose = new Pose(rig.objects.length), floats = new Float32Array(rig.floatCount);
  const group = frame(three, scene, box);
  view.scene.add(group);
  scene.traverse(object => { object.frustumCulled = false; });
  return {
    rig, clips, sizes, height: (box.max.y - box.min.y) * group.scale.y || 0,
    show(index, time) {
      const clip = clips[index];
      if (clip instanceof Clip) {
        clip.sample(time, pose, floats);
        poseToObjects(rig, pose);
        floatsToObjects(rig, floats);
      }
    },
    dispose() {
      group.removeFromParent();
      free(scene);
      clips.forEach(clip => clip instanceof Clip && clip.dispose());
      [pose, rig.rest, rig.skeleton].forEach(object => object.dispose());
    },
  };
}
