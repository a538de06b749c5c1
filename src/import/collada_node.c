/* SPDX-License-Identifier: MIT */
#include <math.h>
#include <string.h>

#include <nakawari/mat.h>
#include <nakawari/orient.h>
#include <nakawari/quat.h>
#include <nakawari/vec.h>

#include "collada.h"

static const struct {
    const char *name;
    size_t width;
} kinds[] = {{"translate", 3}, {"rotate", 4}, {"scale", 3}, {"matrix", 16}, {"lookat", 9}, {"skew", 7}};

enum { KINDS = sizeof kinds / sizeof *kinds };

size_t nkwi_collada_width(nkwi_collada_kind kind)
{
    return kinds[kind].width;
}

static int kind_of(const xmlNode *tag)
{
    int kind = 0;
    while (kind < KINDS && !nkwi_collada_is(tag, kinds[kind].name))
        kind++;
    return kind;
}

/* ---- the elements of nodes ---- */

static int is_element(const xmlNode *tag)
{
    return kind_of(tag) < KINDS && nkwi_collada_is(tag->parent, "node");
}

int nkwi_collada_elements(nkwi_collada *c)
{
    const xmlNode *top = xmlDocGetRootElement(c->xml);
    size_t count = 0;
    for (const xmlNode *t = top; t; t = nkwi_collada_walk(top, t))
        count += (size_t)is_element(t);
    c->elements = (nkwi_collada_element *)nkwi_take(c->memory, count, sizeof *c->elements);
    for (xmlNode *t = (xmlNode *)top; c->elements && t; t = nkwi_collada_walk(top, t)) {
        if (!nkwi_collada_is(t, "node"))
            continue;
        t->_private = c->elements + c->element_count;
        for (const xmlNode *part = t->children; part; part = part->next) {
            nkwi_collada_element one = {(nkwi_collada_kind)kind_of(part), part, {0}, NKWI_COLLADA_NONE};
            if (!is_element(part))
                continue;
            nkwi_collada_numbers(part, one.values, kinds[one.kind].width);
            for (size_t k = 0; k < kinds[one.kind].width; k++)
                one.values[k] = isfinite(one.values[k]) ? one.values[k] : 0.0f;
            c->elements[c->element_count++] = one;
        }
    }
    return c->elements != NULL;
}

nkwi_collada_element *nkwi_collada_elements_of(const nkwi_collada *c, const xmlNode *node, size_t *count)
{
    nkwi_collada_element *first = (nkwi_collada_element *)node->_private;
    *count = 0;
    while (first + *count < c->elements + c->element_count && first[*count].tag->parent == node)
        ++*count;
    return first;
}

/* ---- matrices ---- */

/* Collada writes rows. */
static nkw_mat4 matrix_of(const float *v)
{
    nkw_mat4 m;
    for (int i = 0; i < 16; i++)
        m.m[i] = v[i % 4 * 4 + i / 4];
    return m;
}

static int flat_columns(const nkw_trs *t)
{
    const float x = fabsf(t->scale.x), y = fabsf(t->scale.y), z = fabsf(t->scale.z);
    const float least = 1e-7f * fmaxf(x, fmaxf(y, z));
    return (x <= least) + (y <= least) + (z <= least);
}

/* One column of zeros leaves the rotation to the others, unless the key beside mirrors. */
static int has_rotation(const nkw_trs *t, const nkw_trs *beside)
{
    const int flat = flat_columns(t);
    return flat == 0 || (flat == 1 && !(beside && beside->scale.x < 0.0f));
}

const nkw_trs *nkwi_collada_matrix_keys(nkwi_collada *c, const float *values, size_t count)
{
    nkw_trs *keys = (nkw_trs *)nkwi_take(c->memory, count, sizeof *keys);
    size_t first = count;
    if (!keys)
        return NULL;
    for (size_t i = count; i-- > 0;) {
        const nkw_mat4 m = matrix_of(values + 16 * i);
        keys[i] = nkw_trs_from_mat4(&m);
        first = has_rotation(&keys[i], NULL) ? i : first;
    }
    for (size_t i = 0; i < count; i++) {
        const nkw_trs *beside = i > 0 ? &keys[i - 1] : first < count ? &keys[first] : NULL;
        c->flat_keys += (size_t)(flat_columns(&keys[i]) > 0);
        if (beside && !has_rotation(&keys[i], beside))
            keys[i].rotation = beside->rotation;
    }
    return keys;
}

/* ---- transforms ---- */

/* Columns: right, up, towards the viewer, eye. */
static nkw_trs look(const float *v)
{
    const nkw_vec3 eye = {v[0], v[1], v[2]}, interest = {v[3], v[4], v[5]}, up = {v[6], v[7], v[8]};
    const nkw_vec3 back = nkw_vec3_normalize(nkw_vec3_sub(eye, interest));
    const nkw_vec3 right = nkw_vec3_normalize(nkw_vec3_cross(up, back)), above = nkw_vec3_cross(back, right);
    const nkw_mat4 m = {{right.x, right.y, right.z, 0, above.x, above.y, above.z, 0, back.x, back.y, back.z, 0, eye.x,
                         eye.y, eye.z, 1}};
    return nkw_trs_from_mat4(&m);
}

