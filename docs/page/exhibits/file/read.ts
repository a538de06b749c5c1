// SPDX-License-Identifier: MIT
// A glTF file of a user, which may be anything: what three.js would not survive is refused before it sees it.
import type { GLTF } from 'three/examples/jsm/loaders/GLTFLoader.js';
import type { Library } from '../../kit/view3';
import type { Text } from '../../shell/text';

/** An error with a text for the reader. */
export class Refused extends Error {
  constructor(readonly text: Text) {
    super(text.en);
  }
}
const refuse = (en: string, ja: string): never => { throw new Refused({ en, ja }); };

export interface Accessor {
  count: number;
  type: string;
  componentType: number;
  bufferView?: number;
  byteOffset?: number;
}
export interface Json {
  asset?: { version?: string };
  nodes?: { children?: number[]; name?: string }[];
  buffers?: { uri?: string; byteLength: number }[];
  bufferViews?: { byteLength: number }[];
  accessors?: Accessor[];
  animations?: { channels: { sampler: number; target: { node?: number; path: string } }[];
    samplers: { input: number; output: number }[] }[];
}

const most = { bytes: 512e6, depth: 1000, elements: 2e7, seconds: 30 };
const widths: Record<string, number> = { SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4, MAT2: 4, MAT3: 9, MAT4: 16 };
const sizes: Record<number, number> = { 5120: 1, 5121: 1, 5122: 2, 5123: 2, 5125: 4, 5126: 4 };

/** Bytes of a component of an accessor, and of all its elements. */
export const componentBytes = (accessor: Accessor) => sizes[accessor.componentType] ?? 0;
export const accessorBytes = (accessor: Accessor) =>
  accessor.count * (widths[accessor.type] ?? 0) * componentBytes(accessor);

// The JSON of a .gltf, or of the first chunk of a .glb.
function jsonOf(bytes: Uint8Array): Json {
  if (bytes.length === 0)
    refuse('It is empty.', 'ファイルが空です。');
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  let text = bytes;
  if (bytes.length >= 12 && view.getUint32(0, true) === 0x46546c67) {
    const length = bytes.length >= 20 ? view.getUint32(12, true) : NaN;
    if (!(view.getUint32(4, true) === 2 && view.getUint32(8, true) <= bytes.length && 20 + length <= bytes.length &&
        view.getUint32(16, true) === 0x4e4f534a))
      refuse('This .glb is truncated, or not of version 2.', 'この .glb は途中で切れているか、バージョン 2 ではありません。');
    text = bytes.subarray(20, 20 + length);
  }
  try {
    const json: unknown = JSON.parse(new TextDecoder('utf-8', { fatal: true }).decode(text));
    if (typeof json === 'object' && json !== null && typeof (json as Json).asset?.version === 'string')
      return json as Json;
  } catch {
    // below
  }
  return refuse('It is not glTF: choose a .glb or .gltf, as Blender and converters for Maya export it.',
    'glTF ではありません。Blender などから書き出した .glb または .gltf を選んでください。');
}

const list = <T>(value: T[] | undefined, what: string): T[] => {
  if (value !== undefined && !Array.isArray(value))
    refuse(`"${what}" is not a list.`, `"${what}" がリストではありません。`);
  return value ?? [];
};

// Nodes are trees: each has at most one parent, and none is above itself.
function checkNodes(json: Json) {
  const nodes = list(json.nodes, 'nodes'), parents = new Int32Array(nodes.length).fill(-1);
  nodes.forEach((node, i) => list(node?.children, 'children').forEach(child => {
    if (!(Number.isInteger(child) && child >= 0 && child < nodes.length))
      refuse(`Node ${i} has a child that does not exist.`, `ノード ${i} の子が存在しません。`);
    if (parents[child] >= 0)
      refuse(`Node ${child} has two parents.`, `ノード ${child} に親が二つあります。`);
    parents[child] = i;
  }));
  const depth = new Int32Array(nodes.length);
  for (let i = 0; i < nodes.length; i++) {
    const path = [];
    let n = i;
    for (; n >= 0 && depth[n] === 0 && path.length <= most.depth; n = parents[n])
      path.push(n);
    for (const [k, node] of path.reverse().entries())
      depth[node] = (n < 0 ? 0 : depth[n]) + k + 1;
    if (path.length > most.depth || depth[i] > most.depth)
      refuse(`Node ${i} is above itself, or deeper than ${most.depth} levels.`,
        `ノード ${i} が循環しているか、${most.depth} 段より深くなっています。`);
  }
}

