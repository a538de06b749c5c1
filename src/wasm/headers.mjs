// SPDX-License-Identifier: MIT
// The functions, structs and enumerations of the public headers, read from their texts.
import { readFileSync } from 'node:fs';

const plain = text => text.replace(/\/\*[\s\S]*?\*\//g, '');
const number = { float: 1, int: 1, int32_t: 1, uint32_t: 1, unsigned: 1, size_t: 1, double: 1 };

// The first paragraph of a comment, on one line.
function summary(comment) {
  const lines = comment.replace(/^\/\*\*+|\*\/$/g, '').split('\n').map(line => line.replace(/^\s*\*? ?/, '').trim());
  const from = lines.findIndex(line => line !== '' && !line.startsWith('@'));
  const rest = from < 0 ? [] : lines.slice(from);
  const to = rest.indexOf('');
  return (to < 0 ? rest : rest.slice(0, to)).join(' ');
}

function parameter(text) {
  const parts = text.trim().match(/^(const )?(\w+) *((?:\* *(?:const *)?)*)(\w+)(?:\[(\d+)\])?$/);
  if (!parts)
    throw new Error(`no parameter: ${text}`);
  const [, constant, type, star, name, length] = parts;
  const stars = star.replace(/[^*]/g, '').length;
  return { type, name, constant: !!constant, pointer: stars + (length ? 1 : 0), length: +(length ?? 1) };
}

// The fields of one declaration in a struct: `const float *times`, `nkw_handle in, out`. The length of an array that is
// a macro is NaN: such structs are not bound.
function fieldsOf(text) {
  const [, type, names] = text.match(/^(?:const )?(unsigned char|\w+)\s*([\s\S]*)$/);
  return names.split(',').map(item => {
    const [, stars, name, length] =
      item.replace(/\bconst\b/g, '').trim().match(/^([*\s]*)(\w+)\s*(?:\[(\w+)\])?$/);
    return { type, name, pointer: stars.replace(/[^*]/g, '').length, length: +(length ?? 1) };
  });
}

// Structs of floats have `words`, except those of the stems `objects`.
export function readHeaders(folder, stems, objects) {
  const functions = new Map(), structs = new Map(), enums = new Map(), enumStem = new Map(), constants = [];
  const widths = type => number[type] ?? (enums.has(type) ? 1 : structs.get(type)?.words);
  // Of structs of floats only.
  const wordsOf = type => type === 'float' ? 1 : structs.get(type)?.words ?? NaN;
  for (const stem of stems) {
    const text = readFileSync(`${folder}/${stem}.h`, 'utf8');
    for (const [, body, name] of text.matchAll(/typedef enum \w+ \{([\s\S]*?)\} *(\w+);/g)) {
      let next = 0;
      const members = [];
      for (const item of plain(body).split(',').map(s => s.trim()).filter(s => /^NKW_\w+( *=|$)/.test(s))) {
        const [key, value] = item.split('=').map(s => s.trim());
        next = value === undefined ? next : Number(value);
        if (!/_(COUNT|MAX_ENUM)$/.test(key))
          members.push([key.slice(4), next]);
        next++;
      }
      enums.set(name, members);
      enumStem.set(name, stem);
    }
    for (const [, body, name] of text.matchAll(/typedef struct \w+ \{([\s\S]*?)\} *(\w+);/g)) {
      const fields = plain(body).split(';').map(s => s.trim()).filter(Boolean).flatMap(fieldsOf);
      const words = fields.reduce((sum, f) => sum + (f.pointer ? NaN : wordsOf(f.type) * f.length), 0);
      structs.set(name, { fields, stem, words: objects.includes(stem) ? undefined : words || undefined });
    }
    // Macros that are an initialiser of names of enumerations, or a number: NKW_AXES_GLTF, NKW_NO_JOINT.
    for (const [, name, body] of text.matchAll(/^#define (NKW_\w+)[\s\\]*(\{[^{}]*\}|\(-?\d+\))/gm))
      constants.push({ name, stem, body: body.replace(/[\\\s{}()]/g, '') });
    for (const [, comment, before, args] of text.matchAll(
      /(\/\*\*(?:(?!\*\/)[\s\S])*\*\/\s*)?(?:^NKW_API|^NKW_ALGEBRA\w*)\s+([^;{}()]*?)\(([^;]*?)\);/gm)) {
      const [, type, star, name] = before.trim().match(/^((?:const )?\w+)\s+(\*?)\s*(\w+)$/);
      const parameters = args.trim() === 'void' ? [] : args.split(',').map(parameter);
      const about = comment ? summary(comment.trim()) : '';
      functions.set(name, { name, stem, type: type + star, parameters, summary: about });
    }
  }
  return { functions, structs, enums, enumStem, constants, widths };
}
