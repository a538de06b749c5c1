// SPDX-License-Identifier: MIT
// The targets of docs/determinism.md, and the hash that the copied program prints.
import type { Text } from '../../shell/text';

const both = (text: string): Text => ({ en: text, ja: text });
const native = both('AMD EPYC'), emulated = both('QEMU');
const node: Text = { en: 'Node 18.20 and 20.20', ja: 'Node 18.20 と 20.20' };
const [gcc, clang] = ['GCC 12.2', 'Clang 14.0.6'];

export interface Processor {
  target: Text;
  compilers: string;
  on: Text;
}
export const processors: Processor[] = [
  { target: both('x86-64'), compilers: `${gcc}, ${clang}`, on: native },
  { target: { en: 'x86-64, no vectors', ja: 'x86-64（ベクトル命令なし）' }, compilers: gcc, on: native },
  { target: both('x86-64, musl 1.2.3'), compilers: gcc, on: native },
  { target: { en: 'i386 with SSE2', ja: 'i386（SSE2 使用）' }, compilers: `${gcc}, ${clang}`, on: native },
  { target: both('AArch64'), compilers: `${gcc}, ${clang}`, on: emulated },
  { target: { en: 'ARMv7, hard float', ja: 'ARMv7（ハードウェア浮動小数点）' }, compilers: `${gcc}, ${clang}`, on: emulated },
  { target: both('RISC-V 64'), compilers: gcc, on: emulated },
  { target: { en: 'PowerPC 64, little-endian', ja: 'PowerPC 64（リトルエンディアン）' }, compilers: gcc, on: emulated },
  { target: { en: 's390x, big-endian', ja: 's390x（ビッグエンディアン）' }, compilers: gcc, on: emulated },
  { target: both('Windows x86-64'), compilers: 'MinGW-w64 GCC 12', on: both('Wine 8.0') },
  { target: both('WebAssembly'), compilers: clang, on: node },
  { target: both('WebAssembly simd128'), compilers: clang, on: node },
];

/** The hash of the initial state, and where the C program printed it. */
export const reference = {
  hash: 'bf301595 6287c68c 352013ff 2913ea92',
  on: {
    en: 'x86-64, and in QEMU on AArch64, ARMv7, RISC-V 64, PowerPC 64 and s390x (GCC 12.2)',
    ja: 'x86-64、および QEMU 上の AArch64、ARMv7、RISC-V 64、PowerPC 64、s390x（GCC 12.2）',
  },
};
