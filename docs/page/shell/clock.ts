// SPDX-License-Identifier: MIT
// The play bar: start, stop, the time, the rate. The time is the field `time` of the state.
import { wrap } from 'nakawari/all';
import { element, button } from '../kit/html';
import { say } from './text';

export interface Clock {
  readonly playing: boolean;
  rate: number;
  play(): void;
  stop(): void;
  toggle(): void;
  /** Plays from the start. */
  restart(): void;
  /** The time after `seconds` of play. @internal */
  next(time: number, seconds: number): number;
  /** @internal */
  show(time: number): void;
}

const words = {
  play: { en: 'Play', ja: '再生' },
  stop: { en: 'Stop', ja: '停止' },
  time: { en: 'time, seconds', ja: '時刻（秒）' },
  rate: { en: 'speed', ja: '速さ' },
};

export function makeClock(range: () => { start: number; end: number }, set: (time: number) => void,
  changed: () => void): { clock: Clock; bar: HTMLElement } {
  const slider = element('input', { type: 'range', step: 'any', 'aria-label': say(words.time), class: 'time' });
  const shown = element('output', { class: 'seconds' });
  const rates = element('select', { 'aria-label': say(words.rate) },
    [0.1, 0.25, 0.5, 1, 2].map(r => element('option', { value: String(r) }, `×${r}`)));
  rates.value = '1';
  const toggle = button(say(words.play), () => clock.toggle(), 'play');
  let playing = false;
  const face = () => {
    toggle.setAttribute('aria-label', say(playing ? words.stop : words.play));
    toggle.textContent = playing ? '❚❚' : '▶';
  };
  const turn = (on: boolean) => {
    playing = on;
    face();
    changed();
  };
  const clock: Clock = {
    get playing() { return playing; },
    rate: 1,
    play: () => turn(true),
    stop: () => turn(false),
    toggle: () => turn(!playing),
    restart() {
      set(range().start);
      turn(true);
    },
    next(time, seconds) {
      const { start, end } = range();
      return end > start ? start + wrap(time - start + seconds * clock.rate, end - start) : start;
    },
    show(time) {
      const { start, end } = range();
      Object.assign(slider, { min: String(start), max: String(end), value: String(time) });
      shown.textContent = `${time.toFixed(2)} s`;
      slider.setAttribute('aria-valuetext', shown.textContent);
    },
  };
  slider.addEventListener('input', () => set(Number(slider.value)));
  rates.addEventListener('change', () => { clock.rate = Number(rates.value); });
  face();
  return { clock, bar: element('div', { class: 'bar' }, [toggle, slider, shown, rates]) };
}
