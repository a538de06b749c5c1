/* SPDX-License-Identifier: MIT */
/* A sort of indices that needs no memory. */
#ifndef NAKAWARI_SORT_H
#define NAKAWARI_SORT_H

#include "lane/strict.h"

#include <stddef.h>
#include <stdint.h>

typedef int sort_before(const void *context, uint32_t a, uint32_t b);

static inline void sort_sift_down(uint32_t *heap, size_t root, size_t n, sort_before *before, const void *context)
{
    uint32_t moved = heap[root];
    for (size_t child = 2 * root + 1; child < n; child = 2 * root + 1) {
        if (child + 1 < n && before(context, heap[child], heap[child + 1]))
            child++;
        if (!before(context, moved, heap[child]))
            break;
        heap[root] = heap[child];
        root = child;
    }
    heap[root] = moved;
}

/* Heap sort: in place, n log n whatever the input. `before` must be a total order for the result to be one. */
static inline void sort_indices(uint32_t *a, size_t n, sort_before *before, const void *context)
{
    for (size_t i = n / 2; i-- > 0;)
        sort_sift_down(a, i, n, before, context);
    for (size_t end = n; end-- > 1;) {
        uint32_t largest = a[0];
        a[0] = a[end];
        a[end] = largest;
        sort_sift_down(a, 0, end, before, context);
    }
}

static inline int sort_before_number(const void *context, uint32_t a, uint32_t b)
{
    (void)context;
    return a < b;
}

#endif
