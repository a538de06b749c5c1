/* SPDX-License-Identifier: MIT */
/*
 * An AnimationStack: layers of curves of properties. A property begins with the value of the lowest layer that has it;
 * each layer above combines its value v by its weight w with the result r so far:
 *
 *     additive                r + w v; of composed rotations r slerp(1, v, w), of composed scalings r v^w
 *     override                v
 *     override-passthrough    r + w (v - r); of composed rotations slerp(r, v, w), of composed scalings r^(1 - w) v^w
 */
#include <stdlib.h>
#include <string.h>

#include <nakawari/orient.h>
#include <nakawari/quat.h>
#include <nakawari/scalar.h>
#include <nakawari/vec.h>

#include "fbx.h"

static int compare_texts(const nkwi_fbx_value *a, const char *text, size_t bytes)
{
    const size_t least = a->bytes < bytes ? a->bytes : bytes;
    const int order = least > 0 ? memcmp(a->text, text, least) : 0;
    return order != 0 ? order : a->bytes < bytes ? -1 : a->bytes > bytes;
}

static int compare_channels(const void *left, const void *right)
{
    const nkwi_fbx_channel *a = (const nkwi_fbx_channel *)left, *b = (const nkwi_fbx_channel *)right;
    if (a->object != b->object)
        return a->object < b->object ? -1 : 1;
    const int order = compare_texts(a->property, b->property->text, b->property->bytes);
    return order != 0 ? order : a->layer < b->layer ? -1 : a->layer > b->layer;
}

