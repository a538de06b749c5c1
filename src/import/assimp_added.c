/* SPDX-License-Identifier: MIT */
/*
 * Where Euler angles of an FBX curve are more than half a turn apart, Assimp adds a key on the line between them. This
 * is a turn that was meant where keys are few. In a curve with a key for each frame it is a change from 180 to -180
 * degrees, which an exporter made of rotations: the joint spins once between two frames. Such keys are taken out again:
 * of a track of 8 keys or more those between two keys at the median distance of its keys that are farther than 120
 * degrees from the first, while the second is nearer than 90.
 */
#include <math.h>
#include <stdlib.h>

#include "assimp.h"

enum { KEYS_LEAST = 8 };

static int compare_gaps(const void *left, const void *right)
{
    double a = *(const double *)left, b = *(const double *)right;
    return a < b ? -1 : a > b;
}

/* The median distance of the keys; 0 where there are too few. */
static double median_gap(nkwi_assimp *a, const struct aiNodeAnim *c)
{
    size_t count = c->mNumRotationKeys;
    double *gaps = count < KEYS_LEAST ? NULL : (double *)nkwi_assimp_scratch(a, "animations", count, sizeof *gaps);
    for (size_t i = 1; gaps && i < count; i++)
        gaps[i - 1] = c->mRotationKeys[i].mTime - c->mRotationKeys[i - 1].mTime;
    if (!gaps)
        return 0.0;
    qsort(gaps, count - 1, sizeof *gaps, compare_gaps);
    return gaps[(count - 1) / 2];
}

/* The cosine of half the angle between two keys. */
static double cosine(const struct aiQuatKey *i, const struct aiQuatKey *j)
{
    const struct aiQuaternion p = i->mValue, q = j->mValue;
    return fabs((double)p.x * (double)q.x + (double)p.y * (double)q.y + (double)p.z * (double)q.z +
                (double)p.w * (double)q.w);
}

/* Whether a key lies between two keys, of which the second is near the first, and is far from the first. */
static int is_added(const struct aiQuatKey *first, const struct aiQuatKey *key, const struct aiQuatKey *second)
{
    return cosine(first, key) < 0.5 && cosine(first, second) > 0.70710678; /* 120 and 90 degrees */
}

/* Marks the keys that were added, of which the neighbours are `gap` apart; returns their number. */
static size_t mark_added(const struct aiNodeAnim *c, double gap, unsigned char *added)
{
    const struct aiQuatKey *keys = c->mRotationKeys;
    size_t count = 0;
    for (size_t i = 1; i + 1 < c->mNumRotationKeys; i++) {
        double distance = keys[i + 1].mTime - keys[i - 1].mTime;
        if (added[i - 1] || !(distance > 0.999 * gap && distance < 1.001 * gap))
            continue;
        added[i] = (unsigned char)is_added(&keys[i - 1], &keys[i], &keys[i + 1]);
        count += added[i];
    }
    return count;
}

/* Keys of vectors at the times of added rotations: Assimp has them in all lists. */
static void drop_vectors(const struct aiNodeAnim *c, const unsigned char *added, struct aiVectorKey *keys,
                         unsigned *key_count)
{
    unsigned kept = 0, r = 0;
    for (unsigned i = 0; i < *key_count; i++) {
        while (r + 1 < c->mNumRotationKeys && c->mRotationKeys[r].mTime < keys[i].mTime)
            r++;
        if (!added[r] || c->mRotationKeys[r].mTime != keys[i].mTime)
            keys[kept++] = keys[i];
    }
    *key_count = kept;
}

void nkwi_assimp_drop_added(nkwi_assimp *a, struct aiNodeAnim *c)
{
    double gap = c->mRotationKeys && c->mPositionKeys && c->mScalingKeys ? median_gap(a, c) : 0.0;
    unsigned char *added =
        gap > 0.0 ? (unsigned char *)nkwi_assimp_scratch(a, "animations", c->mNumRotationKeys, 1) : NULL;
    unsigned kept = 0;
    if (!added || mark_added(c, gap, added) == 0)
        return;
    drop_vectors(c, added, c->mPositionKeys, &c->mNumPositionKeys);
    drop_vectors(c, added, c->mScalingKeys, &c->mNumScalingKeys);
    for (unsigned i = 0; i < c->mNumRotationKeys; i++)
        if (!added[i])
            c->mRotationKeys[kept++] = c->mRotationKeys[i];
    c->mNumRotationKeys = kept;
}
