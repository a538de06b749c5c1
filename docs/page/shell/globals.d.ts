// SPDX-License-Identifier: MIT
/** A formula of TeX. The build turns it into MathML (build.mjs). */
declare function tex(source: TemplateStringsArray): string;
declare module '*.css';
