// SPDX-License-Identifier: MIT
// What is not an argument of a function throws: it has no result, also not NaN.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { both, packageFolder } from './support.mjs';

// As three.js has them: objects without elements.
class Quaternion { x = 0; y = 0; z = 0; w = 1; }

test('functions and objects before the module is loaded say what to await', async () => {
  const early = await import(`${packageFolder}/clips.js?early`);
  assert.throws(() => new early.Track({ times: [0], values: [1] }), /await ready first/);
  assert.throws(() => early.playbackHeadF64({}, { start: 0, duration: 1 }, 0), /await ready first/);
  const values = await import(`${packageFolder}/values.js?early`);
  assert.throws(() => values.quatSlerp([], [0, 0, 0, 1], [0, 0, 0, 1], 0.5), /await ready first/);
  await Promise.all([early.ready, values.ready]);
});

for (const [build, n] of [...await both('values'), ...await both('math'), ...await both('all')]) {
  const q = [0, 0, 0, 1];
  test(`${build}: values that are no arrays, short or missing`, () => {
    for (const wrong of [new Quaternion(), [0, 0, 0], undefined, null, 1])
      for (const args of [[wrong, q, 0.5], [q, wrong, 0.5]])
        assert.throws(() => n.quatSlerp([], ...args), RangeError, `${args}`);
    for (const wrong of [undefined, null, '0.5', [0.5], new Quaternion()])
      assert.throws(() => n.quatSlerp([], q, q, wrong), TypeError, `${wrong}`);
    assert.throws(() => n.sin(), TypeError);
    assert.ok(Number.isNaN(n.sin(NaN)), 'a NaN is a number');
    assert.deepEqual(n.quatSlerp([], q, q, 0.5), q);
  });
}

for (const [build, n] of await both('all')) {
  test(`${build}: fields and arrays of records`, () => {
    const limb = { root: [0, 1, 0], mid: [0, 0.5, 0.1], end: [0, 0, 0], target: [0, 0.2, 0.3], pole: [0, 0, 1],
      hinge: [1, 0, 0], softness: 0, weight: 1 };
    assert.throws(() => n.ikTwoBoneSolve({}, { ...limb, target: new Quaternion() }), RangeError);
    assert.throws(() => n.ikTwoBoneSolve({}, { ...limb, target: [0, 1] }), RangeError);
    assert.throws(() => n.ikTwoBoneSolve({}, { ...limb, weight: [1] }), TypeError);
    assert.throws(() => n.ikTwoBoneSolve({}), TypeError);
    assert.throws(() => n.ikTwoBoneSolve({}, 7), TypeError);
    assert.throws(() => n.splineTangents({ times: [0, 1, 2], values: [0, 1] }, [], []), RangeError);
  });

  test(`${build}: rows and component arrays`, () => {
    const columns = [4, 4, 1, 4].map(width => new n.Columns(width, 5)), [a, b, t, out] = columns;
    assert.throws(() => n.quatSlerpN(a, b, out, out, 5), RangeError);
    assert.throws(() => n.quatSlerpN(a, [0, 0, 0, 1], t, out, 5), TypeError);
    assert.throws(() => n.quatSlerpN(a, b, t, out), RangeError);
    columns.forEach(object => object.dispose());
  });
}

