// SPDX-License-Identifier: MIT
// Skinned meshes on a canvas: faces in colours, shaded by their normals.
import { colour } from './colours';
import type { View } from './eye';
import type { Shape } from './picture';
import { polygon } from './space';
import { clamp } from './values';

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

/** Colours of a share from 0 to 1, dark to light, that people with any colour vision tell apart. */
const stops = [[84, 48, 140], [58, 88, 150], [38, 140, 142], [98, 196, 108], [250, 228, 60]];
export const rampStyle = `linear-gradient(to right, ${stops.map(s => `rgb(${s.join(' ')})`).join(', ')})`;

export function ramp(share: number): number[] {
  const at = clamp(share, 0, 1) * (stops.length - 1), k = Math.min(Math.floor(at), stops.length - 2);
  return mix([stops[k], stops[k + 1]], [1 - at + k, at - k]);
}

/** How much light a face has: most where it looks to the eye, more from above. */
function shade([a, b, d]: number[][], eye: number[]): number {
  const [ux, uy, uz] = b.map((x, k) => x - a[k]), [vx, vy, vz] = d.map((x, k) => x - a[k]);
  const n = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx], to = eye.map((x, k) => x - a[k]);
  const facing = Math.abs(n[0] * to[0] + n[1] * to[1] + n[2] * to[2]) / (Math.hypot(...n) * Math.hypot(...to) || 1);
  return 0.68 + 0.26 * facing + 0.08 * n[1] / (Math.hypot(...n) || 1);
}

/** The faces of a mesh, each a list of vertices; `paint` returns the colour of face i. */
export function skinned(c: CanvasRenderingContext2D, view: View, positions: ArrayLike<number>, faces: number[][],
  paint: (i: number) => number[]): Shape[] {
  return faces.map((face, i) => {
    const corners = face.map(v => vertex(positions, v)), share = shade(corners, view.position);
    const fill = `rgb(${paint(i).map(x => Math.round(Math.min(x * share, 255))).join(' ')})`;
    return polygon(c, view, corners, fill, 'rgb(20 24 36 / 0.35)');
  });
}
