// SPDX-License-Identifier: MIT
// The channels of an animation: their keys as they are in the file, and the track that the library makes of them.
import type { Track } from 'nakawari/all';
import { type KeyframesLike, type Rig, trackFromKeyframes } from 'nakawari/all/three';
import { componentBytes, type Json, type Loaded } from './read';

export interface Channel {
  name: string;
  /** Of three.js, and of glTF. */
  property: string;
  path: string;
  mode: 'LINEAR' | 'STEP' | 'CUBICSPLINE';
  times: Float32Array;
  /** As in the file: with tangents for CUBICSPLINE. */
  values: Float32Array;
  width: number;
  /** Bytes of a component in the file. */
  componentBytes: number;
  /** The value of a key, without tangents. */
  value(key: number): Float32Array;
  /** null where the library refuses it (error), or where it animates nothing (unused). */
  track: Track | null;
  error: unknown;
  unused: boolean;
}

const paths: Record<string, string> =
  { position: 'translation', quaternion: 'rotation', scale: 'scale', morphTargetInfluences: 'weights' };

function bytesOf(json: Json, animation: number, node: number | undefined, property: string) {
  const { channels, samplers } = json.animations![animation];
  const channel = channels.find(c => c.target.node === node && c.target.path === paths[property]);
  const accessor = channel && json.accessors![samplers[channel.sampler].output];
  return accessor ? componentBytes(accessor) : 4;
}

interface Known {
  /** As the command names it. */
  name: string;
  componentBytes: number;
}

function channelOf(rig: Rig, from: KeyframesLike, known: (object: string, property: string) => Known): Channel {
  const [, name, property] = from.name.match(/^(.*)\.(\w+)$/)!;
  const cubic = (from.createInterpolant as { isInterpolantFactoryMethodGLTFCubicSpline?: true } | undefined)
    ?.isInterpolantFactoryMethodGLTFCubicSpline;
  const mode = cubic ? 'CUBICSPLINE' : from.getInterpolation() === 2300 ? 'STEP' : 'LINEAR';
  const times = Float32Array.from(from.times), values = Float32Array.from(from.values);
  const width = values.length / times.length / (cubic ? 3 : 1), step = cubic ? 3 * width : width;
  const { name: label, componentBytes } = known(name, property);
  const made: Channel = {
    name: label, property, path: paths[property] ?? property, mode, times, values, width, componentBytes,
    value: key => values.subarray(step * key + (cubic ? width : 0), step * key + (cubic ? 2 * width : width)),
    track: null, error: null, unused: false,
  };
  try {
    const found = trackFromKeyframes(rig, from);
    made.track = found?.track ?? null;
    made.unused = !found;
  } catch (error) {
    made.error = error;
  }
  return made;
}

/** The channels of animation `index`. */
export function channelsOf({ json, gltf }: Loaded, rig: Rig, index: number): Channel[] {
  const known = (name: string, property: string) => {
    const object = rig.named.get(name), node = object && gltf.parser.associations.get(object as never)?.nodes;
    const label = node === undefined ? object?.name || name : json.nodes![node].name || `node_${node}`;
    return { name: label, componentBytes: bytesOf(json, index, node, property) };
  };
  return gltf.animations[index].tracks.map(track => channelOf(rig, track as unknown as KeyframesLike, known));
}