const [[, other]] = await both('clips');
for (const [build, n] of [...await both('characters'), ...await both('all')]) {
  const make = () => {
    const track = new n.Track({ times: [0, 1], values: [0, 0, 0, 1, 0, 0], width: 3 });
    const skeleton = new n.Skeleton([-1, 0]), pose = new n.Pose(2), matrices = new n.Matrices(2);
    const clip = new n.Clip({ jointCount: 2, tracks: [{ target: n.CLIP_TRANSLATION, index: 0, track }] });
    return { track, skeleton, pose, matrices, clip, palette: new n.Palette({ jointCount: 2 }),
      crowd: new n.Crowd({ skeleton, count: 3 }), mask: new n.Mask(2) };
  };
  const blocks = n.memory().blocks;

  test(`${build}: objects of another class`, () => {
    const { pose, matrices, clip, palette, skeleton, crowd, track, mask } = make();
    for (const wrong of [() => palette.update(pose), () => palette.update(), () => clip.sample(0, matrices),
      () => clip.sample(0), () => skeleton.models(matrices, matrices), () => skeleton.models(pose, pose),
      () => skeleton.models(pose), () => crowd.play(track, [0, 0, 0]), () => crowd.play(undefined, [0, 0, 0]),
      () => n.poseBlend(pose, matrices, 0.5, pose), () => n.poseBlend(pose, pose, 0.5, pose, pose),
      () => n.poseBlend(pose, pose, 0.5), () => new n.Crowd({ skeleton: [-1, 0], count: 1 }),
      () => new n.Clip({ jointCount: 1, tracks: [{ target: 0, index: 0, track: { times: [0], values: [0] } }] }),
      () => new n.Clip({ jointCount: 2, rest: matrices })])
      assert.throws(wrong, TypeError, `${wrong}`);
    n.poseBlend(pose, pose, 0.5, pose, mask);
    [pose, matrices, clip, palette, skeleton, crowd, track, mask].forEach(object => object.dispose());
    assert.equal(n.memory().blocks, blocks);
  });

  test(`${build}: objects of another part`, () => {
    const { pose, clip, track, ...rest } = make();
    const strange = { pose: new other.Pose(2), track: new other.Track({ times: [0], values: [0, 0, 0], width: 3 }) };
    assert.throws(() => clip.sample(0, strange.pose), /Pose is no Pose of this part/);
    assert.throws(() => n.poseBlend(pose, strange.pose, 0.5, pose), TypeError);
    assert.throws(() => new n.Clip({ jointCount: 1, tracks: [{ target: 0, index: 0, track: strange.track }] }),
      TypeError);
    assert.throws(() => new n.Clip({ jointCount: 2, rest: strange.pose }), TypeError);
    if (n.poseMirror) {
      assert.throws(() => n.trackAlign(strange.track, new Float32Array(3)), /of another part/);
      assert.throws(() => n.poseFromTrs([[0, 0, 0, 0, 0, 0, 1, 1, 1, 1], [0, 0, 0, 0, 0, 0, 1, 1, 1, 1]], strange.pose),
        /of another part/);
      assert.throws(() => n.trsFromPose(rest.matrices, []), RangeError);
    }
    [pose, clip, track, ...Object.values(rest), ...Object.values(strange)].forEach(object => object.dispose());
    assert.equal(n.memory().blocks, blocks);
  });

  test(`${build}: numbers and arrays that are missing or short`, () => {
    const { pose, clip, track, crowd, skeleton, matrices, ...rest } = make();
    for (const wrong of [() => clip.sample(undefined, pose), () => track.sample(), () => pose.get(),
      () => n.poseBlend(pose, pose, undefined, pose)])
      assert.throws(wrong, TypeError, `${wrong}`);
    for (const wrong of [() => crowd.play(clip, 0.25), () => crowd.play(clip, [0, 0]), () => crowd.play(clip),
      () => crowd.play(clip, [0, 0, 0], [1]), () => pose.set(0, [0, 0, 0]), () => pose.set(0),
      () => skeleton.models(pose, matrices, [1, 0, 0]), () => new n.Pose(), () => new n.Crowd({ skeleton }),
      () => new n.Crowd({ skeleton, count: 1.5 }), () => new n.Palette({ jointCount: 2, globalInverse: [1] }),
      () => new n.Track({ times: 1, values: [1] }), () => new n.Track({ times: [0, 1], values: 1 })])
      assert.throws(wrong, RangeError, `${wrong}`);
    crowd.play(clip, [0, 0.5, 1, 7]);
    [pose, clip, track, crowd, skeleton, matrices, ...Object.values(rest)].forEach(object => object.dispose());
    assert.equal(n.memory().blocks, blocks);
  });
}
