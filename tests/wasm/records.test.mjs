// SPDX-License-Identifier: MIT
// Functions with structs, and the objects for curves and motion, by identities.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { bits, both, numbers, rotation } from './support.mjs';

const near = (a, b, error = 1e-5) =>
  [...a].forEach((x, k) => assert.ok(Math.abs(x - b[k]) <= error, `${x} ${b[k]} (${k})`));

for (const [build, n] of await both('all')) {
  const curve = { times: [0, 1, 3], values: [1, 2, 0], method: n.SPLINE_PCHIP };
  const parents = [-1, 0, 1, 1];

  test(`${build}: a curve with handles passes its keys, and a key added does not change it`, () => {
    const keys = [[0, 1], [1, 3], [2, -1]].map(([time, value]) =>
      ({ time, value, in: [-0.3, 0.1], out: [0.4, 0.2], kind: n.FCURVE_BEZIER, ease: n.EASE_LINEAR }));
    const before = new n.FCurve({ keys, before: n.FCURVE_OUTSIDE_HOLD, after: n.FCURVE_OUTSIDE_CYCLE });
    keys.forEach(key => assert.equal(before.sample(key.time, [])[0], key.value));
    assert.equal(before.sample(-1, [])[0], 1);
    assert.deepEqual(before.sample(2.5, []), before.sample(0.5, []));
    const { index, keys: more } = before.insert(0.5), after = new n.FCurve({ keys: more });
    assert.deepEqual([index, more.length, before.keys.length], [1, 4, 3]);
    for (const time of [0.1, 0.4, 0.5, 0.8, 1.5])
      near(before.sample(time, []), after.sample(time, []), 1e-4);
    assert.throws(() => new n.FCurve({ keys: [keys[1], keys[0]] }), { index: 1 });
    [before, after].forEach(object => object.dispose());
  });

  test(`${build}: an ellipse of NURBS, tangents of a spline`, () => {
    const points = [[1, 0], [1, 1], [0, 1]], weights = [1, Math.SQRT1_2, 1];
    const circle = { points, weights, width: 2, degree: 2, knots: [] };
    n.nurbsMakeKnots(3, 2, 0, 1, n.NURBS_KNOTS_CLAMPED, circle.knots);
    n.nurbsValidate(circle);
    const at = [];
    n.nurbsEvaluate(circle, 0.3, { value: at });
    const speed = [];
    n.nurbsEvaluate(circle, 0.3, { velocity: speed });
    near([at[0] * speed[0] + at[1] * speed[1]], [0]);
    assert.ok(Math.abs(Math.hypot(...at) - 1) < 1e-6);
    assert.throws(() => n.nurbsValidate({ ...circle, knots: [0, 0] }), RangeError);
    const [a, b] = [[], []];
    n.splineTangents(curve, a, b);
    assert.deepEqual([a.length, a[1], b[1]], [3, 0, 0]); // PCHIP: no overshoot at an extreme
    assert.throws(() => n.splineTangents({ ...curve, times: [0, 2, 1] }, a, b), { index: 2 });
  });

  test(`${build}: poly-curves: length, constant speed, frames`, () => {
    const line = { cubics: [[[0, 0, 0], [1, 0, 0], [2, 0, 0], [3, 0, 0]]].flat(), kind: n.CUBIC_BEZIER };
    const lengths = [], frames = [], points = [], count = [];
    n.polycurveMeasure(line, 4, lengths, 5);
    near(lengths, [0, 0.75, 1.5, 2.25, 3]);
    const { index, t } = n.polycurveAtLength({}, line, lengths, 5, 1.2);
    assert.deepEqual([index, Math.round(1000 * t)], [0, 400]);
    near(n.polycurveEvaluate([], line, { index, t }).slice(0, 3), [1.2, 0, 0]);
    n.polycurveFrames(line, 2, [0, 1, 0], n.POLYCURVE_OPEN, frames, 3);
    assert.deepEqual(frames[2].tangent, [1, 0, 0]);
    n.polycurveFlatten(line, 0.01, points, 2, count);
    assert.equal(count[0], 2);
    near(points, [0, 0, 0, 3, 0, 0]);
  });

  test(`${build}: a closed loop, a resampled and a reduced track`, () => {
    const times = [0, 1, 2, 3], track = new n.Track({ times, values: [0, 1, 2, 5] }), error = [], rate = [];
    const less = n.trackReduce(track, 1e-6, error), even = n.trackResample(track, 2);
    assert.deepEqual([[...less.times], [...even.values]], [[0, 2, 3], [0, 0.5, 1, 1.5, 2, 3.5, 5]]);
    n.trackDifference(track, even, error);
    assert.deepEqual(error, [0]);
    const closed = n.trackClose(track, 0), low = n.trackResampleWithin(track, 10, rate);
    assert.deepEqual([closed.values[0], closed.values[3]], [0, 0]);
    assert.ok(rate[0] > 0 && low.count <= 4);
    assert.throws(() => n.trackTrim(track, 2, 1), /nkw_track_trim/);
    assert.throws(() => n.trackResample(track, -2), /nkw_track_resample/);
    [track, less, even, closed, low].forEach(object => object.dispose());
  });

  const next = numbers(9), pose = () => {
    const made = new n.Pose(4);
    parents.forEach((_, j) => made.set(j, [next(), next(), next(), ...rotation(next), 1, 1, 1]));
    return made;
  };

  test(`${build}: a transition begins at the old pose and ends at the new one`, () => {
    const [a, b, out, velocity] = [pose(), pose(), new n.Pose(4), new n.PoseVelocity(4)];
    n.poseVelocityFromPoses(a, a, 0.1, velocity);
    assert.ok(velocity.array.every(x => x === 0));
    const inertia = new n.PoseInertia(4), blend = new n.PoseDeadBlend(4, 0.1, 0.5);
    n.poseInertiaBegin(inertia, { pose: a, velocity }, { pose: b, velocity }, 0.5);
    n.poseDeadBlendBegin(blend, { pose: a });
    for (const evaluate of [t => n.poseInertiaEvaluate(inertia, b, t, out),
      t => n.poseDeadBlendEvaluate(blend, b, t, out)]) {
      evaluate(0);
      parents.forEach((_, j) => {
        const [got, want] = [out.get(j, []), a.get(j, [])];
        near(got.slice(0, 3), want.slice(0, 3));
        near(got.slice(3, 7).map(Math.abs), want.slice(3, 7).map(Math.abs));
      });
      evaluate(0.5);
      parents.forEach((_, j) => assert.deepEqual(bits(out.get(j, [])), bits(b.get(j, []))));
    }
    assert.throws(() => n.poseInertiaEvaluate(inertia, velocity, 0, out), TypeError);
    [a, b, out, velocity, inertia, blend].forEach(object => object.dispose());
  });

  test(`${build}: layers and masks`, () => {
    const [a, b, out, mask] = [pose(), pose(), new n.Pose(4), new n.Mask(4)];
    const skeleton = new n.Skeleton(parents);
    mask.array.fill(0);
    n.maskFromSubtree(skeleton, 1, mask);
    assert.deepEqual([...mask.array.slice(0, 4)], [0, 1, 1, 1]);
    n.poseBlend(a, b, 1, out, mask);
    assert.deepEqual([bits(out.get(0, [])), bits(out.get(2, []))], [bits(a.get(0, [])), bits(b.get(2, []))]);
    n.poseLayersBlend([{ pose: a, weight: 1 }, { pose: b, weight: 0 }], 2, a, 0.1, out);
    near(out.get(3, []).slice(0, 3), a.get(3, []).slice(0, 3));
    n.poseMirror(a, [0, 1, 3, 2], n.MIRROR_X, out);
    near(out.get(2, []).slice(0, 3), [-1, 1, 1].map((s, k) => s * a.get(3, [])[k]));
    assert.throws(() => n.poseMirror(a, [0, 2, 3, 1], n.MIRROR_X, out), { index: 1 });
    [a, b, out, mask, skeleton].forEach(object => object.dispose());
  });

  test(`${build}: inverse kinematics reaches`, () => {
    const limb = { root: [0, 2, 0], mid: [0, 1, 0.1], end: [0, 0, 0], target: [0.3, 0.5, 0.4], pole: [0, 0, 1],
      hinge: [1, 0, 0], softness: 0, weight: 1 };
    const solved = n.ikTwoBoneSolve({}, limb);
    near(solved.endPosition, limb.target);
    assert.ok(solved.error < 1e-5 && solved.root.length === 4);
    const chain = { position: [0, 0, 0], rotation: [0, 0, 0, 1], offsets: [[1, 0, 0], [1, 0, 0], [1, 0, 0]] };
    for (const method of [n.IK_CCD, n.IK_FABRIK]) {
      const q = [0, 0, 0, 1, 0, 0, 0.0998334, 0.9950042, 0, 0, 0, 1];
      const solved = {}, goal = { target: [1, 1, 0.5], tolerance: 1e-4, iterations: 100 };
      n.ikChainSolve(chain, goal, method, q, solved);
      const { error, iterations } = solved;
      assert.ok(error <= 1e-4 && iterations > 0, `${error}`);
    }
    const skeleton = new n.Skeleton([-1, 0, 1]), body = new n.Pose(3), models = new n.Matrices(3);
    const error = [], result = {};
    body.set(1, [0, 1, 0, 0, 0, 0.0998334, 0.9950042, 1, 1, 1]);
    body.set(2, [0, 1, 0, 0, 0, 0, 1, 1, 1, 1]);
    skeleton.models(body, models);
    const target = [0.5, 1.2, 0];
    n.ikPoseTwoBone({ skeleton, models, root: null, pose: body }, { root: 0, mid: 1, end: 2, target, pole: [0, 0, 0],
      hinge: [0, 0, 1], softness: 0, weight: 1 }, error);
    assert.ok(error[0] < 1e-5, `${error}`);
    skeleton.models(body, models);
    near(models.array.slice(44, 47), target);
    n.ikPoseChain({ skeleton, models, root: null, pose: body }, { end: 2, jointCount: 2, method: n.IK_FABRIK, weight: 1,
      goal: { target: [0.4, 1.1, 0.3], tolerance: 1e-4, iterations: 100 } }, result);
    assert.ok(result.error <= 1e-4);
    [skeleton, body, models].forEach(object => object.dispose());
  });

  test(`${build}: retargeting to the same skeleton is the identity; feet stay`, () => {
    const skeleton = new n.Skeleton(parents), rest = pose(), source = pose(), out = new n.Pose(4);
    const joints = parents.map((_, j) => ({ from: j, to: -1, t: 0, translation: 1 }));
    const map = { source: skeleton, target: skeleton, sourceRest: rest, targetRest: rest, joints, align: [0, 0, 0, 1] };
    n.retargetValidate(map);
    n.retargetApply(map, source, out);
    parents.forEach((_, j) => near(out.get(j, []).map(Math.abs), source.get(j, []).map(Math.abs), 1e-4));
    assert.throws(() => n.retargetValidate({ ...map, joints: [...joints.slice(1), { from: 7 }] }), { index: 3 });
    const scale = [0];
    n.retargetChainScale(map, [0, 1], 2, [0, 1], 2, scale);
    assert.equal(scale[0], 1);
    const rules = { up: [0, 1, 0], enterHeight: 0.1, leaveHeight: 0.2, enterSpeed: 10, leaveSpeed: 20,
      releaseDistance: 1, duration: 0.2 };
    const foot = {}, at = [0, 0.01].map(x => n.footUpdate([], foot, rules, [x, 0, 0], 0, 0.01));
    assert.equal(foot.contact, 1);
    near(at[1], at[0], 1e-2);
    [skeleton, rest, source, out].forEach(object => object.dispose());
  });

  test(`${build}: weights of a blend space, boxes, times`, () => {
    const space = { samples: [[0, 0], [1, 0], [0, 1]], dimension: 2, kind: n.BLENDSPACE_CARTESIAN }, weights = [];
    n.blendspaceValidate(space);
    n.blendspaceWeights(space, [1, 0], weights);
    near(weights, [0, 1, 0]);
    const far = [Infinity, Infinity, Infinity], empty = { low: far, high: far.map(x => -x) };
    const point = p => ({ low: p, high: p }), box = n.boxUnion({}, n.boxUnion({}, empty, point([1, 2, 3])), point([0, 0, 5]));
    assert.deepEqual(box, { low: [0, 0, 3], high: [1, 2, 5] });
    const keys = [], passed = [], clock = {};
    const range = { start: 0, duration: 2, before: n.PLAYBACK_LOOP, after: n.PLAYBACK_LOOP };
    n.playbackPassed({ times: [0, 1], duration: 2, from: 0.5, to: 4.5, includesFrom: 0n }, keys, 8, passed);
    assert.deepEqual([passed, keys.slice(0, 4)], [[4], [1, 0, 1, 0]]);
    assert.equal(n.playbackHeadF64({}, range, 1e6 + 0.25).time, 0.25);
    n.timecodeFromFrame(1800, 30, 1, clock);
    assert.deepEqual(clock, { hours: 0, minutes: 1, seconds: 0, frames: 2 });
    const map = n.axesMapFromAxes({}, n.AXES_BLENDER, n.AXES_GLTF);
    assert.deepEqual(map, { x: n.AXIS_X, y: n.AXIS_Z, z: n.AXIS_NEGATIVE_Y });
    assert.deepEqual(n.axesConvertVec3([], map, [1, 2, 3]), [1, 3, -2]);
    assert.throws(() => n.axesConvertVec3([], undefined, [1, 2, 3]), /no axes_map/);
    assert.throws(() => n.axesConvertVec3([], map), /no v/);
  });

  test(`${build}: names, reduced clips and their tracks`, () => {
    const times = Array.from({ length: 31 }, (_, k) => k / 30), turn = t => [0, 0, Math.sin(t), Math.cos(t)];
    const made = (index, values) => ({ target: n.CLIP_ROTATION, index,
      track: new n.Track({ times, values, width: 4, kind: n.TRACK_ROTATION }) });
    const tracks = [made(0, times.map(t => turn(t / 3)).flat()), made(1, times.map(t => turn(t * t)).flat())];
    const rest = new n.Pose(2);
    rest.set(1, [0, 1, 0, 0, 0, 0, 1, 1, 1, 1]);
    const names = { clip: 'wave', joints: ['upper', '下'], floats: ['smile', '眉'] };
    const source = { jointCount: 2, floatCount: 2, tracks, rest, names };
    const reduction = { parents: [-1, 0], tolerance: 1e-3, distance: 1 }, [keys, bytes, error] = [{}, {}, {}];
    const clip = new n.Clip(source), less = n.clipSourceReduce(source, reduction, keys);
    const small = n.clipReduce(source, reduction, bytes);
    assert.deepEqual([clip.name, ...[0, 1, 2].map(j => small.jointName(j))], ['wave', 'upper', '下', '']);
    assert.deepEqual([0, 1, 2].map(i => clip.floatName(i)), ['smile', '眉', '']);
    n.clipDifference(clip, source, error);
    assert.deepEqual(error, { translation: 0, rotation: 0, scale: 0, floats: 0 });
    assert.ok(keys.keyCount < keys.sourceKeyCount && keys.sourceKeyCount === 62 && keys.distance <= 1e-3);
    assert.equal(less.tracks.reduce((sum, t) => sum + t.track.count, 0), keys.keyCount);
    assert.ok(bytes.bytes === small.size && small.size < clip.size && bytes.distance <= 1e-3);
    n.clipSourceDifference(source, less, reduction, error);
    assert.ok(error.distance > 0 && error.distance <= 1e-3);
    const again = n.clipTracks(clip);
    assert.deepEqual(again.map(t => [t.target, t.index, bits(t.track.values)]),
      tracks.map(t => [t.target, t.index, bits(t.track.values)]));
    assert.throws(() => n.clipReduce(source, { ...reduction, parents: [-1] }), RangeError);
    const used = [...tracks, ...less.tracks, ...again].map(t => t.track);
    [clip, small, rest, ...used].forEach(object => object.dispose());
  });

  test(`${build}: morph targets, boxes of joints, parts`, () => {
    const positions = [0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1], joints = Uint8Array.of(0, 1, 1, 0);
    const mesh = new n.Mesh({ positions, influenceCount: 1, joints, weights: new Float32Array(4).fill(1) });
    const dense = { positions: positions.map(() => 1) }, sparse = { positions: [0, 0, 4], indices: [1] };
    const morph = new n.Morph(mesh, [dense, sparse]), boxes = [];
    assert.deepEqual([...morph.apply([0.5, 0.25]).mesh.vectors.positions],
      positions.map((v, k) => v + 0.5 + (k === 5 ? 1 : 0)));
    morph.apply([0, 0]);
    assert.deepEqual([...mesh.vectors.positions], positions);
    n.boxFromSkin(mesh, boxes, 2);
    assert.deepEqual(boxes.slice(0, 2), [{ low: [0, 0, 0], high: [0, 0, 1] }, { low: [0, 0, 0], high: [1, 1, 0] }]);
    assert.ok(boxes[2].low[0] > boxes[2].high[0]);
    const palette = new n.Palette({ jointCount: 2 }), bind = new Float32Array(32), models = new n.Matrices(2), box = {};
    models.array.set([1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 5, 0, 0, 1]);
    n.paletteInverseBind({ models }, bind);
    near([bind[12], bind[28]], [0, -5], 0);
    n.boxFromPalette(palette.update(models), boxes, box);
    near([...box.low, ...box.high], [0, 0, 0, 6, 1, 1], 1e-4);
    assert.throws(() => new n.Morph(mesh, [{ ...sparse, indices: [4] }]), { index: 0 });
    n.skinValidate(mesh, 2);
    assert.throws(() => n.skinValidate(mesh, 1), { index: 1 });
    const kept = [new Uint16Array(8), new Uint8Array(8)];
    n.skinPrune(mesh, 2, ...kept);
    assert.deepEqual(kept.map(a => [...a]), [[0, 0, 1, 0, 1, 0, 0, 0], [255, 0, 255, 0, 255, 0, 255, 0]]);
    const parts = { indices: [0, 1, 2, 3, 4, 5], influenceCount: 1, joints: [0, 0, 1, 2, 2, 3], jointCount: 4,
      weights: [1, 1, 1, 1, 1, 1] };
    const two = n.partitionBuild(parts, 2), none = n.partitionBuild(parts, 1);
    assert.deepEqual([two.parts.length, two.rejectedCount, none.rejectedCount], [2, 0, 2]);
    const jointsOf = ({ firstJoint, jointCount }) => [...two.joints.slice(firstJoint, firstJoint + jointCount)];
    assert.deepEqual(two.parts.map(jointsOf), [[0, 1], [2, 3]]);
    assert.throws(() => n.partitionBuild({ ...parts, jointCount: 3 }, 2), { index: 1 });
    [mesh, morph, palette, models].forEach(object => object.dispose());
  });

  test(`${build}: large records, and nothing remains`, () => {
    const keys = Array.from({ length: 5000 }, (_, k) =>
      ({ time: k, value: k, in: [0, 0], out: [0, 0], kind: n.FCURVE_LINEAR, ease: 0 }));
    const limited = [];
    n.fcurveLimit(keys, 5000, n.HANDLE_KEEP_RATIO, limited);
    assert.equal(limited.length, 5000);
    assert.throws(() => n.fcurveLimit(keys, 5001, n.HANDLE_KEEP_RATIO, limited), RangeError);
    assert.throws(() => n.fcurveLimit(null, 4, n.HANDLE_KEEP_RATIO, limited), /no keys/);
    for (const count of [1e9, NaN])
      assert.throws(() => new n.Pose(count), RangeError, `${count}`);
    const big = new n.FCurve({ keys });
    assert.equal(big.sample(4711.5, [])[0], 4711.5);
    big.dispose();
    assert.equal(n.memory().blocks, 0);
  });
}
