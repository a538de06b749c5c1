/* SPDX-License-Identifier: MIT */
#include <math.h>
#include <string.h>

#include <nakawari/scalar.h>
#include <nakawari/segment.h>
#include <nakawari/spline.h>

#include "collada.h"

/* ---- sources ---- */

/* Numbers that an accessor finds in an array: `count` of `width`. */
typedef struct source {
    float *numbers;
    size_t count, width;
} source;

/* A number that an attribute states. */
static size_t size_of(const xmlNode *tag, const char *key, size_t other)
{
    const char *text = nkwi_collada_text(tag, key);
    size_t number = 0;
    if (!text || !*text)
        return other;
    for (; *text >= '0' && *text <= '9' && number < SIZE_MAX / 100; text++)
        number = 10 * number + (size_t)(*text - '0');
    return number;
}

static xmlNode *accessor_of(const xmlNode *tag)
{
    return nkwi_collada_child(nkwi_collada_child(tag, "technique_common"), "accessor");
}

/* The floats of a source; count 0 for none. Returns 0 without memory. */
static int read_source(nkwi_collada *c, const xmlNode *tag, source *out)
{
    const xmlNode *accessor = accessor_of(tag), *array = nkwi_collada_child(tag, "float_array");
    const xmlNode *named = nkwi_collada_of_url(c, nkwi_collada_text(accessor, "source"));
    memset(out, 0, sizeof *out);
    array = nkwi_collada_is(named, "float_array") ? named : array;
    const size_t all = nkwi_collada_numbers(array, NULL, 0), offset = size_of(accessor, "offset", 0);
    const size_t width = size_of(accessor, "stride", 1);
    if (!array || width == 0 || width > 64 || offset >= all)
        return 1;
    out->numbers = (float *)nkwi_take(c->memory, all, sizeof *out->numbers);
    if (!out->numbers)
        return 0;
    nkwi_collada_numbers(array, out->numbers, all);
    out->numbers += offset;
    const size_t stated = size_of(accessor, "count", SIZE_MAX);
    out->width = width;
    out->count = (all - offset) / width < stated ? (all - offset) / width : stated;
    return 1;
}

static int read_input(nkwi_collada *c, const xmlNode *sampler, const char *semantic, source *out)
{
    return read_source(c, nkwi_collada_input(c, sampler, semantic), out);
}

/* ---- kinds of segments ---- */

enum { LINEAR, STEP, BEZIER, HERMITE, TCB, OTHER };

/* The kind of each segment; without names all are LINEAR. */
static void read_kinds(nkwi_collada *c, const xmlNode *sampler, unsigned char *kinds, size_t count)
{
    static const char *const names[] = {"LINEAR", "STEP", "BEZIER", "HERMITE", "TCB"};
    const xmlNode *tag = nkwi_collada_input(c, sampler, "INTERPOLATION");
    const xmlNode *array = nkwi_collada_child(tag, "Name_array");
    xmlChar *content = tag ? xmlNodeGetContent(array ? array : nkwi_collada_child(tag, "IDREF_array")) : NULL;
    const char *at = (const char *)content;
    for (size_t i = 0; at && i < count && *(at += strspn(at, " \t\r\n")); i++) {
        const size_t length = strcspn(at, " \t\r\n");
        kinds[i] = LINEAR;
        while (kinds[i] < OTHER && (strlen(names[kinds[i]]) != length || memcmp(at, names[kinds[i]], length) != 0))
            kinds[i]++;
        at += length;
    }
    xmlFree(content);
}

/* ---- tangents ---- */

/* What makes the handles of a curve. */
typedef struct tangents {
    source in, out; /* IN_TANGENT, OUT_TANGENT: values, or pairs of time and value */
    float *tcb_in, *tcb_out; /* of TCB, per second; or NULL */
} tangents;

/* A tangent of a number of a key: its time and value. 0 where there is none. */
static int tangent_of(const source *s, size_t key, size_t width, size_t number, float third, nkw_handle *out)
{
    if (key >= s->count || (s->width != width && s->width != 2 * width))
        return 0;
    const float *v = s->numbers + key * s->width;
    const int pairs = s->width == 2 * width;
    out->time = pairs ? v[2 * number] : third;
    out->value = v[pairs ? 2 * number + 1 : number];
    return isfinite(out->time) && isfinite(out->value);
}

