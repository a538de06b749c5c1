/* SPDX-License-Identifier: MIT */
/*
 * The accessors of a file that is rewritten (rewrite.h).
 *
 * Invariant: an index that is not freed keeps its accessor, and every index is in the list: unknown extensions may name
 * any of them.
 *
 * A file of n accessors, of which 2 and 4 were the keys of samplers only, after four new ones:
 *
 *     index        0     1     2     3     4    ...  n - 1  n      n + 1  n + 2  n + 3
 *     appended     mesh  mesh  old   mesh  old       mesh   key a  key b  key c  key d
 *     moved        mesh  mesh  key a mesh  key b     mesh   key c  key d
 *
 * Fewer new ones than freed indices, 2, 4 and n - 1: the last is dropped, and 4, which is not at the end, repeats key a.
 *
 *     appended     mesh  mesh  old   mesh  old       old    key a
 *     moved        mesh  mesh  key a mesh  key a
 */
#include "rewrite.h"

void nkwi_rewriter_mark_samplers(nkwi_rewriter *r, unsigned char mark)
{
    const json_t *animations = json_object_get(r->root, "animations");
    for (size_t a = 0; a < json_array_size(animations); a++) {
        const json_t *samplers = json_object_get(json_array_get(animations, a), "samplers");
        for (size_t i = 0; i < json_array_size(samplers); i++) {
            size_t in = nkwi_rewriter_index(json_array_get(samplers, i), "input"), out;
            out = nkwi_rewriter_index(json_array_get(samplers, i), "output");
            if (in < r->accessor_count)
                r->freed[in] = mark;
            if (out < r->accessor_count)
                r->freed[out] = mark;
        }
    }
}

static void keep(nkwi_rewriter *r, const json_t *object, const char *key)
{
    size_t index = nkwi_rewriter_index(object, key);
    if (index < r->accessor_count)
        r->freed[index] = 0;
}

static void keep_all(nkwi_rewriter *r, const json_t *attributes)
{
    const char *key;
    json_t *value;
    json_object_foreach((json_t *)attributes, key, value) keep(r, attributes, key);
}

/* The accessors of meshes and skins (3.7). */
void nkwi_rewriter_keep_others(nkwi_rewriter *r)
{
    const json_t *meshes = json_object_get(r->root, "meshes"), *skins = json_object_get(r->root, "skins");
    for (size_t i = 0; i < json_array_size(skins); i++)
        keep(r, json_array_get(skins, i), "inverseBindMatrices");
    for (size_t m = 0; m < json_array_size(meshes); m++) {
        const json_t *list = json_object_get(json_array_get(meshes, m), "primitives");
        for (size_t p = 0; p < json_array_size(list); p++) {
            const json_t *primitive = json_array_get(list, p), *targets = json_object_get(primitive, "targets");
            keep(r, primitive, "indices");
            keep_all(r, json_object_get(primitive, "attributes"));
            for (size_t t = 0; t < json_array_size(targets); t++)
                keep_all(r, json_array_get(targets, t));
        }
    }
}

/* The samplers of new keys name the new indices: to[i] of accessor accessor_count + i. */
static void renumber_samplers(nkwi_rewriter *r, const size_t *to)
{
    static const char *const keys[2] = {"input", "output"};
    const json_t *animations = json_object_get(r->root, "animations");
    for (size_t a = 0; a < json_array_size(animations); a++) {
        const json_t *samplers = json_object_get(json_array_get(animations, a), "samplers");
        for (size_t i = 0; i < 2 * json_array_size(samplers); i++) {
            json_t *sampler = json_array_get(samplers, i / 2);
            const size_t index = nkwi_rewriter_index(sampler, keys[i % 2]);
            if (index != SIZE_MAX && index >= r->accessor_count)
                nkwi_set(&r->sink, sampler, keys[i % 2], json_integer((json_int_t)to[index - r->accessor_count]));
        }
    }
}

/* Freed indices from `slot` on: dropped at the end of the list, elsewhere `repeated`, if there is one. */
static void fill_freed(nkwi_rewriter *r, size_t slot, const json_t *repeated)
{
    for (size_t last = r->accessor_count; last-- > slot;)
        if (r->freed[last] && last + 1 == json_array_size(r->sink.accessors))
            json_array_remove(r->sink.accessors, last);
    for (size_t k = slot; repeated && k < json_array_size(r->sink.accessors); k++)
        if (r->freed[k])
            json_array_set(r->sink.accessors, k, (json_t *)repeated);
}

/*
 * An accessor of new keys that was appended moves to a freed index, from the first on; when none is left, the others
 * close the gap at the end. slot ascends, so the freed indices below it are all in use.
 */
void nkwi_rewriter_move_accessors(nkwi_rewriter *r)
{
    const size_t count = r->accessor_count, appended = json_array_size(r->sink.accessors) - count;
    size_t *to = (size_t *)nkwi_take(&r->sink.scratch, appended, sizeof *to), slot = 0, moved = 0;
    r->sink.failed = r->sink.failed || !to;
    if (r->sink.failed)
        return;
    for (; moved < appended; moved++) {
        while (slot < count && !r->freed[slot])
            slot++;
        if (slot == count)
            break;
        to[moved] = slot++;
    }
    for (size_t i = 0; i < appended; i++) {
        to[i] = i < moved ? to[i] : count + i - moved;
        json_array_set(r->sink.accessors, to[i], json_array_get(r->sink.accessors, count + i));
    }
    while (json_array_size(r->sink.accessors) > count + appended - moved)
        json_array_remove(r->sink.accessors, json_array_size(r->sink.accessors) - 1);
    renumber_samplers(r, to);
    if (moved == appended)
        fill_freed(r, slot, moved > 0 ? json_array_get(r->sink.accessors, to[moved - 1]) : NULL);
}
