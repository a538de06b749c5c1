// SPDX-License-Identifier: MIT
// The frame of the page: title, list of exhibits, languages, colours, and the room of the exhibit in the address.
import 'uplot/dist/uPlot.min.css';
import { ready } from 'nakawari/all';
import { exhibits } from '../exhibits/list';
import { button, element, html } from '../kit/html';
import { showCode } from './copy';
import type { Entry } from './exhibit';
import { openRoom, type OpenRoom } from './room';
import { address } from './state';
import { language, languages, say, setLanguage, type Language } from './text';
import '../style.css';

const words = {
  list: { en: 'Exhibits', ja: '展示' },
  dark: { en: 'Dark', ja: 'ダーク' },
  code: { en: 'Copy as C', ja: 'C のコードにする' },
  licences: { en: 'Licences', ja: 'ライセンス' },
  skip: { en: 'To the exhibit', ja: '展示へ移動' },
  broken: { en: 'This exhibit does not open: ', ja: 'この展示を開けません：' },
};
const names: Record<Language, string> = { en: 'English', ja: '日本語' };

let open: OpenRoom | undefined;
let visits = 0;

function link({ id, title }: Entry, i: number) {
  const a = element('a', { href: `#${id}`, 'data-exhibit': id }, `${i + 1} ${say(title)}`);
  a.addEventListener('click', () => open?.keep());
  return element('li', {}, a);
}

function turnLanguage(next: Language) {
  setLanguage(next);
  open?.keep();
  frame();
  void visit();
}

const media = matchMedia('(prefers-color-scheme: dark)');
const root = document.documentElement;
const isDark = () => (root.dataset.theme ?? (media.matches ? 'dark' : 'light')) === 'dark';

function colourSwitch() {
  const made = button(say(words.dark), () => {
    root.dataset.theme = isDark() ? 'light' : 'dark';
    dispatchEvent(new Event('colours'));
  });
  made.dataset.dark = '';
  return made;
}
function showColours() {
  document.querySelector('[data-dark]')!.setAttribute('aria-pressed', String(isDark()));
}
addEventListener('colours', showColours);
media.addEventListener('change', () => dispatchEvent(new Event('colours')));

function languageSwitch(name: Language) {
  const made = button(names[name], () => turnLanguage(name));
  made.lang = name;
  made.setAttribute('aria-pressed', String(name === language()));
  return made;
}

const wide = () => matchMedia('(min-width: 60rem)').matches;

function skipLink() {
  const made = element('a', { href: '#stage', class: 'skip' }, say(words.skip));
  made.addEventListener('click', event => {
    event.preventDefault(); // the address keeps the state
    document.getElementById('stage')?.focus();
  });
  return made;
}

/** All but the exhibit. It is made again when the language changes. */
function frame() {
  const list = element('details', {}, [element('summary', {}, say(words.list)), element('ol', {}, exhibits.map(link))]);
  list.open = wide();
  document.body.replaceChildren(
    skipLink(),
    element('header', {}, [element('a', { href: `#${exhibits[0].id}`, class: 'name' }, 'nakawari 中割り'),
      element('div', { class: 'choices' }, [...languages.map(languageSwitch), colourSwitch()])]),
    element('nav', { 'aria-label': say(words.list) }, list), element('main'),
    element('footer', {}, element('a', { href: 'licences.txt' }, say(words.licences))));
  showColours();
}

function mark(shown: Entry) {
  for (const a of document.querySelectorAll<HTMLElement>('nav a'))
    if (a.dataset.exhibit === shown.id)
      a.setAttribute('aria-current', 'page');
    else
      a.removeAttribute('aria-current');
  document.title = `${say(shown.title)} - nakawari`;
}

/** Shows the exhibit of the address. */
async function visit() {
  const { id, query } = address(), entry = exhibits.find(e => e.id === id) ?? exhibits[0], mine = ++visits;
  open?.close();
  open = undefined;
  mark(entry);
  const heading = element('h1', { tabindex: '-1' }, say(entry.title)), bar = element('div', { class: 'tools' });
  const main = element('main', { id: 'exhibit', 'data-exhibit': entry.id },
    element('div', { class: 'title' }, [heading, bar]));
  document.querySelector('main')!.replaceWith(main);
  try {
    const [exhibit] = await Promise.all([entry.open(), ready]);
    if (mine !== visits)
      return;
    main.append(html('p', say(exhibit.lead), { class: 'lead' }));
    const room = open = openRoom(entry, exhibit, main, query);
    if (exhibit.code)
      bar.append(button(say(words.code), () => showCode(room.code()), 'code'));
  } catch (error) {
    main.append(element('p', { role: 'alert' }, say(words.broken) + String(error)));
  }
}

/** Takes the language of the address; returns whether it is another one. */
function followLanguage() {
  const next = languages.find(name => name === address().query.get('lang')), other = !!next && next !== language();
  if (other)
    setLanguage(next);
  return other;
}

/** The exhibit of a new address; the focus goes to its title. */
function navigate() {
  if (followLanguage())
    frame();
  void visit();
  document.querySelector<HTMLDetailsElement>('nav details')!.open = wide();
  document.querySelector('h1')!.focus();
}

setLanguage(navigator.language.startsWith('ja') ? 'ja' : 'en');
followLanguage();
frame();
addEventListener('hashchange', navigate);
visit().then(() => requestAnimationFrame(() => // after the first picture, the second script
  (globalThis.requestIdleCallback ?? setTimeout)(() => exhibits.forEach(e => e.open().catch(() => {})))));
