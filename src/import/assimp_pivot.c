/* SPDX-License-Identifier: MIT */
/*
 * FBX has a transform of up to 14 factors: translation, offsets, pivots, rotations before and after, scale. Assimp
 * makes a node of each that is not the identity, NAME_$AssimpFbx$_Rotation and so on, and animates these. Such a chain
 * is one node again where this is exact: T * A * R * B * S with constant A and B, of which B has no translation. A
 * rotation about another point moves the node on an arc, which no keys of a translation are: then the nodes stay.
 */
#include <string.h>

#include <nakawari/mat.h>
#include <nakawari/quat.h>
#include <nakawari/transform.h>
#include <nakawari/vec.h>

#include "assimp.h"

static const char mark[] = "_$AssimpFbx$_";

/* Which properties of a node any animation changes; bit k: the nkw_clip_target k. */
static unsigned *animated_properties(nkwi_assimp *a)
{
    unsigned *bits = (unsigned *)nkwi_assimp_scratch(a, "nodes", a->node_count, sizeof *bits);
    for (size_t i = 0; bits && a->scene->mAnimations && i < a->scene->mNumAnimations; i++) {
        const struct aiAnimation *from = a->scene->mAnimations[i];
        for (size_t k = 0; from && from->mChannels && k < from->mNumChannels; k++) {
            const struct aiNodeAnim *c = from->mChannels[k];
            int32_t node = c ? nkwi_assimp_find(a, c->mNodeName.data) : NKW_NO_JOINT;
            if (node == NKW_NO_JOINT || !c->mPositionKeys || !c->mRotationKeys || !c->mScalingKeys)
                continue;
            /* A single key of the identity is there because Assimp has one of each. */
            const struct aiVector3D p = c->mPositionKeys->mValue, s = c->mScalingKeys->mValue;
            const struct aiQuaternion q = c->mRotationKeys->mValue;
            bits[node] |= c->mNumPositionKeys > 1 || p.x != 0.0f || p.y != 0.0f || p.z != 0.0f ? 1u : 0;
            bits[node] |= c->mNumRotationKeys > 1 || q.x != 0.0f || q.y != 0.0f || q.z != 0.0f ? 2u : 0;
            bits[node] |= c->mNumScalingKeys > 1 || s.x != 1.0f || s.y != 1.0f || s.z != 1.0f ? 4u : 0;
        }
    }
    return bits;
}

/* Whether the node is a pivot of the node with this name. */
static int is_pivot(const struct aiNode *node, const char *name)
{
    const char *at = strstr(node->mName.data, mark);
    size_t length = at ? (size_t)(at - node->mName.data) : 0;
    return at && node->mNumChildren == 1 && node->mNumMeshes == 0 && strncmp(name, node->mName.data, length) == 0 &&
           (name[length] == 0 || strncmp(name + length, mark, sizeof mark - 1) == 0);
}

static int is_zero(nkw_vec3 v)
{
    return v.x == 0.0f && v.y == 0.0f && v.z == 0.0f;
}

static int is_one(nkw_vec3 v)
{
    const float most = 1e-6f, x = v.x - 1.0f, y = v.y - 1.0f, z = v.z - 1.0f;
    return x * x <= most * most && y * y <= most * most && z * z <= most * most;
}

static int is_identity(nkw_quat q)
{
    return q.x * q.x + q.y * q.y + q.z * q.z <= 1e-14f;
}

/* A chain so far: what was animated last (0: nothing yet, 1: translation, 2: rotation, 3: scale), and the constants. */
typedef struct chain {
    nkwi_assimp_pivot out;
    int stage;
} chain;

/* A constant factor. */
static int add_constant(chain *c, const nkw_mat4 *local)
{
    const nkw_trs t = nkw_trs_from_mat4(local);
    int rigid = is_one(t.scale), turns = !is_identity(t.rotation), moves = !is_zero(t.translation);
    if (c->stage >= 2) { /* after the rotation */
        if (moves || (turns && c->stage == 3))
            return 0;
        c->out.after = turns ? nkw_quat_mul(c->out.after, t.rotation) : c->out.after;
    } else {
        c->out.offset = nkw_vec3_add(c->out.offset, nkw_quat_rotate(c->out.before, t.translation));
        c->out.before = turns ? nkw_quat_mul(c->out.before, t.rotation) : c->out.before;
    }
    if (!rigid)
        c->out.scale = nkw_vec3_mul(c->out.scale, t.scale);
    c->stage = rigid ? c->stage : 3;
    return 1;
}

