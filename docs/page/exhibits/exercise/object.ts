// SPDX-License-Identifier: MIT
// A model of a file .obj, with the colours of its .mtl, in place of the dart; read by the loaders of three.js.
import { modelOf, type Model, type Triangle } from '../../kit/object';
import type * as Three from '../../kit/three';
import { part } from '../../shell/part';
import { refuse } from './layout';

export interface Own { name: string; triangles: number; model: Model; missing: string[] }

const most = 4000;
const grey = [184, 188, 198];

/** What is shown, until the page is left: the address does not contain it. */
let shown: Own | undefined;
export const ownObject = () => shown;
export const showObject = (own: Own | undefined) => { shown = own; };

/* ---- the lines ---- */

/** The lines that the loader needs. It takes wrong numbers without a word, so they are refused here. */
function checked(text: string): string {
  let vertices = 0, faces = 0;
  const wrong = (i: number, en: string, ja: string) => refuse(`line ${i + 1}: ${en}`, `${i + 1} 行目：${ja}`);
  const lines = text.replace(/\\\r?\n/g, ' ').split(/\r?\n/).map(line => line.trim());
  lines.forEach((line, i) => {
    const [word, ...rest] = line.split(/\s+/);
    if (word === 'v' && !(rest.length >= 3 && rest.slice(0, 3).every(x => Number.isFinite(+x))))
      wrong(i, 'three numbers are expected', '数値が3つ必要です');
    vertices += word === 'v' ? 1 : 0;
    if (word !== 'f')
      return;
    faces++;
    if (rest.length < 3)
      wrong(i, 'a face has three corners or more', '面には3つ以上の頂点が必要です');
    for (const index of rest.map(corner => Number(corner.split('/')[0])))
      if (!Number.isInteger(index) || index === 0 || index > vertices || index < -vertices)
        wrong(i, `vertex ${index} does not exist: there are ${vertices}`, `頂点 ${index} はありません（${vertices} 個）`);
  });
  if (!faces)
    refuse('no faces', '面がありません');
  return lines.filter(line => /^(v|f|o|g|usemtl)\s/.test(line)).map(line =>
    line.replace(/^f\s.*/, face => face.replace(/\/[^\s]*/g, ''))).join('\n');
}

/* ---- the triangles ---- */

/** The colours of all files, without their pictures, which the canvas does not show. */
const materialsOf = ({ MTLLoader }: typeof Three, texts: string[]) =>
  new MTLLoader().parse(texts.join('\n').replace(/^\s*(map_|bump|disp|norm|refl|decal).*$/gim, ''), '');

function trianglesOf(three: typeof Three, text: string, libraries: string[]): Triangle[] {
  const materials = materialsOf(three, libraries), known = materials.materialsInfo, triangles: Triangle[] = [];
  const loader = new three.OBJLoader().setMaterials(materials);
  loader.parse(checked(text)).traverse(mesh => {
    if (!(mesh instanceof three.Mesh))
      return;
    const at = mesh.geometry.getAttribute('position'), list: Three.MeshPhongMaterial[] = [mesh.material].flat();
    const groups = mesh.geometry.groups.length ? mesh.geometry.groups : [{ start: 0, count: at.count, materialIndex: 0 }];
    for (const { start, count, materialIndex } of groups) {
      const { name, color } = list[materialIndex ?? 0], hex = color.getHex();
      const rgb = Object.hasOwn(known, name) ? [hex >> 16, (hex >> 8) & 255, hex & 255] : grey;
      for (let i = start; i + 2 < start + count; i += 3)
        triangles.push({ corners: [i, i + 1, i + 2].map(k => [at.getX(k), at.getY(k), at.getZ(k)]), rgb });
    }
  });
  return triangles;
}

/* ---- files ---- */

const isLibrary = (file: File) => /\.mtl$/i.test(file.name);
export const isObject = (files: File[]) => files.some(file => /\.obj$/i.test(file.name) || isLibrary(file));

const librariesIn = (text: string) => [...text.matchAll(/^\s*mtllib\s+(.+?)\s*$/gm)].map(([, name]) =>
  name.split(/[\\/]/).pop()!);

/** The model of the first .obj of the files. Throws LayoutError. */
export async function readObject(files: File[]): Promise<Own> {
  const file = files.find(f => /\.obj$/i.test(f.name)), libraries = files.filter(isLibrary);
  if (!file)
    return refuse('a file .mtl is chosen together with its .obj', '.mtl は .obj と一緒に選んでください');
  const text = await file.text(), three = await part<typeof Three>('three');
  const triangles = trianglesOf(three, text, await Promise.all(libraries.map(f => f.text())));
  if (triangles.length > most)
    refuse(`${triangles.length} triangles; at most ${most} are drawn`,
      `三角形が ${triangles.length} 個あります。${most} 個までです`);
  const model = modelOf(triangles) ?? refuse('its faces have no size', '面に大きさがありません');
  const missing = librariesIn(text).filter(name => !libraries.some(f => f.name === name));
  return { name: file.name, triangles: triangles.length, model, missing };
}
