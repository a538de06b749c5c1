// SPDX-License-Identifier: MIT
// The ticks of an axis: at least two, at multiples of 1, 2, 2.5 or 5 times a power of ten.
import { language } from '../shell/text';
import { clamp } from './values';

const slack = 1e-9;

function multiples(least: number, most: number, step: number): number[] {
  const from = Math.ceil(least / step - slack), to = Math.floor(most / step + slack);
  return Array.from({ length: Math.max(to - from + 1, 0) }, (_, i) => (from + i) * step);
}

/** The largest steps with `wanted` ticks in the range. */
export function ticks(least: number, most: number, wanted: number): number[] {
  for (let power = Math.ceil(Math.log10(most - least)); most > least; power--)
    for (const digit of [5, 2.5, 2, 1]) {
      const made = multiples(least, most, digit * 10 ** power);
      if (made.length >= wanted)
        return made;
    }
  return [least];
}

/** Powers of ten with their doubles and halves, or only the powers where there are many. */
export function logTicks(least: number, most: number, wanted: number): number[] {
  const powers = multiples(Math.floor(Math.log10(least)), Math.ceil(Math.log10(most)), 1);
  const made = (digits: number[]) => powers.flatMap(p => digits.map(d => d * 10 ** p))
    .filter(x => x >= least * (1 - slack) && x <= most * (1 + slack));
  const [all, few] = [made([1, 2, 5]), made([1])];
  return all.length < 2 ? ticks(least, most, 2) : few.length >= wanted ? few : all;
}

/** The texts of ticks in the language of the page, with as many decimals as tell them apart. */
export function tickTexts(list: number[]): string[] {
  const step = Math.min(...list.slice(1).map((x, i) => x - list[i])), size = Math.log10(step);
  const digits = Number.isFinite(size) ? clamp(1 - Math.floor(size), 0, 12) : 6;
  const format = new Intl.NumberFormat(language(), { maximumFractionDigits: digits });
  return list.map(x => format.format(x).replace(/^-(?=0$)/, '').replace('-', '−'));
}
