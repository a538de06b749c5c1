// SPDX-License-Identifier: MIT
/** A formula of TeX. The build turns it into MathML (build.mjs). */
declare function tex(source: TemplateStringsArray): string;
declare module '*.css';
declare module '*.glb' {
  const bytes: Uint8Array<ArrayBuffer>;
  export default bytes;
}