/* The first channel not before (object, property), or before (object + 1) without a property. */
static size_t lower(const nkwi_fbx_stack *s, size_t object, const char *property)
{
    size_t low = 0, high = s->channel_count;
    while (low < high) {
        const size_t middle = low + (high - low) / 2;
        const nkwi_fbx_channel *c = &s->channels[middle];
        if (c->object < object || (c->object == object && compare_texts(c->property, property, strlen(property)) < 0))
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

const nkwi_fbx_channel *nkwi_fbx_channels(const nkwi_fbx_stack *stack, size_t object, const char *property,
                                          size_t *count)
{
    const size_t first = lower(stack, object, property);
    size_t end = first;
    while (end < stack->channel_count && stack->channels[end].object == object &&
           nkwi_fbx_equals(stack->channels[end].property, property))
        end++;
    *count = end - first;
    return end > first ? &stack->channels[first] : NULL;
}

/* The curves of an AnimationCurveNode: of d|X, d|Y, d|Z, or one of d|NAME. */
static int read_curves(nkwi_fbx *fbx, size_t curve_node, nkwi_fbx_channel *out)
{
    const nkwi_fbx_object *o = &fbx->objects[curve_node];
    static const char letters[] = "XYZ";
    char name[4] = "d|X";
    for (size_t k = 0; k < 3; k++) {
        name[2] = letters[k];
        out->values[k] = (float)nkwi_fbx_number(fbx, curve_node, name, (double)out->values[k]);
    }
    for (size_t i = o->first_link; i < o->first_link + o->link_count; i++) {
        const nkwi_fbx_link *link = &fbx->links[i];
        if (!link->property || !nkwi_fbx_is_kind(fbx, link->from, "AnimationCurve"))
            continue;
        const size_t bytes = link->property->bytes;
        const char *at = bytes == 3 ? strchr(letters, link->property->text[2]) : NULL;
        const size_t k = at && *at ? (size_t)(at - letters) : 0;
        nkwi_fbx_curve *curve = (nkwi_fbx_curve *)nkwi_take(fbx->memory, 1, sizeof *curve);
        if (!curve)
            return nkwi_fbx_fail(&fbx->tree, 0, "no memory for a curve");
        if (!nkwi_fbx_curve_read(fbx, link->from, curve))
            return 0;
        out->curves[k] = curve->curve.key_count > 0 ? curve : NULL;
    }
    return 1;
}

/* The curve nodes of the layers with the properties that they animate. */
static int read_channels(nkwi_fbx *fbx, nkwi_fbx_stack *s)
{
    uint32_t *layer_of = (uint32_t *)nkwi_take(fbx->memory, fbx->object_count, sizeof *layer_of); /* 1 more */
    if (!layer_of)
        return nkwi_fbx_fail(&fbx->tree, 0, "no memory for the channels");
    for (size_t k = 0; k < s->layer_count; k++) {
        const nkwi_fbx_object *layer = &fbx->objects[s->layers[k].object];
        for (size_t i = layer->first_link; i < layer->first_link + layer->link_count; i++)
            if (!fbx->links[i].property)
                layer_of[fbx->links[i].from] = (uint32_t)k + 1;
    }
    size_t most = 0;
    for (size_t i = 0; i < fbx->link_count; i++)
        most += fbx->links[i].property && layer_of[fbx->links[i].from] > 0;
    s->channels = (nkwi_fbx_channel *)nkwi_take(fbx->memory, most, sizeof *s->channels);
    if (!s->channels)
        return nkwi_fbx_fail(&fbx->tree, 0, "no memory for the channels");
    for (size_t i = 0; i < fbx->link_count; i++) {
        const nkwi_fbx_link *link = &fbx->links[i];
        char name[64];
        if (!link->property || layer_of[link->from] == 0 || !nkwi_fbx_is_kind(fbx, link->from, "AnimationCurveNode"))
            continue;
        nkwi_fbx_channel c = {link->to, link->property, layer_of[link->from] - 1, {NULL, NULL, NULL}, {0, 0, 0}};
        const size_t length = link->property->bytes < sizeof name ? link->property->bytes : sizeof name - 1;
        memcpy(name, link->property->text, length);
        name[length] = 0;
        const nkw_vec3 none = {0.0f, 0.0f, 0.0f}, rest = nkwi_fbx_vector(fbx, link->to, name, none);
        memcpy(c.values, &rest, sizeof rest);
        if (!read_curves(fbx, link->from, &c))
            return 0;
        s->channels[s->channel_count++] = c;
    }
    qsort(s->channels, s->channel_count, sizeof *s->channels, compare_channels);
    return 1;
}

static nkwi_fbx_layer layer_of_object(const nkwi_fbx *fbx, size_t object)
{
    const double mode = nkwi_fbx_number(fbx, object, "BlendMode", 0.0);
    const nkwi_fbx_layer layer = {object,
                                  mode == 1.0 || mode == 2.0 ? (int)mode : 0,
                                  nkwi_fbx_number(fbx, object, "RotationAccumulationMode", 0.0) == 0.0,
                                  nkwi_fbx_number(fbx, object, "ScaleAccumulationMode", 0.0) == 0.0,
                                  nkw_clamp((float)(nkwi_fbx_number(fbx, object, "Weight", 100.0) / 100.0), 0.0f, 1.0f),
                                  NULL};
    return layer;
}

int nkwi_fbx_stack_read(nkwi_fbx *fbx, size_t object, nkwi_fbx_stack *out)
{
    const nkwi_fbx_object *o = &fbx->objects[object];
    memset(out, 0, sizeof *out);
    out->object = object;
    out->start = (float)(nkwi_fbx_number(fbx, object, "LocalStart", 0.0) / fbx->ticks);
    out->stop = (float)(nkwi_fbx_number(fbx, object, "LocalStop", 0.0) / fbx->ticks);
    if (!(out->stop > out->start)) {
        out->start = (float)(nkwi_fbx_number(fbx, object, "ReferenceStart", 0.0) / fbx->ticks);
        out->stop = (float)(nkwi_fbx_number(fbx, object, "ReferenceStop", -1.0) / fbx->ticks);
    }
    out->layers = (nkwi_fbx_layer *)nkwi_take(fbx->memory, o->link_count, sizeof *out->layers);
    if (!out->layers)
        return nkwi_fbx_fail(&fbx->tree, 0, "no memory for the layers");
    for (size_t i = o->first_link; i < o->first_link + o->link_count; i++)
        if (nkwi_fbx_is_kind(fbx, fbx->links[i].from, "AnimationLayer"))
            out->layers[out->layer_count++] = layer_of_object(fbx, fbx->links[i].from);
    if (!read_channels(fbx, out))
        return 0;
    for (size_t k = 0; k < out->layer_count; k++) {
        size_t count;
        out->layers[k].weights = nkwi_fbx_channels(out, out->layers[k].object, "Weight", &count);
    }
    return 1;
}

/* ---- values ---- */

static nkw_vec3 sample_channel(const nkwi_fbx_channel *c, float time)
{
    float out[3];
    nkw_vec3 v;
    for (int k = 0; k < 3; k++)
        out[k] =
            c->curves[k] ? nkw_fcurve_sample(&c->curves[k]->curve, time, &c->curves[k]->cursor).value : c->values[k];
    memcpy(&v, out, sizeof v);
    return v;
}

static float weight_of(const nkwi_fbx_layer *layer, float time)
{
    if (!layer->weights)
        return layer->weight;
    return nkw_clamp(0.01f * sample_channel(layer->weights, time).x, 0.0f, 1.0f);
}

static float power(float base, float exponent)
{
    const float size = nkw_pow(nkw_abs(base), exponent);
    return exponent <= 0.0f ? 1.0f : exponent >= 1.0f ? base : base < 0.0f ? -size : size;
}

static nkw_vec3 powers(nkw_vec3 v, float exponent)
{
    const nkw_vec3 out = {power(v.x, exponent), power(v.y, exponent), power(v.z, exponent)};
    return out;
}

static nkw_vec3 combine_rotation(const nkwi_fbx_layer *layer, nkw_vec3 result, nkw_vec3 value, float w,
                                 nkw_euler_order order)
{
    static const float degrees = 57.29577951308232f;
    const nkw_quat identity = {0.0f, 0.0f, 0.0f, 1.0f};
    const nkw_quat r = nkwi_fbx_turn(result, order);
    nkw_quat v = nkwi_fbx_turn(value, order);
    if (layer->mode == 0 && nkw_abs(v.w) < 1e-6f)
        v.w = 0.0f; /* half a turn: in the direction of its angles */
    const nkw_quat sum = layer->mode == 0 ? nkw_quat_mul(r, nkw_quat_slerp(identity, v, w)) : nkw_quat_slerp(r, v, w);
    return nkw_vec3_scale(nkw_euler_from_quat(nkw_quat_normalize(sum), order), degrees);
}

static nkw_vec3 combine(const nkwi_fbx_layer *layer, const nkwi_fbx_animated *a, nkw_vec3 result, nkw_vec3 value,
                        float w)
{
    if (layer->mode == 1)
        return value;
    if (layer->composes_rotation && a->kind == 'R')
        return combine_rotation(layer, result, value, w, a->order);
    if (layer->composes_scaling && a->kind == 'S')
        return nkw_vec3_mul(layer->mode == 0 ? result : powers(result, 1.0f - w), powers(value, w));
    return layer->mode == 0 ? nkw_vec3_add(result, nkw_vec3_scale(value, w)) : nkw_vec3_lerp(result, value, w);
}

nkw_vec3 nkwi_fbx_sample(const nkwi_fbx_animated *a, float time)
{
    nkw_vec3 result = a->rest;
    for (size_t i = 0; i < a->count; i++) {
        const nkwi_fbx_channel *c = &a->channels[i];
        const nkw_vec3 value = sample_channel(c, time);
        result = c->layer == 0 ? value
                               : combine(&a->stack->layers[c->layer], a, result, value,
                                         weight_of(&a->stack->layers[c->layer], time));
    }
    return result;
}
