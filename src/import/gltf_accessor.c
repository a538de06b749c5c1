/* SPDX-License-Identifier: MIT */
/* glTF 2.0, 3.6: accessors: strides, sparse elements, normalised integers. */
#include <string.h>

#include "gltf.h"

static size_t bytes_of(nkwi_component component)
{
    switch (component) {
    case NKWI_I8:
    case NKWI_U8:
        return 1;
    case NKWI_I16:
    case NKWI_U16:
        return 2;
    case NKWI_U32:
    case NKWI_F32:
        return 4;
    default:
        return 0;
    }
}

static int component_of(nkwi_gltf *g, const nkwi_value *object, nkwi_component *out)
{
    nkwi_value value = nkwi_member(object, "componentType");
    size_t number;
    if (!nkwi_integer(g->error, &value, &number))
        return 0;
    *out = (nkwi_component)(number <= NKWI_F32 ? number : 0);
    return bytes_of(*out) > 0 ||
           nkwi_fail(g->error, &value.place, NKW_IMPORT_INVALID, "%zu is no component type", number);
}

/*
 * The elements of a part of a buffer view, which must be inside the view, and the view inside its buffer. e: count and
 * size are set; receives data and stride. object: has bufferView and byteOffset.
 */
static int find_elements(nkwi_gltf *g, const nkwi_value *object, nkwi_elements *e)
{
    int32_t view_index, buffer_index;
    size_t view_offset, view_bytes, offset;
    nkwi_buffer buffer;
    nkwi_value length, at = nkwi_member(object, "bufferView");
    if (!nkwi_needed_index(g->error, object, "bufferView", "buffer view", nkwi_length(&g->view_list), &view_index))
        return 0;
    nkwi_value view = nkwi_element(&g->view_list, (size_t)view_index);
    length = nkwi_member(&view, "byteLength");
    if (!nkwi_is_object(g->error, &view) || !nkwi_integer(g->error, &length, &view_bytes) ||
        !nkwi_needed_index(g->error, &view, "buffer", "buffer", nkwi_length(&g->buffer_list), &buffer_index) ||
        !nkwi_count(g->error, &view, "byteOffset", 0, &view_offset) ||
        !nkwi_count(g->error, &view, "byteStride", 0, &e->stride) ||
        !nkwi_count(g->error, object, "byteOffset", 0, &offset) || !nkwi_gltf_buffer(g, (size_t)buffer_index, &buffer))
        return 0;
    if (view_bytes > buffer.bytes || view_offset > buffer.bytes - view_bytes)
        return nkwi_fail(g->error, &view.place, NKW_IMPORT_INVALID, "ends after its buffer of %zu bytes", buffer.bytes);
    e->stride = e->stride ? e->stride : e->size;
    if (e->stride < e->size)
        return nkwi_fail(g->error, &view.place, NKW_IMPORT_INVALID, "has a stride of %zu bytes for elements of %zu",
                         e->stride, e->size);
    if (e->size > view_bytes || offset > view_bytes - e->size ||
        (view_bytes - e->size - offset) / e->stride < e->count - 1)
        return nkwi_fail(g->error, &at.place, NKW_IMPORT_INVALID,
                         "%zu elements do not fit: the buffer view has %zu bytes", e->count, view_bytes);
    e->data = buffer.data + view_offset + offset;
    return 1;
}

int nkwi_gltf_view(nkwi_gltf *g, const nkwi_value *object, const unsigned char **data, size_t *bytes)
{
    int32_t index;
    nkwi_elements e = {NULL, 0, 1, 0};
    if (!nkwi_needed_index(g->error, object, "bufferView", "buffer view", nkwi_length(&g->view_list), &index))
        return 0;
    nkwi_value view = nkwi_element(&g->view_list, (size_t)index), length = nkwi_member(&view, "byteLength");
    if (!nkwi_integer(g->error, &length, &e.count) || !find_elements(g, object, &e))
        return 0;
    *data = e.data;
    *bytes = e.count;
    return e.stride == 1 || nkwi_fail(g->error, &view.place, NKW_IMPORT_INVALID, "has a stride and is no array");
}

