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

const trsOfObject = o => [...o.position.toArray(), ...o.quaternion.toArray(), ...o.scale.toArray()];

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
  objects.forEach((object, i) => rest.set(i, trsOfObject(object)));
  const named = new Map();
  for (const object of [...objects, ...morphs.map(m => m.object)].reverse())
    named.set(object.uuid, object).set(object.name, object);
  const { matrix, position, quaternion, scale } = root;
  return { objects, parents, jointOf, named, skeleton, rest, morphs, restFloats, floatCount: restFloats.length,
    restInverse: matrix.clone().compose(position, quaternion, scale).invert(), rootIsAnimated: false };
}

const targets = { position: CLIP_TRANSLATION, quaternion: CLIP_ROTATION, scale: CLIP_SCALE };
const trsOf = { [CLIP_TRANSLATION]: [0, 3], [CLIP_ROTATION]: [3, 7], [CLIP_SCALE]: [7, 10] };
const interpolations = { 2300: INTERPOLATION_STEP, 2301: INTERPOLATION_LINEAR };

// The product of two rotations, or of a rotation and a tangent.
const product = ([x, y, z, w], [a, b, c, d]) => [w * a + x * d + y * c - z * b, w * b + y * d + z * a - x * c,
  w * c + z * d + x * b - y * a, w * d - x * a - y * b - z * c];

// An object by its uuid, its name, or a path that ends with its name.
const objectOf = (rig, path) =>
  path === '' ? rig.objects[0] : rig.named.get(path) ?? rig.named.get(path.slice(path.lastIndexOf('/') + 1));

// The separate float of a morph target, by its name or its number; of all targets, the first.
function floatOf(rig, object, target) {
  const first = rig.morphs.find(m => m.object === object)?.first;
  const k = target === undefined ? 0 : object?.morphTargetDictionary?.[target] ?? Number(target);
  return k >= 0 && k < object?.morphTargetInfluences?.length ? first + k : undefined;
}

const trackName =
  /^(?:.*\.bones\[(.*)\]|(.*))\.(?:(position|quaternion|scale)|morphTargetInfluences(?:\[(.*)\])?)$/;

// What a track of three.js animates, { target, index }: 'name.property', 'uuid.property', 'path/name.property',
// '.bones[name].property', 'name.morphTargetInfluences[target]'. null for all others: components, as 'name.position[y]',
// properties of materials, visibility.
function targetOf(rig, name) {
  const found = name.match(trackName);
  if (!found)
    return null;
  const [, bone, node, property, target] = found, object = objectOf(rig, bone ?? node);
  const index = property ? rig.jointOf.get(object) : floatOf(rig, object, target);
  return index === undefined ? null : { target: targets[property] ?? CLIP_FLOATS, index };
}

// Values of a track of differences, each added to the rest: the sum of numbers, the product of rotations.
function addToRest(rig, { target, index }, values, width, tall) {
  const rest = target === CLIP_FLOATS ? rig.restFloats.slice(index) : rig.rest.get(index, []).slice(...trsOf[target]);
  return Float32Array.from(values, (value, i) => {
    const k = i % width, from = i - k;
    if (target === CLIP_ROTATION)
      return product(rest, values.slice(from, from + 4))[k];
    return Math.floor(i / width) % tall === (tall >> 1) ? rest[k] + value : value; // tangents are differences
  });
}

function interpolationOf(track) {
  const interpolation = track.createInterpolant?.isInterpolantFactoryMethodGLTFCubicSpline
    ? INTERPOLATION_CUBICSPLINE : interpolations[track.getInterpolation()];
  if (interpolation === undefined)
    throw new RangeError(`nakawari: ${track.name}: neither LINEAR, STEP nor CUBICSPLINE`);
  return interpolation;
}

/**
 * The track of a KeyframeTrack, for a Clip; null if it animates nothing of the rig. With `additive`, the values are
 * differences from the rest pose of the rig, and are added to it.
 */
