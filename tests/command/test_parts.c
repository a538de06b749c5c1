/* SPDX-License-Identifier: MIT */
/* nakawari parts: the rules of the converter's JSON. */
#if !defined(_POSIX_C_SOURCE)
#define _POSIX_C_SOURCE 200809L
#endif
#include "program.h"

#include <math.h>
#include <stdlib.h>

#include <jansson.h>

#include "planted.h"

enum { BONES = 64 };

static json_t *convert(const char *arguments)
{
    json_error_t error;
    char *text = program_run(NULL, "parts %s", arguments);
    json_t *all = json_loads(text, 0, &error);
    free(text);
    assert_non_null(all);
    return all;
}

static json_t *models_of(json_t *all)
{
    json_t *models = json_object_get(all, "skin_models");
    assert_true(json_object_size(models) > 0);
    return models;
}

static float number(json_t *list, size_t i)
{
    return (float)json_number_value(json_array_get(list, i));
}

static size_t whole(json_t *object, const char *key)
{
    return (size_t)json_integer_value(json_object_get(object, key));
}

/* The model matrices of the bones in the bind pose; parents come first. */
static size_t bind_models(json_t *model, nkw_mat4 *models)
{
    json_t *bones = json_object_get(model, "bones");
    size_t count = json_array_size(bones);
    assert_in_range(count, 1, BONES);
    for (size_t b = 0; b < count; b++) {
        json_t *bone = json_array_get(bones, b), *matrix = json_object_get(bone, "matrix");
        json_int_t parent = json_integer_value(json_object_get(bone, "parent"));
        nkw_mat4 local;
        assert_int_equal(json_array_size(matrix), 16);
        for (size_t i = 0; i < 16; i++)
            local.m[i] = number(matrix, i);
        assert_true(parent >= -1 && parent < (json_int_t)b);
        models[b] = parent < 0 ? local : nkw_mat4_mul_affine(&models[parent], &local);
    }
    return count;
}

/* The sum of the weighted bone-local positions is the position in the bind pose; weights sum to 1. */
static void check_vertex(json_t *part, json_t *bound, size_t v, const nkw_mat4 *models)
{
    json_t *bones = json_object_get(part, "bone"), *vertex = json_object_get(part, "vertex");
    size_t slots = json_array_size(bones), at = v * whole(part, "vertexStride");
    size_t other = v * whole(bound, "vertexStride");
    nkw_vec3 sum = NKW_VEC3_ZERO;
    float weights = 0.0f;
    for (size_t s = 0; s < slots; s++, at += 7) {
        nkw_vec3 p = {number(vertex, at + 1), number(vertex, at + 2), number(vertex, at + 3)};
        size_t bone = (size_t)json_integer_value(json_array_get(bones, s));
        sum = nkw_vec3_add_scaled(sum, nkw_mat4_transform_point(&models[bone], p), number(vertex, at));
        weights += number(vertex, at);
        expect_near(number(json_object_get(bound, "vertex"), other + s), number(vertex, at), 1e-7);
    }
    json_t *flat = json_object_get(bound, "vertex");
    nkw_vec3 want = {number(flat, other + slots), number(flat, other + slots + 1), number(flat, other + slots + 2)};
    expect_near(weights, 1.0f, 1e-6);
    expect_vec3_near(sum, want, 2e-6 * (1.0 + (double)nkw_vec3_length(want)));
}

static size_t check_part(json_t *part, json_t *bound, const nkw_mat4 *models, size_t bone_count)
{
    json_t *index = json_object_get(part, "index"), *bones = json_object_get(part, "bone");
    size_t stride = whole(part, "vertexStride"), vertices = json_array_size(json_object_get(part, "vertex")) / stride;
    size_t slots = json_array_size(bones);
    assert_true(slots == 2 || slots == 4);
    assert_true(stride == 7 * slots || stride == 7 * slots + 2);
    assert_int_equal(json_array_size(json_object_get(part, "vertex")), vertices * stride);
    for (size_t i = 0; i < slots; i++)
        assert_true((size_t)json_integer_value(json_array_get(bones, i)) < bone_count);
    for (size_t i = 0; i < json_array_size(index); i++)
        assert_true((size_t)json_integer_value(json_array_get(index, i)) < vertices);
    for (size_t v = 0; v < vertices; v++)
        check_vertex(part, bound, v, models);
    return json_array_size(index) / 3;
}

