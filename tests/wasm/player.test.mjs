// SPDX-License-Identifier: MIT
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { bits, both, numbers, rotation } from './support.mjs';

const [[, clips]] = await both('clips');

for (const [build, player] of await both('player'))
  test(`${build}: a clip that was built elsewhere plays with the same bits`, () => {
    const next = numbers(6), times = [0, 1, 2, 3], values = times.flatMap(() => rotation(next));
    const track = new clips.Track({ times, width: 4, kind: clips.TRACK_ROTATION, values });
    for (const format of [clips.CLIP_FLOAT32, clips.CLIP_UNORM16]) {
      const tracks = [{ target: clips.CLIP_ROTATION, index: 1, track }], names = { clip: 'wave' };
      const made = new clips.Clip({ jointCount: 2, tracks, names, format }), clip = player.Clip.open(made.bytes);
      const [a, b] = [new clips.Pose(2), new player.Pose(2)];
      for (const time of [-1, 0, 0.3, 1.9, 4]) {
        made.sample(time, a);
        clip.sample(time, b);
        assert.deepEqual(bits(b.array), bits(a.array));
      }
      assert.equal(clip.name, 'wave');
      [made, clip, a, b].forEach(object => object.dispose());
    }
    assert.throws(() => new player.Clip({ jointCount: 2 }), /opens clips only/);
    track.dispose();
    assert.equal(player.memory().blocks, 0);
  });