export function trackFromKeyframes(rig, from, additive = false) {
  const target = targetOf(rig, from.name);
  if (!target)
    return null;
  const interpolation = interpolationOf(from), tall = interpolation === INTERPOLATION_CUBICSPLINE ? 3 : 1;
  const kind = target.target === CLIP_ROTATION ? TRACK_ROTATION : TRACK_FLOATS;
  const width = from.values.length / from.times.length / tall;
  const values = additive ? addToRest(rig, target, from.values, width, tall) : from.values;
  const track = new Track({ times: from.times, values, width, kind, interpolation });
  rig.rootIsAnimated ||= target.index === 0 && target.target !== CLIP_FLOATS;
  return { ...target, track };
}

const additiveBlend = 2501; // THREE.AdditiveAnimationBlendMode

/**
 * The clip of an AnimationClip. An additive one is added to the rest pose; poseAdditiveBuild(pose, rig.rest, ...) of its
 * poses has the differences again. `skipped` receives the names of the tracks that animate nothing of the rig.
 */
export function clipFromAnimation(rig, animation, { format, skipped = [] } = {}) {
  const tracks = [];
  try {
    for (const from of animation.tracks) {
      const track = trackFromKeyframes(rig, from, animation.blendMode === additiveBlend);
      track ? tracks.push(track) : skipped.push(from.name);
    }
    const { objects, rest, restFloats, floatCount } = rig;
    return new Clip({ jointCount: objects.length, floatCount, tracks, rest, restFloats, format });
  } finally {
    tracks.forEach(t => t.track.dispose());
  }
}

// The rig that poses a three.js Skeleton.
const rigOf = new WeakMap();

/** The skin of a three.js Skeleton, for a Palette or a Crowd. */
export function skinFromSkeleton(rig, skeleton) {
  const joints = skeleton.bones.map(bone => rig.jointOf.get(bone));
  rigOf.set(skeleton, rig);
  if (joints.includes(undefined))
    throw new RangeError(`nakawari: bone ${joints.indexOf(undefined)} is not in the rig`);
  return { joints, inverseBind: skeleton.boneInverses.flatMap(matrix => matrix.toArray()) };
}

// Whether ten numbers of an object, or of a joint, are those of the root's rest.
const isRest = (rig, trs) => rig.rest.get(0, []).every((x, i) => x === Math.fround(trs[i]));

/**
 * Writes a pose into the objects, as an AnimationMixer does; three.js then computes the matrices. A root that no clip
 * of the rig animates remains where it is.
 */
export function poseToObjects(rig, pose) {
  const a = pose.array, n = pose.stride;
  rig.objects.forEach((object, i) => {
    if (i === 0 && !(rig.rootIsAnimated ||= !isRest(rig, pose.get(0, []))))
      return;
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

const identity = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];

// The world matrix of the space of a rig's poses, null for the identity: that of the parent of the root, and what the
// root has been moved by since its rest, if no clip animates it.
function placeOf(rig) {
  const [root] = rig.objects;
  root.updateWorldMatrix(true, false);
  const place = rig.rootIsAnimated || isRest(rig, trsOfObject(root)) ? root.parent?.matrixWorld
    : root.matrixWorld.clone().multiply(rig.restInverse);
  return place?.elements.some((x, i) => x !== identity[i]) ? place.elements : null;
}

// Multiplies the affine matrices of an array by one from the left.
function multiply(m, matrices) {
  for (let at = 0; at < matrices.length; at += 4) {
    const [x, y, z, w] = matrices.subarray(at, at + 4);
    for (let row = 0; row < 3; row++)
      matrices[at + row] = m[row] * x + m[4 + row] * y + m[8 + row] * z + m[12 + row] * w;
  }
}

/**
 * Fills the bone matrices of a three.js Skeleton with a Palette. Its bones have no effect on them from here on. The
 * figure is where the parents of the rig's root, and the root, are now: call it after they have been moved.
 */
export function fillSkeleton(skeleton, palette) {
  const rig = rigOf.get(skeleton), place = rig && placeOf(rig), { array } = palette;
  skeleton.update = keep;
  skeleton.boneMatrices.set(array);
  if (place)
    multiply(place, skeleton.boneMatrices.subarray(0, array.length));
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
