/* SPDX-License-Identifier: MIT */
#include "value.h"

#include <float.h>
#include <stdint.h>

nkwi_value nkwi_root(const json_t *json)
{
    const nkwi_value root = {{NULL, NULL, 0}, json};
    return root;
}

nkwi_value nkwi_member(const nkwi_value *object, const char *key)
{
    const nkwi_value member = {{&object->place, key, 0}, json_object_get(object->json, key)};
    return member;
}

nkwi_value nkwi_element(const nkwi_value *array, size_t index)
{
    const nkwi_value element = {{&array->place, NULL, index}, json_array_get(array->json, index)};
    return element;
}

size_t nkwi_length(const nkwi_value *array)
{
    return json_array_size(array->json);
}

int nkwi_is_array(nkw_import_error *error, const nkwi_value *value)
{
    if (value->json && !json_is_array(value->json))
        return nkwi_fail(error, &value->place, NKW_IMPORT_INVALID, "is not an array");
    return 1;
}

int nkwi_is_object(nkw_import_error *error, const nkwi_value *value)
{
    if (!value->json)
        return nkwi_fail(error, &value->place, NKW_IMPORT_INVALID, "is missing");
    if (!json_is_object(value->json))
        return nkwi_fail(error, &value->place, NKW_IMPORT_INVALID, "is not an object");
    return 1;
}

const char *nkwi_text(const nkwi_value *object, const char *key, const char *absent)
{
    const char *text = json_string_value(json_object_get(object->json, key));
    return text ? text : absent;
}

int nkwi_is_true(const nkwi_value *object, const char *key)
{
    return json_is_true(json_object_get(object->json, key));
}

int nkwi_integer(nkw_import_error *error, const nkwi_value *value, size_t *out)
{
    double number = json_number_value(value->json);
    *out = 0;
    if (!json_is_number(value->json) || number < 0.0 || number > 0x1p53 || number != (double)(uint64_t)number)
        return nkwi_fail(error, &value->place, NKW_IMPORT_INVALID, "is not an integer from 0 on");
    if ((uint64_t)number > SIZE_MAX)
        return nkwi_fail(error, &value->place, NKW_IMPORT_TOO_LARGE, "%.0f is too large", number);
    *out = (size_t)number;
    return 1;
}

int nkwi_count(nkw_import_error *error, const nkwi_value *object, const char *key, size_t absent, size_t *out)
{
    nkwi_value value = nkwi_member(object, key);
    *out = absent;
    return !value.json || nkwi_integer(error, &value, out);
}

int nkwi_index_at(nkw_import_error *error, const nkwi_value *value, const char *of, size_t count, int32_t *out)
{
    size_t index;
    *out = NKW_NO_JOINT;
    if (!nkwi_integer(error, value, &index))
        return 0;
    if (index >= count || index > INT32_MAX)
        return nkwi_fail(error, &value->place, NKW_IMPORT_INVALID, "%s %zu does not exist: the file has %zu", of, index,
                         count);
    *out = (int32_t)index;
    return 1;
}

int nkwi_index(nkw_import_error *error, const nkwi_value *object, const char *key, const char *of, size_t count,
               int32_t *out)
{
    nkwi_value value = nkwi_member(object, key);
    *out = NKW_NO_JOINT;
    return !value.json || nkwi_index_at(error, &value, of, count, out);
}

int nkwi_needed_index(nkw_import_error *error, const nkwi_value *object, const char *key, const char *of, size_t count,
                      int32_t *out)
{
    nkwi_value value = nkwi_member(object, key);
    *out = NKW_NO_JOINT;
    if (!value.json)
        return nkwi_fail(error, &value.place, NKW_IMPORT_INVALID, "is missing");
    return nkwi_index_at(error, &value, of, count, out);
}

int nkwi_floats(nkw_import_error *error, const nkwi_value *object, const char *key, float *out, size_t n)
{
    nkwi_value array = nkwi_member(object, key);
    if (!array.json)
        return 1;
    if (!json_is_array(array.json) || nkwi_length(&array) != n)
        return nkwi_fail(error, &array.place, NKW_IMPORT_INVALID, "is not an array of %zu numbers", n);
    for (size_t i = 0; i < n; i++) {
        nkwi_value element = nkwi_element(&array, i);
        double number = json_number_value(element.json);
        if (!json_is_number(element.json))
            return nkwi_fail(error, &element.place, NKW_IMPORT_INVALID, "is not a number");
        if (!(number <= (double)FLT_MAX && number >= -(double)FLT_MAX))
            return nkwi_fail(error, &element.place, NKW_IMPORT_INVALID, "%g is too large for binary32", number);
        out[i] = (float)number;
    }
    return 1;
}
