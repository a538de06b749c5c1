// SPDX-License-Identifier: MIT
// JavaScript and its types for the functions that take numbers, values, arrays and component arrays. The shape of each
// follows from its prototype:
//
//     float, int, an enumeration             a number
//     nkw_vec3 a, const nkw_mat4 *m          an array of its floats: 3, 16
//     the result nkw_vec3                    the first parameter `out`, which is returned
//     float *x, nkw_vec3 *x                  an array that receives the value
//     const nkw_quat *q, ..., size_t count   an array of `count` values
//     nkw_quat_view q, ..., size_t n         Columns
//     nkw_result                             nothing; an error is thrown

import { needsRecords, writeWithRecords } from './calls.mjs';

export const scriptName = name => name.slice(4).replace(/_([a-z0-9])/g, (_, c) => c.toUpperCase());
export const safe = name => ({ in: 'input', function: 'f' })[name] ?? scriptName('nkw_' + name);
const numbers = /^(float|double|int|int32_t|uint32_t|size_t|unsigned)$/;
const views = { nkw_vec3: 3, nkw_quat: 4, nkw_mat3: 9, nkw_mat4: 16, nkw_trs: 10 };
const columns = type => views[type.match(/^(\w+)_(view|span)$/)?.[1]];

// One parameter: what JavaScript takes, what it passes, what it reads back; undefined if it does not fit.
function shape(p, f, headers, at) {
  const name = safe(p.name), words = headers.widths(p.type), many = f.parameters.some(q => q.name === 'count');
  const batch = f.name.endsWith('_n');
  if (p.pointer === 0 && (headers.enums.has(p.type) || numbers.test(p.type)))
    return { name, type: headers.enums.has(p.type) ? scriptName(p.type).replace(/^./, c => c.toUpperCase()) : 'number',
      pass: `$n(${name})` };
  if (p.pointer === 0 && columns(p.type))
    return { name, type: 'Columns', pass: `$c(${at}, ${name}, ${columns(p.type)}, n)`, words: columns(p.type) };
  if (batch && p.pointer === 1 && p.type === 'float')
    return { name, type: 'Columns', pass: `$c1(${name}, n)` };
  if (p.pointer > 1 || !words || (p.pointer === 0 && !headers.structs.has(p.type)))
    return undefined;
  if (p.pointer === 1 && p.length === 1 && (many || /_(un)?pack_n$/.test(f.name))) {
    if (p.type === 'size_t' || p.type === 'int32_t')
      return undefined;
    const count = many ? 'count' : 'n';
    return { name, type: p.constant ? 'ArrayLike<number>' : 'FloatArray', row: [name, words, p.constant, count],
      pass: `${name}At` };
  }
  const width = words * p.length, written = p.pointer === 1 && !p.constant;
  return { name, type: written ? 'FloatArray' : 'ArrayLike<number>', pass: `${written ? '$io' : '$w'}(${at}, ${name}, ${width})`, words: width,
    read: written ? `$r(${name}, ${at}, ${width});` : '' };
}

// The text of one function and of its type, or undefined if it does not fit.
export function writeFunction(f, headers) {
  return needsRecords(f, headers) ? writeWithRecords(f, headers) : writePlain(f, headers);
}

function writePlain(f, headers) {
  const result = headers.structs.has(f.type) ? headers.widths(f.type) : 0;
  const simple = numbers.test(f.type) || /^(void|nkw_result)$/.test(f.type) || headers.enums.has(f.type);
  if (!result && !simple)
    return undefined;
  let at = result;
  const shapes = [];
  for (const p of f.parameters) {
    const s = shape(p, f, headers, at);
    if (!s)
      return undefined;
    at += s.words ?? 0;
    shapes.push(s);
  }
  if (at > 256)
    throw new Error(`${f.name}: ${at} words`);
  const rows = shapes.filter(s => s.row), reads = shapes.map(s => s.read ?? '').filter(Boolean).join(' ');
  const call = `$.${f.name}(${[...(result ? ['$p'] : []), ...shapes.map(s => s.pass)].join(', ')})`;
  let body = f.type === 'nkw_result' ? `$check('${f.name}', ${call});` : result || f.type === 'void' ? `${call};`
    : reads || rows.length ? `const y = ${call};` : `return ${call};`;
  body += reads ? ` ${reads}` : '';
  body += result ? ` return $r(out, 0, ${result});` : body.startsWith('const y') ? ' return y;' : '';
  if (rows.length) {
    const list = rows.map(s => `[${s.row[0]}, ${s.row[1]} * ${s.row[3]}, ${s.row[2] ? 0 : 1}]`).join(', ');
    body = `return $rows([${list}], ([${rows.map(s => s.pass).join(', ')}]) => { ${body} });`;
  }
  const names = [...(result ? ['out'] : []), ...shapes.map(s => s.name)];
  const types = [...(result ? ['out: T'] : []), ...shapes.map(s => `${s.name}: ${s.type}${s.row ? ' | null' : ''}`)];
  const returned = result ? 'T' : f.type === 'void' || f.type === 'nkw_result' ? 'void' : 'number';
  const js = scriptName(f.name);
  return {
    code: `export function ${js}(${names.join(', ')}) { ${body} }`,
    type: `/** ${f.summary} */\n` +
      `export function ${js}${result ? '<T extends FloatArray>' : ''}(${types.join(', ')}): ${returned};`,
  };
}
