/* SPDX-License-Identifier: MIT */
#include "pair.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

/* A joint with what sorts it: its name, then its node. */
typedef struct named {
    const char *name;
    size_t node;
    int32_t joint;
} named;

static int by_name(const void *a, const void *b)
{
    const named *x = a, *y = b;
    int order = strcmp(x->name, y->name);
    return order ? order : (x->node > y->node) - (x->node < y->node);
}

static named *sorted(const nkw_document *d)
{
    named *list = calloc(d->skeleton.joint_count, sizeof *list);
    for (size_t j = 0; list && j < d->skeleton.joint_count; j++) {
        named one = {d->nodes[j].name, d->nodes[j].number, (int32_t)j};
        list[j] = one;
    }
    if (list)
        qsort(list, d->skeleton.joint_count, sizeof *list, by_name);
    return list;
}

int pair_joints(const nkw_document *a, const nkw_document *b, int32_t *partner, int32_t *back)
{
    named *x = sorted(a), *y = sorted(b);
    const size_t m = a->skeleton.joint_count, n = b->skeleton.joint_count;
    if (!x || !y) {
        fprintf(stderr, "no memory\n");
        free(x);
        free(y);
        return 0;
    }
    for (size_t j = 0; j < m; j++)
        partner[j] = NKW_NO_JOINT;
    for (size_t j = 0; j < n; j++)
        back[j] = NKW_NO_JOINT;
    for (size_t i = 0, k = 0; i < m && k < n;) {
        int order = strcmp(x[i].name, y[k].name);
        if (order == 0) {
            partner[x[i].joint] = y[k].joint;
            back[y[k].joint] = x[i].joint;
        }
        i += order <= 0;
        k += order >= 0;
    }
    free(x);
    free(y);
    return 1;
}

size_t pair_clip(const nkw_document *a, size_t i, const nkw_document *b)
{
    const char *name = a->animations[i].name;
    size_t before = 0;
    for (size_t k = 0; k < i; k++)
        before += strcmp(a->animations[k].name, name) == 0;
    for (size_t k = 0; k < b->animation_count; k++)
        if (strcmp(b->animations[k].name, name) == 0 && before-- == 0)
            return k;
    return SIZE_MAX;
}
