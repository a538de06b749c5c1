// SPDX-License-Identifier: MIT
// An adapter for three.js. It imports nothing of it: objects of three.js are known by their properties.
import {
  CLIP_FLOATS, CLIP_ROTATION, CLIP_SCALE, CLIP_TRANSLATION, Clip, INTERPOLATION_CUBICSPLINE, INTERPOLATION_LINEAR,
  INTERPOLATION_STEP, Pose, Skeleton, TRACK_FLOATS, TRACK_ROTATION, Track,
} from './characters.js';

// The objects above `object` up to `root`, with both.
function pathTo(root, object) {
  const path = [];
  for (let o = object; o && o !== root.parent; o = o.parent)
    path.push(o);
  return path;
}

/**
 * A tree of objects as a skeleton: joint i is objects[i], parents first. The rest pose is the present state of the
 * objects. With `wanted`, for example the bones of a skeleton, only these and the objects above them are joints.
 */
export function rigFromObject(root, wanted) {
  const kept = wanted && new Set(wanted.flatMap(object => pathTo(root, object)));
  const objects = [], morphs = [], restFloats = [];
  root.traverse(object => {
    if (!kept || kept.has(object))
      objects.push(object);
    if (object.morphTargetInfluences) {
      morphs.push({ object, first: restFloats.length });
      restFloats.push(...object.morphTargetInfluences);
    }
  });
  const jointOf = new Map(objects.map((object, i) => [object, i]));
  const parents = objects.map((object, i) => i ? jointOf.get(object.parent) : -1), skeleton = new Skeleton(parents);
  const rest = new Pose(objects.length);
  objects.forEach((o, i) => rest.set(i, [...o.position.toArray(), ...o.quaternion.toArray(), ...o.scale.toArray()]));
  const named = new Map();
  for (const object of [...objects, ...morphs.map(m => m.object)].reverse())
    named.set(object.uuid, object).set(object.name, object);
  return { objects, parents, jointOf, named, skeleton, rest, morphs, restFloats, floatCount: restFloats.length };
}

const targets = { position: CLIP_TRANSLATION, quaternion: CLIP_ROTATION, scale: CLIP_SCALE };
const interpolations = { 2300: INTERPOLATION_STEP, 2301: INTERPOLATION_LINEAR };

// What a track of three.js animates, { target, index }: 'name.property', 'uuid.property', '.bones[name].property'.
function targetOf(rig, name) {
  const [, bone, node, property] =
    name.match(/^(?:.*\.bones\[(.*)\]|(.*))\.(position|quaternion|scale|morphTargetInfluences)$/) ?? [];
  const path = bone ?? node, object = path === '' ? rig.objects[0] : rig.named.get(path);
  const index = property === 'morphTargetInfluences' ? rig.morphs.find(m => m.object === object)?.first
    : rig.jointOf.get(object);
  return index === undefined ? null : { target: targets[property] ?? CLIP_FLOATS, index };
}

function interpolationOf(track) {
  const interpolation = track.createInterpolant?.isInterpolantFactoryMethodGLTFCubicSpline
    ? INTERPOLATION_CUBICSPLINE : interpolations[track.getInterpolation()];
  if (interpolation === undefined)
    throw new RangeError(`nakawari: ${track.name}: neither LINEAR, STEP nor CUBICSPLINE`);
  return interpolation;
}

/** The track of a KeyframeTrack, for a Clip; null if it animates nothing of the rig. */
export function trackFromKeyframes(rig, from) {
  const target = targetOf(rig, from.name);
  if (!target)
    return null;
  const interpolation = interpolationOf(from), tall = interpolation === INTERPOLATION_CUBICSPLINE ? 3 : 1;
  const kind = target.target === CLIP_ROTATION ? TRACK_ROTATION : TRACK_FLOATS;
  const width = from.values.length / from.times.length / tall;
  return { ...target, track: new Track({ times: from.times, values: from.values, width, kind, interpolation }) };
}

