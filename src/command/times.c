/* SPDX-License-Identifier: MIT */
#include "times.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

static int ascending(const void *a, const void *b)
{
    float x = *(const float *)a, y = *(const float *)b;
    return (x > y) - (x < y);
}

/* Sorts, and removes equal times. */
static void tidy(times *t)
{
    size_t kept = 0;
    qsort(t->times, t->count, sizeof *t->times, ascending);
    for (size_t i = 0; i < t->count; i++)
        if (!kept || t->times[i] != t->times[kept - 1])
            t->times[kept++] = t->times[i];
    t->count = kept;
}

/* Channels that share an array of times are neighbours in most files. */
static int append(times *t, const nkw_document *d, size_t animation, size_t *room)
{
    const float *last = NULL;
    for (size_t i = 0; animation < d->animation_count && i < d->animations[animation].track_count; i++) {
        const nkw_track *track = &d->animations[animation].tracks[i].track;
        if (track->times == last)
            continue;
        last = track->times;
        if (track->count > *room - t->count) {
            tidy(t);
            size_t more = 2 * (t->count + track->count);
            float *longer = realloc(t->times, more * sizeof *longer);
            if (!longer)
                return 0;
            t->times = longer;
            *room = more;
        }
        memcpy(t->times + t->count, track->times, track->count * sizeof *track->times);
        t->count += track->count;
    }
    return 1;
}

/* From n times to 2 n - 1, from the last to the first. */
static void insert_middles(times *t)
{
    for (size_t i = t->count; i-- > 0;) {
        t->times[2 * i] = t->times[i];
        if (i + 1 < t->count)
            t->times[2 * i + 1] = t->times[i] + 0.5f * (t->times[2 * i + 2] - t->times[i]);
    }
    t->count = 2 * t->count - 1;
}

int times_of_clips(times *t, const nkw_document *a, size_t i, const nkw_document *b, size_t k)
{
    size_t room = 16;
    t->count = 0;
    t->times = malloc(room * sizeof *t->times);
    if (t->times && append(t, a, i, &room) && append(t, b, k, &room)) {
        if (!t->count)
            t->times[t->count++] = 0.0f;
        tidy(t);
        float *wide = realloc(t->times, 2 * t->count * sizeof *wide);
        if (wide) {
            t->times = wide;
            insert_middles(t);
            tidy(t);
            return 1;
        }
    }
    fprintf(stderr, "no memory\n");
    return 0;
}

void times_free(times *t)
{
    free(t->times);
}