static int open_sparse(nkwi_gltf *g, const nkwi_value *object, nkwi_accessor *a)
{
    nkwi_value sparse = nkwi_member(object, "sparse"), indices = nkwi_member(&sparse, "indices");
    nkwi_value values = nkwi_member(&sparse, "values"), count = nkwi_member(&sparse, "count");
    if (!sparse.json)
        return 1;
    if (!nkwi_is_object(g->error, &sparse) || !nkwi_is_object(g->error, &indices) ||
        !nkwi_is_object(g->error, &values) || !nkwi_integer(g->error, &count, &a->sparse_count) ||
        !component_of(g, &indices, &a->sparse_component))
        return 0;
    if (a->sparse_count == 0 || a->sparse_count > a->elements.count)
        return nkwi_fail(g->error, &count.place, NKW_IMPORT_INVALID, "%zu is not 1 .. %zu, the number of elements",
                         a->sparse_count, a->elements.count);
    if (a->sparse_component != NKWI_U8 && a->sparse_component != NKWI_U16 && a->sparse_component != NKWI_U32)
        return nkwi_fail(g->error, &indices.place, NKW_IMPORT_INVALID, "are not unsigned integers");
    a->sparse_indices.count = a->sparse_values.count = a->sparse_count;
    a->sparse_indices.size = bytes_of(a->sparse_component);
    a->sparse_values.size = a->elements.size;
    return find_elements(g, &indices, &a->sparse_indices) && find_elements(g, &values, &a->sparse_values);
}

static size_t width_of(const char *type)
{
    static const struct {
        const char *type;
        size_t width;
    } types[] = {{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}, {"MAT4", 16}};
    for (size_t i = 0; i < sizeof types / sizeof *types; i++)
        if (strcmp(type, types[i].type) == 0)
            return types[i].width;
    return 0; /* MAT2 and MAT3: nothing that is read has these */
}

static int open_accessor(nkwi_gltf *g, const nkwi_value *object, nkwi_accessor *a)
{
    nkwi_value count = nkwi_member(object, "count"), type = nkwi_member(object, "type");
    const char *name = nkwi_text(object, "type", "");
    if (!nkwi_is_object(g->error, object) || !nkwi_integer(g->error, &count, &a->elements.count) ||
        !component_of(g, object, &a->component))
        return 0;
    a->width = width_of(name);
    a->normalized = nkwi_is_true(object, "normalized");
    a->elements.size = a->width * bytes_of(a->component);
    if (a->width == 0)
        return nkwi_fail(g->error, &type.place, NKW_IMPORT_INVALID, "\"%s\" is no type for this use", name);
    if (a->elements.count == 0)
        return nkwi_fail(g->error, &count.place, NKW_IMPORT_INVALID, "there are no elements");
    if (nkwi_member(object, "bufferView").json && !find_elements(g, object, &a->elements))
        return 0;
    return a->is_open = open_sparse(g, object, a);
}

static uint32_t bits_of(const unsigned char *p, size_t bytes)
{
    uint32_t bits = 0;
    for (size_t i = bytes; i-- > 0;)
        bits = bits << 8 | p[i];
    return bits;
}