static size_t check_file(const char *path)
{
    char arguments[1024];
    size_t triangles = 0;
    const char *name;
    json_t *model;
    snprintf(arguments, sizeof arguments, "'%s'", path);
    json_t *local = convert(arguments);
    snprintf(arguments, sizeof arguments, "--space bind '%s'", path);
    json_t *bind = convert(arguments);
    json_object_foreach(models_of(local), name, model)
    {
        nkw_mat4 models[BONES];
        json_t *parts = json_object_get(model, "parts");
        json_t *others = json_object_get(json_object_get(models_of(bind), name), "parts");
        size_t bone_count = bind_models(model, models);
        assert_int_equal(json_array_size(parts), json_array_size(others));
        for (size_t i = 0; i < json_array_size(parts); i++) {
            json_t *part = json_array_get(parts, i);
            triangles += check_part(part, json_array_get(others, i), models, bone_count);
            if (i)
                assert_true(json_integer_value(json_object_get(json_array_get(parts, i - 1), "material")) <=
                            json_integer_value(json_object_get(part, "material")));
        }
    }
    json_decref(local);
    json_decref(bind);
    return triangles;
}

static void every_triangle_is_in_one_part(void **state)
{
    (void)state;
    assert_int_equal(check_file(NKW_CHARACTER), 2424);
}

static void real_files_keep_their_triangles(void **state)
{
    (void)state;
    FILE *f = fopen(NKW_DATA_DIR "/gltf/Fox.glb", "rb");
    if (!f) {
        print_message("skipped: there is no " NKW_DATA_DIR "/gltf/Fox.glb\n");
        skip();
    }
    fclose(f);
    assert_int_equal(check_file(NKW_DATA_DIR "/gltf/Fox.glb"), 576);
    assert_int_equal(check_file(NKW_DATA_DIR "/gltf/RiggedSimple.glb"), 188);
}

static void triangles_of_too_many_bones_are_reported(void **state)
{
    (void)state;
    planted p = planted_clean();
    for (int v = 0; v < PLANTED_VERTICES; v++) {
        p.weights[v][0] = v == 0;
        p.weights[v][1] = v != 0;
    }
    planted_write(&p, "planted_parts");
    program_says(0, "\"vertexStride\": 14", "parts planted_parts.gltf");
    program_says(1, "1 triangle of more than 1 bone: left out", "parts --bones 1 planted_parts.gltf");
}

static void expect_texcoords(const json_t *part, size_t before, int sets, int is_up)
{
    json_t *vertex = json_object_get(part, "vertex");
    const size_t stride = before + 2 * (size_t)sets;
    assert_int_equal(json_integer_value(json_object_get(part, "vertexStride")), stride);
    assert_int_equal(json_array_size(vertex), PLANTED_VERTICES * stride);
    for (int v = 0; v < PLANTED_VERTICES; v++)
        for (int set = 0; set < sets; set++) {
            const size_t at = (size_t)v * stride + before + 2 * (size_t)set;
            const float down = planted_texcoord(set, v, 1);
            expect_near(number(vertex, at), planted_texcoord(set, v, 0), 0);
            expect_near(number(vertex, at + 1), is_up ? 1.0f - down : down, 0);
        }
}

/* The converter's format: two floats for each set after the bones; none without one. */
static void vertices_have_all_sets_of_texture_coordinates(void **state)
{
    (void)state;
    static const int counts[] = {0, 1, 2, 8};
    for (int i = 0; i < 16; i++) {
        const int sets = counts[i / 4], is_bound = i % 2, is_up = i / 2 % 2;
        char arguments[128];
        planted p = planted_clean();
        p.texcoord_count = sets;
        planted_write(&p, "planted_texcoords");
        snprintf(arguments, sizeof arguments, "%s%s planted_texcoords.gltf", is_bound ? "--space bind " : "",
                 is_up ? "--v up" : i % 3 ? "--v down" : "");
        json_t *all = convert(arguments);
        json_t *parts = json_object_get(json_object_get(models_of(all), "leg"), "parts");
        assert_int_equal(json_array_size(parts), 1);
        expect_texcoords(json_array_get(parts, 0), is_bound ? 2 + 6 : 2 * 7, sets, is_up);
        json_decref(all);
    }
}

static void misuse_and_files_in_error(void **state)
{
    (void)state;
    program_says(0, "Usage: nakawari parts", "parts --help");
    program_says(2, "not ascending numbers", "parts --bones 4,2 x");
    program_says(2, "not ascending numbers", "parts --bones 0 x");
    program_says(2, "not ascending numbers", "parts --bones 2, x");
    program_says(2, "not down or up", "parts --v left x");
    program_says(2, "not bone or bind", "parts --space world x");
    program_says(1, "no-such-file: ", "parts no-such-file");
    planted p = planted_clean();
    p.joints[2][1] = 2;
    planted_write(&p, "planted_parts");
    program_says(1, "a joint of a vertex is not in the skin", "parts planted_parts.gltf");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_triangle_is_in_one_part),
        cmocka_unit_test(real_files_keep_their_triangles),
        cmocka_unit_test(triangles_of_too_many_bones_are_reported),
        cmocka_unit_test(vertices_have_all_sets_of_texture_coordinates),
        cmocka_unit_test(misuse_and_files_in_error),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
