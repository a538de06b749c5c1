/* SPDX-License-Identifier: MIT */
#include "memory.h"

#include <stdlib.h>
#include <string.h>

/* The elements follow the header, aligned for every type. */
typedef union nkwi_block_header {
    struct nkwi_block {
        struct nkwi_block *next;
    } block;
    long double widest;
} nkwi_block_header;

void *nkwi_take(nkwi_memory *memory, size_t count, size_t size)
{
    size_t left = memory->most - memory->taken;
    if (left < sizeof(nkwi_block_header) || (size > 0 && count > (left - sizeof(nkwi_block_header)) / size)) {
        memory->exceeded = 1;
        return NULL;
    }
    size_t bytes = sizeof(nkwi_block_header) + count * size;
    nkwi_block_header *header = (nkwi_block_header *)calloc(1, bytes);
    if (!header)
        return NULL;
    header->block.next = memory->blocks;
    memory->blocks = &header->block;
    memory->taken += bytes;
    return header + 1;
}

char *nkwi_copy(nkwi_memory *memory, const char *text)
{
    size_t bytes = strlen(text) + 1;
    char *copy = (char *)nkwi_take(memory, bytes, 1);
    return copy ? (char *)memcpy(copy, text, bytes) : NULL;
}

void nkwi_give(nkwi_memory *memory)
{
    while (memory->blocks) {
        struct nkwi_block *next = memory->blocks->next;
        free(memory->blocks);
        memory->blocks = next;
    }
}