/* 3.11: max(c / 127, -1), c / 255, max(c / 32767, -1), c / 65535, each rounded once. */
static float float_of(const unsigned char *p, nkwi_component component, int normalized)
{
    uint32_t bits = bits_of(p, bytes_of(component));
    float value;
    switch (component) {
    case NKWI_F32:
        memcpy(&value, &bits, sizeof value);
        return value;
    case NKWI_I8:
        value = (float)(bits < 0x80 ? (int32_t)bits : (int32_t)bits - 0x100);
        return !normalized ? value : value < -127.0f ? -1.0f : value / 127.0f;
    case NKWI_I16:
        value = (float)(bits < 0x8000 ? (int32_t)bits : (int32_t)bits - 0x10000);
        return !normalized ? value : value < -32767.0f ? -1.0f : value / 32767.0f;
    case NKWI_U8:
        return normalized ? (float)bits / 255.0f : (float)bits;
    case NKWI_U16:
        return normalized ? (float)bits / 65535.0f : (float)bits;
    default:
        return normalized ? (float)((double)bits / 4294967295.0) : (float)bits;
    }
}

/* A loop over elements writes each by one of these. */
typedef void nkwi_put(const nkwi_accessor *a, const unsigned char *element, void *out, size_t index);

static void put_floats(const nkwi_accessor *a, const unsigned char *element, void *out, size_t index)
{
    size_t bytes = bytes_of(a->component);
    float *to = (float *)out + index * a->width;
    for (size_t c = 0; c < a->width; c++)
        to[c] = float_of(element + c * bytes, a->component, a->normalized);
}

static void put_integer(const nkwi_accessor *a, const unsigned char *element, void *out, size_t index)
{
    ((uint32_t *)out)[index] = bits_of(element, a->elements.size);
}

static void put_shorts(const nkwi_accessor *a, const unsigned char *element, void *out, size_t index)
{
    size_t bytes = bytes_of(a->component);
    for (size_t c = 0; c < a->width; c++)
        ((uint16_t *)out)[index * a->width + c] = (uint16_t)bits_of(element + c * bytes, bytes);
}

/* All elements, then the sparse ones over them; their indices ascend. */
static int decode(nkwi_gltf *g, const nkwi_place *place, const nkwi_accessor *a, nkwi_put *put, void *out)
{
    const nkwi_elements *e = &a->elements, *s = &a->sparse_indices, *v = &a->sparse_values;
    size_t last = 0;
    for (size_t i = 0; e->data && i < e->count; i++)
        put(a, e->data + i * e->stride, out, i);
    for (size_t i = 0; i < a->sparse_count; i++) {
        size_t index = bits_of(s->data + i * s->stride, s->size);
        if (index >= e->count || (i > 0 && index <= last))
            return nkwi_fail(g->error, place, NKW_IMPORT_INVALID, "sparse index %zu is %zu: %s", i, index,
                             index >= e->count ? "there is no such element" : "it does not ascend");
        put(a, v->data + i * v->stride, out, last = index);
    }
    return 1;
}

/* The accessor that a member names. */
static int find_accessor(nkwi_gltf *g, const nkwi_value *object, const char *key, size_t *index, nkwi_accessor **out)
{
    int32_t found;
    if (!nkwi_needed_index(g->error, object, key, "accessor", g->accessor_count, &found))
        return 0;
    *index = (size_t)found;
    *out = &g->accessors[found];
    nkwi_value accessor = nkwi_element(&g->accessor_list, *index);
    return (*out)->is_open || open_accessor(g, &accessor, *out);
}

/* Memory for the numbers of an accessor, decoded. */
static int decode_new(nkwi_gltf *g, size_t index, nkwi_accessor *a, nkwi_put *put, size_t size, void **out)
{
    nkwi_value object = nkwi_element(&g->accessor_list, index);
    size_t most = SIZE_MAX / 64, numbers = a->elements.count < most ? a->elements.count * a->width : SIZE_MAX;
    *out = nkwi_gltf_take(g, &object, numbers, size);
    if (!*out || !decode(g, &object.place, a, put, *out)) {
        *out = NULL;
        return 0;
    }
    return 1;
}

