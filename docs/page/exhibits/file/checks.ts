// SPDX-License-Identifier: MIT
// What is wrong with the keys of a channel: the findings of the command `nakawari check`, with its names and bounds.
import { NakawariError, quatAngle, quatDot, quatLength } from 'nakawari/all';
import type { Channel } from './channels';

export type Severity = 'error' | 'warning' | 'note';
export interface Finding {
  severity: Severity;
  what: string;
  key: number;
  time: number;
  amount: number;
}

type Add = (severity: Severity, what: string, key: number, amount: number) => void;

function checkTimes({ times }: Channel, add: Add) {
  for (let k = 1; k < times.length; k++) {
    const step = times[k] - times[k - 1];
    if (step < 0)
      add('error', 'unsorted-time', k, step);
    else if (step === 0)
      add('warning', 'duplicate-time', k, 0);
    else if (step <= 4 * 2 ** -23 * Math.abs(times[k]))
      add('warning', 'short-segment', k, step);
  }
}

function checkFinite({ times, values }: Channel, add: Add) {
  const floats = values.length / times.length;
  times.forEach((time, k) => {
    if (!Number.isFinite(time) || !values.subarray(floats * k, floats * (k + 1)).every(Number.isFinite))
      add('error', 'not-finite', k, NaN);
  });
}

function checkUnits(channel: Channel, add: Add) {
  const bound = channel.componentBytes === 1 ? 1 / 127 : 1e-3;
  const rounding = channel.componentBytes === 2 ? 1 / 32767 : 1e-5;
  let worst = 0, at = -1;
  for (let k = 0; k < channel.times.length; k++) {
    const length = quatLength(channel.value(k)), off = Math.abs(length - 1);
    if (off > bound)
      add(off > 1e-2 ? 'error' : 'warning', 'not-unit', k, length);
    else if (off > worst)
      [worst, at] = [off, k];
  }
  if (worst > rounding)
    add('note', 'rounded-unit', at, worst);
}

// Neighbouring keys as they are given: the angle in 0..360 degrees.
function checkArcs(channel: Channel, add: Add) {
  for (let k = 1; channel.mode !== 'STEP' && k < channel.times.length; k++) {
    const a = channel.value(k - 1), b = channel.value(k), dot = quatDot(a, b);
    if (!(dot < 1e-6))
      continue;
    const angle = 360 - quatAngle(a, b) * 180 / Math.PI;
    if (dot > -1e-6)
      add('note', 'half-turn', k, 180);
    else if (channel.mode === 'CUBICSPLINE')
      add('warning', 'long-way', k, angle);
    else
      add(angle > 269.9 ? 'note' : 'warning', angle > 269.9 ? 'sign-flip' : 'over-half-turn', k, angle);
  }
}

function checkScales(channel: Channel, add: Add) {
  for (let k = 0; k < channel.times.length; k++) {
    const least = Math.min(...channel.value(k));
    if (least <= 0)
      add(least < 0 ? 'warning' : 'note', 'non-positive-scale', k, least);
  }
}

/** What the library itself says of the track, and whether it moves anything. */
function checkTrack(channel: Channel, add: Add) {
  if (channel.unused)
    add('warning', 'unused', -1, 0);
  else if (channel.error instanceof NakawariError)
    add('error', 'refused', channel.error.index, channel.error.result);
  else if (channel.error)
    add('error', 'refused', -1, 0);
}

/** At most `most` findings of one kind; `total` counts them all. */
export function check(channel: Channel, most = 100): { findings: Finding[]; total: number } {
  const findings: Finding[] = [], counts = new Map<string, number>();
  let total = 0;
  const add: Add = (severity, what, key, amount) => {
    const count = (counts.get(what) ?? 0) + 1;
    counts.set(what, count);
    total++;
    if (count <= most)
      findings.push({ severity, what, key, time: channel.times[key] ?? NaN, amount });
  };
  checkTimes(channel, add);
  checkFinite(channel, add);
  if (!findings.some(f => f.severity === 'error')) {
    if (channel.property === 'quaternion') {
      checkUnits(channel, add);
      checkArcs(channel, add);
    }
    if (channel.property === 'scale')
      checkScales(channel, add);
  }
  if (!findings.some(f => f.severity === 'error'))
    checkTrack(channel, add);
  return { findings, total };
}
