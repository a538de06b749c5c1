/* SPDX-License-Identifier: MIT */
/*
 * Rotation keys that are no rotations: Assimp makes quaternions of matrix keys that mirror, or that have a column of
 * zeros, whose length is not 1 (0.707 of diag(-1, 1, 1)). Such a key keeps the rotation of its neighbour.
 */
#include <math.h>
#include <string.h>

#include "assimp.h"

/* Within 1e-2 of unit: what `check` calls an error is farther. */
static int is_rotation(const float *q)
{
    const double square = (double)q[0] * (double)q[0] + (double)q[1] * (double)q[1] + (double)q[2] * (double)q[2] +
                          (double)q[3] * (double)q[3];
    return fabs(sqrt(square) - 1.0) <= 1e-2;
}

/* The first key that is a rotation, count if none is. */
static size_t first_rotation(const nkw_track *t)
{
    size_t k = 0;
    while (k < t->count && !is_rotation(t->values + 4 * k))
        k++;
    return k;
}

/* Of the key before, of the first ones that after them, of a track without a rotation the rest pose. */
static size_t mend(float *values, const nkw_track *t, const nkw_quat *rest)
{
    const size_t first = first_rotation(t);
    const float *last = first < t->count ? values + 4 * first : &rest->x;
    size_t mended = 0;
    for (size_t k = 0; k < t->count; k++) {
        if (is_rotation(values + 4 * k)) {
            last = values + 4 * k;
            continue;
        }
        memcpy(values + 4 * k, last, 4 * sizeof *last);
        mended++;
    }
    return mended;
}

int nkwi_assimp_units(nkwi_assimp *a)
{
    nkw_document *d = &a->document->all;
    for (size_t i = 0; i < d->animation_count; i++)
        for (size_t k = 0; k < d->animations[i].track_count; k++) {
            const nkw_clip_track *track = &d->animations[i].tracks[k];
            const nkw_document_node *node = &d->nodes[d->animations[i].channels[k].joint];
            if (track->target != NKW_CLIP_ROTATION || track->track.interpolation == NKW_INTERPOLATION_CUBICSPLINE)
                continue;
            const size_t mended = mend((float *)track->track.values, &track->track, &node->rest.rotation);
            if (mended > 0 &&
                !nkwi_document_warn(a->document, a->error,
                                    "joint %.60s: %zu keys mirror or have no size: they keep the rotation beside them",
                                    node->name, mended))
                return 0;
        }
    return 1;
}
