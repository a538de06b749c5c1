// SPDX-License-Identifier: MIT
// The texts that the exercise's program draws into its picture (DisplayCallback, DrawTextInformation).
import { colour } from '../../kit/colours';
import { say } from '../../shell/text';
import { operationOf, type State } from './model';
import { operationWords, programWords } from './words';

/** The operation of clicks, if they have one. */
export const operationTexts = (state: State) => state.clicks ? [say(operationWords[operationOf(state)])] : [];

/** Its lines, in its words. The operation is also below the methods, which the program shows in its place. */
export function textsOf(state: State, playing: boolean): string[] {
  const { position, orientation, view, time } = state, operation = playing ? [] : operationTexts(state);
  const methods = `Position: ${programWords.position[position]}, Orientation: ${programWords.orientation[orientation]}`;
  return [
    playing ? 'Animation Mode' : 'Layout Mode',
    ...(view === 'plain' && operation.length ? [] : [methods]),
    ...operation,
    ...(playing && view !== 'frames' ? [`Time: ${time.toFixed(2)}`] : []),
  ];
}

/** From (16, 40) on, every 24 pixels, as in the program; smaller where the longest line does not fit. */
export function drawTexts(c: CanvasRenderingContext2D, width: number, lines: string[]) {
  const font = (size: number) => `${size}px Helvetica, Arial, "Noto Sans CJK JP", sans-serif`;
  c.font = font(18);
  const share = Math.min(1, (width - 32) / Math.max(...lines.map(line => c.measureText(line).width)));
  c.font = font(18 * share);
  c.textAlign = 'left';
  c.fillStyle = 'rgb(255 0 0)';
  c.lineJoin = 'round';
  c.lineWidth = 3;
  c.strokeStyle = colour('paper');
  lines.forEach((line, i) => {
    c.strokeText(line, 16, 16 + (24 + 24 * i) * share);
    c.fillText(line, 16, 16 + (24 + 24 * i) * share);
  });
}
