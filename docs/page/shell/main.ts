// SPDX-License-Identifier: MIT
// The frame of the page: title, list of exhibits, languages, colours, and the room of the exhibit in the address.
import { ready } from 'nakawari/all';
import { exhibits } from '../exhibits/list';
import { button, element, html } from '../kit/html';
import { showCode } from './copy';
import type { Exhibit } from './exhibit';
import { openRoom, type OpenRoom } from './room';
import { address } from './state';
import { language, languages, say, setLanguage, type Language } from './text';
import '../style.css';

const words = {
  list: { en: 'Exhibits', ja: '展示' },
  dark: { en: 'Dark or light', ja: '明暗の切り替え' },
  code: { en: 'Copy as C', ja: 'C のコードにする' },
  licences: { en: 'Licences', ja: 'ライセンス' },
  skip: { en: 'To the exhibit', ja: '展示へ移動' },
  broken: { en: 'This browser cannot run the library: ', ja: 'このブラウザではライブラリを実行できません: ' },
};
const names: Record<Language, string> = { en: 'English', ja: '日本語' };

let open: OpenRoom | undefined;
let shown: Exhibit<never> | undefined;

function link(exhibit: Exhibit<never>, number: number) {
  const a = element('a', { href: `#${exhibit.id}`, 'data-exhibit': exhibit.id }, `${number} ${say(exhibit.title)}`);
  if (exhibit === shown)
    a.setAttribute('aria-current', 'page');
  return element('li', {}, a);
}

function turnLanguage(next: Language) {
  setLanguage(next);
  open?.keep();
  build();
}

const media = matchMedia('(prefers-color-scheme: dark)');
function turnColours() {
  const root = document.documentElement, now = root.dataset.theme ?? (media.matches ? 'dark' : 'light');
  root.dataset.theme = now === 'dark' ? 'light' : 'dark';
  dispatchEvent(new Event('colours'));
}
media.addEventListener('change', () => dispatchEvent(new Event('colours')));

function header() {
  const choices = languages.map(name => {
    const made = button(names[name], () => turnLanguage(name));
    made.lang = name;
    made.setAttribute('aria-pressed', String(name === language()));
    return made;
  });
  const list = element('details', {}, [element('summary', {}, say(words.list)),
    element('ol', {}, exhibits.map((exhibit, i) => link(exhibit, i + 1)))]);
  list.open = matchMedia('(min-width: 60rem)').matches;
  return [
    element('a', { href: '#stage', class: 'skip' }, say(words.skip)),
    element('header', {}, [element('a', { href: `#${exhibits[0].id}`, class: 'name' }, 'nakawari 中割り'),
      element('div', { class: 'choices' }, [...choices, button(say(words.dark), turnColours)])]),
    element('nav', { 'aria-label': say(words.list) }, list),
  ];
}

function build() {
  const { id, query } = address();
  if (query.get('lang') && languages.includes(query.get('lang') as Language))
    setLanguage(query.get('lang') as Language);
  shown = exhibits.find(exhibit => exhibit.id === id) ?? exhibits[0];
  open?.close();
  document.title = `${say(shown.title)} - nakawari`;
  const main = element('main', { id: 'exhibit', 'data-exhibit': shown.id });
  const footer = element('footer', {}, element('a', { href: 'licences.txt' }, say(words.licences)));
  document.body.replaceChildren(...header(), main, footer);
  open = openRoom(shown, main, query);
  const bar = element('div', { class: 'tools' });
  const room = open;
  if (shown.code)
    bar.append(button(say(words.code), () => showCode(room.code()), 'code'));
  main.prepend(element('div', { class: 'title' }, [element('h1', {}, say(shown.title)), bar]),
    html('p', say(shown.lead), { class: 'lead' }));
}

addEventListener('hashchange', () => {
  if (location.hash === '#stage')
    document.getElementById('stage')?.focus();
  else
    build();
});

setLanguage(language());
ready.then(build, error => document.body.replaceChildren(element('p', {}, say(words.broken) + String(error))));
