// SPDX-License-Identifier: MIT
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { bits, both, numbers, rotation } from './support.mjs';

const [[, math]] = await both('math');

for (const [build, n] of [...await both('characters'), ...await both('all')]) {
  const parents = [-1, 0, 1, 1, 0], joints = [4, 2, 0];
  const next = numbers(5), matrix = () => {
    const q = rotation(next);
    return math.mat4FromTrs([], [next(), next(), next(), ...q, 1, 1, 1]);
  };
  const inverseBind = joints.flatMap(matrix);
  const times = Float32Array.from({ length: 7 }, (_, k) => k / 3);
  const tracks = parents.map((_, index) => ({
    target: n.CLIP_ROTATION, index,
    track: new n.Track({ times, width: 4, kind: n.TRACK_ROTATION, values: [...times].flatMap(() => rotation(next)) }),
  }));
  const rest = new n.Pose(5);
  parents.forEach((_, j) => rest.set(j, [next(), next(), next(), 0, 0, 0, 1, 1, 1, 1]));
  const clip = new n.Clip({ jointCount: 5, tracks, rest }), skeleton = new n.Skeleton(parents);
  const pose = new n.Pose(5), models = new n.Matrices(5), palette = new n.Palette({ joints, inverseBind });

  test(`${build}: models are products along the parents, and joint matrices of them and the inverse binds`, () => {
    const root = matrix();
    clip.sample(0.4, pose);
    skeleton.models(pose, models, root);
    palette.update(models);
    const want = [];
    parents.forEach((parent, j) =>
      want.push(math.mat4MulAffine([], parent < 0 ? root : want[parent], math.mat4FromTrs([], pose.get(j, [])))));
    assert.deepEqual(bits(models.array), bits(want.flat()));
    assert.deepEqual(bits(palette.array), bits(joints.flatMap((j, k) =>
      math.mat4MulAffine([], want[j], inverseBind.slice(16 * k, 16 * k + 16)))));
  });

  test(`${build}: a crowd has the bits of its characters one by one, with and without roots`, () => {
    const count = 37, at = Float32Array.from({ length: count }, () => 1 + next());
    const roots = Float32Array.from(Array.from({ length: count }, matrix).flat());
    const crowd = new n.Crowd({ skeleton, count, joints, inverseBind });
    for (const root of [null, roots]) {
      crowd.play(clip, at, root);
      at.forEach((time, i) => {
        clip.sample(time, pose);
        skeleton.models(pose, models, root?.subarray(16 * i, 16 * i + 16));
        assert.deepEqual(bits(crowd.array.subarray(48 * i, 48 * i + 48)), bits(palette.update(models).array), `${i}`);
      });
    }
    assert.throws(() => crowd.play(clip, new Float32Array(count - 1)), RangeError);
    crowd.dispose();
  });

  test(`${build}: vertices move with their joints`, () => {
    const positions = Array.from({ length: 30 }, next);
    const mesh = new n.Mesh({ positions, normals: positions, influenceCount: 1,
      joints: Uint8Array.from({ length: 10 }, (_, i) => i % 3), weights: new Float32Array(10).fill(1) });
    mesh.skinLinear(palette);
    const { positions: moved, tangents } = mesh.skinned;
    assert.equal(tangents, null);
    for (let i = 0; i < 10; i++) {
      const m = palette.array.slice(16 * (i % 3), 16 * (i % 3) + 16);
      const want = math.mat4TransformPoint([], m, positions.slice(3 * i, 3 * i + 3));
      assert.deepEqual(bits(moved.subarray(3 * i, 3 * i + 3)), bits(want));
    }
    const whole = moved.slice(), half = new n.Mesh({ positions, normals: positions, influenceCount: 1,
      joints: Float32Array.from({ length: 10 }, (_, i) => i === 9 ? 0.5 : i % 3), weights: new Float32Array(10).fill(0.5) });
    half.skinLinear(palette, { divideByWeights: true, inverseNormals: true });
    const { positions: divided, normals } = half.skinned;
    assert.deepEqual(bits(divided.subarray(0, 27)), bits(whole.subarray(0, 27)));
    assert.deepEqual([...divided.subarray(27)], positions.slice(27).map(Math.fround));
    for (let i = 0; i < 9; i++) {
      const m = palette.array.slice(16 * (i % 3), 16 * (i % 3) + 16);
      const block = [0, 1, 2, 4, 5, 6, 8, 9, 10].map(k => m[k]);
      const want = math.vec3Normalize([], math.mat3Transform([], math.mat3Normal([], block), positions.slice(3 * i, 3 * i + 3)));
      want.forEach((x, k) => assert.ok(Math.abs(normals[3 * i + k] - x) < 1e-6));
    }
    half.dispose();
    const linear = moved.slice(), dual = new n.Palette({ joints, inverseBind, format: n.PALETTE_DUAL_QUAT });
    dual.update(models);
    mesh.skinDualQuat(dual);
    mesh.skinned.positions.forEach((x, k) => assert.ok(Math.abs(x - linear[k]) < 1e-5));
    assert.throws(() => mesh.skinLinear(dual), /format/);
    const few = { joints: new Uint8Array(10), weights: new Float32Array(10) };
    assert.throws(() => new n.Mesh({ positions, ...few }), RangeError);
    [mesh, dual].forEach(object => object.dispose());
  });

  test(`${build}: blends of poses`, () => {
    const [a, b, out] = [new n.Pose(5), new n.Pose(5), new n.Pose(5)];
    clip.sample(0.1, a);
    clip.sample(1.1, b);
    n.poseBlendSlerp(a, b, 0.25, out);
    for (let j = 0; j < 5; j++)
      assert.deepEqual(bits(out.get(j, []).slice(3, 7)),
        bits(math.quatSlerp([], a.get(j, []).slice(3, 7), b.get(j, []).slice(3, 7), 0.25)));
    assert.deepEqual(bits(n.poseBlend(a, b, 0, out).get(2, [])), bits(a.get(2, [])));
    n.poseAdditiveBuild(b, a, n.ADDITIVE_LOCAL, out);
    n.poseAdditiveApply(a, out, 1, n.ADDITIVE_LOCAL, out);
    out.array.forEach((x, k) => assert.ok(Math.abs(Math.abs(x) - Math.abs(b.array[k])) < 1e-5));
    [a, b, out].forEach(object => object.dispose());
  });

  test(`${build}: a skeleton that is not ordered is refused with the joint`, () => {
    assert.throws(() => new n.Skeleton([-1, 2, 0]), { index: 1, message: /a joint precedes its parent/ });
  });

  test(`${build}: everything is released`, () => {
    [rest, clip, skeleton, pose, models, palette, ...tracks.map(t => t.track)].forEach(object => object.dispose());
    assert.equal(n.memory().blocks, 0);
  });
}
