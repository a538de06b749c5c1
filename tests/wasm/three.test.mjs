// SPDX-License-Identifier: MIT
// The adapter beside the AnimationMixer and the Skeleton of three.js (NKW_THREE, its folder).
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { numbers, packageFolder, root, rotation } from './support.mjs';

const three = process.env.NKW_THREE;
const THREE = await import(`${three}/build/three.module.js`);
const { GLTFLoader } = await import(`${three}/examples/jsm/loaders/GLTFLoader.js`);
const over = async (part, name) => {
  const [n, adapter] = [await import(`${packageFolder}/${part}.js`), await import(`${packageFolder}/${name}.js`)];
  await n.ready;
  return { n, adapter };
};
const { n, adapter } = await over('characters', 'three');

async function character() {
  const bytes = Uint8Array.from(readFileSync(`${root}/docs/examples/character.glb`));
  const model = await new GLTFLoader().parseAsync(bytes.buffer, '');
  const meshes = [];
  model.scene.traverse(object => object.isSkinnedMesh && meshes.push(object));
  model.scene.position.set(0.5, 0, -2);
  model.scene.updateMatrixWorld(true);
  return { ...model, meshes };
}

// The bone matrices of three.js at a time.
function play({ scene, animations, meshes }, index, time) {
  const mixer = new THREE.AnimationMixer(scene);
  mixer.clipAction(animations[index]).play();
  mixer.setTime(time);
  scene.updateMatrixWorld(true);
  meshes[0].skeleton.update();
  const matrices = meshes[0].skeleton.boneMatrices.slice(0, 16 * meshes[0].skeleton.bones.length);
  const influences = meshes.filter(m => m.morphTargetInfluences).map(m => [...m.morphTargetInfluences]);
  mixer.stopAllAction();
  return { matrices, influences };
}

const apart = (a, b) => Math.max(...Array.from(a, (x, i) => Math.abs(x - b[i])));

test('a crowd of a file has the matrices of the mixer, for LINEAR, STEP and CUBICSPLINE', async t => {
  const model = await character(), rig = adapter.rigFromObject(model.scene), count = 40;
  const skin = adapter.skinFromSkeleton(rig, model.meshes[0].skeleton);
  const crowd = new n.Crowd({ skeleton: rig.skeleton, count, ...skin }), palette = new n.Palette(skin);
  const pose = new n.Pose(rig.objects.length), models = new n.Matrices(rig.objects.length);
  let worst = 0;
  model.animations.forEach((animation, index) => {
    const skipped = [], clip = adapter.clipFromAnimation(rig, animation, { skipped });
    assert.deepEqual(skipped, []);
    assert.equal(clip.end, Math.fround(animation.duration));
    const times = Float32Array.from({ length: count }, (_, i) => animation.duration * (i + 0.3) / count);
    crowd.play(clip, times);
    times.forEach((time, i) => {
      const ours = crowd.array.slice(16 * crowd.jointCount * i, 16 * crowd.jointCount * (i + 1));
      const floats = new Float32Array(rig.floatCount), theirs = play(model, index, time);
      clip.sample(time, pose, floats);
      assert.deepEqual([...palette.update(rig.skeleton.models(pose, models)).array], [...ours]);
      worst = Math.max(worst, apart(ours, theirs.matrices), apart(floats, theirs.influences.flat()));
    });
  });
  t.diagnostic(`largest difference of an element: ${worst}`);
  assert.ok(worst < 1e-5, `${worst}`);
});

test('the adapter of the part all makes objects of that part', async () => {
  const all = await over('all', 'all/three'), { scene, animations } = await character();
  const rig = all.adapter.rigFromObject(scene), clip = all.adapter.clipFromAnimation(rig, animations[0]);
  assert.ok(clip instanceof all.n.Clip && !(clip instanceof n.Clip));
  assert.deepEqual([...clip.bytes], [...adapter.clipFromAnimation(adapter.rigFromObject(scene), animations[0]).bytes]);
});