/* An animated property of a node; the channel replaces its constant. */
static int add_animated(chain *c, int32_t node, int property)
{
    if (c->stage > property || (property == 0 && !is_identity(c->out.before)))
        return 0;
    c->out.sources[property] = node;
    c->stage = property + 1;
    return 1;
}

/*
 * A chain of translation, rotations before and after, and scale only: Assimp has nodes for it, but the channel of the
 * node itself is the whole chain, T * before * R * after. Assimp 5.2 uses the rotation after as it is in the file, not
 * its inverse as FBX states, and as the node has it: the inverse is multiplied twice.
 */
static int is_whole(const nkwi_assimp *a, const unsigned *animated, int32_t top, int32_t last, chain *c)
{
    for (int32_t n = top; n < last; n++) {
        const char *part = strstr(a->nodes[n]->mName.data, mark) + sizeof mark - 1;
        if (animated[n] != 0)
            return 0;
        if (strcmp(part, "PostRotation") == 0) {
            nkw_quat inverse = nkw_trs_from_mat4(&a->locals[n]).rotation;
            c->out.after = nkw_quat_mul(inverse, inverse);
        }
    }
    for (int p = 0; p < 3; p++)
        c->out.sources[p] = last;
    return animated[last] != 0;
}

/* The nodes top .. last, each the only child of the one before, as one. */
static int join(const nkwi_assimp *a, const unsigned *animated, int32_t top, int32_t last, chain *c)
{
    const nkwi_assimp_pivot none = {{NKW_NO_JOINT, NKW_NO_JOINT, NKW_NO_JOINT},
                                    {0.0f, 0.0f, 0.0f},
                                    {0.0f, 0.0f, 0.0f, 1.0f},
                                    {0.0f, 0.0f, 0.0f, 1.0f},
                                    {1.0f, 1.0f, 1.0f}};
    c->out = none;
    c->stage = 0;
    if (is_whole(a, animated, top, last, c))
        return 1;
    c->out = none;
    for (int32_t n = top; n <= last; n++) {
        if (animated[n] == 0 && !add_constant(c, &a->locals[n]))
            return 0;
        for (int p = 0; p < 3; p++)
            if (animated[n] >> p & 1 && !add_animated(c, n, p))
                return 0;
    }
    return 1;
}

/* The rest transform of a chain is the product of its matrices. */
static void merge(nkwi_assimp *a, int32_t top, int32_t last)
{
    for (int32_t n = top; n < last; n++)
        a->part_of[n] = last;
    for (int32_t n = last; n-- > top;)
        a->locals[last] = nkw_mat4_mul(&a->locals[n], &a->locals[last]);
    a->parents[last] = a->parents[top];
}

int nkwi_assimp_pivots(nkwi_assimp *a)
{
    int32_t count = (int32_t)a->node_count;
    if (!strstr(a->document->all.format, "FBX"))
        return 1;
    unsigned *animated = animated_properties(a);
    a->pivots = (nkwi_assimp_pivot **)nkwi_assimp_scratch(a, "nodes", a->node_count, sizeof *a->pivots);
    if (!animated || !a->pivots)
        return 0;
    for (int32_t last = 1; last < count; last++) {
        const char *name = a->nodes[last]->mName.data;
        int32_t top = last;
        chain c;
        if (strstr(name, mark))
            continue;
        while (top > 0 && a->parents[top] == top - 1 && is_pivot(a->nodes[top - 1], name))
            top--;
        if (top == last || !join(a, animated, top, last, &c))
            continue;
        a->pivots[last] = (nkwi_assimp_pivot *)nkwi_assimp_scratch(a, "nodes", 1, sizeof **a->pivots);
        if (!a->pivots[last])
            return 0;
        *a->pivots[last] = c.out;
        merge(a, top, last);
    }
    return 1;
}
