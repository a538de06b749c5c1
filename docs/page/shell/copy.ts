// SPDX-License-Identifier: MIT
// The dialog that shows the state as a C program and copies it.
import { button, element } from '../kit/html';
import { say } from './text';

const words = {
  title: { en: 'This state as a C program', ja: 'この状態を再現する C プログラム' },
  copy: { en: 'Copy', ja: 'コピー' },
  copied: { en: 'Copied', ja: 'コピーしました' },
  failed: { en: 'Select the text and copy it', ja: 'テキストを選択してコピーしてください' },
  close: { en: 'Close', ja: '閉じる' },
};

export function showCode(text: string) {
  const code = element('pre', { tabindex: '0', class: 'program', 'aria-label': say(words.title) }, text);
  const done = element('p', { role: 'status' });
  const copy = button(say(words.copy), () => navigator.clipboard.writeText(text)
    .then(() => { done.textContent = say(words.copied); }, () => {
      getSelection()?.selectAllChildren(code);
      done.textContent = say(words.failed);
    }));
  const dialog = element('dialog', { 'aria-label': say(words.title) },
    [element('h2', {}, say(words.title)), code, done, element('div', { class: 'tools' },
      [copy, button(say(words.close), () => dialog.close())])]);
  dialog.addEventListener('close', () => dialog.remove());
  document.body.append(dialog);
  dialog.showModal();
  copy.focus();
}