test('a pose written into objects gives the matrices that a palette fills in', async () => {
  const model = await character(), rig = adapter.rigFromObject(model.scene), [body] = model.meshes;
  const clip = adapter.clipFromAnimation(rig, model.animations[2]), pose = new n.Pose(rig.objects.length);
  const floats = new Float32Array(rig.floatCount);
  clip.sample(0.37, pose, floats);
  adapter.poseToObjects(rig, pose);
  adapter.floatsToObjects(rig, floats);
  model.scene.updateMatrixWorld(true);
  body.skeleton.update();
  const theirs = body.skeleton.boneMatrices.slice(), models = new n.Matrices(rig.objects.length);
  const morphs = model.meshes.filter(mesh => mesh.morphTargetInfluences);
  assert.deepEqual(morphs.flatMap(mesh => mesh.morphTargetInfluences), [...floats]);
  assert.ok(floats.some(x => x !== 0));
  const palette = new n.Palette(adapter.skinFromSkeleton(rig, body.skeleton));
  const { version } = body.skeleton.computeBoneTexture().boneTexture;
  adapter.fillSkeleton(body.skeleton, palette.update(rig.skeleton.models(pose, models)));
  body.skeleton.update();
  assert.ok(apart(theirs, body.skeleton.boneMatrices) < 1e-5);
  assert.deepEqual([...body.skeleton.boneMatrices.slice(0, palette.array.length)], [...palette.array]);
  assert.equal(body.skeleton.boneTexture.version, version + 1);
});

test('a bone texture has a row for each character, which is the memory of the crowd', async () => {
  const model = await character(), { skeleton } = model.meshes[0];
  const rig = adapter.rigFromObject(model.scene, skeleton.bones), skin = adapter.skinFromSkeleton(rig, skeleton);
  assert.ok(rig.objects.length < adapter.rigFromObject(model.scene).objects.length);
  const clip = adapter.clipFromAnimation(rig, model.animations[0]);
  for (const count of [5, 9]) {
    const crowd = new n.Crowd({ skeleton: rig.skeleton, count, ...skin }).play(clip, new Float32Array(count));
    adapter.fillInstances(skeleton, crowd);
    const { image, version } = skeleton.boneTexture;
    assert.deepEqual([image.width, image.height], [4 * crowd.jointCount, count]);
    assert.equal(image.data.buffer, crowd.array.buffer);
    assert.deepEqual([...image.data], [...crowd.array]);
    adapter.fillInstances(skeleton, crowd);
    assert.equal(skeleton.boneTexture.version, version + 1);
  }
});