int nkwi_gltf_floats(nkwi_gltf *g, const nkwi_value *object, const char *key, size_t width, nkwi_integers integers,
                     const float **out, size_t *count)
{
    size_t index;
    nkwi_accessor *a;
    void *numbers;
    if (!find_accessor(g, object, key, &index, &a))
        return 0;
    nkwi_value at = nkwi_member(object, key);
    if (a->width != width)
        return nkwi_fail(g->error, &at.place, NKW_IMPORT_INVALID, "accessor %zu has %zu components, not %zu", index,
                         a->width, width);
    if (a->component != NKWI_F32 && integers == NKWI_NORMALIZED && (!a->normalized || a->component == NKWI_U32))
        return nkwi_fail(g->error, &at.place, NKW_IMPORT_INVALID,
                         "accessor %zu has neither floats nor normalised integers", index);
    if (!a->floats) {
        if (!decode_new(g, index, a, put_floats, sizeof(float), &numbers))
            return 0;
        a->floats = (float *)numbers;
    }
    *out = a->floats;
    *count = a->elements.count;
    return 1;
}

int nkwi_gltf_texcoords(nkwi_gltf *g, const nkwi_value *object, const char *key, const float **out, size_t *count)
{
    size_t index;
    nkwi_accessor *a;
    if (!nkwi_gltf_floats(g, object, key, 2, NKWI_ANY, out, count) || !find_accessor(g, object, key, &index, &a))
        return 0;
    for (size_t i = 0; g->document->v_is_up && !a->v_is_up && i < *count; i++)
        a->floats[2 * i + 1] = 1.0f - a->floats[2 * i + 1];
    a->v_is_up = g->document->v_is_up;
    return 1;
}

/* An accessor of unsigned integers of at most `most` bytes. */
static int find_integers(nkwi_gltf *g, const nkwi_value *object, const char *key, size_t width, size_t most,
                         size_t *index, nkwi_accessor **a)
{
    if (!find_accessor(g, object, key, index, a))
        return 0;
    nkwi_value at = nkwi_member(object, key);
    nkwi_component type = (*a)->component;
    if ((*a)->width != width)
        return nkwi_fail(g->error, &at.place, NKW_IMPORT_INVALID, "accessor %zu has %zu components, not %zu", *index,
                         (*a)->width, width);
    if ((type != NKWI_U8 && type != NKWI_U16 && type != NKWI_U32) || bytes_of(type) > most)
        return nkwi_fail(g->error, &at.place, NKW_IMPORT_INVALID,
                         "accessor %zu has no unsigned integers of at most %zu bytes", *index, most);
    return 1;
}

int nkwi_gltf_integers(nkwi_gltf *g, const nkwi_value *object, const char *key, const uint32_t **out, size_t *count)
{
    size_t index;
    nkwi_accessor *a;
    void *numbers;
    if (!find_integers(g, object, key, 1, 4, &index, &a))
        return 0;
    if (!a->integers) {
        if (!decode_new(g, index, a, put_integer, sizeof(uint32_t), &numbers))
            return 0;
        a->integers = (uint32_t *)numbers;
    }
    *out = a->integers;
    *count = a->elements.count;
    return 1;
}

int nkwi_gltf_shorts(nkwi_gltf *g, const nkwi_value *object, const char *key, const uint16_t **out, size_t *count)
{
    size_t index;
    nkwi_accessor *a;
    void *numbers;
    if (!find_integers(g, object, key, 4, 2, &index, &a))
        return 0;
    if (!a->shorts) {
        if (!decode_new(g, index, a, put_shorts, sizeof(uint16_t), &numbers))
            return 0;
        a->shorts = (uint16_t *)numbers;
    }
    *out = a->shorts;
    *count = a->elements.count;
    return 1;
}

size_t nkwi_gltf_bytes(const nkwi_gltf *g, size_t accessor)
{
    const nkwi_accessor *a = &g->accessors[accessor];
    return (a->elements.data ? a->elements.count : 0) * a->elements.size +
           a->sparse_count * (a->sparse_indices.size + a->sparse_values.size);
}
