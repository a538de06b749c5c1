// SPDX-License-Identifier: MIT
// The two languages. A text is resolved when it is shown; a change of the language shows the exhibit anew.
export interface Text {
  en: string;
  ja: string;
}
export type Language = keyof Text;
export const languages: Language[] = ['en', 'ja'];

let now: Language = navigator.language.startsWith('ja') ? 'ja' : 'en';
export const language = () => now;

export function setLanguage(next: Language) {
  now = next;
  document.documentElement.lang = next;
}

/** The text in the present language. */
export const say = (text: Text | string) => typeof text === 'string' ? text : text[now];
