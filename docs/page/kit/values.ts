// SPDX-License-Identifier: MIT
// Arrays and ranges.
export const zeros = (count: number): number[] => Array<number>(count).fill(0);

export const clamp = (x: number, least: number, most: number) => Math.min(Math.max(x, least), most);
