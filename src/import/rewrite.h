/* SPDX-License-Identifier: MIT */
/*
 * A glTF 2.0 file while its animations are replaced: the tree of the file, which is changed in place, and the sink
 * (sink.h), whose one buffer receives everything that is needed.
 *
 * Invariant: an accessor that something other than a sampler may name keeps its index, also where an extension that is
 * not known here names it. Views may be renumbered: an index of a view is a member named bufferView anywhere.
 *
 *     step         the tree                                          the buffer of the sink
 *     animations   samplers -> new accessors -> one new view         | new keys |
 *     accessors    new ones move to the indices of old keys          |
 *     images       outer files -> new views, if asked                | new keys | images |
 *     views        those that nothing names are dropped              |
 *     buffers      old views -> offsets in the one buffer            | new keys | images | parts of old buffers |
 *
 * While this is done a new view has a member "new", which no glTF file may have: its offset is in the sink already.
 */
#ifndef NAKAWARI_IMPORT_REWRITE_H
#define NAKAWARI_IMPORT_REWRITE_H

#include "sink.h"

typedef struct nkwi_rewriter {
    nkwi_gltf g;
    nkwi_sink sink;
    const nkw_gltf_rewriting *rewriting;
    json_t *root;
    unsigned char *freed; /* of each accessor of the file: it has no use any more */
    size_t accessor_count; /* of the file; those after them were appended */
} nkwi_rewriter;

/* States that there is no memory, unless an error is stated already. Returns 0. */
int nkwi_rewriter_no_memory(nkwi_rewriter *r);

/* The member `key`, an index; SIZE_MAX if there is none. */
size_t nkwi_rewriter_index(const json_t *object, const char *key);

/* The steps, in their order. They return 0 after an error. */
int nkwi_rewriter_animations(nkwi_rewriter *r);
void nkwi_rewriter_images(nkwi_rewriter *r, nkw_gltf_file *file);
int nkwi_rewriter_views(nkwi_rewriter *r);
int nkwi_rewriter_buffers(nkwi_rewriter *r);

/*
 * Marks, or unmarks, the accessors of all samplers. Called with 1 before and with 0 after the channels are replaced, it
 * leaves marked what the old samplers used and the new ones do not. Then those of meshes and skins are unmarked, and
 * new accessors move to the marked indices.
 */
void nkwi_rewriter_mark_samplers(nkwi_rewriter *r, unsigned char mark);
void nkwi_rewriter_keep_others(nkwi_rewriter *r);
void nkwi_rewriter_move_accessors(nkwi_rewriter *r);

#endif
