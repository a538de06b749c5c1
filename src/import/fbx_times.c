/* SPDX-License-Identifier: MIT */
#include <math.h>
#include <stdlib.h>

#include "fbx_bake.h"

enum { REPEATS_MOST = 20000 }; /* times of one curve that repeats */

void nkwi_fbx_add_time(nkwi_fbx_times *times, float time, int may_jump)
{
    const nkwi_fbx_time one = {time, (unsigned char)may_jump, times->curves};
    if (!(time >= times->start && time <= times->stop) || times->failed)
        return;
    if (times->count == times->room) {
        const size_t room = times->room ? 2 * times->room : 256;
        nkwi_fbx_time *wider =
            room < SIZE_MAX / sizeof *wider ? (nkwi_fbx_time *)realloc(times->list, room * sizeof *wider) : NULL;
        times->failed = !wider;
        if (!wider)
            return;
        times->list = wider;
        times->room = room;
    }
    times->list[times->count++] = one;
}

/* The keys of the cycles on one side of the curve. */
static void add_cycles(nkwi_fbx_times *times, const nkw_fcurve *c, nkw_fcurve_outside outside, int side)
{
    const float first = c->keys[0].time, last = c->keys[c->key_count - 1].time, length = last - first;
    const float room = side > 0 ? times->stop - last : first - times->start;
    if (outside < NKW_FCURVE_OUTSIDE_CYCLE || !(length > 0.0f) || !(room > 0.0f))
        return;
    const float cycles = room / length;
    for (size_t n = 1, added = 0; (float)n < cycles + 1.0f && added < REPEATS_MOST; n++)
        for (size_t k = 0; k < c->key_count; k++, added++) {
            const float at = c->keys[k].time;
            const int back = outside == NKW_FCURVE_OUTSIDE_OSCILLATE && n % 2 == 1;
            nkwi_fbx_add_time(times,
                (float)((back ? (double)first + (double)last - (double)at : (double)at) +
                        side * (double)n * ((double)last - (double)first)),
                NKWI_FBX_SEAM);
        }
}

static void add_curve(nkwi_fbx_times *times, const nkwi_fbx_curve *curve)
{
    const nkw_fcurve *c = &curve->curve;
    times->curves++;
    for (size_t k = 0; k < c->key_count; k++) {
        const int ends = k + 1 == c->key_count && c->after >= NKW_FCURVE_OUTSIDE_CYCLE;
        const int begins = k == 0 && c->before >= NKW_FCURVE_OUTSIDE_CYCLE;
        const int after = ends || c->keys[k].kind == NKW_FCURVE_CONSTANT_NEXT;
        const int jump = begins || (k > 0 && c->keys[k - 1].kind == NKW_FCURVE_CONSTANT);
        nkwi_fbx_add_time(times, c->keys[k].time, (after ? NKWI_FBX_AFTER : 0) | (jump ? NKWI_FBX_JUMP : 0));
        times->outside += c->keys[k].time < times->start - 1e-4f || c->keys[k].time > times->stop + 1e-4f;
    }
    add_cycles(times, c, c->before, -1);
    add_cycles(times, c, c->after, 1);
}

static void add_channel(nkwi_fbx_times *times, const nkwi_fbx_channel *c)
{
    times->channels++;
    for (int k = 0; k < 3; k++)
        if (c->curves[k])
            add_curve(times, c->curves[k]);
}

void nkwi_fbx_add_times(nkwi_fbx_times *times, const nkwi_fbx_animated *a)
{
    for (size_t i = 0; i < a->count; i++) {
        const nkwi_fbx_channel *weights = a->stack->layers[a->channels[i].layer].weights;
        add_channel(times, &a->channels[i]);
        if (weights && a->channels[i].layer > 0)
            add_channel(times, weights);
    }
}

static int compare(const void *left, const void *right)
{
    const nkwi_fbx_time *a = (const nkwi_fbx_time *)left, *b = (const nkwi_fbx_time *)right;
    return a->time != b->time ? (a->time < b->time ? -1 : 1) : a->curve < b->curve ? -1 : a->curve > b->curve;
}

/* Whether a curve has two keys among those that become one: then it jumps. */
static int is_double(const nkwi_fbx_time *first, const nkwi_fbx_time *key)
{
    while (first < key && (first->curve != key->curve || key->curve == 0))
        first++;
    return first < key;
}

void nkwi_fbx_sort_times(nkwi_fbx_times *times)
{
    const uint32_t curves = times->curves;
    size_t kept = 0, first = 0; /* first: of those that become one */
    times->curves = 0;
    nkwi_fbx_add_time(times, times->start, 0);
    nkwi_fbx_add_time(times, times->stop, 0);
    times->curves = curves;
    if (times->failed)
        return;
    qsort(times->list, times->count, sizeof *times->list, compare);
    for (size_t i = 0; i < times->count; i++) {
        const nkwi_fbx_time t = times->list[i];
        nkwi_fbx_time *last = kept > 0 ? &times->list[kept - 1] : NULL;
        const float least = fmaxf(1e-6f, 2.5e-7f * fabsf(t.time));
        if (last && t.time - last->time <= least) {
            const int are_seams =
                t.may_jump & last->may_jump & NKWI_FBX_SEAM; /* of one time but for rounding: the first */
            last->time = (t.may_jump && !are_seams) || t.time == times->stop ? t.time : last->time;
            last->may_jump |=
                (unsigned char)(t.may_jump | (is_double(&times->list[first], &times->list[i]) ? NKWI_FBX_JUMP : 0));
            continue;
        }
        first = i;
        times->list[kept++] = t;
    }
    times->count = kept;
}