test('a material takes the row of its instance', () => {
  const material = adapter.instanceMaterial(new THREE.MeshStandardMaterial());
  const shader = { vertexShader: THREE.ShaderLib.standard.vertexShader };
  material.onBeforeCompile(shader);
  assert.match(shader.vertexShader, /skinning_pars_vertex>\n#define getBoneMatrix\( i \) .*gl_InstanceID/);
  assert.notEqual(material.customProgramCacheKey(), new THREE.MeshStandardMaterial().customProgramCacheKey());
});

test('tracks are found by name, uuid and bone; others are named, and smooth ones refused', () => {
  const scene = new THREE.Group(), bone = new THREE.Bone();
  scene.add(bone);
  bone.name = 'arm';
  const rig = adapter.rigFromObject(scene), keys = [[0, 1], [0, 0, 0, 1, 2, 3]];
  const of = (name, ...more) => new THREE.VectorKeyframeTrack(name, ...keys, ...more);
  for (const name of ['arm.position', `${bone.uuid}.position`, '.bones[arm].position'])
    assert.equal(adapter.trackFromKeyframes(rig, of(name)).index, 1, name);
  assert.equal(adapter.trackFromKeyframes(rig, of('.scale')).index, 0);
  const skipped = [], names = ['leg.position', 'arm.visible', '.material.color'];
  adapter.clipFromAnimation(rig, { tracks: names.map(name => of(name)) }, { skipped });
  assert.deepEqual(skipped, names);
  assert.throws(() => adapter.trackFromKeyframes(rig, of('arm.position', THREE.InterpolateSmooth)), RangeError);
  const wrong = new THREE.VectorKeyframeTrack('arm.position', [1, 0], keys[1]);
  assert.throws(() => adapter.clipFromAnimation(rig, { tracks: [wrong] }), { index: 1 });
  const stranger = new THREE.Skeleton([new THREE.Bone()]);
  assert.throws(() => adapter.skinFromSkeleton(rig, stranger), /bone 0 is not in the rig/);
});

// The properties of all objects of a tree at a time, by the mixer, and by a clip of the adapter.
function byMixer(root, animation, time) {
  const mixer = new THREE.AnimationMixer(root);
  mixer.clipAction(animation).play();
  mixer.setTime(time);
  return numbersOf(root);
}
function byClip(root, animation, time) {
  const rig = adapter.rigFromObject(root), skipped = [], clip = adapter.clipFromAnimation(rig, animation, { skipped });
  const pose = new n.Pose(rig.objects.length), floats = new Float32Array(rig.floatCount);
  clip.sample(time, pose, floats);
  adapter.poseToObjects(rig, pose);
  adapter.floatsToObjects(rig, floats);
  return { ...numbersOf(root), skipped };
}
function numbersOf(root) {
  const values = [];
  root.traverse(o => values.push(...o.position.toArray(), ...o.quaternion.toArray(), ...o.scale.toArray(),
    ...o.morphTargetInfluences ?? []));
  return { values };
}

function face() {
  const root = Object.assign(new THREE.Group(), { name: 'root' }), geometry = new THREE.BufferGeometry();
  geometry.setAttribute('position', new THREE.Float32BufferAttribute(9, 3));
  geometry.morphAttributes.position = ['smile', 'blink'].map(name =>
    Object.assign(new THREE.Float32BufferAttribute(9, 3), { name }));
  const mesh = Object.assign(new THREE.Mesh(geometry), { name: 'face' });
  mesh.updateMorphTargets();
  mesh.position.set(1, 3, -2);
  mesh.rotation.set(0.1, 0.2, 0.5);
  mesh.scale.set(2, 1, 0.5);
  mesh.morphTargetInfluences[1] = 0.125;
  return root.add(mesh);
}

const turn = angle => new THREE.Quaternion().setFromAxisAngle(new THREE.Vector3(0, 0.6, 0.8), angle).toArray();

test('an additive clip is added to the rest pose, as the mixer plays it', () => {
  const times = [0, 0.5, 1], make = () => THREE.AnimationUtils.makeClipAdditive(new THREE.AnimationClip('breath', -1, [
    new THREE.VectorKeyframeTrack('face.position', times, [0, 3, 0, 0, 3.1, 0, 1, 2, 3]),
    new THREE.QuaternionKeyframeTrack('face.quaternion', times, [0.5, 0.6, -0.4].flatMap(turn)),
    new THREE.VectorKeyframeTrack('face.scale', times, [1, 1, 1, 1, 2, 1, 3, 1, 1], THREE.InterpolateDiscrete),
    new THREE.NumberKeyframeTrack('face.morphTargetInfluences[blink]', times, [0.5, 0.25, 1])]));
  for (const time of [0, 0.2, 0.5, 0.8, 0.99])
    assert.ok(apart(byClip(face(), make(), time).values, byMixer(face(), make(), time).values) < 1e-6, `${time}`);
});

test('tracks of single morph targets and paths are read; components are named as skipped', () => {
  const number = (name, values) => new THREE.NumberKeyframeTrack(name, [0, 1], values);
  for (const track of [number('face.morphTargetInfluences[smile]', [0, 1]),
    number('face.morphTargetInfluences[1]', [0, 1]),
    number('face.morphTargetInfluences', [0, 0, 1, 0.5]),
    new THREE.VectorKeyframeTrack('root/face.position', [0, 1], [0, 0, 0, 2, 0, 0])]) {
    const animation = new THREE.AnimationClip('c', -1, [track]), ours = byClip(face(), animation, 0.5);
    assert.deepEqual(ours.skipped, []);
    assert.ok(apart(ours.values, byMixer(face(), animation, 0.5).values) < 1e-6, track.name);
    assert.ok(apart(ours.values, numbersOf(face()).values) > 0.1, track.name);
  }
  const others = ['face.position[y]', 'face.rotation[z]', 'face.morphTargetInfluences[wink]',
    'face.morphTargetInfluences[2]', 'leg.morphTargetInfluences[smile]'].map(name => number(name, [0, 1]));
  assert.deepEqual(byClip(face(), { tracks: others }, 0.5).skipped, others.map(track => track.name));
});

test('an attached figure follows its root and the parents of the root', async () => {
  const model = await character(), [body] = model.meshes, { skeleton } = body, above = new THREE.Group();
  const top = new THREE.Group();
  top.add(above.add(model.scene));
  const rig = adapter.rigFromObject(model.scene, skeleton.bones);
  const clip = adapter.clipFromAnimation(rig, model.animations[0]);
  const palette = new n.Palette(adapter.skinFromSkeleton(rig, skeleton)), pose = new n.Pose(rig.objects.length);
  const models = new n.Matrices(rig.objects.length), update = skeleton.update;
  clip.sample(0.3, pose);
  for (const move of [() => {}, () => above.position.set(10, 0, 0), () => model.scene.position.set(3, 0, 5),
    () => above.rotation.set(0.3, 1, 0), () => top.scale.set(2, 1, 1), () => model.scene.rotation.set(0, 2, 1)]) {
    move();
    adapter.fillSkeleton(skeleton, palette.update(rig.skeleton.models(pose, models)));
    const ours = skeleton.boneMatrices.slice();
    skeleton.update = update;
    top.updateMatrixWorld(true);
    const theirs = play(model, 0, 0.3).matrices;
    assert.ok(apart(theirs, ours) < 2e-5, `${move}: ${apart(theirs, ours)}`);
  }
  const moved = model.scene.position.toArray();
  adapter.poseToObjects(rig, pose);
  assert.deepEqual(model.scene.position.toArray(), moved, 'no clip animates the root');
});

test('a root that a clip animates is where the clip has it', () => {
  const make = () => {
    const [parent, root, bone] = [new THREE.Group(), new THREE.Bone(), new THREE.Bone()];
    parent.add(Object.assign(root, { name: 'hips' }).add(bone));
    parent.position.set(0, 0, 4);
    parent.rotation.y = 1;
    bone.position.y = 1;
    parent.updateMatrixWorld(true);
    return { parent, root, skeleton: new THREE.Skeleton([root, bone]) };
  };
  const animation = new THREE.AnimationClip('walk', -1,
    [new THREE.VectorKeyframeTrack('hips.position', [0, 1], [0, 0, 0, 2, 0, 0])]);
  const theirs = make(), ours = make(), rig = adapter.rigFromObject(ours.root), pose = new n.Pose(2);
  byMixer(theirs.root, animation, 0.75);
  theirs.parent.updateMatrixWorld(true);
  theirs.skeleton.update();
  const palette = new n.Palette(adapter.skinFromSkeleton(rig, ours.skeleton));
  adapter.clipFromAnimation(rig, animation).sample(0.75, pose);
  for (let frame = 0; frame < 2; frame++) {
    adapter.fillSkeleton(ours.skeleton, palette.update(rig.skeleton.models(pose, new n.Matrices(2))));
    assert.ok(apart(ours.skeleton.boneMatrices.slice(0, 32), theirs.skeleton.boneMatrices.slice(0, 32)) < 1e-6);
    adapter.poseToObjects(rig, pose);
  }
});

// A tree of 67 bones, each turned by 301 keys.
function figure(next) {
  const bones = Array.from({ length: 67 }, (_, i) => Object.assign(new THREE.Bone(), { name: `bone${i}` }));
  bones.forEach((bone, i) => {
    bone.position.set(next(), next(), next());
    bones[Math.floor((i - 1) / 3)]?.add(bone);
  });
  return { bones, skeleton: new THREE.Skeleton(bones) };
}

const median = list => list.sort((a, b) => a - b)[list.length >> 1];

test('1000 characters of 67 joints take less time than the mixer', t => {
  const count = 1000, next = numbers(11), times = Float32Array.from({ length: 301 }, (_, i) => i / 30);
  const { bones, skeleton: instances } = figure(numbers(12));
  const animation = new THREE.AnimationClip('all', 10, bones.map(bone =>
    new THREE.QuaternionKeyframeTrack(`${bone.name}.quaternion`, times, [...times].flatMap(() => rotation(next)))));
  const actors = Array.from({ length: count }, () => {
    const actor = figure(numbers(12)), mixer = new THREE.AnimationMixer(actor.bones[0]);
    mixer.clipAction(animation).play();
    return { ...actor, mixer };
  });
  const rig = adapter.rigFromObject(bones[0]), clip = adapter.clipFromAnimation(rig, animation);
  const crowd = new n.Crowd({ skeleton: rig.skeleton, count, ...adapter.skinFromSkeleton(rig, instances) });
  const at = new Float32Array(count), took = { mixer: [], crowd: [] };
  const one = ({ bones: [top], skeleton, mixer }, i) => {
    mixer.setTime(at[i]);
    top.updateMatrixWorld(true);
    skeleton.update();
  };
  for (let frame = 0; frame < 7; frame++) {
    at.forEach((_, i) => { at[i] = (i / 101 + frame / 60) % 10; });
    let start = performance.now();
    actors.forEach(one);
    took.mixer.push(performance.now() - start);
    start = performance.now();
    crowd.play(clip, at);
    adapter.fillInstances(instances, crowd);
    took.crowd.push(performance.now() - start);
  }
  const size = 16 * crowd.jointCount, ours = i => crowd.array.subarray(size * i, size * i + size);
  const worst = Math.max(...actors.map(({ skeleton }, i) => apart(ours(i), skeleton.boneMatrices)));
  const [mixer, mine] = [took.mixer, took.crowd].map(list => 1000 * median(list) / count);
  t.diagnostic(`microseconds a character: three.js ${mixer.toFixed(1)}, Crowd ${mine.toFixed(1)}; ` +
    `largest difference of an element ${worst}`);
  assert.ok(worst < 1e-4, `${worst}`);
  assert.ok(mine < mixer);
});