/** The clip of an AnimationClip. `skipped` receives the names of the tracks that animate nothing of the rig. */
export function clipFromAnimation(rig, animation, { format, skipped = [] } = {}) {
  const tracks = [];
  try {
    for (const from of animation.tracks) {
      const track = trackFromKeyframes(rig, from);
      track ? tracks.push(track) : skipped.push(from.name);
    }
    const { objects, rest, restFloats, floatCount } = rig;
    return new Clip({ jointCount: objects.length, floatCount, tracks, rest, restFloats, format });
  } finally {
    tracks.forEach(t => t.track.dispose());
  }
}

/** The skin of a three.js Skeleton, for a Palette or a Crowd. */
export function skinFromSkeleton(rig, skeleton) {
  const joints = skeleton.bones.map(bone => rig.jointOf.get(bone));
  if (joints.includes(undefined))
    throw new RangeError(`nakawari: bone ${joints.indexOf(undefined)} is not in the rig`);
  return { joints, inverseBind: skeleton.boneInverses.flatMap(matrix => matrix.toArray()) };
}

/** Writes a pose into the objects, as an AnimationMixer does; three.js then computes the matrices. */
export function poseToObjects(rig, pose) {
  const a = pose.array, n = pose.stride;
  rig.objects.forEach((object, i) => {
    object.position.set(a[i], a[n + i], a[2 * n + i]);
    object.quaternion.set(a[3 * n + i], a[4 * n + i], a[5 * n + i], a[6 * n + i]);
    object.scale.set(a[7 * n + i], a[8 * n + i], a[9 * n + i]);
  });
}

/** Writes the separate floats of a clip into the morph target influences. */
export function floatsToObjects(rig, floats) {
  for (const { object, first } of rig.morphs)
    for (let i = 0; i < object.morphTargetInfluences.length; i++)
      object.morphTargetInfluences[i] = floats[first + i];
}

// The renderer calls skeleton.update() before it draws, which computes the matrices from the bones.
const keep = () => {};

/** Fills the bone matrices of a three.js Skeleton with a Palette. Its bones have no effect on them from here on. */
export function fillSkeleton(skeleton, palette) {
  skeleton.update = keep;
  skeleton.boneMatrices.set(palette.array);
  if (skeleton.boneTexture)
    skeleton.boneTexture.needsUpdate = true;
}

/**
 * Gives a three.js Skeleton a bone texture with the matrices of all characters of a Crowd, a row each: the memory of
 * the crowd, not a copy. Call it after each Crowd.play. For a SkinnedMesh with an InstancedBufferGeometry and a
 * material of instanceMaterial.
 */
export function fillInstances(skeleton, crowd) {
  const width = 4 * crowd.jointCount, height = crowd.count, image = skeleton.boneTexture?.image;
  if (image?.width !== width || image.height !== height) {
    skeleton.boneTexture?.dispose();
    skeleton.update = keep;
    skeleton.computeBoneTexture();
    skeleton.boneTexture.image = { width, height };
  }
  skeleton.boneTexture.image.data = crowd.array;
  skeleton.boneTexture.needsUpdate = true;
}

// The matrices of an instance are a row of the bone texture. In its own replacement a macro is not expanded.
const ofInstance =
  '#define getBoneMatrix( i ) getBoneMatrix( ( i ) + float( gl_InstanceID * textureSize( boneTexture, 0 ).x / 4 ) )';

/** Lets a material of the WebGLRenderer, also one for shadows, take the matrices of fillInstances. */
export function instanceMaterial(material) {
  material.onBeforeCompile = shader => {
    const include = '#include <skinning_pars_vertex>';
    shader.vertexShader = shader.vertexShader.replace(include, `${include}\n${ofInstance}`);
  };
  material.customProgramCacheKey = () => ofInstance;
  material.needsUpdate = true;
  return material;
}
