// SPDX-License-Identifier: MIT
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { bits, both, numbers, rotation } from './support.mjs';

for (const [build, clips] of [...await both('clips'), ...await both('all')]) {
  const { Clip, NakawariError, Pose, Track } = clips;
  const tracks = (next, n = 9) => {
    const times = Float32Array.from({ length: n }, (_, k) => k / 4);
    const make = (width, value, more) =>
      new Track({ times, width, values: [...times].flatMap(() => value()), ...more });
    const step = { interpolation: clips.INTERPOLATION_STEP };
    return [
      { target: clips.CLIP_TRANSLATION, index: 2, track: make(3, () => [next(), next(), next()]) },
      { target: clips.CLIP_ROTATION, index: 0, track: make(4, () => rotation(next), { kind: clips.TRACK_ROTATION }) },
      { target: clips.CLIP_SCALE, index: 1, track: make(3, () => [next(), next(), next()], step) },
      { target: clips.CLIP_FLOATS, index: 1, track: make(2, () => [next(), next()]) },
    ];
  };

  test(`${build}: a clip has the bits of its tracks`, () => {
    const source = tracks(numbers(3)), clip = new Clip({ jointCount: 3, floatCount: 3, tracks: source });
    const pose = new Pose(3), floats = new Float32Array(3);
    assert.deepEqual([clip.jointCount, clip.floatCount, clip.start, clip.end], [3, 3, 0, 2]);
    for (const time of [-1, 0, 0.1, 0.25, 1.37, 1.999, 2, 3, NaN]) {
      clip.sample(time, pose, floats);
      const [t, r, s, f] = source.map(({ track }) => track.sample(time, []));
      assert.deepEqual(bits(pose.get(2, []).slice(0, 3)), bits(t));
      assert.deepEqual(bits(pose.get(0, []).slice(3, 7)), bits(r));
      assert.deepEqual(bits(pose.get(1, []).slice(7)), bits(s));
      assert.deepEqual(bits(floats), bits([0, ...f]));
    }
    [clip, pose, ...source.map(t => t.track)].forEach(object => object.dispose());
    assert.equal(clips.memory().blocks, 0);
  });

  test(`${build}: a block is opened again; a damaged one is refused with its text`, () => {
    const source = tracks(numbers(4)), clip = new Clip({ jointCount: 3, floatCount: 3, tracks: source });
    const bytes = clip.bytes.slice(), again = Clip.open(bytes), [a, b] = [new Pose(3), new Pose(3)];
    clip.sample(0.7, a);
    again.sample(0.7, b);
    assert.deepEqual(bits(a.array), bits(b.array));
    assert.throws(() => Clip.open(bytes.subarray(0, 60)), NakawariError);
    bytes[0] ^= 1;
    assert.throws(() => Clip.open(bytes), /nkw_clip_open: not a clip/);
    [clip, again, a, b, ...source.map(t => t.track)].forEach(object => object.dispose());
    assert.equal(clips.memory().blocks, 0);
  });

  test(`${build}: errors have the result, its text and the index`, () => {
    assert.throws(() => new Track({ times: [0, 1, 0.5], values: [0, 0, 0] }),
      { name: 'NakawariError', message: /a key time is less than the one before it \(2\)/, index: 2 });
    assert.throws(() => new Track({ times: [0, 1], values: [0] }), RangeError);
    const track = new Track({ times: [0], values: [1, 2, 3], width: 3 });
    const twice = [0, 0].map(index => ({ target: clips.CLIP_SCALE, index, track }));
    assert.throws(() => new Clip({ jointCount: 1, tracks: twice }), { index: 1 });
    const [clip, pose] = [new Clip({ jointCount: 1 }), new Pose(2)];
    assert.throws(() => clip.sample(0, pose), /differ in kind/);
    [track, clip, pose].forEach(object => object.dispose());
    assert.throws(() => track.sample(0, []), /disposed/);
    assert.throws(() => pose.array, /disposed/);
    assert.equal(clips.memory().blocks, 0);
  });

  test(`${build}: derivatives of a track`, () => {
    const track = new Track({ times: [0, 2], values: [1, 5] }), [v, d, s] = [[], [], []];
    track.sampleMotion(1, v, d, s);
    track.sampleMotion(1, null, [], null);
    assert.deepEqual([v, d, s], [[3], [2], [0]]);
    track.dispose();
  });

  test(`${build}: memory is used again after dispose, and views are valid after it has grown`, () => {
    const before = new Pose(5);
    before.set(4, [1, 2, 3, 0, 0, 0, 1, 1, 1, 1]);
    const bytes = () => clips.memory().bytes, cycle = () => {
      const poses = Array.from({ length: 50 }, (_, k) => new Pose(20 * k + 1));
      poses.forEach((pose, k) => k % 2 && pose.dispose());
      poses.forEach(pose => pose.dispose());
    };
    const small = bytes();
    cycle();
    const grown = bytes();
    assert.ok(grown > small);
    for (let k = 0; k < 20; k++)
      cycle();
    assert.equal(bytes(), grown);
    assert.deepEqual(before.get(4, []), [1, 2, 3, 0, 0, 0, 1, 1, 1, 1]);
    assert.equal(before.array[4], 1);
    before.dispose();
    before.dispose();
    assert.equal(clips.memory().blocks, 0);
  });

  test(`${build}: objects that nobody holds release their memory`, async () => {
    for (let k = 0; k < 100; k++)
      new Pose(10);
    assert.ok(clips.memory().blocks > 0);
    for (let k = 0; k < 50 && clips.memory().blocks > 0; k++) {
      global.gc();
      await new Promise(resolve => setTimeout(resolve, 10));
    }
    assert.equal(clips.memory().blocks, 0);
  });
}

