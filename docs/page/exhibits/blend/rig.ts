// SPDX-License-Identifier: MIT
// The example character without three.js: its skeleton, its rest pose and its clips.
import * as N from 'nakawari/all';
import { part } from '../../shell/part';

interface Gltf {
  nodes: { name: string; children?: number[]; translation?: number[]; rotation?: number[] }[];
  skins: { joints: number[] }[];
  accessors: { bufferView: number; count: number; type: string }[];
  bufferViews: { byteOffset?: number }[];
  animations: { name: string; channels: { sampler: number; target: { node: number; path: string } }[];
    samplers: { input: number; output: number; interpolation?: string }[] }[];
}

export interface Rig {
  skeleton: N.Skeleton;
  parents: number[];
  names: string[];
  rest: N.Pose;
  clips: Record<string, N.Clip>;
}

const widths: Record<string, number> = { SCALAR: 1, VEC3: 3, VEC4: 4 };
const targets: Record<string, number> = {
  translation: N.CLIP_TRANSLATION, rotation: N.CLIP_ROTATION, scale: N.CLIP_SCALE,
};

// The JSON of the file, and the floats of an accessor.
function parse(bytes: Uint8Array<ArrayBuffer>) {
  const length = new DataView(bytes.buffer, bytes.byteOffset).getUint32(12, true);
  const json = JSON.parse(new TextDecoder().decode(bytes.subarray(20, 20 + length))) as Gltf;
  const floats = (i: number) => {
    const { bufferView, count, type } = json.accessors[i];
    const first = 28 + length + (json.bufferViews[bufferView].byteOffset ?? 0);
    return new Float32Array(bytes.slice(first, first + 4 * count * widths[type]).buffer);
  };
  return { json, floats };
}

// Linear keys become those of a Catmull-Rom spline, so that the velocity of a clip itself does not jump at its keys.
function smooth(times: Float32Array, values: Float32Array, width: number): Float32Array {
  const count = times.length, into = values.slice(), out = values.slice();
  N.splineTangents({ times, values, count, width, stride: width, method: N.SPLINE_CATMULL_ROM,
    ends: N.SPLINE_ENDS_PERIODIC, tension: 0 }, into, out);
  const key = (array: Float32Array, k: number) => [...array.subarray(k * width, (k + 1) * width)];
  return Float32Array.from(Array.from(times, (_, k) => [...key(into, k), ...key(values, k), ...key(out, k)]).flat());
}

function trackOf(times: Float32Array, values: Float32Array, path: string, interpolation = 'LINEAR') {
  const width = path === 'rotation' ? 4 : 3, linear = interpolation === 'LINEAR';
  return new N.Track({
    times, values: linear ? smooth(times, values, width) : values, width,
    kind: path === 'rotation' ? N.TRACK_ROTATION : N.TRACK_FLOATS,
    interpolation: interpolation === 'STEP' ? N.INTERPOLATION_STEP : N.INTERPOLATION_CUBICSPLINE,
  });
}

function rigOf(bytes: Uint8Array<ArrayBuffer>): Rig {
  const { json, floats } = parse(bytes), { joints } = json.skins[0], jointCount = joints.length;
  const nodes = joints.map(i => json.nodes[i]), rest = new N.Pose(jointCount);
  nodes.forEach(({ translation = [0, 0, 0], rotation = [0, 0, 0, 1] }, j) =>
    rest.set(j, [...translation, ...rotation, 1, 1, 1]));
  const parents = joints.map(i => nodes.findIndex(node => node.children?.includes(i)));
  const clips = json.animations.map(({ name, channels, samplers }) => {
    const moved = channels.filter(({ target: { node, path } }) => joints.includes(node) && path in targets);
    const tracks = moved.map(({ sampler, target: { node, path } }) => {
      const { input, output, interpolation } = samplers[sampler];
      return { target: targets[path], index: joints.indexOf(node),
        track: trackOf(floats(input), floats(output), path, interpolation) };
    });
    return [name, new N.Clip({ jointCount, tracks, rest })] as const;
  });
  return { skeleton: new N.Skeleton(parents), parents, names: nodes.map(node => node.name), rest,
    clips: Object.fromEntries(clips) };
}

let loaded: Promise<Rig> | undefined;
/** The character; it is read once. */
export const loadRig = () => loaded ??=
  part<{ default: Uint8Array<ArrayBuffer> }>('character').then(script => rigOf(script.default));

export const lengthOf = (clip: N.Clip) => Math.fround(clip.end - clip.start);

/** The pose of a clip that repeats. */
export function sampleLoop(clip: N.Clip, time: number, pose: N.Pose): N.Pose {
  clip.sample(N.playbackHead([0, 0], N.PLAYBACK_LOOP, clip.start, lengthOf(clip), time)[0], pose);
  return pose;
}

/** The rotation of a joint. */
export const rotationOf = (pose: N.Pose, joint: number) => [...pose.get(joint, new Float32Array(10)).subarray(3, 7)];

/** The rotation vector in degrees. */
export const angles = (rotation: number[]) =>
  N.quatLog([0, 0, 0], rotation).map(half => N.degreesFromRadians(2 * half));

/** The same in C: prints it under names[i]. */
export const anglesInC = (rotation: string) => `const nkw_vec3 half = nkw_quat_log(${rotation});
    show(names[i], 0, (double)nkw_degrees_from_radians(2.0f * half.x));
    show(names[i], 1, (double)nkw_degrees_from_radians(2.0f * half.y));
    show(names[i], 2, (double)nkw_degrees_from_radians(2.0f * half.z));`;
