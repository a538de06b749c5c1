// SPDX-License-Identifier: MIT
// Structs of C with other fields than floats are objects in JavaScript, fields in camel case (records.js). This writes
// their layouts in the memory of wasm32, and their types.
import { scriptName } from './functions.mjs';
import { arrays } from './parts.mjs';

// The kind of a field in records.js, and its bytes.
const kinds = { float: ['f', 4], int: ['i', 4], int32_t: ['i', 4], unsigned: ['u', 4], uint32_t: ['u', 4],
  size_t: ['u', 4], double: ['d', 8], int64_t: ['q', 8], uint16_t: ['h', 2], 'unsigned char': ['b', 1],
  void: ['v', 1] };
const field = name => scriptName('nkw_' + name);
// A struct of floats is the array of them, and a view of components is Columns.
export const isRecord = (type, headers) => headers.structs.has(type) && !headers.structs.get(type).words &&
  !/^nkw_(vec3|quat|mat3|mat4|trs)_(view|span)$/.test(type);
export const recordType = type => objects[type] ?? scriptName(type).replace(/^./, c => c.toUpperCase());
const objects = { nkw_track: 'Track', nkw_skeleton: 'Skeleton', nkw_fcurve: 'FCurve', nkw_pose_view: 'Pose',
  nkw_pose_span: 'Pose', nkw_mask_view: 'Mask', nkw_mask_span: 'Mask', nkw_pose_velocity_view: 'PoseVelocity',
  nkw_pose_velocity_span: 'PoseVelocity', nkw_pose_inertia: 'PoseInertia', nkw_pose_dead_blend: 'PoseDeadBlend',
  nkw_palette_view: 'Palette' };

export function kindOf(type, headers) {
  const struct = headers.structs.get(type);
  if (struct?.words)
    return { kind: 'f', bytes: 4, align: 4, words: struct.words };
  if (struct) {
    const { bytes, align } = layoutOf(type, headers);
    return { kind: '$' + type, bytes, align, words: 1 };
  }
  const [kind, bytes] = headers.enums.has(type) ? ['i', 4] : kinds[type] ?? [];
  return kind && { kind, bytes, align: bytes, words: 1 };
}

// Whether all fields can be written, and, with `out`, read.
export function fits(type, headers, out) {
  const known = f => headers.structs.has(f.type) ? fits(f.type, headers, out)
    : headers.enums.has(f.type) || f.type in kinds;
  return headers.structs.get(type).fields.every(f =>
    f.pointer === 0 ? known(f) : f.pointer === 1 && !out && arrays[type]?.[field(f.name)] && known(f));
}

// Bytes, alignment and fields of a struct.
function layoutOf(type, headers) {
  let [at, most] = [0, 4];
  const fields = [];
  for (const f of headers.structs.get(type).fields) {
    const of = kindOf(f.type, headers) ?? { kind: 'v', bytes: 1, align: 1, words: 1 };
    const align = f.pointer ? 4 : of.align, n = of.words * f.length;
    at = Math.ceil(at / align) * align;
    fields.push({ ...f, ...of, at, n });
    at += f.pointer ? 4 : of.bytes * n;
    most = Math.max(most, align);
  }
  return { bytes: Math.ceil(at / most) * most, align: most, fields };
}

// `count * width` as a function of a record.
const given = text => `r => ${text.replace(/(?<![\w.])[a-z]\w*\b(?!\s*\()/g, 'r.$&')}`;

function writeLayout(type, headers) {
  const { bytes, fields } = layoutOf(type, headers);
  const list = fields.map(f => {
    const name = field(f.name), text = arrays[type]?.[name];
    const kind = f.kind.length > 1 ? f.kind : `'${f.kind}'`;
    const rest = f.pointer ? [given(text)] : text ? [f.n, given(text)] : [f.n];
    return `[${[`'${name}'`, f.at, kind, ...rest].join(', ')}]`;
  });
  return `const $${type} = [${bytes}, '${type}', ${list.join(', ')}];`;
}

function writeType(type, headers) {
  const list = layoutOf(type, headers).fields.map(f => {
    const name = field(f.name), one = f.kind.length > 1 ? recordType(f.type) : f.kind === 'q' ? 'bigint' : 'number';
    const many = f.pointer || f.n > 1;
    const optional = f.pointer || arrays[type]?.[name] || /^(Mask|PoseVelocity)$/.test(one);
    const list = f.pointer && one === 'number' ? 'Numbers' : `ArrayLike<${one}>`;
    return `  ${name}${optional ? '?' : ''}: ${many ? list : one}${f.pointer ? ' | null' : ''};`;
  });
  return `export interface ${recordType(type)} {\n${list.join('\n')}\n}`;
}

// The layouts and types that a text of JavaScript names, each after those that it needs.
export function writeRecords(js, headers) {
  const found = new Map();
  const visit = type => {
    if (found.has(type) || !headers.structs.has(type))
      return;
    layoutOf(type, headers).fields.forEach(f => f.kind.length > 1 && visit(f.type));
    found.set(type, { code: writeLayout(type, headers), type: type in objects ? '' : writeType(type, headers) });
  };
  [...js.matchAll(/\$(nkw_\w+)/g)].forEach(m => visit(m[1]));
  return [...found.values()];
}

// The constants of stems: a number, or an object of the struct whose name begins that of the constant.
export function writeConstants(stems, headers) {
  const numberOf = new Map([...headers.enums.values()].flat());
  return headers.constants.filter(c => stems.includes(c.stem)).map(({ name, body }) => {
    const type = [...headers.structs.keys()].find(struct => name.toLowerCase().startsWith(`${struct}_`));
    const numbers = body.split(',').map(item => numberOf.get(item.slice(4)) ?? Number(item));
    const js = name.slice(4), fields = headers.structs.get(type)?.fields ?? [];
    const record = `{ ${fields.map((f, k) => `${field(f.name)}: ${numbers[k]}`).join(', ')} }`;
    return { code: `export const ${js} = ${type ? record : numbers[0]};`,
      type: `export const ${js}: ${type ? recordType(type) : numbers[0]};` };
  });
}
