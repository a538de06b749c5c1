// SPDX-License-Identifier: MIT
// The targets of docs/determinism.md, and the hash that the copied program prints.

/** Target, compiler, what it runs on. */
export const processors = [
  ['x86-64', 'GCC 12.2', 'AMD EPYC'],
  ['x86-64', 'Clang 14.0.6', 'AMD EPYC'],
  ['x86-64, no vectors', 'GCC 12.2', 'AMD EPYC'],
  ['x86-64, musl 1.2.3', 'GCC 12.2', 'AMD EPYC'],
  ['i386 with SSE2', 'GCC 12.2', 'AMD EPYC'],
  ['i386 with SSE2', 'Clang 14.0.6', 'AMD EPYC'],
  ['AArch64', 'GCC 12.2', 'QEMU'],
  ['AArch64', 'Clang 14.0.6', 'QEMU'],
  ['ARMv7, hard float', 'GCC 12.2', 'QEMU'],
  ['ARMv7, hard float', 'Clang 14.0.6', 'QEMU'],
  ['RISC-V 64', 'GCC 12.2', 'QEMU'],
  ['PowerPC 64, little-endian', 'GCC 12.2', 'QEMU'],
  ['s390x, big-endian', 'GCC 12.2', 'QEMU'],
  ['Windows x86-64', 'MinGW-w64 GCC 12', 'Wine 8.0'],
  ['WebAssembly', 'Clang 14.0.6', 'Node 18.20 and 20.20'],
  ['WebAssembly simd128', 'Clang 14.0.6', 'Node 18.20 and 20.20'],
];

/** The hash of the initial state, and where the C program printed it. */
export const reference = {
  hash: 'bf301595 6287c68c 352013ff 2913ea92',
  on: {
    en: 'x86-64, and in QEMU on AArch64, ARMv7, RISC-V 64, PowerPC 64 and s390x (GCC 12.2)',
    ja: 'x86-64、および QEMU 上の AArch64、ARMv7、RISC-V 64、PowerPC 64、s390x（GCC 12.2）',
  },
};
