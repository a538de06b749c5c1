/* SPDX-License-Identifier: MIT */
/* The joints that carry a mesh, in the order of the matrix stack's draw list. */
#include <nakawari/mat.h>

#include "documents.h"

/*
 *     0 root -- 1 turret (mesh) -- 2 gun -- 3 muzzle (mesh)
 *            `- 4 tracks -- 5 left (mesh)
 *     6 flag (mesh)
 *
 * The numbers are those of joints; the nodes of the file are in another order.
 */
static const char tree[] = "{'asset':{'version':'2.0'},'meshes':[{'primitives':[]},{'primitives':[]}],'nodes':["
                           "{'name':'root','children':[1,2]},{'name':'turret','mesh':1,'children':[4]},"
                           "{'name':'tracks','children':[3]},{'name':'left','mesh':0},{'name':'gun','children':[5]},"
                           "{'name':'muzzle','mesh':1},{'name':'flag','mesh':0}]}";

static void expect_list(const nkw_document *d, int32_t root, const int32_t *want, size_t want_count)
{
    int32_t joints[8] = {-9, -9, -9, -9, -9, -9, -9, -9};
    size_t count;
    assert_int_equal(nkw_document_mesh_joints(d, root, joints, 8, &count), NKW_OK);
    assert_int_equal(count, want_count);
    for (size_t i = 0; i < 8; i++)
        assert_int_equal(joints[i], i < want_count ? want[i] : -9);
}

static void the_list_is_in_depth_first_order(void **state)
{
    (void)state;
    static const int32_t all[] = {1, 3, 5, 6};
    nkw_document *d = opened(tree, NULL, 0);
    expect_list(d, NKW_NO_JOINT, all, 4);
    expect_list(d, 0, all, 3); /* without the second root */
    expect_list(d, 1, all, 2);
    expect_list(d, 2, all + 1, 1);
    expect_list(d, 3, all + 1, 1);
    expect_list(d, 4, all + 2, 1);
    expect_list(d, 6, all + 3, 1);
    nkw_document_close(d);
}

static void a_list_that_is_too_small_is_a_question(void **state)
{
    (void)state;
    nkw_document *d = opened(tree, NULL, 0);
    int32_t joints[4] = {-9, -9, -9, -9};
    size_t count = 99;
    assert_int_equal(nkw_document_mesh_joints(d, NKW_NO_JOINT, NULL, 0, &count), NKW_TOO_SMALL);
    assert_int_equal(count, 4);
    assert_int_equal(nkw_document_mesh_joints(d, NKW_NO_JOINT, joints, 2, &count), NKW_TOO_SMALL);
    assert_int_equal(count, 4);
    assert_true(joints[0] == 1 && joints[1] == 3 && joints[2] == -9);
    assert_int_equal(nkw_document_mesh_joints(d, 7, joints, 4, &count), NKW_OUT_OF_RANGE);
    assert_int_equal(count, 0);
    assert_int_equal(nkw_document_mesh_joints(d, -2, joints, 4, &count), NKW_OUT_OF_RANGE);
    nkw_document_close(d);
}

static void documents_without_meshes_have_an_empty_list(void **state)
{
    (void)state;
    size_t count = 99;
    nkw_document *d = opened("{'asset':{'version':'2.0'},'nodes':[{}]}", NULL, 0);
    assert_int_equal(nkw_document_mesh_joints(d, NKW_NO_JOINT, NULL, 0, &count), NKW_OK);
    assert_int_equal(count, 0);
    nkw_document_close(d);
    d = opened("{'asset':{'version':'2.0'}}", NULL, 0);
    assert_int_equal(nkw_document_mesh_joints(d, NKW_NO_JOINT, NULL, 0, &count), NKW_OK);
    assert_int_equal(nkw_document_mesh_joints(d, 0, NULL, 0, &count), NKW_OUT_OF_RANGE);
    nkw_document_close(d);
}

#if defined(NKW_TEST_ASSIMP)
/* The lesson's numbers: the root frame at 10, its child 7 from it; a world matrix of -10 draws them at 0 and 7. */
#define MATRIX(x) "FrameTransformMatrix {\n1.0,0.0,0.0,0.0, 0.0,1.0,0.0,0.0, 0.0,0.0,1.0,0.0, " x ",0.0,0.0,1.0;;\n}\n"
#define PART      "Mesh {\n3;\n0.0;0.0;0.0;,\n1.0;0.0;0.0;,\n0.0;1.0;0.0;;\n1;\n3;0,1,2;;\n}\n"

static void the_tank_of_the_lesson_is_drawn(void **state)
{
    (void)state;
    static const char text[] = "xof 0303txt 0032\nFrame root {\n" MATRIX("10.0") PART
        "Frame axle {\n" MATRIX("0.0") "Frame child {\n" MATRIX("7.0") PART "}\n}\n}\n";
    const nkw_import_memory memory = {text, sizeof text - 1, "tank.x", NULL, NULL, NULL, 0, 0};
    const nkw_mat4 world = nkw_mat4_from_translation((nkw_vec3){-10, 0, 0});
    static const char *const names[] = {"root", "child"};
    static const float places[] = {0, 7};
    nkw_document *d;
    nkw_import_error error;
    nkw_mat4 models[8];
    int32_t joints[8];
    size_t count;
    if (nkw_document_from_memory(&memory, &d, &error) != NKW_IMPORT_OK)
        fail_msg("%s: %s", error.place, error.reason);
    assert_in_range(d->skeleton.joint_count, 3, 8);
    assert_int_equal(nkw_document_models(d, d->rest, &world, models), NKW_OK);
    assert_int_equal(nkw_document_mesh_joints(d, NKW_NO_JOINT, joints, 8, &count), NKW_OK);
    assert_int_equal(count, 2);
    for (size_t i = 0; i < 2; i++) {
        assert_string_equal(d->nodes[joints[i]].name, names[i]);
        expect_near(models[joints[i]].m[12], places[i], 0);
    }
    nkw_document_close(d);
}
#endif

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_list_is_in_depth_first_order),
        cmocka_unit_test(a_list_that_is_too_small_is_a_question),
        cmocka_unit_test(documents_without_meshes_have_an_empty_list),
#if defined(NKW_TEST_ASSIMP)
        cmocka_unit_test(the_tank_of_the_lesson_is_drawn),
#endif
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
