// SPDX-License-Identifier: MIT
// JavaScript for functions with records (layouts.mjs), integers of 64 bits, arrays of a length that the table `lengths`
// has, working memory, and tracks as results. `bad`, working memory and the arrays of tracks are no parameters of theirs.
import { safe, scriptName } from './functions.mjs';
import { fits, isRecord, kindOf, recordType } from './layouts.mjs';
import { lengths, work } from './parts.mjs';

const isBad = p => p.type === 'size_t' && p.pointer === 1 && /^bad/.test(p.name);
const isSpan = p => p.type === 'nkw_track_span';

// Results that are one number also in functions with a count.
const one = /^(index|passed|difference|error|negated|rate|total|cursor)$/;

export const needsRecords = (f, headers) => f.name in lengths || f.name in work || isRecord(f.type, headers) ||
  f.parameters.some(p => isRecord(p.type, headers) || isBad(p) || p.type === 'int64_t' ||
    (p.pointer && !p.constant && one.test(p.name)));

function lengthOfParameter(p, f) {
  const text = lengths[f.name]?.[p.name];
  if (text || p.length > 1)
    return text ?? String(p.length);
  return !one.test(p.name) && f.parameters.some(q => q.name === 'count' && q.pointer === 0) ? 'count' : '1';
}

const literal = kind => kind.length > 1 ? kind : `'${kind}'`;
const times = (n, words) =>
  words === 1 ? n : n === '1' ? String(words) : `${/^\w+$/.test(n) ? n : `(${n})`} * ${words}`;

// What moves, as an object of the arrays that are wanted. Orientations have 3 floats of velocity.
function shapeOfMotion(name, n) {
  const parts = ['value', 'velocity', 'acceleration'], at = k => `${name}At${k}`;
  return { name, type: '{ value?: Output | null; velocity?: Output | null; acceleration?: Output | null }',
    before: parts.map((part, k) => `const ${at(k)} = $o('f', ${name}.${part} ?? null, ${n});`).join(' '),
    pass: `words(0, ${parts.map((part, k) => at(k)).join(', ')})`,
    after: parts.map((part, k) => `$v('f', ${name}.${part} ?? null, ${at(k)}, ${n});`).join(' ') };
}

// One parameter: its name in JavaScript, its type, what is passed, and what is done before and after the call.
function shape(p, f, headers) {
  const name = safe(p.name), record = isRecord(p.type, headers);
  if (isBad(p))
    return { pass: 'badAt()' };
  if (p.type === 'nkw_work')
    return { pass: `$work(${work[f.name]})` };
  if (p.name === 'work' && p.pointer)
    return { pass: `temporary(8 * 3 * ${work[f.name]} + 8)` };
  if (p.name === 'work_count')
    return { pass: work[f.name] };
  if (p.type === 'nkw_motion_span')
    return shapeOfMotion(name, lengthOfParameter(p, f));
  if (isSpan(p) || (p.type === 'nkw_track' && p.pointer && !p.constant))
    return { pass: isSpan(p) ? '$span' : '$to' };
  const of = kindOf(p.type, headers), value = p.pointer === 0;
  if (!of || p.pointer > 1 || (record && !fits(p.type, headers, p.pointer && !p.constant)))
    return undefined;
  if (value && !headers.structs.has(p.type)) {
    const type = p.type === 'int64_t' ? 'bigint | number'
      : headers.enums.has(p.type) ? scriptName(p.type).replace(/^./, c => c.toUpperCase()) : 'number';
    return { name, type, pass: p.type === 'int64_t' ? `BigInt(${name})` : `$n(${name})` };
  }
  const n = value ? '1' : lengthOfParameter(p, f), type = recordType(p.type);
  if (record && n === '1' && (value || p.constant))
    return { name, type, pass: `$i(${of.kind}, ${name})` };
  if (record && n === '1')
    return { name, type: `Partial<${type}> | null`, before: `const ${name}At = ${name} ? $i(${of.kind}, ${name}) : 0;`,
      pass: `${name}At`, after: `$g(${of.kind}, ${name}, ${name}At);` };
  const total = times(n, of.words), big = of.kind === 'q' ? 'bigint' : 'number';
  if (value || p.constant)
    return { name, type: record ? `ArrayLike<${type}>` : `Numbers${value ? '' : ' | null'}`,
      pass: `$a(${literal(of.kind)}, ${name}, ${total}, '${name}')` };
  return { name, type: record ? `${type}[] | null` : `${big === 'bigint' ? 'bigint[]' : 'Output'} | null`,
    before: `const ${name}At = $o(${literal(of.kind)}, ${name}, ${total});`, pass: `${name}At`,
    after: `$v(${literal(of.kind)}, ${name}, ${name}At, ${total});` };
}

// The result: what JavaScript receives, and the memory of a struct; undefined if it does not fit.
function resultOf(f, headers) {
  if (!headers.structs.has(f.type)) {
    const nothing = /^(void|nkw_result)$/.test(f.type);
    return f.type.includes('*') ? undefined
      : { type: nothing ? 'void' : f.type === 'int64_t' ? 'bigint' : 'number', back: nothing ? '' : 'return y;' };
  }
  const { kind, words } = kindOf(f.type, headers);
  if (isRecord(f.type, headers))
    return fits(f.type, headers, true) ? { type: `T & ${recordType(f.type)}`, generic: '<T extends object>',
      memory: `const $y = $m(${kind});`, back: `return $g(${kind}, out, $y);` } : undefined;
  return words && { type: 'T', generic: '<T extends FloatArray>', memory: `const $y = temporary(${4 * words});`,
    back: `$v('f', out, $y, ${words}); return out;` };
}

function bodyOf(f, shapes, result) {
  const after = shapes.map(s => s.after ?? ''), call =
    `$.${f.name}(${[...(result.memory ? ['$y'] : []), ...shapes.map(s => s.pass)].join(', ')})`;
  const called = f.type === 'nkw_result' ? `$check('${f.name}', ${call}${f.parameters.some(isBad) ? ', bad' : ''});`
    : result.type === 'number' || result.type === 'bigint' ? `const y = ${call};` : `${call};`;
  return [...shapes.map(s => s.before ?? ''), result.memory ?? '', called, ...after, result.back].filter(Boolean)
    .join(' ').replace(/const y = (.*); return y;$/, after.some(Boolean) ? '$&' : 'return $1;');
}

// A function that makes a track.
function bodyOfTrack(f, body) {
  return `return trackFrom(${lengths[f.name].span}, ($span, $to) => { ${body} });`;
}

export function writeWithRecords(f, headers) {
  const shapes = f.parameters.map(p => shape(p, f, headers)), result = resultOf(f, headers);
  if (shapes.includes(undefined) || !result)
    return undefined;
  const track = f.parameters.some(isSpan), named = shapes.filter(s => s.name), js = scriptName(f.name);
  const optional = i => named.slice(i).every(s => s.after && / null$/.test(s.type)) ? '?' : '';
  const types = named.map((s, i) => `${s.name}${optional(i)}: ${s.type}`), out = result.generic ? ['out'] : [];
  const body = bodyOf(f, shapes, result);
  return {
    code: `export function ${js}(${[...out, ...named.map(s => s.name)].join(', ')}) ` +
      `{ return $t(() => { ${track ? bodyOfTrack(f, body) : body} }); }`,
    type: `/** ${f.summary} */\nexport function ${js}${result.generic ?? ''}(` +
      `${[...out.map(name => `${name}: T`), ...types].join(', ')}): ${track ? 'Track' : result.type};`,
  };
}
