// SPDX-License-Identifier: MIT
// One of several curves is chosen: it is drawn thick, and it is not hidden when it is chosen.
import type uPlot from 'uplot';
import type { Room } from '../shell/exhibit';

/** Draws the chosen series of a plot thick, before the plot is drawn for the state. */
export function thick<S>(room: Room<S>, made: uPlot, width: number, chosen: () => number) {
  let last = -1;
  room.draw(() => {
    const next = chosen();
    if (next === last)
      return;
    made.series.slice(1).forEach((series, i) => { series.width = i === next ? 2 * width : width; });
    made.redraw();
    last = next;
  });
}

/** The state with the method chosen. */
export const choosing = <M extends string>(method: M, { hidden }: { hidden: string[] }) =>
  ({ method, hidden: hidden.filter(name => name !== method) });