function checkAccessors(json: Json) {
  const views = list(json.bufferViews, 'bufferViews');
  list(json.accessors, 'accessors').forEach((accessor, i) => {
    const { count, bufferView } = accessor ?? {}, view = bufferView === undefined ? undefined : views[bufferView];
    if (!(Number.isInteger(count) && count! >= 0 && count! <= most.elements) || accessorBytes(accessor) > most.bytes)
      refuse(`Accessor ${i} has ${count} elements.`, `アクセサ ${i} の要素数が ${count} です。`);
    if (bufferView !== undefined && !(view && accessorBytes(accessor) + (accessor.byteOffset ?? 0) <= view.byteLength))
      refuse(`Accessor ${i} reaches beyond its buffer view.`, `アクセサ ${i} がバッファビューの範囲を超えています。`);
  });
}

/** The number in a channel of an animation, for messages of this page; throws Refused. */
function checkAnimations(json: Json) {
  const accessors = list(json.accessors, 'accessors');
  list(json.animations, 'animations').forEach((animation, i) => {
    const samplers = list(animation?.samplers, 'samplers');
    for (const sampler of samplers)
      if (!(accessors[sampler?.input] && accessors[sampler.output]))
        refuse(`Animation ${i} has a sampler without an accessor.`, `アニメーション ${i} のサンプラにアクセサがありません。`);
    for (const channel of list(animation?.channels, 'channels'))
      if (!(channel?.target && samplers[channel.sampler]))
        refuse(`Animation ${i} has a channel without a sampler.`, `アニメーション ${i} のチャンネルにサンプラがありません。`);
  });
}

const fileOf = (uri: string, files: File[]) => {
  const name = decodeURIComponent(uri.split('/').at(-1)!);
  return files.find(file => file.name === name);
};
const white = 'data:image/png;base64,' +
  'iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAAAAAA6fptVAAAACklEQVR4nGP4DwABAQEAsTj2FAAAAABJ' +
  'RU5ErkJggg==';

// Names in a file are those of the files that were dropped with it; nothing is fetched. A missing image is white.
function manager(three: Library, files: File[]) {
  const made = new three.LoadingManager(), urls: string[] = [], missing = new Set<string>();
  made.setURLModifier(url => {
    if (/^(data|blob):/.test(url))
      return url;
    const file = fileOf(url, files);
    if (!file)
      missing.add(url);
    return file ? urls[urls.push(URL.createObjectURL(file)) - 1] : white;
  });
  return { made, missing, free: () => urls.forEach(url => URL.revokeObjectURL(url)) };
}

function checkBuffers(json: Json, files: File[]) {
  for (const { uri } of list(json.buffers, 'buffers'))
    if (uri !== undefined && !/^data:/.test(uri) && !fileOf(uri, files))
      refuse(`It needs the file ${uri}: drop both together.`,
        `ファイル ${uri} が必要です。一緒にドロップしてください。`);
}

const late = (seconds: number) => new Promise<never>((_, reject) => setTimeout(() =>
  reject(new Refused({ en: `It does not load within ${seconds} seconds.`, ja: `${seconds} 秒以内に読み込めませんでした。` })),
1000 * seconds));

export interface Loaded {
  name: string;
  json: Json;
  gltf: GLTF;
  /** Images that were not dropped with it: they are white. */
  missing: string[];
}

/** Reads a .glb or .gltf; `files` has what it may refer to. Throws Refused, or an error of three.js. */
export async function readModel(three: Library, name: string, bytes: Uint8Array<ArrayBuffer>,
  files: File[]): Promise<Loaded> {
  if (bytes.length > most.bytes)
    refuse(`It is larger than ${most.bytes / 1e6} MB.`, `${most.bytes / 1e6} MB を超えています。`);
  const json = jsonOf(bytes);
  checkNodes(json);
  checkAccessors(json);
  checkAnimations(json);
  checkBuffers(json, files);
  const { made, missing, free } = manager(three, files);
  try {
    const gltf = await Promise.race([new three.GLTFLoader(made).parseAsync(bytes.buffer, ''), late(most.seconds)]);
    if (!gltf.scene)
      refuse('It has no scene.', 'シーンがありません。');
    return { name, json, gltf, missing: [...missing] };
  } finally {
    free();
  }
}
