// SPDX-License-Identifier: MIT
// The two languages. A text is resolved when it is shown; a change of the language shows the exhibit anew.
export interface Text {
  en: string;
  ja: string;
}
export type Language = keyof Text;
export const languages: Language[] = ['en', 'ja'];

/** The language of the document: both scripts of the page read it. */
export const language = () => document.documentElement.lang as Language;

export function setLanguage(next: Language) {
  document.documentElement.lang = next;
}

/** The text in the present language. */
export const say = (text: Text | string) => typeof text === 'string' ? text : text[language()];