for (const part of ['player', 'clips', 'characters', 'math', 'all'])
  for (const [build, n] of await both(part))
    test(`${part}, ${build}: the play head of a clip that repeats, after a week`, () => {
      const range = { start: 0.5, duration: 2, after: n.PLAYBACK_LOOP }, week = 604800;
      assert.deepEqual(n.playbackHeadF64({}, range, week + 0.75), { time: 0.75, cycle: week / 2, closing: 0 });
      const alternate = { ...range, after: n.PLAYBACK_PING_PONG, afterCycles: 3 };
      assert.deepEqual(n.playbackHeadF64({}, alternate, 3), { time: 2, cycle: 1, closing: 0 });
      assert.throws(() => n.playbackHeadF64({}, range), TypeError);
      assert.throws(() => n.playbackHeadF64({}, undefined, 1), TypeError);
    });

// 1000 blocks of random sizes, taken and released in random order: each keeps its numbers. A search of all blocks
// would take minutes for the 160,000 of 40,000 tracks.
for (const [build, clips] of await both('clips')) {
  test(`${build}: blocks are apart, and free ones are joined`, () => {
    const next = numbers(20), held = [], whole = n => Math.floor((next() + 1) / 2 * n), before = clips.memory();
    const release = ([object, value]) => {
      assert.ok(object.array.every(x => x === value));
      object.dispose();
    };
    for (let k = 1; k <= 4000; k++) {
      const object = new clips.Pose(whole(k % 100 ? 60 : 4000));
      assert.equal(object._p % 64, 0);
      object.array.fill(k);
      held.push([object, k]);
      if (held.length > whole(1000))
        release(held.splice(whole(held.length), 1)[0]);
    }
    held.forEach(release);
    const { bytes, blocks } = clips.memory();
    assert.equal(blocks, before.blocks);
    new clips.Pose(Math.floor((bytes - before.bytes) / 48)).dispose();
    assert.equal(clips.memory().bytes, bytes);
  });

  test(`${build}: a track costs the same beside 40,000 others`, t => {
    const times = [0, 1], values = [0, 1], kept = [], took = [];
    for (let part = 0; part < 4; part++) {
      const from = process.cpuUsage(); // not the clock: the machine may be busy
      for (let k = 0; k < 10000; k++)
        kept.push(new clips.Track({ times, values }));
      const { user, system } = process.cpuUsage(from);
      took.push((user + system) / 1000);
    }
    t.diagnostic(`milliseconds of the processor for 10,000 each: ${took.map(Math.round)}`);
    assert.ok(took[3] < 5 * took[0] + 100, `${took}`);
    kept.forEach(track => track.dispose());
    assert.equal(clips.memory().blocks, 0);
  });
}
