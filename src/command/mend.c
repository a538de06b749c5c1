/* SPDX-License-Identifier: MIT */
/* Clips that begin at 0, and notes of what is copied. */
#include "mend.h"

#include <math.h>
#include <string.h>

#include <nakawari/mat.h>
#include <nakawari/transform.h>

static int is_gltf(const model *m)
{
    return strcmp(m->original->format, "glTF 2.0") == 0;
}

/* The times of a track less `start`, in binary64, rounded. */
static int move_track(model *m, nkw_track *t, double start)
{
    float *times = model_take(m, t->count, sizeof *times);
    for (size_t k = 0; times && k < t->count; k++)
        times[k] = (float)((double)t->times[k] - start);
    t->times = times ? times : t->times;
    return times != NULL;
}

static int move_clip(model *m, size_t animation)
{
    nkw_document_animation *a = &m->animations[animation];
    nkw_clip_track *tracks = model_tracks(m, animation);
    double start = 0.0;
    int fine = 1;
    for (size_t i = 0; i < a->track_count; i++)
        if (tracks[i].track.count > 0)
            start = fmin(start, (double)tracks[i].track.times[0]);
    if (!(start < 0.0) || !isfinite(start))
        return 1;
    for (size_t i = 0; fine && i < a->track_count; i++)
        fine = move_track(m, &tracks[i].track, start);
    output_text(stderr, m->original->file);
    fputs(": note: clip ", stderr);
    output_text(stderr, a->name);
    fprintf(stderr, " begins at %.6g s: its keys are written %.6g s later\n", start, -start);
    return fine;
}

int mend_starts(model *m)
{
    int fine = 1;
    for (size_t i = 0; fine && (!is_gltf(m) || m->mends) && i < m->original->animation_count; i++)
        fine = move_clip(m, i);
    return fine;
}

/* Whether translation, rotation and scale make another matrix: a share of its largest column. */
static int has_shear(const nkw_mat4 *matrix)
{
    const nkw_trs parts = nkw_trs_from_mat4(matrix);
    const nkw_mat4 again = nkw_mat4_from_trs(&parts);
    float most = 0.0f, off = 0.0f;
    for (int i = 0; i < 12; i++) {
        most = fmaxf(most, fabsf(matrix->m[i]));
        off = fmaxf(off, fabsf(matrix->m[i] - again.m[i]));
    }
    return off > 1e-4f * most;
}

void mend_note(const model *m)
{
    const nkw_document *d = &m->document;
    nkw_import_error error;
    for (size_t j = 0; j < d->skeleton.joint_count && !m->is_obj; j++) {
        if (!d->nodes[j].matrix || !has_shear(d->nodes[j].matrix))
            continue;
        output_text(stderr, m->original->file);
        fputs(": note: the matrix of node ", stderr);
        output_text(stderr, d->nodes[j].name);
        fputs(" shears: glTF has no such nodes, and players may refuse the file\n", stderr);
    }
    if (m->is_obj || !is_gltf(m) || m->mends || nkw_document_validate(m->original, &error) == NKW_IMPORT_OK)
        return;
    output_text(stderr, m->original->file);
    fprintf(stderr, ":%s: note: %s: what is wrong in the file is copied: see nakawari check, and convert --repair\n",
            error.place, error.reason);
}
