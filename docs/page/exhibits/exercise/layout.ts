// SPDX-License-Identifier: MIT
// Layouts in the formats of the command: scenes of keys in JSON, and tables of keys in CSV (docs/import.md).
import * as N from 'nakawari/all';
import type { Text } from '../../shell/text';
import { fromDegrees, limits, problem, type Key } from './model';

export class LayoutError extends Error {
  constructor(readonly text: Text) {
    super(text.en);
  }
}
export const refuse = (en: string, ja: string): never => { throw new LayoutError({ en, ja }); };

/* ---- writing ---- */

/** The shortest decimals that are read as the same float. */
const decimals = (x: number) => {
  for (let digits = 1; digits < 9; digits++)
    if (Math.fround(+x.toPrecision(digits)) === x)
      return String(+x.toPrecision(digits));
  return String(+x.toPrecision(9));
};
const list = (numbers: number[]) => `[${numbers.map(decimals).join(', ')}]`;

/** A scene of keys: `nakawari exercise FILE` reads it. */
export function write(name: string, keys: Key[]): string {
  const rows = keys.map(({ time, position, orientation }) =>
    `  {"time": ${decimals(time)}, "pos": ${list(position)}, "quat_xyzw": ${list(orientation)}}`);
  return `{"${name}": [\n${rows.join(',\n')}\n]}\n`;
}

/* ---- reading ---- */

export interface Layout { name: string; keys: Key[] }

const isNumbers = (value: unknown, count: number): value is number[] =>
  Array.isArray(value) && value.length === count && value.every(x => typeof x === 'number' && Number.isFinite(x));

/** The first that a key has of a quaternion, angles in radians, and a rotation matrix by rows. */
function orientationOf(key: Record<string, unknown>, place: string): number[] {
  const { quat_xyzw: q, euler_yxz_yaw_pitch_roll: e } = key;
  const m = Array.isArray(key.ori_rows) ? (key.ori_rows as unknown[]).flat() : undefined;
  if (isNumbers(q, 4))
    return q.map(Math.fround);
  if (isNumbers(e, 3))
    return N.quatFromEuler([0, 0, 0, 0], [e[1], e[0], e[2]], N.EULER_YXZ);
  if (isNumbers(m, 9))
    return N.quatFromMat3([0, 0, 0, 0], [0, 3, 6, 1, 4, 7, 2, 5, 8].map(i => m[i]));
  return refuse(`${place}: no orientation`, `${place}: 向きがありません`);
}

function keyOf(value: unknown, place: string): Key {
  const key = (value ?? {}) as Record<string, unknown>;
  if (!isNumbers([key.time], 1) || !isNumbers(key.pos, 3))
    return refuse(`${place}: no time or position`, `${place}: 時刻か位置がありません`);
  return {
    time: Math.fround(key.time as number), position: key.pos.map(Math.fround), orientation: orientationOf(key, place),
  };
}

function readScenes(text: string): Layout[] {
  let members: unknown;
  try {
    members = JSON.parse(text);
  } catch {
    refuse('not JSON', 'JSON として読めません');
  }
  if (typeof members !== 'object' || members === null || !Object.values(members).every(Array.isArray))
    return refuse('not a scene of keys', 'キーのシーンではありません');
  return Object.entries(members as Record<string, unknown[]>).map(([name, keys]) =>
    ({ name, keys: keys.map((key, i) => keyOf(key, `/${name}/${i}`)) }));
}

const cells = (line: string) => line.split(',').map(cell => cell.trim().replace(/^"(.*)"$/, '$1'));

/** The keys of the first node of the first clip. */
function readTable(text: string): Layout[] {
  const [header, ...rows] = text.split(/\r?\n/).filter(line => line.trim() && !line.startsWith('#')).map(cells);
  const column = (row: string[], name: string) => row[header.indexOf(name)] ?? '';
  const numbersOf = (row: string[], names: string[]) => names.map(name => +(column(row, name) || NaN));
  const same = (row: string[]) => ['name', 'clip'].every(name => column(row, name) === column(rows[0], name));
  const keys = rows.filter(same).map((row, i) => {
    const [pos, angles] = [numbersOf(row, ['tx', 'ty', 'tz']), numbersOf(row, ['yaw', 'pitch', 'roll'])];
    const turn = isNumbers(angles, 3) && fromDegrees(angles as [number, number, number]).orientation;
    const quat = turn || numbersOf(row, ['qx', 'qy', 'qz', 'qw']);
    return keyOf({ time: numbersOf(row, ['time'])[0], pos, quat_xyzw: quat }, `row ${i}`);
  });
  return [{ name: column(rows[0], 'clip') || column(rows[0], 'name'), keys }];
}

function check({ name, keys }: Layout) {
  if (keys.length < 1 || keys.length > limits.keys)
    refuse(`${name}: ${keys.length} keys; 1 to ${limits.keys} are possible`,
      `${name}: キーが ${keys.length} 個あります。1 個から ${limits.keys} 個までです`);
  if (keys[keys.length - 1].time - keys[0].time > limits.seconds)
    refuse(`${name}: longer than ${limits.seconds} s`, `${name}: ${limits.seconds} 秒を超えています`);
  const error = problem(keys);
  if (error)
    refuse(`${name}, key ${error.index}: ${error.message}`, `${name} のキー ${error.index}: ${error.message}`);
}

/** The layouts in a file, at least one. Throws LayoutError. */
export function read(text: string): Layout[] {
  const layouts = /^\s*\{/.test(text) ? readScenes(text) : /\bname\b.*\btime\b|\btime\b.*\bname\b/.test(text)
    ? readTable(text) : refuse('neither a scene of keys nor a table of keys nor a model',
      'キーのシーン、キーの表、モデルのいずれでもありません');
  if (!layouts.length)
    refuse('no keys', 'キーがありません');
  layouts.forEach(check);
  return layouts;
}
