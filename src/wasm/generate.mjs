// SPDX-License-Identifier: MIT
// node generate.mjs exports ROOT PART            the linker's --export options of a part
// node generate.mjs package ROOT WASM OUT VERSION    the package, from WASM/PART.wasm and WASM/PART.plain.wasm
import { mkdirSync, readFileSync, writeFileSync, copyFileSync } from 'node:fs';
import { dirname } from 'node:path';
import { deflateRawSync } from 'node:zlib';
import { readHeaders } from './headers.mjs';
import { scriptName, writeFunction } from './functions.mjs';
import { writeConstants, writeRecords } from './layouts.mjs';
import { adapters, excluded, excludedStems, objectStems, parts, partial } from './parts.mjs';

const here = new URL('.', import.meta.url).pathname;

export function readAll(root) {
  const cmake = readFileSync(`${root}/src/subjects.cmake`, 'utf8');
  const stems = [...cmake.matchAll(/set\(NKW_STEMS_\w+ ([^)]*)\)/g)].flatMap(m => m[1].trim().split(/\s+/));
  return { ...readHeaders(`${root}/include/nakawari`, stems, objectStems), stems };
}

const source = name => readFileSync(`${here}${name}.js`, 'utf8');
const called = part =>
  [...part.sources, 'core'].flatMap(s => [...source(s).matchAll(/\bx\.(nkw_\w+)/g)].map(m => m[1]));

export function functionsOf(part, headers) {
  const written = [], calls = called(part);
  for (const f of headers.functions.values())
    if (part.stems.includes(f.stem) && !(f.name in excluded) && !part.without?.test(f.name) &&
        (part.batch || !f.name.endsWith('_n')) && !calls.includes(f.name)) {
      const made = writeFunction(f, headers);
      if (made)
        written.push({ ...f, ...made });
      else if (!partial.includes(f.stem))
        throw new Error(`${f.name} of ${f.stem}.h does not fit: exclude it in parts.mjs, with a reason`);
    }
  return written;
}

const exportsOf = (part, headers) => [...new Set([...functionsOf(part, headers).map(f => f.name), ...called(part)])];

// Every public function is in a part, or excluded with a reason.
export function checkList(headers) {
  const bound = new Set(parts.flatMap(part => exportsOf(part, headers)));
  const missing = [...headers.functions.values()].filter(f =>
    !bound.has(f.name) && !(f.name in excluded) && !(f.stem in excludedStems) && !partial.includes(f.stem));
  const stale = Object.keys(excluded).filter(name => bound.has(name) || !headers.functions.has(name));
  const unknown = [...bound].filter(name => !headers.functions.has(name));
  return { bound: bound.size, missing: missing.map(f => f.name), stale, unknown };
}

// Without comments and indentation: the types have the comments.
const short = text => text.replace(/\/\*\*[\s\S]*?\*\/|^\s*\/\/.*$/gm, '').replace(/^[ \t]+|[ \t]+$/gm, '')
  .replace(/\n+/g, '\n').trim();

function writePart(part, headers, out, wasm) {
  const functions = functionsOf(part, headers);
  const stems = [...part.stems, ...(part.enums ?? [])];
  const enums = [...headers.enums].filter(([name]) => stems.some(s => headers.enumStem.get(name) === s));
  const title = `// SPDX-License-Identifier: MIT\n// nakawari: generated from the headers of the C library.\n`;
  const code = [...part.sources.map(source), ...functions.map(f => f.code)].join('\n');
  const records = writeRecords(code, headers), constants = writeConstants(stems, headers);
  const js = [source('core').replaceAll('PART', part.name), ...records.map(r => r.code),
    ...enums.flatMap(([, members]) => members.map(([name, value]) => `export const ${name} = ${value};`)),
    ...constants.map(c => c.code), code];
  const camel = name => scriptName(name).replace(/^./, c => c.toUpperCase());
  const ts = [title, readFileSync(`${here}core.d.ts`, 'utf8'),
    ...part.sources.map(s => readFileSync(`${here}${s}.d.ts`, 'utf8')),
    ...[...headers.enums.keys()].filter(name => functions.some(f => f.type.includes(camel(name))) ||
      enums.some(([e]) => e === name)).map(name => `export type ${camel(name)} = number;`),
    ...enums.flatMap(([, members]) => members.map(([name, value]) => `export const ${name}: ${value};`)),
    ...constants.map(c => c.type), ...records.map(r => r.type).filter(Boolean), ...functions.map(f => f.type)];
  writeFileSync(`${out}/${part.name}.js`, title + short(js.join('\n')) + '\n');
  writeFileSync(`${out}/${part.name}.d.ts`, ts.join('\n') + '\n');
  const base64 = (file, pack) => `export default '${pack(readFileSync(`${wasm}/${file}.wasm`)).toString('base64')}';\n`;
  writeFileSync(`${out}/wasm/${part.name}.js`, base64(part.name, b => deflateRawSync(b, { level: 9 })));
  writeFileSync(`${out}/wasm/${part.name}.plain.js`, base64(`${part.name}.plain`, b => b));
}

// A script on top of a part: an import of the part of characters becomes one of its own part.
function writeAdapter([name, part], out) {
  const file = name.split('/').at(-1), to = `'${name.includes('/') ? '..' : '.'}/${part}.js'`;
  const over = text => text.replaceAll("'./characters.js'", to);
  mkdirSync(dirname(`${out}/${name}`), { recursive: true });
  writeFileSync(`${out}/${name}.js`, `// SPDX-License-Identifier: MIT\n${over(short(source(file)))}\n`);
  writeFileSync(`${out}/${name}.d.ts`, over(readFileSync(`${here}${file}.d.ts`, 'utf8')));
}

function writePackage(root, wasm, out, version) {
  const headers = readAll(root), { missing, stale, unknown } = checkList(headers);
  if (missing.length + stale.length + unknown.length)
    throw new Error(`parts.mjs: missing ${missing}; stale ${stale}; unknown ${unknown}`);
  mkdirSync(`${out}/wasm`, { recursive: true });
  for (const part of parts)
    writePart(part, headers, out, wasm);
  Object.entries(adapters).forEach(adapter => writeAdapter(adapter, out));
  const entry = name => ({ types: `./${name}.d.ts`, default: `./${name}.js` });
  writeFileSync(`${out}/package.json`, JSON.stringify({
    name: 'nakawari', version, license: 'MIT', type: 'module', sideEffects: false,
    description: 'Keyframe interpolation mathematics: the same bits everywhere',
    engines: { node: '>=18' },
    exports: { '.': entry('all'), ...Object.fromEntries(
      [...parts.map(part => part.name), ...Object.keys(adapters)].map(name => [`./${name}`, entry(name)])) },
  }, null, 2) + '\n');
  copyFileSync(`${root}/LICENSE`, `${out}/LICENSE`);
  copyFileSync(`${root}/docs/web.md`, `${out}/README.md`);
}

if (import.meta.url === `file://${process.argv[1]}`) {
  const [verb, root, ...rest] = process.argv.slice(2);
  if (verb === 'exports') {
    const part = parts.find(p => p.name === rest[0]);
    console.log(exportsOf(part, readAll(root)).map(name => `--export=${name}`).join('\n'));
  } else {
    writePackage(root, ...rest);
  }
}
