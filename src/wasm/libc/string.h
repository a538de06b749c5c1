/* SPDX-License-Identifier: MIT */
/* The part of <string.h> that the library uses, for a target without a C library; the functions are in heap.c. */
#ifndef NAKAWARI_WASM_STRING_H
#define NAKAWARI_WASM_STRING_H

#include <stddef.h>

void *memcpy(void *to, const void *from, size_t bytes);
void *memmove(void *to, const void *from, size_t bytes);
void *memset(void *to, int byte, size_t bytes);
int memcmp(const void *a, const void *b, size_t bytes);

#endif
