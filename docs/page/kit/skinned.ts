// SPDX-License-Identifier: MIT
// Skinned meshes on a canvas: faces in colours, shaded by their normals.
import { colour } from './colours';
import type { View } from './eye';
import type { Shape } from './picture';
import { polygon } from './space';

/** Vertex i of an array of vectors. */
export const vertex = (positions: ArrayLike<number>, i: number) => [0, 1, 2].map(k => positions[3 * i + k]);

/** Red, green and blue of a CSS variable. */
export function rgb(name: string): number[] {
  const n = parseInt(colour(name).slice(1), 16);
  return [n >> 16 & 255, n >> 8 & 255, n & 255];
}

/** The sum of colours by their weights. */
export const mix = (colours: number[][], weights: ArrayLike<number>) =>
  [0, 1, 2].map(k => colours.reduce((sum, c, i) => sum + c[k] * weights[i], 0));

const lamp = [0.5, 0.6, 0.62];

function shade([a, b, d]: number[][]): number {
  const [ux, uy, uz] = b.map((x, k) => x - a[k]), [vx, vy, vz] = d.map((x, k) => x - a[k]);
  const n = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
  return 0.8 + 0.2 * (n[0] * lamp[0] + n[1] * lamp[1] + n[2] * lamp[2]) / (Math.hypot(...n) || 1);
}

/** The faces of a mesh, each a list of vertices; `paint` gives the colour of face i. */
export function skinned(c: CanvasRenderingContext2D, view: View, positions: ArrayLike<number>, faces: number[][],
  paint: (i: number) => number[], offset = [0, 0, 0]): Shape[] {
  return faces.map((face, i) => {
    const corners = face.map(v => vertex(positions, v).map((x, k) => x + offset[k])), share = shade(corners);
    const fill = `rgb(${paint(i).map(x => Math.round(Math.min(x * share, 255))).join(' ')})`;
    return polygon(c, view, corners, fill, 'rgb(20 24 36 / 0.35)');
  });
}
