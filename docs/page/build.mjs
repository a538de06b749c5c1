// SPDX-License-Identifier: MIT
// node build.mjs PAGE BUILD: checks the types and writes BUILD/page, from the sources in PAGE, the tools in
// BUILD/node_modules and the package in BUILD/package.
import { execFileSync } from 'node:child_process';
import { copyFileSync, mkdirSync, readFileSync, readdirSync, realpathSync, rmSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { gzipSync } from 'node:zlib';
import { html, reference } from '../generate/reference.mjs';

const [page, build] = process.argv.slice(2).map(path => realpathSync(path));
const modules = `${build}/node_modules`, out = `${build}/page`;
const require = createRequire(`${build}/`);
const [esbuild, katex] = [require('esbuild'), require('katex')];

// The types: paths that depend on the build folder are in a file of this folder.
function check() {
  const config = `${build}/tsconfig.json`;
  writeFileSync(config, JSON.stringify({
    extends: `${page}/tsconfig.json`,
    compilerOptions: { paths: { 'nakawari/*': [`${build}/package/*`], '*': [`${modules}/@types/*`, `${modules}/*`] } },
    include: [`${page}/**/*.ts`],
  }));
  execFileSync(process.execPath, [`${modules}/typescript/bin/tsc`, '-p', config], { stdio: 'inherit' });
}

const imports = /\bimport\('(\.\/\w+)'\)/g;

// In sources, tex`...` becomes MathML, and import('./keys') becomes later('./keys'), a module of the second script.
const sources = {
  name: 'sources',
  setup: ({ onLoad }) => onLoad({ filter: /\.ts$/ }, ({ path }) => {
    const text = readFileSync(path, 'utf8').replace(/\btex`([^`]*)`/g, (_, source) =>
      JSON.stringify(katex.renderToString(source, { output: 'mathml', throwOnError: true, strict: 'error' })));
    const contents = text.replaceAll(imports, "later('$1')");
    const head = contents === text ? '' : `import { later } from '${page}/shell/part';\n`;
    return { loader: 'ts', contents: head + contents };
  }),
};

// Each script of the page has one part of the package under the name nakawari/all. The package loads its module with
// import(), which scripts of a page that is a file cannot use: `part` loads a script.
const library = name => ({
  name: 'library',
  setup({ onLoad, onResolve }) {
    onResolve({ filter: /^nakawari\/all/ }, ({ path }) => ({
      path: realpathSync(`${build}/package/${path.slice(9).replace('all', name)}.js`) }));
    onLoad({ filter: /package\/\w+\.js$/ }, ({ path }) => {
      const text = readFileSync(path, 'utf8');
      const contents = text.replace(/import\('\.\/wasm\/([\w.]+)\.js'\)/g, (_, wasm) => `part('wasm-${wasm}')`);
      if (contents === text)
        throw new Error(`${path}: no import of a module`);
      return { contents: `import { part } from '${page}/shell/part';\n${contents}`, loader: 'js' };
    });
  },
});

const common = {
  bundle: true, minify: true, format: 'iife', target: 'es2022', nodePaths: [modules], legalComments: 'none',
  metafile: true, logLevel: 'warning', logOverride: { 'import-is-undefined': 'error' }, loader: { '.glb': 'binary' },
};

// A script that `part` loads: its exports are a member of the global nakawariParts.
const script = (name, options) => esbuild.build({
  ...common, outfile: `${out}/${name}.js`, globalName: `nakawariParts["${name}"]`, ...options,
});
const module = (name, path) => script(name, { entryPoints: [path] });
const wasm = name => module(`wasm-${name}`, `${build}/package/wasm/${name}.js`);

// The exhibits that the list imports: the second script.
function exhibits() {
  const list = readFileSync(`${page}/exhibits/list.ts`, 'utf8'), names = [...list.matchAll(imports)].map(m => m[1]);
  const contents = names.map(name => `export * as '${name}' from '${name}';`).join('\n');
  return script('exhibits', { plugins: [library('all'), sources],
    stdin: { contents: `export { ready } from 'nakawari/all';\n${contents}`, resolveDir: `${page}/exhibits` } });
}

async function bundle() {
  rmSync(out, { recursive: true, force: true });
  mkdirSync(out, { recursive: true });
  const results = await Promise.all([
    esbuild.build({ ...common, entryPoints: [`${page}/shell/main.ts`], outfile: `${out}/page.js`,
      plugins: [library('math'), sources] }),
    exhibits(),
    ...['math', 'math.plain', 'all', 'all.plain'].map(wasm),
    module('three', `${page}/kit/three.ts`),
    module('character', `${page}/kit/character.ts`),
  ]);
  copyFileSync(`${page}/index.html`, `${out}/index.html`);
  writeFileSync(`${out}/reference.html`, html(readFileSync(reference, 'utf8')));
  return results.flatMap(result => Object.keys(result.metafile.inputs));
}

// The licence of each package that a script contains.
function licences(inputs) {
  const names = new Set(inputs.map(path => path.match(/node_modules\/((?:@[^/]+\/)?[^/]+)\//)?.[1]).filter(Boolean));
  names.add('katex');
  const one = name => {
    const { version, license } = JSON.parse(readFileSync(`${modules}/${name}/package.json`, 'utf8'));
    const file = readdirSync(`${modules}/${name}`).find(f => /^licen[cs]e/i.test(f));
    return `${name} ${version}: ${license}\n\n${file ? readFileSync(`${modules}/${name}/${file}`, 'utf8') : ''}`;
  };
  const own = ['nakawari: MIT', readFileSync(`${build}/package/LICENSE`, 'utf8')].join('\n\n');
  writeFileSync(`${out}/licences.txt`, [own, ...[...names].sort().map(one)].join(`\n${'-'.repeat(80)}\n\n`));
}

// The sizes with gzip. What the first picture needs is at most 300 KB.
function sizes() {
  const kb = name => gzipSync(readFileSync(`${out}/${name}`), { level: 9 }).length / 1024;
  const sum = (what, names) => {
    const list = names.map(kb), total = list.reduce((all, size) => all + size, 0);
    const each = names.map((name, i) => `${name} ${list[i].toFixed(1)}`).join(', ');
    console.log(`${what}: ${total.toFixed(1)} KB with gzip (${each})`);
    return total;
  };
  const first = sum('The first picture', ['index.html', 'page.css', 'page.js', 'wasm-math.js']);
  sum('The other exhibits', ['exhibits.js', 'wasm-all.js']);
  sum('Where a model is shown', ['three.js', 'character.js']);
  if (first > 300)
    throw new Error('the first picture needs more than 300 KB');
}

check();
licences(await bundle());
sizes();