/* The handles of segment i; 0 where the file states none. */
static int read_handles(const nkwi_collada_curve *c, const tangents *t, int kind, size_t i, size_t number,
                        nkw_handle *out, nkw_handle *in)
{
    const float time0 = c->times[i], time1 = c->times[i + 1], third = (time1 - time0) / 3.0f;
    const float value0 = c->values[i * c->width + number], value1 = c->values[(i + 1) * c->width + number];
    if (kind == TCB) {
        const nkw_handle first = {third, third * t->tcb_out[i * c->width + number]};
        const nkw_handle last = {-third, -third * t->tcb_in[(i + 1) * c->width + number]};
        *out = first, *in = last;
        return 1;
    }
    const float out_third = kind == BEZIER ? time0 + third : 3.0f * third;
    const float in_third = kind == BEZIER ? time1 - third : 3.0f * third;
    if (!tangent_of(&t->out, i, c->width, number, out_third, out) ||
        !tangent_of(&t->in, i + 1, c->width, number, in_third, in))
        return 0;
    if (kind == BEZIER) {
        out->time -= time0, out->value -= value0;
        in->time -= time1, in->value -= value1;
    } else {
        out->time /= 3.0f, out->value /= 3.0f;
        in->time /= -3.0f, in->value /= -3.0f;
    }
    return 1;
}

/* A parameter of TCB; 0 where the file states none. */
static int read_parameter(nkwi_collada *c, const xmlNode *sampler, const char *semantic, float *out, size_t count)
{
    source s;
    if (!read_input(c, sampler, semantic, &s))
        return 0;
    for (size_t i = 0; i < count && i < s.count; i++)
        out[i * sizeof(nkw_tcb) / sizeof(float)] = isfinite(s.numbers[i * s.width]) ? s.numbers[i * s.width] : 0.0f;
    return 1;
}

static int read_tcb(nkwi_collada *c, const xmlNode *sampler, const nkwi_collada_curve *curve, tangents *t)
{
    const size_t n = curve->count * curve->width;
    nkw_tcb *tcb = (nkw_tcb *)nkwi_take(c->memory, curve->count, sizeof *tcb);
    t->tcb_in = (float *)nkwi_take(c->memory, n, sizeof(float));
    t->tcb_out = (float *)nkwi_take(c->memory, n, sizeof(float));
    if (!tcb || !t->tcb_in || !t->tcb_out ||
        !read_parameter(c, sampler, "TENSION", &tcb->tension, curve->count) ||
        !read_parameter(c, sampler, "CONTINUITY", &tcb->continuity, curve->count) ||
        !read_parameter(c, sampler, "BIAS", &tcb->bias, curve->count))
        return 0;
    const nkw_spline spline = {curve->times,  curve->values,  curve->count,          curve->width, curve->width,
                               NKW_SPLINE_TCB, NKW_SPLINE_ENDS_FREE, 0.0f, tcb, NULL};
    const nkw_tangent_span span = {t->tcb_in, t->tcb_out, curve->width};
    const nkw_work none = {NULL, 0};
    nkw_spline_tangents(&spline, span, NULL, none); /* times that do not ascend were refused before */
    return 1;
}

/* Kinds of the file become LINEAR, STEP and CUBIC with handles. */
static int read_tangents(nkwi_collada *c, const xmlNode *sampler, nkwi_collada_curve *curve, unsigned char *kinds)
{
    tangents t;
    int has_cubic = 0, has_tcb = 0, other = 0, missing = 0;
    memset(&t, 0, sizeof t);
    for (size_t i = 0; i < curve->count; i++) {
        has_tcb |= kinds[i] == TCB;
        has_cubic |= kinds[i] == BEZIER || kinds[i] == HERMITE || kinds[i] == TCB;
        other |= kinds[i] == OTHER;
    }
    const size_t n = has_cubic ? curve->count * curve->width : 0;
    nkw_handle *out = (nkw_handle *)nkwi_take(c->memory, n, sizeof *out);
    nkw_handle *in = (nkw_handle *)nkwi_take(c->memory, n, sizeof *in);
    if (!out || !in || !read_input(c, sampler, "IN_TANGENT", &t.in) || !read_input(c, sampler, "OUT_TANGENT", &t.out) ||
        (has_tcb && !read_tcb(c, sampler, curve, &t)))
        return 0;
    for (size_t i = 0; i < curve->count; i++) {
        const int kind = kinds[i];
        int cubic = kind >= BEZIER && kind <= TCB && i + 1 < curve->count;
        for (size_t k = 0; k < curve->width && cubic; k++)
            cubic = read_handles(curve, &t, kind, i, k, &out[i * curve->width + k], &in[i * curve->width + k]);
        missing |= kind >= BEZIER && kind <= TCB && !cubic && i + 1 < curve->count;
        kinds[i] = cubic ? NKWI_COLLADA_CUBIC : kind == STEP ? NKWI_COLLADA_STEP : NKWI_COLLADA_LINEAR;
    }
    curve->out = out;
    curve->in = in;
    c->unread_kinds += (size_t)other;
    c->no_tangents += (size_t)missing;
    return 1;
}

