/* SPDX-License-Identifier: MIT */
/*
 * The memory of the package: blocks for its JavaScript, and the four functions of <string.h> that compilers call. The
 * library itself allocates nothing.
 *
 * Blocks of a multiple of 64 bytes, each after a header of 64 bytes, fill the memory from __heap_base on. A block is
 * taken from the first free one that is large enough; free neighbours are joined when a search passes them.
 */
#include <string.h>

#include <stdint.h>

#define PAGE 65536u
#define STEP 64u

typedef struct header {
    uint32_t bytes; /* of the block that follows */
    uint32_t used;
    uint8_t padding[STEP - 8];
} header;

extern unsigned char __heap_base;
static uintptr_t first, end; /* of all blocks; 0 before the first */

static header *after(header *h)
{
    return (header *)((uintptr_t)(h + 1) + h->bytes);
}

static int grow(uintptr_t bytes)
{
    uintptr_t have = __builtin_wasm_memory_size(0) * PAGE;
    if (bytes <= have - end)
        return 1;
    return bytes < UINT32_MAX - PAGE &&
           __builtin_wasm_memory_grow(0, (bytes - (have - end) + PAGE - 1) / PAGE) != SIZE_MAX;
}

static header *append(uint32_t bytes)
{
    if (!grow(bytes + sizeof(header)))
        return NULL;
    header *h = (header *)end;
    end += bytes + sizeof(header);
    h->bytes = bytes;
    return h;
}

/* Joins h with the free blocks after it. */
static void join(header *h)
{
    for (header *next = after(h); (uintptr_t)next < end && !next->used; next = after(h))
        h->bytes += next->bytes + (uint32_t)sizeof(header);
}

static void split(header *h, uint32_t bytes)
{
    if (h->bytes < bytes + sizeof(header) + STEP)
        return;
    header *rest = (header *)((uintptr_t)(h + 1) + bytes);
    rest->bytes = h->bytes - bytes - (uint32_t)sizeof(header);
    rest->used = 0;
    h->bytes = bytes;
}

/* A block of zeros, aligned to 64 bytes; NULL if there is no memory. */
__attribute__((export_name("take"))) void *nkwi_take(uint32_t bytes)
{
    if (bytes > UINT32_MAX / 2)
        return NULL;
    if (first == 0)
        first = end = ((uintptr_t)&__heap_base + STEP - 1) / STEP * STEP;
    bytes = (bytes + STEP - 1) / STEP * STEP;
    header *h = (header *)first;
    for (; (uintptr_t)h < end; h = after(h)) {
        if (h->used)
            continue;
        join(h);
        if (h->bytes >= bytes)
            break;
    }
    if ((uintptr_t)h >= end && !(h = append(bytes)))
        return NULL;
    split(h, bytes);
    h->used = 1;
    return memset(h + 1, 0, h->bytes);
}

__attribute__((export_name("release"))) void nkwi_release(void *block)
{
    if (block)
        ((header *)block - 1)->used = 0;
}

void *memmove(void *to, const void *from, size_t bytes)
{
    unsigned char *t = to;
    const unsigned char *f = from;
    if (t <= f || t >= f + bytes)
        for (size_t i = 0; i < bytes; i++)
            t[i] = f[i];
    else
        for (size_t i = bytes; i-- > 0;)
            t[i] = f[i];
    return to;
}

void *memcpy(void *to, const void *from, size_t bytes)
{
    return memmove(to, from, bytes);
}

void *memset(void *to, int byte, size_t bytes)
{
    for (size_t i = 0; i < bytes; i++)
        ((unsigned char *)to)[i] = (unsigned char)byte;
    return to;
}

int memcmp(const void *a, const void *b, size_t bytes)
{
    const unsigned char *x = a, *y = b;
    for (size_t i = 0; i < bytes; i++)
        if (x[i] != y[i])
            return x[i] < y[i] ? -1 : 1;
    return 0;
}
