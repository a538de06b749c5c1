// SPDX-License-Identifier: MIT
// The colours of style.css, for canvases.

/** The value of a CSS variable: ink, paper, soft, line, c0 to c7, x, y, z. */
export const colour = (name: string) =>
  getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();
