// SPDX-License-Identifier: MIT
// docs/reference.md as one HTML page for printing: two sheets of A4, two columns, letters of 7 points.
//
//     node reference.mjs > reference.html
import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';

const style = `
@page { size: A4; margin: 9mm 8mm; }
body { font: 7pt/1.12 sans-serif; columns: 2; column-gap: 5mm; margin: 0; color: #000; background: #fff; }
h1 { font-size: 11pt; margin: 0; } p { margin: 1mm 0; }
h2 { font-size: 7.5pt; margin: 1.2mm 0 0.2mm; break-after: avoid; border-bottom: 0.2mm solid #888; }
div { padding-left: 3mm; text-indent: -3mm; break-inside: avoid; } .variables { color: #555; }
code { font: 7pt "Liberation Mono", monospace; letter-spacing: -0.25pt; }`;

const escape = text => text.replace(/[&<>]/g, c => ({ '&': '&amp;', '<': '&lt;', '>': '&gt;' })[c]);
const inline = text => escape(text).replace(/\[([^\]]*)\]\([^)]*\)/g, '$1').replace(/`([^`]*)`/g, '<code>$1</code>');

/** A line of a block: the statement, and what it does. */
function line(text) {
  const [code, words = ''] = text.split(' // ');
  const kind = text.includes('nkw_') && text.includes('(') ? '' : ' class="variables"';
  return `<div${kind}><code>${escape(code)}</code> ${escape(words)}</div>`;
}

/** The page. */
export function html(markdown) {
  const body = markdown.split(/\n```(?:c\n)?/).map((part, i) => i % 2 ? part.trim().split('\n').map(line).join('\n')
    : part.trim().split(/\n\n+/).filter(Boolean).map(p => /^\[`\w+\.h`\]\([^)]*\)$/.test(p) ? ''
      : p.startsWith('## ') ? `<h2>${inline(p.slice(3))}</h2>`
        : p.startsWith('# ') ? `<h1>${inline(p.slice(2))}</h1>` : `<p>${inline(p)}</p>`).join('\n')).join('\n');
  return `<!doctype html>\n<html lang="en"><meta charset="utf-8"><title>nakawari: core on two pages</title>
<style>${style}</style>\n<body>\n${body}\n</body></html>\n`;
}

export const reference = fileURLToPath(new URL('../reference.md', import.meta.url));
if (process.argv[1] === fileURLToPath(import.meta.url))
  process.stdout.write(html(readFileSync(reference, 'utf8')));
