// SPDX-License-Identifier: MIT
// The same characters by three.js alone: a tree of bones, an AnimationMixer and a Skeleton for each.
import type * as Three from '../../kit/three';
import type { Library } from '../../kit/view3';
import type { Cast } from './cast';
import type { Group } from './ours';

export interface Mixers {
  /** All matrices of a group, by three.js: what is measured. */
  play(): void;
  /** Copies them into one array, in the order of the crowd. */
  copy(): Float32Array;
}

// The tree without meshes, so that three.js computes what the crowd computes and no more.
function bare(cast: Cast) {
  const tree = cast.scene.clone(true), kept = new Set<string>(cast.rig.objects.map(object => object.name));
  const others: Three.Object3D[] = [];
  tree.traverse(object => {
    if (object !== tree && !kept.has(object.name))
      others.push(object);
  });
  others.forEach(object => object.removeFromParent());
  return tree;
}

function makeActor(three: Library, cast: Cast, tree: Three.Object3D, root: Float32Array,
  clip: Three.AnimationClip) {
  const place = new three.Group(), body = tree.clone(true), mixer = new three.AnimationMixer(body);
  place.matrixAutoUpdate = false;
  place.matrix.fromArray(Array.from(root));
  place.add(body);
  const bones = cast.bones.map(bone => body.getObjectByName(bone.name) as Three.Bone);
  const inverses = cast.bones.map((_, k) => new three.Matrix4().fromArray(cast.inverseBind, 16 * k));
  mixer.clipAction(clip).play();
  return { place, mixer, skeleton: new three.Skeleton(bones, inverses) };
}

export function makeMixers(three: Library, cast: Cast, group: Group): Mixers {
  const { name, duration, tracks } = cast.animations[group.clip], tree = bare(cast);
  const clip = new three.AnimationClip(name, duration,
    tracks.filter(track => !/\.morphTargetInfluences$/.test(track.name)));
  const actors = group.members.map((_, k) =>
    makeActor(three, cast, tree, group.roots.subarray(16 * k, 16 * k + 16), clip));
  const floats = 16 * cast.bones.length, all = new Float32Array(floats * actors.length);
  return {
    play() {
      actors.forEach(({ place, mixer, skeleton }, k) => {
        mixer.setTime(group.times[k]);
        place.updateMatrixWorld(true);
        skeleton.update();
      });
    },
    copy() {
      actors.forEach(({ skeleton }, k) => all.set(skeleton.boneMatrices!.subarray(0, floats), floats * k));
      return all;
    },
  };
}
