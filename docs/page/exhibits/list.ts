// SPDX-License-Identifier: MIT
// The exhibits, in the order of the list on the page.
import type { Exhibit } from '../shell/exhibit';
import { crowd } from './crowd';
import { exercise } from './exercise';
import { file } from './file';
import { rotations } from './rotations';

export const exhibits = [
  exercise,
  rotations,
  crowd,
  file,
] as unknown as Exhibit<never>[];
