/* SPDX-License-Identifier: MIT */
/*
 * The buffers of a file that is rewritten (rewrite.h): what its views need of them, in the one buffer of the sink.
 *
 * Invariant: a byte that a view of the new file names is in the sink once for each part of an old buffer, at an offset
 * of the same remainder modulo 4, so elements remain aligned (3.6.2.4).
 *
 *     views of buffer 0    [8 ... 20)   [12 ...... 40)       [66 ... 70)        in bytes of the old buffer
 *     parts                [8 ................... 40)        [66 ... 70)        overlapping views are one part
 *     the sink             | new keys | 8 ...... 40 | . . 66 ... 70 |           lead of two bytes: 66 is 2 modulo 4
 *
 * A view is then found among the parts by bisection, and moves with its part: at + (offset - start of the part). Views
 * of new keys and of embedded images are in the sink already, and are left out of all this.
 */
#include <stdlib.h>

#include "rewrite.h"

/* A part: bytes start..end - 1 of an old buffer, which views need, and their place in the sink, `at`. */
typedef struct part {
    size_t buffer, start, end, at;
} part;

/* Merged, in the order of buffers and bytes. */
typedef struct part_list {
    part *parts;
    size_t count;
} part_list;

/* The order of parts: by buffer, then by their first byte. */
static int before(const void *a, const void *b)
{
    const part *x = (const part *)a, *y = (const part *)b;
    if (x->buffer != y->buffer)
        return x->buffer < y->buffer ? -1 : 1;
    return x->start < y->start ? -1 : x->start > y->start;
}

/* The bytes of a view of the source. Those of new keys are in the sink already: their buffer is the sink. */
static part part_of(const json_t *view)
{
    /* 3.6.1: byteOffset is optional, and 0 without it. */
    const size_t start = nkwi_rewriter_index(view, "byteOffset"), from = start == SIZE_MAX ? 0 : start;
    const part p = {nkwi_rewriter_index(view, "buffer"), from, from + nkwi_rewriter_index(view, "byteLength"), 0};
    return p;
}

static int is_new(const json_t *view)
{
    return json_object_get(view, "new") != NULL;
}

/* The views of old buffers, checked; then sorted and merged. */
static int collect_parts(nkwi_rewriter *r, part_list *list)
{
    size_t n = 0;
    for (size_t i = 0; i < json_array_size(r->sink.views); i++) {
        const json_t *view = json_array_get(r->sink.views, i);
        const part p = part_of(view);
        nkwi_buffer buffer;
        if (is_new(view))
            continue;
        if (p.buffer >= nkwi_length(&r->g.buffer_list) || p.end < p.start)
            return nkwi_fail(r->sink.error, NULL, NKW_IMPORT_INVALID, "bufferView %zu is outside its buffer", i);
        if (!nkwi_gltf_buffer(&r->g, p.buffer, &buffer))
            return 0;
        if (p.end > buffer.bytes)
            return nkwi_fail(r->sink.error, NULL, NKW_IMPORT_INVALID, "bufferView %zu is outside its buffer", i);
        list->parts[n++] = p;
    }
    /* Sorted, a part overlaps at most the last one of the merged list, which is in the same array before it. */
    qsort(list->parts, n, sizeof *list->parts, before);
    for (size_t i = 0; i < n; i++) {
        part *last = list->count ? &list->parts[list->count - 1] : NULL;
        if (last && last->buffer == list->parts[i].buffer && list->parts[i].start < last->end)
            last->end = list->parts[i].end > last->end ? list->parts[i].end : last->end;
        else
            list->parts[list->count++] = list->parts[i];
    }
    return 1;
}

/* Appends each part at a multiple of four, after the start % 4 bytes before it: so it keeps its remainder. */
static int copy_parts(nkwi_rewriter *r, part_list *list)
{
    for (size_t i = 0; i < list->count; i++) {
        part *p = &list->parts[i];
        const size_t lead = p->start % 4;
        nkwi_buffer buffer;
        if (!nkwi_gltf_buffer(&r->g, p->buffer, &buffer))
            return 0;
        p->at = nkwi_sink_append(&r->sink, buffer.data + p->start - lead, p->end - p->start + lead) + lead;
    }
    return !r->sink.failed || nkwi_rewriter_no_memory(r);
}

/*
 * Names the place of each view: its part is the last one that is not after it. Parts of a buffer do not overlap, and
 * each view lies in one, so no other test is needed.
 */
static void place_views(nkwi_rewriter *r, const part_list *list)
{
    for (size_t i = 0; i < json_array_size(r->sink.views); i++) {
        json_t *view = json_array_get(r->sink.views, i);
        const part p = part_of(view);
        size_t low = 0, high = list->count;
        if (is_new(view)) {
            json_object_del(view, "new");
            continue;
        }
        while (high - low > 1) { /* the part is one of low..high - 1 */
            size_t middle = low + (high - low) / 2;
            if (before(&list->parts[middle], &p) <= 0)
                low = middle;
            else
                high = middle;
        }
        nkwi_set(&r->sink, view, "buffer", json_integer(0));
        nkwi_set(&r->sink, view, "byteOffset",
                 json_integer((json_int_t)(list->parts[low].at + p.start - list->parts[low].start)));
    }
}

int nkwi_rewriter_buffers(nkwi_rewriter *r)
{
    part_list list = {NULL, 0};
    list.parts = (part *)nkwi_take(&r->sink.scratch, json_array_size(r->sink.views), sizeof *list.parts);
    if (!list.parts)
        return nkwi_rewriter_no_memory(r);
    if (!collect_parts(r, &list) || !copy_parts(r, &list))
        return 0;
    place_views(r, &list);
    return !r->sink.failed || nkwi_rewriter_no_memory(r);
}