/* ---- curves ---- */

static int is_good(const source *times, const source *values, size_t count)
{
    for (size_t i = 0; i < count; i++)
        if (!isfinite(times->numbers[i * times->width]) ||
            (i > 0 && times->numbers[i * times->width] < times->numbers[(i - 1) * times->width]))
            return 0;
    for (size_t i = 0; i < count * values->width; i++)
        if (!isfinite(values->numbers[i]))
            return 0;
    return 1;
}

const nkwi_collada_curve *nkwi_collada_curve_read(nkwi_collada *c, const xmlNode *sampler, const char **reason)
{
    source times, values;
    nkwi_collada_curve curve;
    memset(&curve, 0, sizeof curve);
    *reason = NULL;
    if (!read_input(c, sampler, "INPUT", &times) || !read_input(c, sampler, "OUTPUT", &values))
        return NULL;
    curve.count = times.count < values.count ? times.count : values.count;
    curve.width = values.width;
    *reason = "its sampler has no keys";
    if (curve.count == 0)
        return NULL;
    *reason = "its keys are not finite, or not in the order of their times";
    c->bad_curves += (size_t)!is_good(&times, &values, curve.count);
    if (!is_good(&times, &values, curve.count))
        return NULL;
    *reason = NULL;
    for (size_t i = 0; i < curve.count; i++)
        times.numbers[i] = times.numbers[i * times.width];
    curve.times = times.numbers;
    curve.values = values.numbers;
    unsigned char *kinds = (unsigned char *)nkwi_take(c->memory, curve.count, 1);
    nkwi_collada_curve *out = (nkwi_collada_curve *)nkwi_take(c->memory, 1, sizeof *out);
    if (!kinds || !out)
        return NULL;
    curve.kinds = kinds;
    read_kinds(c, sampler, kinds, curve.count);
    if (!read_tangents(c, sampler, &curve, kinds))
        return NULL;
    int cubic = 0;
    for (size_t i = 0; i < curve.count; i++)
        cubic |= kinds[i] == NKWI_COLLADA_CUBIC;
    curve.keys = curve.width == 16 && !cubic ? nkwi_collada_matrix_keys(c, curve.values, curve.count) : NULL;
    *out = curve;
    return curve.width == 16 && !cubic && !curve.keys ? NULL : out;
}

size_t nkwi_collada_segment(const nkwi_collada_curve *c, float time, float *part)
{
    *part = 0.0f;
    if (!(time >= c->times[0]) || c->count == 1)
        return 0;
    if (time >= c->times[c->count - 1])
        return c->count - 1;
    const nkw_segment s = nkw_segment_find(c->times, c->count, time);
    *part = s.t;
    return s.index;
}

void nkwi_collada_sample(const nkwi_collada_curve *c, float time, float *out)
{
    float part;
    const size_t i = nkwi_collada_segment(c, time, &part), w = c->width;
    const float *a = c->values + i * w, *b = a + w;
    for (size_t k = 0; k < w; k++) {
        if (!(part > 0.0f) || c->kinds[i] == NKWI_COLLADA_STEP)
            out[k] = a[k];
        else if (c->kinds[i] == NKWI_COLLADA_LINEAR)
            out[k] = nkw_lerp(a[k], b[k], part);
        else {
            const nkw_handle_segment s = {c->times[i],         a[k], c->out[i * w + k], c->in[i * w + k],
                                          c->times[i + 1], b[k]};
            out[k] = nkw_handle_sample(&s, time).value;
        }
    }
}
