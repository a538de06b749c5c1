/* SPDX-License-Identifier: MIT */
/*
 * A glTF file while it is written (sink.h): one buffer that only grows, and the lists that point into it.
 *
 * Invariant: what is appended begins at a multiple of 4 bytes, the largest component of glTF, and never moves. After a
 * failure (`failed`, no memory) all functions still return, and the caller tests once at the end.
 *
 *     data         | positions | indices | image . | times 0 | values 0 | values 1 | times 2 | ...  |  room |
 *     views        |  view 0   | view 1  | view 2  | view 3: the keys of all tracks, open           |
 *     accessors    |    0      |    1    |         |    2    |     3    |    4     |    5    | ...
 *
 * Numbers and bytes have a view each, images no accessor. Accessors of keys share one view, and their offsets count
 * from its start. Tracks whose times are equal share an accessor: here 3 and 4 have the times 2.
 *
 * Keys of the library and of glTF (3.11) differ in three ways, which `convert` removes:
 *
 *                     library                              glTF
 *     equal times     allowed: the value jumps             times ascend strictly
 *     interpolation   one for each segment, if any         one for the sampler
 *     rotations       may be normalised at use             unit
 *
 *     jump at t          ... (t, a) (t, b) ...             (below(t), a) (t, b)
 *     STEP k..k + 1      (t0, a) (t1, b), sampler LINEAR   (t0, a) (below(t1), a) (t1, b)
 *     LINEAR k..k + 1    in a sampler of CUBICSPLINE       both tangents (b - a)/(t1 - t0), per second
 *
 * below(t) is the float before t, so no time between two floats is lost. Memory: at most two keys for each.
 */
#include <stdlib.h>
#include <string.h>

#include <nakawari/quat.h>

#include "file.h"
#include "sink.h"

void nkwi_sink_open(nkwi_sink *s, nkw_import_error *error, json_t *views, json_t *accessors)
{
    memset(s, 0, sizeof *s);
    s->error = error;
    s->views = views;
    s->accessors = accessors;
    s->scratch.most = SIZE_MAX;
    s->failed = !views || !accessors;
}

void nkwi_sink_close(nkwi_sink *s)
{
    nkwi_give(&s->scratch);
    free(s->known);
    free(s->data);
}

void nkwi_set(nkwi_sink *s, json_t *object, const char *key, json_t *value)
{
    if (json_object_set_new(object, key, value) != 0)
        s->failed = 1;
}

void nkwi_put(nkwi_sink *s, json_t *array, json_t *value)
{
    if (json_array_append_new(array, value) != 0)
        s->failed = 1;
}

/* JSON has no number for an infinity or NaN: x - x is 0 only of a finite x. */
json_t *nkwi_real(double number)
{
    return json_real(number - number == 0.0 ? number : 0.0);
}

/* Jansson refuses text that is not UTF-8; then each byte from 128 on becomes a question mark. */
json_t *nkwi_string(nkwi_sink *s, const char *text)
{
    json_t *string = json_string(text);
    char *copy = string ? NULL : nkwi_copy(&s->scratch, text);
    for (char *c = copy; c && *c; c++)
        *c = (char)((unsigned char)*c < 0x80 ? *c : '?');
    return copy ? json_string(copy) : string;
}

