// SPDX-License-Identifier: MIT
// The room of one exhibit: its state, its frames, its keys.
import { element } from '../kit/html';
import { makeClock } from './clock';
import type { Entry, Exhibit, Room, Shortcut } from './exhibit';
import { forget, read, show, showLater, write } from './state';
import { language, say, type Text } from './text';

export interface OpenRoom {
  close(): void;
  /** Writes the state into the address at once. */
  keep(): void;
  code(): string;
}

/** The milliseconds of work of the last frames, for tests. */
export const work: number[] = [];
Object.assign(globalThis, { nakawariWork: work });

const help = { en: 'Keys', ja: 'キー操作' };
const beside = { en: 'Controls and numbers', ja: '操作と数値' };

/** Whether a key is that of the element with the focus: all keys in fields of text, those that operate a control. */
function isOwn(key: string, target: EventTarget | null) {
  if (!(target instanceof HTMLElement))
    return false;
  if (target instanceof HTMLInputElement && target.type === 'range')
    return /^(Arrow|Page|Home|End)/.test(key);
  if (target instanceof HTMLInputElement && !/^(checkbox|radio|button|color|file)$/.test(target.type))
    return true;
  if (target instanceof HTMLSelectElement)
    return /^( |Enter|Arrow|Page|Home|End)/.test(key);
  return target.isContentEditable || target instanceof HTMLTextAreaElement ||
    (key === ' ' && /^(BUTTON|SUMMARY|INPUT|A)$/.test(target.tagName));
}

/** The letter of a key, also while an input method composes, or with capital letters. */
const letterOf = ({ key, code }: KeyboardEvent) =>
  key.length === 1 ? key.toLowerCase() : key === 'Process' && code.startsWith('Key') ? code.slice(3).toLowerCase() : key;

function keyTable(list: Shortcut[]) {
  const name = (key: string) => key === ' ' ? 'space' : key;
  return element('details', { class: 'keys' }, [element('summary', {}, say(help)),
    element('dl', {}, list.flatMap(s => [element('dt', {}, element('kbd', {}, name(s.key))),
      element('dd', {}, say(s.does))]))]);
}

/** Calls the function of a key. */
const onKey = (keys: Shortcut[]) => (event: KeyboardEvent) => {
  const plain = !event.ctrlKey && !event.metaKey && !event.altKey && !isOwn(event.key, event.target);
  const found = plain && keys.find(s => s.key === letterOf(event));
  if (found) {
    event.preventDefault();
    found.run();
  }
};

/** Listens to keys, colours and the size of the stage; the function that is returned ends this. */
function listen(stage: HTMLElement, pressed: (event: KeyboardEvent) => void, ask: () => void) {
  const sizes = new ResizeObserver(ask);
  sizes.observe(stage);
  addEventListener('keydown', pressed);
  addEventListener('colours', ask);
  return () => {
    sizes.disconnect();
    removeEventListener('keydown', pressed);
    removeEventListener('colours', ask);
  };
}

/** Calls `step` with the seconds since the last frame: in the next frame after `ask`, and in each one while it runs. */
function makeFrames(step: (seconds: number) => void, runs: () => boolean) {
  let asked = 0, last = 0;
  const frame = (now: number) => {
    const seconds = Math.min(Math.max((now - last) / 1000, 0), 0.1), from = performance.now();
    asked = 0;
    last = now;
    step(seconds);
    work.push(performance.now() - from);
    if (work.length > 600)
      work.splice(0, 300);
    if (runs())
      ask();
  };
  const ask = () => {
    if (asked)
      return;
    asked = requestAnimationFrame(frame);
    if (!runs())
      last = performance.now();
  };
  return { ask, cancel: () => cancelAnimationFrame(asked) };
}

export function openRoom<S extends object>({ id, title }: Entry, exhibit: Exhibit<S>, main: HTMLElement,
  query: URLSearchParams): OpenRoom {
  let state = read(exhibit.fields, query);
  const draws: ((seconds: number) => void)[] = [];
  const endings: (() => void)[] = [], keys: Shortcut[] = [];
  const stage = element('section', { id: 'stage', tabindex: '-1', 'aria-label': say(title) });
  const side = element('section', { class: 'side', tabindex: '0', 'aria-label': say(beside) });
  const live = element('p', { class: 'live', role: 'status' });
  const timed = exhibit.range && 'time' in state;

  const toQuery = () => {
    const made = new URLSearchParams({ lang: language() });
    write(exhibit.fields, state, made);
    return made;
  };
  const { ask, cancel } = makeFrames(seconds => {
    if (timed && clock.playing)
      state = { ...state, time: clock.next((state as { time: number }).time, seconds) };
    if (timed)
      clock.show((state as { time: number }).time);
    draws.forEach(f => f(seconds));
    main.dataset.drawn = '';
  }, () => clock.playing);
  const set = (change: Partial<S>) => {
    state = { ...state, ...change };
    showLater(id, toQuery);
    ask();
  };
  const { clock, bar } = makeClock(() => exhibit.range!(state), time => set({ time } as unknown as Partial<S>), () => {
    if (timed)
      set({});
  });
  const room: Room<S> = {
    get state() { return state; },
    set, stage, side, clock,
    refresh: ask,
    draw: f => { draws.push(f); },
    shortcuts: list => { keys.push(...list); },
    closed: f => { endings.push(f); },
    announce: (text: Text) => { live.textContent = say(text); },
  };

  main.append(stage, side, live);
  const unlisten = listen(stage, onKey(keys), ask);
  exhibit.mount(room);
  if (timed) {
    stage.append(bar);
    if (!keys.some(s => s.key === ' '))
      keys.unshift({ key: ' ', does: { en: 'plays and stops', ja: '再生と停止' }, run: clock.toggle });
  }
  if (keys.length)
    side.append(keyTable(keys));
  ask();
  return {
    close() {
      forget();
      cancel();
      unlisten();
      endings.forEach(f => f());
    },
    keep: () => show(id, toQuery()),
    code: () => exhibit.code!(state),
  };
}
