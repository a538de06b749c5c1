/* SPDX-License-Identifier: MIT */
/*
 * The memory of the package: blocks for its JavaScript, and the four functions of <string.h> that compilers call. The
 * library itself allocates nothing.
 *
 * Blocks fill the memory from __heap_base on, each after a header of 64 bytes. A size is u steps of 64 bytes, rounded
 * up to a class: u < 8, or (8 + s) 2^e with s = 0...7, at most an eighth more. Free blocks are in a list for each class
 * and are joined with free neighbours at once, so taking and releasing have a constant cost,
 * except for the zeros.
 * Source: Masmano, Ripoll, Crespo, Real, TLSF: a new dynamic memory allocator for real-time systems, ECRTS 2004.
 */
#include <string.h>

#include <stdint.h>

#define PAGE    65536u
#define STEP    64u
#define CLASSES 192u

typedef struct block {
    uint32_t steps; /* of the memory after this header */
    uint32_t used;
    struct block *below;           /* the block before it in memory; NULL for the first */
    struct block *next, *previous; /* in the list of its class, if it is free */
    uint8_t padding[STEP - 20];
} block;

extern unsigned char __heap_base;
static uintptr_t end; /* of all blocks; 0 before the first */
static block *last;   /* the block before end */
static block *lists[CLASSES];
static uint32_t filled[CLASSES / 32]; /* a bit for each list that is not empty */

static block *after(block *b)
{
    return (block *)((uintptr_t)(b + 1) + b->steps * STEP);
}

/* The exponent e of the sizes (8 + s) 2^e that u is between; 0 for u < 16. */
static uint32_t exponent(uint32_t u)
{
    return u < 8 ? 0 : 28 - (uint32_t)__builtin_clz(u);
}

static uint32_t class_of(uint32_t u)
{
    return 8 * exponent(u) + (u >> exponent(u));
}

/* Adds a free block to the list of its class. */
static void insert(block *b)
{
    uint32_t c = class_of(b->steps);
    b->used = 0;
    b->previous = NULL;
    b->next = lists[c];
    if (b->next)
        b->next->previous = b;
    lists[c] = b;
    filled[c / 32] |= 1u << c % 32;
}

static void take_out(block *b)
{
    uint32_t c = class_of(b->steps);
    if (b->next)
        b->next->previous = b->previous;
    if (b->previous)
        b->previous->next = b->next;
    else if (!(lists[c] = b->next))
        filled[c / 32] &= ~(1u << c % 32);
}

/* A free block of class c or of a larger one; NULL if there is none. */
static block *find(uint32_t c)
{
    uint32_t bits = filled[c / 32] & ~0u << c % 32;
    for (c /= 32; !bits && ++c < CLASSES / 32;)
        bits = filled[c];
    return bits ? lists[32 * c + (uint32_t)__builtin_ctz(bits)] : NULL;
}

/* Sets the size of b, and what the block after it, or the end, knows of it. */
static void resize(block *b, uint32_t steps)
{
    b->steps = steps;
    if ((uintptr_t)after(b) >= end)
        last = b;
    else
        after(b)->below = b;
}

static int grow(uintptr_t bytes)
{
    uintptr_t have = __builtin_wasm_memory_size(0) * PAGE;
    if (bytes <= have - end)
        return 1;
    return bytes < UINT32_MAX - PAGE &&
           __builtin_wasm_memory_grow(0, (bytes - (have - end) + PAGE - 1) / PAGE) != SIZE_MAX;
}

/* A new block before a new end. A free block there grows. */
static block *append(uint32_t steps)
{
    int grows = last && !last->used;
    if (!grow((steps + 1 - (grows ? last->steps + 1 : 0)) * STEP))
        return NULL;
    block *b = grows ? last : (block *)end;
    if (grows)
        take_out(b);
    else
        b->below = last;
    end = (uintptr_t)(b + 1) + steps * STEP;
    resize(b, steps);
    return b;
}

/* Leaves the first steps of b, and adds the rest to a list. */
static void split(block *b, uint32_t steps)
{
    if (b->steps < steps + 2)
        return;
    uint32_t rest = b->steps - steps - 1;
    b->steps = steps;
    after(b)->below = b;
    resize(after(b), rest);
    insert(after(b));
}

/* A block of zeros, aligned to 64 bytes; NULL if there is no memory. */
__attribute__((export_name("take"))) void *nkwi_take(uint32_t bytes)
{
    if (bytes > UINT32_MAX / 2)
        return NULL;
    if (end == 0)
        end = ((uintptr_t)&__heap_base + STEP - 1) / STEP * STEP;
    uint32_t u = bytes <= STEP ? 1 : (bytes + STEP - 1) / STEP, unit = 1u << exponent(u);
    u = (u + unit - 1) / unit * unit;
    block *b = find(class_of(u));
    if (b)
        take_out(b);
    else if (!(b = append(u)))
        return NULL;
    split(b, u);
    b->used = 1;
    return memset(b + 1, 0, b->steps * STEP);
}

__attribute__((export_name("release"))) void nkwi_release(void *memory)
{
    if (!memory)
        return;
    block *b = (block *)memory - 1, *next = after(b), *below = b->below;
    if ((uintptr_t)next < end && !next->used) {
        take_out(next);
        resize(b, b->steps + 1 + next->steps);
    }
    if (below && !below->used) {
        take_out(below);
        resize(below, below->steps + 1 + b->steps);
        b = below;
    }
    insert(b);
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
