/* SPDX-License-Identifier: MIT */
/* JSON values with their places: members, elements, and checked conversions. */
#ifndef NAKAWARI_IMPORT_VALUE_H
#define NAKAWARI_IMPORT_VALUE_H

#include <jansson.h>

#include "fault.h"

/* A value; json is NULL where it is absent. Its parent must outlive it. */
typedef struct nkwi_value {
    nkwi_place place;
    const json_t *json;
} nkwi_value;

nkwi_value nkwi_root(const json_t *json);

/* Absent in a value that is no object or has no such member. */
nkwi_value nkwi_member(const nkwi_value *object, const char *key);
nkwi_value nkwi_element(const nkwi_value *array, size_t index);

/* Elements of an array; 0 for any other value. */
size_t nkwi_length(const nkwi_value *array);

/* Fails where the value is there and is no array; where it is not there or no object. */
int nkwi_is_array(nkw_import_error *error, const nkwi_value *value);
int nkwi_is_object(nkw_import_error *error, const nkwi_value *value);

/* A text; `absent` where there is none or it is no text. */
const char *nkwi_text(const nkwi_value *object, const char *key, const char *absent);

/* Whether the member is true. */
int nkwi_is_true(const nkwi_value *object, const char *key);

/* An integer 0 .. 2^53. */
int nkwi_integer(nkw_import_error *error, const nkwi_value *value, size_t *out);
int nkwi_count(nkw_import_error *error, const nkwi_value *object, const char *key, size_t absent, size_t *out);

/* An index less than `count`; absent: NKW_NO_JOINT. `of` names what it is an index of, for the message. */
int nkwi_index_at(nkw_import_error *error, const nkwi_value *value, const char *of, size_t count, int32_t *out);
int nkwi_index(nkw_import_error *error, const nkwi_value *object, const char *key, const char *of, size_t count,
               int32_t *out);
/* The same; absence is an error. */
int nkwi_needed_index(nkw_import_error *error, const nkwi_value *object, const char *key, const char *of, size_t count,
                      int32_t *out);

/* An array of exactly n finite floats; absent: `out` is unchanged. */
int nkwi_floats(nkw_import_error *error, const nkwi_value *object, const char *key, float *out, size_t n);

#endif
