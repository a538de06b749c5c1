// SPDX-License-Identifier: MIT
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { bits, both, numbers, rotation } from './support.mjs';

for (const [build, n] of await both('all')) {
  const JOINTS = 5, next = numbers(8), rest = new n.Pose(JOINTS);
  const times = Float32Array.from({ length: 9 }, (_, k) => k / 8), levels = [...times].map(next);
  const clipOf = () => new n.Clip({ jointCount: JOINTS, floatCount: 1, rest, tracks: [
    ...Array.from({ length: JOINTS }, (_, index) => ({ target: n.CLIP_ROTATION, index, track: new n.Track({ times,
      width: 4, kind: n.TRACK_ROTATION, values: [...times].flatMap(() => rotation(next)) }) })),
    { target: n.CLIP_TRANSLATION, index: 0,
      track: new n.Track({ times, width: 3, values: [...times].flatMap(t => [0, 1, 2 * t]) }) },
    { target: n.CLIP_FLOATS, index: 0, track: new n.Track({ times, width: 1, values: levels }) },
  ] });
  const clips = [clipOf(), clipOf()], pose = new n.Pose(JOINTS), a = new n.Pose(JOINTS), b = new n.Pose(JOINTS);
  const loop = { mode: n.PLAYBACK_LOOP, transition: n.MIXER_FADE_IN };
  const setOf = more => new n.MixerSet({ clips: clips.map(clip => ({ clip })), rest, ...more });

  test(`${build}: one slot is the sample, two are the blend, bit for bit`, () => {
    const mixer = new n.Mixer(setOf()), floats = [0], want = [0];
    const slot = mixer.play({ ...loop, time: 0.25 });
    const frame = mixer.advance(0.125, pose, floats);
    clips[0].sample(0.375, a, want);
    assert.deepEqual(bits(pose.array), bits(a.array));
    assert.deepEqual(bits(floats), bits(want));
    assert.deepEqual(frame, { events: [], eventCount: 0, motion: [0, 0, 0, 0, 0, 0, 1, 1, 1, 1] });
    const other = mixer.play({ ...loop, clip: 1 });
    mixer.setWeight(slot, 0.75);
    mixer.setWeight(other, 0.25);
    mixer.setSpeed(other, 2);
    mixer.advance(0.125, pose);
    clips[0].sample(0.5, a);
    clips[1].sample(0.25, b);
    n.poseBlend(a, b, 0.25, a);
    assert.deepEqual(bits(pose.array), bits(a.array));
    assert.deepEqual(mixer.slot(other), { clip: 1, weight: 0.25, speed: 2, time: 0.25 });
    mixer.stop(slot);
    mixer.advance(0, pose);
    assert.equal(mixer.slot(slot), null);
  });

  test(`${build}: events are in the order of their moments, and the root moves the character`, () => {
    const events = [{ time: 0.75 }, { time: 0.25, duration: 0.25 }];
    const set = new n.MixerSet({ clips: [{ clip: clips[0], events }], rest, rootParts: n.ROOT_PLANE });
    const mixer = new n.Mixer(set, { events: 2 });
    mixer.play(loop);
    const { events: list, eventCount, motion } = mixer.advance(1, pose);
    assert.equal(eventCount, 3);
    assert.deepEqual(list.map(e => [e.event, e.kind, e.moment, e.weight]),
      [[1, n.MIXER_ENTERED, 0.25, 1], [1, n.MIXER_LEFT, 0.5, 1]]);
    assert.ok(Math.abs(motion[2] - 2) < 1e-6 && Math.abs(motion[0]) < 1e-6);
  });

  test(`${build}: a restored state repeats every bit`, () => {
    const set = setOf({ masks: [null, new n.Mask(JOINTS)] }), mixer = new n.Mixer(set), copy = new n.Mixer(set);
    const step = m => { m.advance(1 / 60, pose); return bits(pose.array); };
    mixer.play(loop);
    for (let k = 0; k < 40; k++) {
      if (k === 7)
        mixer.play({ clip: 1, mask: 1, mode: n.PLAYBACK_LOOP, fade: 0.25 });
      if (k === 20)
        mixer.play({ mode: n.PLAYBACK_LOOP, transition: n.MIXER_INERTIA, fade: 0.25 });
      const saved = mixer.save(), want = [step(mixer), step(mixer)];
      copy.restore(saved);
      assert.deepEqual([step(copy), step(copy)], want);
      mixer.restore(saved);
      assert.deepEqual(step(mixer), want[0]);
    }
  });

  test(`${build}: what is wrong is refused, and changes nothing`, () => {
    const mixer = new n.Mixer(setOf());
    mixer.play(loop);
    const saved = mixer.save(), wrong = saved.slice();
    wrong.fill(255, 168, 176); // playing, and the clip
    assert.throws(() => mixer.restore(wrong), n.NakawariError);
    assert.throws(() => mixer.restore(saved.slice(1)), RangeError);
    assert.throws(() => mixer.play({ clip: 2 }), n.NakawariError);
    assert.throws(() => mixer.stop(3), n.NakawariError);
    assert.throws(() => mixer.setWeight(16, 1), RangeError);
    assert.throws(() => mixer.advance(-1, pose), n.NakawariError);
    assert.throws(() => mixer.advance(0.1, new n.Pose(JOINTS + 1)), n.NakawariError);
    assert.throws(() => new n.MixerSet({ clips: [{ clip: clips[0], markers: [0.5, 0.25] }], rest }), n.NakawariError);
    assert.throws(() => new n.MixerSet({ clips: [{ clip: {} }], rest }), TypeError);
    assert.deepEqual(mixer.save(), saved);
    const set = setOf(), before = n.memory().blocks;
    new n.Mixer(set).dispose();
    assert.equal(n.memory().blocks, before);
    mixer.dispose();
    assert.throws(() => mixer.save(), /disposed/);
  });
}
