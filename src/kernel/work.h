/* SPDX-License-Identifier: MIT */
/* Working memory that the caller lends: see nkw_work in <nakawari/types.h>. */
#ifndef NAKAWARI_WORK_H
#define NAKAWARI_WORK_H

#include <nakawari/types.h>

#include <stdint.h>

/* True if the memory has at least `bytes` bytes at a multiple of 16. No memory is enough for 0 bytes. */
static inline int work_fits(nkw_work work, size_t bytes)
{
    return work.bytes >= bytes && ((uintptr_t)work.data & 15) == 0 && (work.data || bytes == 0);
}

/* work_fits for `count` elements of `each` bytes, whose product may exceed size_t: then no memory is enough. */
static inline int work_fits_each(nkw_work work, size_t count, size_t each)
{
    return count <= SIZE_MAX / each && work_fits(work, count * each);
}

#endif
