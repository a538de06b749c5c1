// SPDX-License-Identifier: MIT
import { readFileSync } from 'node:fs';

export const { NKW_PACKAGE: packageFolder, NKW_ROOT: root } = process.env;
export const text = path => readFileSync(path, 'utf8');

// A part of the package with simd128, and with the fallback: modules are loaded once for each address.
export async function both(part) {
  const parts = {};
  for (const [name, query] of [['simd128', ''], ['plain', '?plain']]) {
    const validate = WebAssembly.validate;
    if (query)
      WebAssembly.validate = () => false;
    parts[name] = await import(`${packageFolder}/${part}.js${query}`);
    await parts[name].ready;
    WebAssembly.validate = validate;
  }
  return Object.entries(parts);
}

export const bits = values => [...new Uint32Array(Float32Array.from(values).buffer)];

// Reproducible numbers in [-1, 1).
export function numbers(seed) {
  let state = seed >>> 0;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return Math.fround(state / 2 ** 31 - 1);
  };
}

export function rotation(next) {
  const q = [next(), next(), next(), next()], length = Math.hypot(...q);
  return q.map(x => Math.fround(x / length));
}