/* RFC 3986, 2.3: the unreserved characters, and the separator of a path. A byte becomes at most three. */
json_t *nkwi_uri(nkwi_sink *s, const char *path)
{
    static const char plain[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_.~/";
    static const char digits[] = "0123456789ABCDEF";
    char *uri = (char *)nkwi_take(&s->scratch, 3 * strlen(path) + 1, 1), *to = uri;
    for (; uri && *path; path++) {
        const unsigned char c = (unsigned char)*path;
        if (strchr(plain, c)) {
            *to++ = (char)c;
            continue;
        }
        *to++ = '%';
        *to++ = digits[c >> 4];
        *to++ = digits[c & 15];
    }
    return uri ? json_string(uri) : NULL;
}

json_t *nkwi_floats_of(nkwi_sink *s, const float *values, size_t count)
{
    json_t *list = json_array();
    for (size_t i = 0; i < count; i++)
        nkwi_put(s, list, nkwi_real((double)values[i]));
    return list;
}

/*
 * Makes room for `bytes` more, and for padding before them. The room doubles, so a file of n bytes is
 * copied less than 2 n bytes in all.
 */
static int grow(nkwi_sink *s, size_t bytes)
{
    size_t room = s->room ? s->room : 4096;
    if (s->failed || bytes > NKWI_BYTES_MOST - s->bytes - 4) {
        s->failed = 1;
        return 0;
    }
    while (room < s->bytes + bytes + 4)
        room *= 2;
    if (room == s->room)
        return 1;
    unsigned char *wider = (unsigned char *)realloc(s->data, room);
    s->failed = wider == NULL;
    if (!wider)
        return 0;
    s->data = wider;
    s->room = room;
    return 1;
}

size_t nkwi_sink_append(nkwi_sink *s, const void *data, size_t bytes)
{
    if (!grow(s, bytes))
        return 0;
    while (s->bytes % 4 != 0)
        s->data[s->bytes++] = 0;
    size_t at = s->bytes;
    if (bytes > 0)
        memcpy(s->data + at, data, bytes);
    s->bytes += bytes;
    return at;
}

static size_t size_of(nkwi_component component)
{
    return component == NKWI_I8 || component == NKWI_U8 ? 1 : component == NKWI_I16 || component == NKWI_U16 ? 2 : 4;
}

/* glTF is little-endian. */
static void to_little_endian(unsigned char *data, size_t size, size_t count)
{
    const uint16_t one = 1;
    unsigned char low;
    memcpy(&low, &one, 1);
    for (size_t i = 0; !low && i < count; i++)
        for (size_t k = 0; k < size / 2; k++) {
            unsigned char *a = data + i * size + k, *b = data + i * size + (size - 1 - k), c = *a;
            *a = *b;
            *b = c;
        }
}

/* Components of more than a byte are converted where they are appended; the caller's array remains as it is. */
static size_t append_numbers(nkwi_sink *s, const nkwi_numbers *n)
{
    const size_t size = size_of(n->component), count = n->width * n->count;
    size_t at = nkwi_sink_append(s, n->data, size * count);
    if (!s->failed && size > 1)
        to_little_endian(s->data + at, size, count);
    return at;
}

static double number_at(const nkwi_numbers *n, size_t i)
{
    return n->component == NKWI_F32   ? (double)((const float *)n->data)[i]
           : n->component == NKWI_U32 ? (double)((const uint32_t *)n->data)[i]
                                      : (double)((const uint16_t *)n->data)[i];
}

/* The least and the greatest of each component: required of positions (3.7.2.1) and of key times (3.11). */
static void set_bounds(nkwi_sink *s, json_t *accessor, const nkwi_numbers *n)
{
    json_t *low = json_array(), *high = json_array();
    for (size_t c = 0; c < n->width; c++) {
        double least = number_at(n, c), greatest = least;
        for (size_t i = c; i < n->width * n->count; i += n->width) {
            double x = number_at(n, i);
            least = x < least ? x : least;
            greatest = x > greatest ? x : greatest;
        }
        nkwi_put(s, low, nkwi_real(least));
        nkwi_put(s, high, nkwi_real(greatest));
    }
    nkwi_set(s, accessor, "min", low);
    nkwi_set(s, accessor, "max", high);
}

/* An accessor of n: `offset` in bytes from the start of the view. types: by the number of components. */
static json_t *accessor_of(nkwi_sink *s, const nkwi_numbers *n, size_t view, size_t offset)
{
    static const char *const types[17] = {NULL, "SCALAR", "VEC2", "VEC3", "VEC4", NULL, NULL, NULL,  NULL,
                                          NULL, NULL,     NULL,   NULL,   NULL,   NULL, NULL, "MAT4"};
    json_t *a = json_object();
    nkwi_set(s, a, "bufferView", json_integer((json_int_t)view));
    if (offset)
        nkwi_set(s, a, "byteOffset", json_integer((json_int_t)offset));
    nkwi_set(s, a, "componentType", json_integer(n->component));
    if (n->normalized)
        nkwi_set(s, a, "normalized", json_true());
    nkwi_set(s, a, "count", json_integer((json_int_t)n->count));
    nkwi_set(s, a, "type", json_string(types[n->width]));
    if (n->bounds && n->count > 0)
        set_bounds(s, a, n);
    return a;
}

/* A view of the one buffer: start and bytes in bytes. target: 34962, 34963 or 0 (sink.h). */
static json_t *view_of(nkwi_sink *s, size_t start, size_t bytes, int target)
{
    json_t *view = json_object();
    nkwi_set(s, view, "buffer", json_integer(0));
    nkwi_set(s, view, "byteOffset", json_integer((json_int_t)start));
    nkwi_set(s, view, "byteLength", json_integer((json_int_t)bytes));
    if (target)
        nkwi_set(s, view, "target", json_integer(target));
    return view;
}

size_t nkwi_sink_numbers(nkwi_sink *s, const nkwi_numbers *n)
{
    size_t view = json_array_size(s->views), index = json_array_size(s->accessors), at = append_numbers(s, n);
    nkwi_put(s, s->views, view_of(s, at, s->bytes - at, n->target));
    nkwi_put(s, s->accessors, accessor_of(s, n, view, 0));
    return index;
}

size_t nkwi_sink_bytes(nkwi_sink *s, const void *data, size_t bytes)
{
    const size_t view = json_array_size(s->views), at = nkwi_sink_append(s, data, bytes);
    nkwi_put(s, s->views, view_of(s, at, bytes, 0));
    return view;
}

/* By the first bytes: JPEG begins with FF D8 and another marker FF, PNG with 89 50 4E 47. */
const char *nkwi_image_type(const void *data, size_t bytes)
{
    return bytes > 3 && memcmp(data, "\xff\xd8\xff", 3) == 0 ? "image/jpeg"
           : bytes > 8 && memcmp(data, "\x89PNG", 4) == 0    ? "image/png"
                                                             : NULL;
}

/* The view of keys is not in the list before its length is known; its index is that of the next view. */
void nkwi_sink_begin_keys(nkwi_sink *s)
{
    s->view_index = json_array_size(s->views);
    s->view_start = nkwi_sink_append(s, NULL, 0);
    s->view = view_of(s, s->view_start, 0, 0);
}

void nkwi_sink_end_keys(nkwi_sink *s)
{
    if (s->bytes > s->view_start) {
        nkwi_set(s, s->view, "byteLength", json_integer((json_int_t)(s->bytes - s->view_start)));
        nkwi_put(s, s->views, s->view);
    } else
        json_decref(s->view); /* 3.6.1: a view has at least one byte */
    s->view = NULL;
}

/* An accessor in the view of keys that is open. Returns its index. */
static size_t add_keys(nkwi_sink *s, const nkwi_numbers *n)
{
    size_t index = json_array_size(s->accessors), at = append_numbers(s, n);
    nkwi_put(s, s->accessors, accessor_of(s, n, s->view_index, at - s->view_start));
    return index;
}

/* ---- keys as glTF has them: times that ascend strictly, one interpolation ---- */

/*
 * Accessors of keys that exist already: key times are the same where their numbers are, values where the track has the
 * same array. count: keys as written; size: floats of a key, 3 widths of CUBICSPLINE.
 */
typedef struct nkwi_known {
    const float *times, *values; /* as written */
    size_t count, size, width; /* keys, numbers of a key and of an element */
    nkw_track_kind kind;
    nkwi_component component;
    size_t time_accessor, value_accessor;
} nkwi_known;

/*
 * Keys as glTF has them, in scratch memory for 2 * t->count of them.
 *
 *     times     seconds, strictly ascending
 *     values    of each key `width` floats; of CUBICSPLINE 3 widths: in-tangent, value, out-tangent (per second)
 *     mode      of the whole sampler
 */
typedef struct keys {
    float *times, *values;
    size_t count;
    nkw_interpolation mode;
} keys;

static nkw_interpolation mode_at(const nkw_track *t, size_t k)
{
    return t->key_interpolation ? (nkw_interpolation)t->key_interpolation[k] : t->interpolation;
}

/*
 * The one mode of all segments; otherwise that of the layout, LINEAR for a STEP layout of other modes. A LINEAR sampler
 * can show STEP segments by a key more, a STEP sampler no LINEAR ones.
 */
static nkw_interpolation mode_of(const nkw_track *t)
{
    int same = 1;
    for (size_t k = 1; k + 1 < t->count; k++)
        same = same && mode_at(t, k) == mode_at(t, 0);
    if (t->interpolation == NKW_INTERPOLATION_CUBICSPLINE)
        return NKW_INTERPOLATION_CUBICSPLINE;
    return same && t->count > 0 ? mode_at(t, 0) : NKW_INTERPOLATION_LINEAR;
}

/* The next float below a finite one. Bits of positive floats ascend with the number, those of negative ones descend. */
static float below(float x)
{
    uint32_t bits;
    memcpy(&bits, &x, sizeof bits);
    if (x == 0.0f)
        bits = 0x80000001u;
    else
        bits = x > 0.0f ? bits - 1 : bits + 1;
    memcpy(&x, &bits, sizeof x);
    return x;
}

static int is_cubic(const nkw_track *t)
{
    return t->interpolation == NKW_INTERPOLATION_CUBICSPLINE;
}

/* Adds a key if it is later than the last one. */
static void add_key(keys *out, const nkw_track *t, float time, const float *key)
{
    const size_t size = t->width * (is_cubic(t) ? 3 : 1);
    if (out->count > 0 && !(time > out->times[out->count - 1]))
        return;
    out->times[out->count] = time;
    memcpy(out->values + size * out->count, key, size * sizeof *key);
    out->count++;
}

/*
 * All keys in their order, into memory for twice as many: a key adds at most one before the next.
 *
 * A STEP segment of CUBICSPLINE keys is a cubic whose ends are equal and whose tangents are 0: the out-tangent of its
 * first key, from (3 at + 2) widths on, and the in-tangent of the key that was added, the floats after it.
 */
static void convert(const nkw_track *t, keys *out)
{
    const size_t size = t->width * (is_cubic(t) ? 3 : 1);
    const int mixed = out->mode != NKW_INTERPOLATION_STEP && t->key_interpolation;
    for (size_t k = 0; k < t->count; k++) {
        const float *key = t->values + size * k;
        const size_t at = out->count;
        const int jumps = k + 1 < t->count && t->times[k] == t->times[k + 1];
        add_key(out, t, jumps ? below(t->times[k]) : t->times[k], key);
        if (!mixed || jumps || k + 1 == t->count || out->count == at)
            continue;
        if (mode_at(t, k) == NKW_INTERPOLATION_STEP)
            add_key(out, t, below(t->times[k + 1]), key);
        if (is_cubic(t) && out->count == at + 2)
            memset(out->values + (3 * at + 2) * t->width, 0, 2 * t->width * sizeof(float));
    }
}

/*
 * The tangents of lines between cubics of numbers: the slope, after key `at` and before the next. Hermite with both
 * tangents equal to the chord's slope is the chord itself.
 *
 *     floats of keys at, at + 1, in widths     in  value  out | in  value  out
 *                                              3at        +2    +3
 */
static void set_slope(const nkw_track *t, size_t k, keys *out, size_t at)
{
    const float *a = t->values + (3 * k + 1) * t->width, *b = a + 3 * t->width;
    const double duration = (double)t->times[k + 1] - (double)t->times[k];
    for (size_t i = 0; i < t->width; i++) {
        float slope = (float)(((double)b[i] - (double)a[i]) / duration);
        out->values[(3 * at + 2) * t->width + i] = slope;
        out->values[(3 * at + 3) * t->width + i] = slope;
    }
}

/* k counts keys of the track, at those of the sampler: as many or more, since STEP segments add keys. */
static void set_slopes(const nkw_track *t, keys *out)
{
    for (size_t k = 0, at = 0; t->key_interpolation && is_cubic(t) && k + 1 < t->count; k++) {
        while (at < out->count && out->times[at] < t->times[k])
            at++;
        if (mode_at(t, k) == NKW_INTERPOLATION_LINEAR && t->times[k] < t->times[k + 1] && at + 1 < out->count)
            set_slope(t, k, out, at);
    }
}

/*
 * The keys of a sampler. A rotation between CUBICSPLINE keys is refused where it is LINEAR: its slerp is no Hermite
 * curve of four numbers, whatever the tangents are.
 */
static int prepare(nkwi_sink *s, const nkw_clip_track *track, const nkwi_place *place, keys *out)
{
    const nkw_track *t = &track->track;
    const size_t size = t->width * (is_cubic(t) ? 3 : 1);
    out->count = 0;
    out->mode = mode_of(t);
    for (size_t k = 0; is_cubic(t) && track->target == NKW_CLIP_ROTATION && k + 1 < t->count; k++)
        if (mode_at(t, k) == NKW_INTERPOLATION_LINEAR)
            return nkwi_fail(s->error, place, NKW_IMPORT_UNSUPPORTED,
                             "glTF has no rotation that is LINEAR after key %zu and CUBICSPLINE elsewhere", k);
    out->times = (float *)nkwi_take(&s->scratch, 2 * t->count, sizeof(float));
    out->values = (float *)nkwi_take(&s->scratch, 2 * t->count * size, sizeof(float));
    s->failed = s->failed || !out->times || !out->values;
    if (s->failed)
        return 0;
    convert(t, out);
    set_slopes(t, out);
    return 1;
}

/* The least and the greatest integer of a normalised component type. */
static int range_of(nkwi_component component, float *low, float *high)
{
    *low = component == NKWI_I8 ? -127.0f : component == NKWI_I16 ? -32767.0f : 0.0f;
    *high = component == NKWI_I8 ? 127.0f : component == NKWI_U8 ? 255.0f : component == NKWI_I16 ? 32767.0f : 65535.0f;
    return component == NKWI_I8 || component == NKWI_U8 || component == NKWI_I16 || component == NKWI_U16;
}

/*
 * Integers of values in -1..1 or 0..1, normalised (3.11): x / high is the value of the integer x, as reading decodes
 * it. Returns 0 if a value is none of them, so nothing is lost: a file that had integers keeps them only where exact.
 *
 *     component   I8          U8         I16             U16
 *     x           -127..127   0..255     -32767..32767   0..65535
 */
static int encode(const float *values, size_t count, nkwi_component component, unsigned char *out)
{
    float low, high;
    if (!range_of(component, &low, &high))
        return 0;
    for (size_t i = 0; i < count; i++) {
        float scaled = values[i] * high, code = (float)(int32_t)(scaled < 0.0f ? scaled - 0.5f : scaled + 0.5f);
        if (!(scaled >= low - 0.5f && scaled <= high + 0.5f) || code / high != values[i])
            return 0;
        const int16_t word = (int16_t)(uint16_t)(int32_t)code;
        if (high < 256.0f)
            out[i] = (unsigned char)(word & 0xff);
        else
            memcpy(out + 2 * i, &word, 2);
    }
    return 1;
}

/* Quaternions that the track normalises before use. Written as floats they are unit for every reader. */
static void normalize(const nkw_track *t, const keys *k)
{
    const size_t size = t->width * (is_cubic(t) ? 3 : 1), value = is_cubic(t) ? t->width : 0;
    for (size_t i = 0; i < k->count; i++) {
        nkw_quat q;
        memcpy(&q, k->values + size * i + value, sizeof q);
        q = nkw_quat_normalize(q);
        memcpy(k->values + size * i + value, &q, sizeof q);
    }
}

/*
 * The accessor of the values: integers of the type `component` where they are exact, otherwise floats. width: numbers
 * of an element, 3 or 4, and 1 of morph weights, whose accessor is a list of scalars (3.11).
 */
static size_t values_accessor(nkwi_sink *s, const nkw_track *t, const keys *k, size_t width, nkwi_component component)
{
    const size_t count = k->count * t->width * (is_cubic(t) ? 3 : 1);
    nkwi_numbers numbers = {NKWI_F32, 0, width, count / width, k->values, 0, 0};
    unsigned char *codes = (unsigned char *)nkwi_take(&s->scratch, count, 2);
    if (codes && encode(k->values, count, component, codes)) {
        numbers.component = component;
        numbers.normalized = 1;
        numbers.data = codes;
    } else if (t->kind == NKW_TRACK_ROTATION_NORMALIZED) {
        normalize(t, k);
    }
    return add_keys(s, &numbers);
}

/* Adds to the list of known accessors, whose room doubles from 64 on. */
static int remember(nkwi_sink *s, const nkwi_known *known)
{
    if (s->known_count == s->known_room) {
        size_t room = s->known_room ? 2 * s->known_room : 64;
        nkwi_known *wider = (nkwi_known *)realloc(s->known, room * sizeof *wider);
        if (!wider)
            return 0;
        s->known = wider;
        s->known_room = room;
    }
    s->known[s->known_count++] = *known;
    return 1;
}

static int same_times(const nkwi_known *a, const keys *k)
{
    return a->count == k->count && memcmp(a->times, k->times, k->count * sizeof *k->times) == 0;
}

/* Whether the values of a known accessor are those of `found`, and would be written with the same type. */
static int same_values(const nkwi_known *a, const nkwi_known *found)
{
    return a->count == found->count && a->size == found->size && a->width == found->width && a->kind == found->kind &&
           a->component == found->component &&
           memcmp(a->values, found->values, found->count * found->size * sizeof *found->values) == 0;
}

/*
 * The accessors of the keys, which several tracks may share: known times and known values that are equal byte for byte,
 * each for itself. A linear search, in which most arrays differ in their first bytes.
 */
static nkwi_known accessors_of(nkwi_sink *s, const nkw_track *t, const keys *k, size_t width, nkwi_component component)
{
    const size_t size = t->width * (is_cubic(t) ? 3 : 1);
    nkwi_known found = {k->times, k->values, k->count, size, width, t->kind, component, SIZE_MAX, SIZE_MAX};
    if (t->kind == NKW_TRACK_ROTATION_NORMALIZED && component == NKWI_F32)
        normalize(t, k);
    for (size_t i = 0; i < s->known_count; i++) {
        const nkwi_known *known = &s->known[i];
        if (found.time_accessor == SIZE_MAX && same_times(known, k))
            found.time_accessor = known->time_accessor;
        if (found.value_accessor == SIZE_MAX && same_values(known, &found))
            found.value_accessor = known->value_accessor;
    }
    const nkwi_numbers times = {NKWI_F32, 0, 1, k->count, k->times, 1, 0};
    const int is_known = found.time_accessor != SIZE_MAX && found.value_accessor != SIZE_MAX;
    if (found.time_accessor == SIZE_MAX)
        found.time_accessor = add_keys(s, &times);
    if (found.value_accessor == SIZE_MAX)
        found.value_accessor = values_accessor(s, t, k, width, component);
    s->failed = s->failed || (!is_known && !remember(s, &found));
    return found;
}

json_t *nkwi_sink_sampler(nkwi_sink *s, const nkw_clip_track *track, const nkwi_place *place, nkwi_component component)
{
    static const char *const names[] = {"LINEAR", "STEP", "CUBICSPLINE"};
    keys k = {NULL, NULL, 0, NKW_INTERPOLATION_LINEAR};
    if (!prepare(s, track, place, &k))
        return NULL;
    const size_t width = track->target == NKW_CLIP_FLOATS ? 1 : track->target == NKW_CLIP_ROTATION ? 4 : 3;
    const nkwi_known known = accessors_of(s, &track->track, &k, width, component);
    json_t *sampler = json_object();
    nkwi_set(s, sampler, "input", json_integer((json_int_t)known.time_accessor));
    nkwi_set(s, sampler, "output", json_integer((json_int_t)known.value_accessor));
    nkwi_set(s, sampler, "interpolation", json_string(names[k.mode]));
    return sampler;
}
