/* SPDX-License-Identifier: MIT */
/**
 * @file
 * A document in one block of bytes, for another process of the same program.
 *
 *     data    | nkw_document | nodes | name 0 | name 1 | ... each part at a multiple of PARCEL_ALIGNMENT
 *     links   the offset in `data` of each pointer that is not NULL; in its place stands the offset that it points to
 *
 * Arrays that two members share are in the block once, and are shared again by what parcel_open makes of it.
 */
#ifndef PARCEL_H
#define PARCEL_H

#include "command.h"

enum { PARCEL_ALIGNMENT = 16 };

typedef struct parcel {
    unsigned char *data;
    size_t *links;
    size_t bytes, link_count;
} parcel;

/** Copies a document and all that it points to. Returns 0 without memory. parcel_free is due either way. */
int parcel_pack(parcel *p, const nkw_document *document);
void parcel_free(parcel *p);

/**
 * The document of a block that was read: offsets become pointers. It is p->data, and is freed with it. NULL if a link
 * or an offset is outside the block.
 */
nkw_document *parcel_open(const parcel *p);

#endif
