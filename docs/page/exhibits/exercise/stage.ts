// SPDX-License-Identifier: MIT
// The canvas of the exhibit.
import { makeCanvas } from '../../kit/canvas';
import { viewOf } from '../../kit/eye';
import { element } from '../../kit/html';
import type { Room } from '../../shell/exhibit';
import { drawGizmo, drawScene } from './draw';
import { gizmoOf, grips, kinds, type Handle } from './gizmo';
import { canvasKeys } from './keyboard';
import { keysOf, type State } from './model';
import { pointers, type Stage } from './pointers';
import { drawTexts, operationTexts, textsOf } from './texts';
import { labels } from './words';

function stageOf(room: Room<State>, canvas: HTMLCanvasElement, show: Stage['show']): Stage {
  const view = () => viewOf(room.state, canvas.clientWidth, canvas.clientHeight);
  const gizmo = () => {
    const key = keysOf(room.state)[room.state.selected], eye = view();
    const length = Math.min(90, 0.2 * Math.min(eye.width, eye.height));
    const { clicks, turns, local } = room.state, shown = !clicks ? kinds.all : turns ? kinds.turns : kinds.moves;
    return key && !room.clock.playing ? gizmoOf(key, eye, local, shown, length) : undefined;
  };
  return { room, canvas, view, gizmo, show };
}

export function stage(room: Room<State>) {
  const { canvas, c, clear } = makeCanvas(room.stage, labels.canvas);
  const said = element('p', { role: 'status', class: 'unseen' });
  room.stage.append(said);
  let active: Handle | undefined;
  const made = stageOf(room, canvas, handle => {
    if (handle?.kind === active?.kind && handle?.axis === active?.axis)
      return;
    active = handle;
    canvas.dataset.handle = handle ? `${handle.kind} ${handle.axis}` : '';
    canvas.style.cursor = handle ? 'grab' : '';
    room.refresh();
  });
  room.draw(() => {
    clear();
    const eye = made.view(), handles = made.gizmo();
    drawScene(c, eye, room.state, room.clock.playing);
    if (handles)
      drawGizmo(c, eye, handles, active);
    drawTexts(c, canvas.clientWidth, textsOf(room.state, room.clock.playing));
    const [operation = ''] = operationTexts(room.state);
    if (said.textContent !== operation)
      said.textContent = operation;
    // For tests: the pixels of the keys, and those where each handle is drawn.
    canvas.dataset.keys = JSON.stringify(keysOf(room.state).map(key => eye.project(key.position)));
    canvas.dataset.grips = JSON.stringify(handles ? grips(handles, eye) : {});
  });
  pointers(made);
  canvasKeys(room, canvas);
}
