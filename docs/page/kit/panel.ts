// SPDX-License-Identifier: MIT
// Controls of the state by lil-gui.
import GUI, { type Controller } from 'lil-gui';
import type { Room } from '../shell/exhibit';
import { say, type Text } from '../shell/text';

type Keys<S, T> = { [K in keyof S]: S[K] extends T ? K : never }[keyof S] & string;

export interface Panel<S> {
  slider(name: Keys<S, number>, label: Text, least: number, most: number, step?: number): Controller;
  choice(name: Keys<S, string>, label: Text, words: Record<string, Text>): Controller;
  check(name: Keys<S, boolean>, label: Text): Controller;
  action(label: Text, run: () => void): Controller;
}

/** A panel beside the exhibit, open unless it is folded. Its controls follow the state. */
export function panel<S extends object>(room: Room<S>, title: Text, folded = false): Panel<S> {
  const gui = new GUI({ autoPlace: false, container: room.side, title: say(title) });
  const shadow = { ...room.state } as Record<string, unknown>;
  const follow = (name: string, controller: Controller) => {
    controller.onChange((value: unknown) => room.set({ [name]: value } as Partial<S>));
    return controller;
  };
  room.draw(() => {
    for (const controller of gui.controllersRecursive()) {
      const next = (room.state as Record<string, unknown>)[controller.property];
      if (controller.property in shadow && shadow[controller.property] !== next) {
        shadow[controller.property] = next;
        controller.updateDisplay();
      }
    }
  });
  gui.open(!folded);
  room.closed(() => gui.destroy());
  return {
    slider: (name, label, least, most, step) => follow(name, gui.add(shadow, name, least, most, step).name(say(label))),
    choice: (name, label, words) => follow(name, gui.add(shadow, name,
      Object.fromEntries(Object.entries(words).map(([word, text]) => [say(text), word]))).name(say(label))),
    check: (name, label) => follow(name, gui.add(shadow, name).name(say(label))),
    action: (label, run) => gui.add({ run }, 'run').name(say(label)),
  };
}
