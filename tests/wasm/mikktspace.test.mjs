// SPDX-License-Identifier: MIT
// Tangents beside the package mikktspace (NKW_MIKKTSPACE, its folder), the reference in WebAssembly: components within
// 1e-3, because it takes angles from binary32 cosines, and signs equal.
import assert from 'node:assert/strict';
import { createRequire } from 'node:module';
import { test } from 'node:test';
import { both } from './support.mjs';

const { generateTangents } = createRequire(import.meta.url)(process.env.NKW_MIKKTSPACE);

let state = 1;
const random = () => (state = Math.imul(state, 1664525) + 1013904223 >>> 0) / 2 ** 32;
const unit = v => v.map(x => x / (Math.hypot(...v) || 1));

// A surface of columns x rows quads, as corners: vertex(u, v) has position, normal and texture coordinates.
function surface(columns, rows, vertex) {
  const corners = { positions: [], normals: [], texcoords: [] };
  const at = Array.from({ length: rows + 1 }, (_, y) =>
    Array.from({ length: columns + 1 }, (_, x) => vertex(x / columns, y / rows, x, y)));
  for (let y = 0; y < rows; y++)
    for (let x = 0; x < columns; x++)
      for (const [i, j] of [[0, 0], [1, 0], [1, 1], [0, 0], [1, 1], [0, 1]]) {
        const [p, n, t] = at[y + j][x + i];
        corners.positions.push(...p), corners.normals.push(...n), corners.texcoords.push(...t);
      }
  return Object.fromEntries(Object.entries(corners).map(([name, list]) => [name, Float32Array.from(list)]));
}

function torus(texture) {
  return surface(24, 12, (u, v) => {
    const [a, b] = [2 * Math.PI * (u % 1), 2 * Math.PI * (v % 1)];
    const n = [Math.cos(a) * Math.cos(b), Math.sin(a) * Math.cos(b), Math.sin(b)];
    return [[3 * Math.cos(a) + n[0], 3 * Math.sin(a) + n[1], n[2]], n, texture(u, v)];
  });
}

// The triangles at the poles have two corners at one position.
const sphere = () => surface(16, 8, (u, v, x, y) => {
  const [a, b] = [2 * Math.PI * (u % 1), Math.PI * v], ring = y === 0 || y === 8 ? 0 : Math.sin(b);
  const n = [Math.cos(a) * ring, Math.sin(a) * ring, Math.cos(b)];
  return [n, n, [u, v]];
});

const uneven = texture => surface(15, 15, (u, v, x, y) => [[x + 0.5 * random(), y + 0.5 * random(), random()],
  unit([random() - 0.5, random() - 0.5, 1]), texture(u, v, x, y)]);

const meshes = {
  'a torus with seams': () => torus((u, v) => [4 * u, v]),
  'a torus whose second half is mirrored': () => torus((u, v) => [u < 0.5 ? u : 1 - u, v]),
  'a sphere with collapsed triangles': sphere,
  'an uneven surface': () => uneven((u, v) => [u + 0.02 * random(), v + 0.02 * random()]),
  'an uneven surface whose texture has no area in places': () => uneven((u, v, x) => [Math.floor(x / 2), v]),
  'an uneven surface without a texture': () => uneven(() => [0.5, 0.5]),
};

for (const [build, n] of await both('all'))
  for (const [name, make] of Object.entries(meshes))
    test(`${build}: ${name}`, () => {
      const { positions, normals, texcoords } = make(), count = positions.length / 3;
      const want = generateTangents(positions, normals, texcoords), got = new Float32Array(4 * count);
      const bitangents = new Float32Array(3 * count);
      n.meshTangents({ positions }, { normals, texcoords }, got, bitangents);
      for (let i = 0; i < 4 * count; i++)
        assert.ok(Math.abs(got[i] - want[i]) <= (i % 4 === 3 ? 0 : 1e-3), `${got[i]} ${want[i]} (${i})`);
      for (let c = 0; c < count; c++) {
        const [a, t] = [unit([...normals.slice(3 * c, 3 * c + 3)]), got.slice(4 * c, 4 * c + 4)];
        const b = [a[1] * t[2] - a[2] * t[1], a[2] * t[0] - a[0] * t[2], a[0] * t[1] - a[1] * t[0]];
        b.forEach((x, k) => assert.ok(Math.abs(t[3] * x - bitangents[3 * c + k]) <= 1e-6));
      }
    });
