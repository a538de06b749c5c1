/* SPDX-License-Identifier: MIT */
/* The blocks of a document: taken one by one, freed together, with a limit to their sum. */
#ifndef NAKAWARI_IMPORT_MEMORY_H
#define NAKAWARI_IMPORT_MEMORY_H

#include <stddef.h>

typedef struct nkwi_memory {
    struct nkwi_block *blocks;
    size_t taken, most; /* bytes */
    int exceeded; /* a block was refused because of `most` */
} nkwi_memory;

/* `count` elements of `size` bytes, all zero; NULL if there is no memory, or more than `most` would be taken. */
void *nkwi_take(nkwi_memory *memory, size_t count, size_t size);

/* A copy of a text; NULL as above. */
char *nkwi_copy(nkwi_memory *memory, const char *text);

void nkwi_give(nkwi_memory *memory);

#endif
