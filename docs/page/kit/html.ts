// SPDX-License-Identifier: MIT
// Elements of the page.
type Content = string | Node | (string | Node)[];

/** An element with attributes and children. Strings are texts, not HTML. */
export function element<K extends keyof HTMLElementTagNameMap>(name: K, attributes: Record<string, string> = {},
  content: Content = []): HTMLElementTagNameMap[K] {
  const made = document.createElement(name);
  for (const [key, value] of Object.entries(attributes))
    made.setAttribute(key, value);
  made.append(...(Array.isArray(content) ? content : [content]));
  return made;
}

/** An element whose content is HTML of this page's sources. */
export function html<K extends keyof HTMLElementTagNameMap>(name: K, text: string,
  attributes: Record<string, string> = {}) {
  const made = element(name, attributes);
  made.innerHTML = text;
  return made;
}

export function button(label: string, run: () => void, kind = '') {
  const made = element('button', { type: 'button', class: kind }, label);
  made.addEventListener('click', run);
  return made;
}