static nkw_trs trs_of(nkwi_collada_kind kind, const float *v)
{
    nkw_trs t = nkw_trs_identity();
    const nkw_vec3 three = {v[0], v[1], v[2]};
    if (kind == NKWI_COLLADA_TRANSLATE)
        t.translation = three;
    else if (kind == NKWI_COLLADA_SCALE)
        t.scale = three;
    else if (kind == NKWI_COLLADA_ROTATE) /* two turns are the period of a quaternion */
        t.rotation = nkw_quat_from_axis_angle(three, (float)(remainder((double)v[3], 720.0) * 0.017453292519943295));
    else if (kind == NKWI_COLLADA_MATRIX) {
        const nkw_mat4 m = matrix_of(v);
        t = nkw_trs_from_mat4(&m);
    } else if (kind == NKWI_COLLADA_LOOKAT)
        t = look(v);
    return t;
}

/* The values of an element at a time; its transform, if its channel has whole matrices. */
static const nkwi_collada_curve *sample_element(const nkwi_collada *c, const nkwi_collada_element *e, float time,
                                                float *v)
{
    memcpy(v, e->values, sizeof e->values);
    for (size_t i = e->channel; i != NKWI_COLLADA_NONE; i = c->channels[i].next) {
        const nkwi_collada_channel *one = &c->channels[i];
        if (one->curve->keys && e->kind == NKWI_COLLADA_MATRIX)
            return one->curve;
        nkwi_collada_sample(one->curve, time, v + one->first);
    }
    return NULL;
}

/* Between matrices: lines of translation and scale, arcs of rotation. */
static nkw_trs sample_keys(const nkwi_collada_curve *curve, float time)
{
    float part;
    const size_t i = nkwi_collada_segment(curve, time, &part);
    const nkw_trs *a = &curve->keys[i], *b = a + (part > 0.0f);
    const nkw_trs t = {nkw_vec3_lerp(a->translation, b->translation, part),
                       nkw_quat_slerp(a->rotation, b->rotation, part), nkw_vec3_lerp(a->scale, b->scale, part)};
    return curve->kinds[i] == NKWI_COLLADA_STEP || !(part > 0.0f) ? *a : t;
}

static int turns(const nkw_trs *t)
{
    return t->rotation.x != 0.0f || t->rotation.y != 0.0f || t->rotation.z != 0.0f;
}

static int is_uniform(nkw_vec3 s)
{
    return s.x == s.y && s.y == s.z;
}

nkw_trs nkwi_collada_transform(const nkwi_collada *c, const nkwi_collada_element *list, size_t count, float time,
                               nkw_mat4 *matrix)
{
    nkw_trs whole = nkw_trs_identity();
    nkw_mat4 product = nkw_mat4_from_trs(&whole);
    int shears = 0; /* the product is no TRS: it is decomposed at the end */
    for (size_t i = 0; i < count; i++) {
        float v[16];
        const nkwi_collada_curve *keys = sample_element(c, &list[i], time, v);
        const nkw_trs one = keys ? sample_keys(keys, time) : trs_of(list[i].kind, v);
        const nkw_mat4 m = list[i].kind == NKWI_COLLADA_MATRIX && !keys ? matrix_of(v) : nkw_mat4_from_trs(&one);
        shears |= !is_uniform(whole.scale) && turns(&one);
        whole = nkw_trs_mul(&whole, &one);
        product = nkw_mat4_mul(&product, &m);
    }
    if (matrix)
        *matrix = product;
    return shears ? nkw_trs_from_mat4(&product) : whole;
}

static int is_turn(nkwi_collada_kind kind)
{
    return kind == NKWI_COLLADA_ROTATE || kind == NKWI_COLLADA_MATRIX || kind == NKWI_COLLADA_LOOKAT;
}

static int is_scale(nkwi_collada_kind kind)
{
    return kind == NKWI_COLLADA_SCALE || kind == NKWI_COLLADA_MATRIX;
}

int nkwi_collada_affects(const nkwi_collada_element *list, size_t count, size_t element, int part)
{
    const nkwi_collada_kind kind = list[element].kind;
    int scaled = 0, mixed = 0, moved = 0;
    for (size_t i = 0; i < count; i++) {
        mixed |= scaled && is_turn(list[i].kind);
        scaled |= is_scale(list[i].kind);
        moved |= i > element && list[i].kind != NKWI_COLLADA_ROTATE && list[i].kind != NKWI_COLLADA_SCALE;
    }
    if (part == 0)
        return moved || (kind != NKWI_COLLADA_ROTATE && kind != NKWI_COLLADA_SCALE);
    return mixed || (part == 1 ? is_turn(kind) : is_scale(kind));
}
