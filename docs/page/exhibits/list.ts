// SPDX-License-Identifier: MIT
// The exhibits, in the order of the list on the page.
import type { Exhibit } from '../shell/exhibit';
import { bits } from './bits';
import { blend } from './blend';
import { crowd } from './crowd';
import { exercise } from './exercise';
import { file } from './file';
import { jointChain } from './joints';
import { keys } from './keys';
import { loop } from './loop';
import { pole } from './pole';
import { rotations } from './rotations';
import { splines } from './splines';
import { time } from './time';
import { twist } from './twist';

export const exhibits = [
  exercise,
  keys,
  time,
  rotations,
  splines,
  pole,
  jointChain,
  twist,
  blend,
  loop,
  crowd,
  bits,
  file,
] as unknown as Exhibit<never>[];
