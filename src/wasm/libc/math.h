/* SPDX-License-Identifier: MIT */
/* The part of <math.h> that the library uses, for a target without a C library: instructions of WebAssembly. */
#ifndef NAKAWARI_WASM_MATH_H
#define NAKAWARI_WASM_MATH_H

#define INFINITY __builtin_inff()
#define NAN      __builtin_nanf("")
#define sqrtf(x) __builtin_sqrtf(x)
#define sqrt(x)  __builtin_sqrt(x)
#define floor(x) __builtin_floor(x)

#endif
