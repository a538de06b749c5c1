// SPDX-License-Identifier: MIT
// node build.mjs PAGE BUILD: checks the types and writes BUILD/page, from the sources in PAGE, the tools in
// BUILD/node_modules and the package in BUILD/package.
import { execFileSync } from 'node:child_process';
import { copyFileSync, existsSync, mkdirSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { gzipSync } from 'node:zlib';

const [page, build] = process.argv.slice(2);
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

// tex`...` becomes MathML.
const formulas = {
  name: 'formulas',
  setup: ({ onLoad }) => onLoad({ filter: /\.ts$/ }, ({ path }) => ({
    loader: 'ts',
    contents: readFileSync(path, 'utf8').replace(/\btex`([^`]*)`/g, (_, source) =>
      JSON.stringify(katex.renderToString(source, { output: 'mathml', throwOnError: true, strict: 'error' }))),
  })),
};

// The package loads its module with import(), which scripts of a page that is a file cannot use: `part` loads a script.
const wasm = {
  name: 'wasm',
  setup({ onLoad, onResolve }) {
    onResolve({ filter: /^nakawari\// }, ({ path }) => ({ path: `${build}/package/${path.slice(9)}.js` }));
    onLoad({ filter: /package\/all\.js$/ }, ({ path }) => {
      const text = readFileSync(path, 'utf8');
      const contents = text.replace(/import\('\.\/wasm\/([\w.]+)\.js'\)/g, (_, name) => `part('wasm-${name}')`);
      if (contents === text)
        throw new Error(`${path}: no import of a module`);
      return { contents: `import { part } from '${page}/shell/part.ts';\n${contents}`, loader: 'js' };
    });
  },
};

const common = {
  bundle: true, minify: true, format: 'iife', target: 'es2022', nodePaths: [modules], legalComments: 'none',
  metafile: true, logLevel: 'warning', loader: { '.glb': 'binary' },
};

// A script that `part` loads: its exports are a member of the global nakawariParts.
const script = (name, entry) => esbuild.build({
  ...common, entryPoints: [entry], outfile: `${out}/${name}.js`, globalName: `nakawariParts["${name}"]`,
});

async function bundle() {
  rmSync(out, { recursive: true, force: true });
  mkdirSync(out, { recursive: true });
  const results = await Promise.all([
    esbuild.build({ ...common, entryPoints: [`${page}/shell/main.ts`], outfile: `${out}/page.js`,
      plugins: [wasm, formulas] }),
    script('wasm-all', `${build}/package/wasm/all.js`),
    script('wasm-all.plain', `${build}/package/wasm/all.plain.js`),
    script('three', `${page}/kit/three.ts`),
    script('character', `${page}/kit/character.ts`),
  ]);
  copyFileSync(`${page}/index.html`, `${out}/index.html`);
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

// What the first picture needs is at most 300 KB with gzip.
function sizes() {
  const kb = name => gzipSync(readFileSync(`${out}/${name}`), { level: 9 }).length / 1024;
  const first = ['index.html', 'page.css', 'page.js', 'wasm-all.js'].filter(name => existsSync(`${out}/${name}`));
  const total = first.reduce((sum, name) => sum + kb(name), 0);
  console.log(`${first.map(name => `${name} ${kb(name).toFixed(1)}`).join(', ')}: ${total.toFixed(1)} KB with gzip; ` +
    `three.js ${kb('three.js').toFixed(1)}`);
  if (total > 300)
    throw new Error('the first picture needs more than 300 KB');
}

check();
licences(await bundle());
sizes();
