/* SPDX-License-Identifier: MIT */
#include <math.h>

#include "random.h"
#include "support/expect.h"
#include "support/views.h"

enum { MAPS = 48 };

static const nkw_axis all[6] = {NKW_AXIS_X,          NKW_AXIS_Y,          NKW_AXIS_Z,
                                NKW_AXIS_NEGATIVE_X, NKW_AXIS_NEGATIVE_Y, NKW_AXIS_NEGATIVE_Z};

/* Every signed permutation, numbered 0..47. */
static nkw_axes_map map_at(unsigned i)
{
    static const unsigned char order[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
    const unsigned char *o = order[i / 8];
    nkw_axes_map map = {all[o[0] + 3 * (i & 1)], all[o[1] + 3 * (i >> 1 & 1)], all[o[2] + 3 * (i >> 2 & 1)]};
    return map;
}

static nkw_vec3 vec(float x, float y, float z)
{
    nkw_vec3 r = {x, y, z};
    return r;
}

static nkw_trs draw_trs(random_source *r)
{
    nkw_trs trs = {random_vec3(r, -5, 5), random_rotation(r), random_vec3(r, -2, 2)};
    return trs;
}

static nkw_vec3 as_kind(nkw_axes_map map, nkw_vec3 v, nkw_axes_kind kind)
{
    nkw_axes_convert_values(map, &v.x, 1, kind, &v.x);
    return v;
}

/* P, from its columns. */
static nkw_mat3 matrix_of(nkw_axes_map map)
{
    return nkw_mat3_from_columns(nkw_axes_convert_vec3(map, vec(1, 0, 0)), nkw_axes_convert_vec3(map, vec(0, 1, 0)),
                                 nkw_axes_convert_vec3(map, vec(0, 0, 1)));
}

static int is_valid(nkw_axes axes)
{
    return nkw_axes_map_is_valid(nkw_axes_map_from_axes(axes, axes));
}

static nkw_vec3 between(nkw_axes from, nkw_axes to, nkw_vec3 v)
{
    return nkw_axes_convert_vec3(nkw_axes_map_from_axes(from, to), v);
}

static void the_identity_changes_nothing(void **state)
{
    (void)state;
    nkw_vec3 v = vec(-0.0f, 2, -3);
    nkw_quat q = {0.1f, -0.0f, 0.3f, -0.9f};
    nkw_axes_map none = NKW_AXES_MAP_IDENTITY;
    expect_vec3_bits(nkw_axes_convert_vec3(none, v), v);
    expect_vec3_bits(as_kind(none, v, NKW_AXES_ANGULAR), v);
    expect_vec3_bits(as_kind(none, v, NKW_AXES_SCALE), v);
    expect_quat_bits(nkw_axes_convert_quat(none, q), q);
    assert_int_equal(nkw_axes_map_is_mirror(none), 0);
    const nkw_axes gltf = NKW_AXES_GLTF;
    expect_vec3_bits(between(gltf, gltf, v), v);
}

static void there_and_back_restores_every_bit(void **state)
{
    (void)state;
    random_source r = random_from(1);
    for (unsigned i = 0; i < MAPS; i++)
        for (int k = 0; k < 50; k++) {
            nkw_axes_map to = map_at(i), back = nkw_axes_map_inverse(to);
            nkw_trs trs = draw_trs(&r);
            trs.translation.y = k == 0 ? -0.0f : k == 1 ? INFINITY : k == 2 ? float_of(1) : trs.translation.y;
            nkw_mat4 m;
            for (size_t e = 0; e < 16; e++)
                m.m[e] = random_finite(&r);
            nkw_trs there = nkw_axes_convert_trs(to, &trs), again = nkw_axes_convert_trs(back, &there);
            expect_floats_bits(&again.translation.x, &trs.translation.x, 10);
            nkw_mat4 m_there = nkw_axes_convert_mat4(to, &m), m_again = nkw_axes_convert_mat4(back, &m_there);
            expect_floats_bits(m_again.m, m.m, 16);
            nkw_vec3 w = as_kind(to, trs.translation, NKW_AXES_ANGULAR);
            expect_vec3_bits(as_kind(back, w, NKW_AXES_ANGULAR), trs.translation);
        }
}

static void all_maps_differ_and_half_of_them_mirror(void **state)
{
    (void)state;
    int mirrors = 0;
    for (unsigned i = 0; i < MAPS; i++) {
        nkw_mat3 p = matrix_of(map_at(i));
        assert_true(nkw_axes_map_is_valid(map_at(i)));
        expect_bits(nkw_mat3_determinant(&p), nkw_axes_map_is_mirror(map_at(i)) ? -1.0f : 1.0f);
        mirrors += nkw_axes_map_is_mirror(map_at(i));
        for (unsigned k = 0; k < i; k++) {
            nkw_mat3 other = matrix_of(map_at(k));
            assert_memory_not_equal(p.m, other.m, sizeof p);
        }
    }
    assert_int_equal(mirrors, MAPS / 2);
}

static void vectors_are_multiplied_by_the_matrix_of_the_map(void **state)
{
    (void)state;
    random_source r = random_from(2);
    for (unsigned i = 0; i < MAPS; i++) {
        nkw_vec3 v = random_vec3(&r, -9, 9);
        nkw_mat3 p = matrix_of(map_at(i));
        expect_vec3_bits(nkw_axes_convert_vec3(map_at(i), v), nkw_mat3_transform(&p, v));
        nkw_vec3 s = as_kind(map_at(i), vec(1, -2, 3), NKW_AXES_SCALE),
                 c = nkw_axes_convert_vec3(map_at(i), vec(1, 2, 3));
        assert_true(nkw_abs(s.x) == nkw_abs(c.x) && nkw_abs(s.y) == nkw_abs(c.y) && nkw_abs(s.z) == nkw_abs(c.z));
        assert_true(s.x * s.y * s.z == -6.0f);
    }
}

static void rotations_turn_converted_vectors_as_before(void **state)
{
    (void)state;
    random_source r = random_from(3);
    for (unsigned i = 0; i < MAPS; i++)
        for (int k = 0; k < 200; k++) {
            nkw_axes_map map = map_at(i);
            nkw_quat q = random_rotation(&r);
            nkw_vec3 v = random_vec3(&r, -3, 3);
            nkw_quat p = nkw_axes_convert_quat(map, q);
            expect_bits(p.w, q.w);
            expect_vec3_near(nkw_quat_rotate(p, nkw_axes_convert_vec3(map, v)),
                             nkw_axes_convert_vec3(map, nkw_quat_rotate(q, v)), 2e-6);
            expect_vec3_near(nkw_quat_log(p), as_kind(map, nkw_quat_log(q), NKW_AXES_ANGULAR), 1e-6);
            nkw_vec3 cross = nkw_vec3_cross(v, vec(1, 2, -3));
            expect_vec3_near(nkw_vec3_cross(nkw_axes_convert_vec3(map, v), nkw_axes_convert_vec3(map, vec(1, 2, -3))),
                             as_kind(map, cross, NKW_AXES_ANGULAR), 0);
        }
}

static void transforms_and_their_matrices_convert_alike(void **state)
{
    (void)state;
    random_source r = random_from(4);
    for (unsigned i = 0; i < MAPS; i++)
        for (int k = 0; k < 100; k++) {
            nkw_axes_map map = map_at(i);
            nkw_trs trs = draw_trs(&r), converted = nkw_axes_convert_trs(map, &trs);
            nkw_mat4 m = nkw_mat4_from_trs(&trs), got = nkw_axes_convert_mat4(map, &m);
            nkw_mat4 want = nkw_mat4_from_trs(&converted);
            expect_floats_near(got.m, want.m, 16, 2e-6);
            nkw_vec3 p = random_vec3(&r, -3, 3);
            expect_vec3_near(nkw_trs_transform_point(&converted, nkw_axes_convert_vec3(map, p)),
                             nkw_axes_convert_vec3(map, nkw_trs_transform_point(&trs, p)), 2e-5);
            nkw_mat3 block = nkw_mat3_from_mat4(&m), part = nkw_mat3_from_mat4(&got);
            nkw_mat4 alone = nkw_mat4_from_mat3(&block, NKW_VEC3_ZERO), turned = nkw_axes_convert_mat4(map, &alone);
            nkw_mat3 want_part = nkw_mat3_from_mat4(&turned);
            expect_floats_bits(part.m, want_part.m, 9);
        }
}

/* From the documents of the tools. */
static void axes_of_tools_convert_as_their_documents_say(void **state)
{
    (void)state;
    const nkw_axes gltf = NKW_AXES_GLTF, blender = NKW_AXES_BLENDER, unity = NKW_AXES_UNITY, unreal = NKW_AXES_UNREAL;
    expect_vec3_bits(between(blender, gltf, vec(1, 2, 3)), vec(1, 3, -2));
    expect_vec3_bits(between(gltf, unity, vec(1, 2, 3)), vec(-1, 2, 3));
    expect_vec3_bits(between(unity, unreal, vec(1, 2, 3)), vec(3, 1, 2));
    expect_vec3_bits(between(gltf, unreal, vec(1, 2, 3)), vec(3, -1, 2));
    assert_int_equal(nkw_axes_map_is_mirror(nkw_axes_map_from_axes(blender, gltf)), 0);
    assert_int_equal(nkw_axes_map_is_mirror(nkw_axes_map_from_axes(gltf, unity)), 1);
    assert_int_equal(nkw_axes_map_is_mirror(nkw_axes_map_from_axes(unity, unreal)), 0);
    /* The glTF importers of Unity: (x, y, z, w) to (x, -y, -z, w). */
    const nkw_quat q = {0.1f, 0.2f, 0.3f, 0.9f}, want = {0.1f, -0.2f, -0.3f, 0.9f};
    expect_quat_bits(nkw_axes_convert_quat(nkw_axes_map_from_axes(gltf, unity), q), want);
}

/*
 * Godot: Vector3.MODEL_FRONT (0, 0, 1), MODEL_TOP (0, 1, 0), MODEL_LEFT (1, 0, 0), as in glTF. OpenUSD: an upAxis of Z
 * is one of Y turned by 90 degrees about x, (x, y, z) to (x, -z, y). Unreal: a yaw of -90 degrees, which maps +y to +x,
 * turns a mesh to face as its actor.
 */
static void models_of_godot_usd_and_unreal_face_as_they_say(void **state)
{
    (void)state;
    const nkw_axes gltf = NKW_AXES_GLTF, godot = NKW_AXES_GODOT, y = NKW_AXES_USD_Y, z = NKW_AXES_USD_Z,
                   mesh = NKW_AXES_UNREAL_MESH, actor = NKW_AXES_UNREAL;
    expect_vec3_bits(between(gltf, godot, vec(1, 2, 3)), vec(1, 2, 3));
    expect_vec3_bits(between(gltf, y, vec(1, 2, 3)), vec(1, 2, 3));
    expect_vec3_bits(between(y, z, vec(1, 2, 3)), vec(1, -3, 2));
    expect_vec3_bits(between(mesh, actor, vec(1, 2, 3)), vec(2, -1, 3));
    expect_vec3_bits(between(gltf, mesh, vec(1, 2, 3)), vec(1, 3, 2));
    assert_int_equal(nkw_axes_map_is_mirror(nkw_axes_map_from_axes(mesh, actor)), 0);
    assert_int_equal(nkw_axes_map_is_mirror(nkw_axes_map_from_axes(gltf, mesh)), 1);
    assert_int_equal(nkw_axes_map_is_mirror(nkw_axes_map_from_axes(y, z)), 0);
}

/* A camera of glTF looks along -z, a character along +z: half a turn about y. OpenCV: x right, y down, z ahead. */
static void cameras_look_against_the_direction_that_characters_face(void **state)
{
    (void)state;
    const nkw_axes gltf = NKW_AXES_GLTF, gl = NKW_AXES_OPENGL_CAMERA, cv = NKW_AXES_OPENCV_CAMERA;
    expect_vec3_bits(between(gltf, gl, vec(1, 2, 3)), vec(-1, 2, -3));
    expect_vec3_bits(between(gl, cv, vec(1, 2, 3)), vec(1, -2, -3));
    assert_int_equal(nkw_axes_map_is_mirror(nkw_axes_map_from_axes(gltf, gl)), 0);
    assert_int_equal(nkw_axes_map_is_mirror(nkw_axes_map_from_axes(gl, cv)), 0);
}

static void directions_of_one_tool_become_those_of_the_other(void **state)
{
    (void)state;
    for (unsigned i = 0; i < MAPS; i++)
        for (unsigned k = 0; k < MAPS; k++) {
            nkw_axes_map a = map_at(i), b = map_at(k);
            nkw_axes from = {a.x, a.y, a.z}, to = {b.x, b.y, b.z};
            nkw_mat3 source = matrix_of(a), target = matrix_of(b);
            assert_true(is_valid(from));
            for (size_t row = 0; row < 3; row++)
                expect_vec3_near(between(from, to, vec(source.m[row], source.m[3 + row], source.m[6 + row])),
                                 vec(target.m[row], target.m[3 + row], target.m[6 + row]), 0);
        }
}

static void axes_that_are_not_three_have_no_valid_map(void **state)
{
    (void)state;
    const nkw_axes twice = {NKW_AXIS_X, NKW_AXIS_NEGATIVE_X, NKW_AXIS_Z}, unity = NKW_AXES_UNITY;
    const nkw_axes unreal = NKW_AXES_UNREAL;
    assert_int_equal(is_valid(twice), 0);
    assert_int_equal(nkw_axes_map_is_valid(nkw_axes_map_from_axes(twice, unreal)), 0);
    assert_int_equal(nkw_axes_map_is_valid(nkw_axes_map_from_axes(unreal, twice)), 0);
    const nkw_axes_map none = nkw_axes_map_from_axes(twice, unreal);
    assert_true((int)none.x == 0 && (int)none.y == 0 && (int)none.z == 0);
    /* Unknown numbers are X. */
    nkw_axes_map odd = {(nkw_axis)0, (nkw_axis)3, (nkw_axis)-99};
    assert_int_equal(nkw_axes_map_is_valid(odd), 0);
    assert_int_equal(nkw_axes_map_is_mirror(odd), 0);
    expect_vec3_bits(nkw_axes_convert_vec3(odd, vec(1, 2, 3)), vec(1, 3, 1));
    expect_vec3_bits(nkw_axes_convert_vec3(nkw_axes_map_inverse(odd), vec(1, 2, 3)), vec(1, 2, 3));
    nkw_euler_order order = NKW_EULER_ZYX;
    nkw_axes_convert_euler(odd, vec(1, 2, 3), &order);
    assert_int_equal(order, NKW_EULER_ZYX);
    assert_int_equal(is_valid(unity), 1);
}

static void euler_angles_and_their_order_are_the_same_rotation(void **state)
{
    (void)state;
    random_source r = random_from(5);
    for (unsigned i = 0; i < MAPS; i++)
        for (int order = 0; order < 12; order++) {
            nkw_axes_map map = map_at(i);
            nkw_vec3 angles = random_vec3(&r, -1.5f, 1.5f);
            nkw_quat q = nkw_quat_from_euler(angles, (nkw_euler_order)order);
            nkw_euler_order other = (nkw_euler_order)order;
            nkw_vec3 moved = nkw_axes_convert_euler(map, angles, &other);
            expect_quat_near(nkw_quat_from_euler(moved, other), nkw_axes_convert_quat(map, q), 5e-7);
        }
    nkw_euler_order unknown = (nkw_euler_order)17;
    nkw_axes_convert_euler(NKW_AXES_MAP_IDENTITY, NKW_VEC3_ZERO, &unknown);
    assert_int_equal(unknown, NKW_EULER_XYZ);
}

static void poses_convert_as_their_models(void **state)
{
    (void)state;
    enum { JOINTS = 19 };
    random_source r = random_from(6);
    int32_t parents[JOINTS] = {-1};
    nkw_trs trs[JOINTS];
    float pose[NKW_POSE_FLOATS(JOINTS)], other[NKW_POSE_FLOATS(JOINTS)];
    for (int j = 0; j < JOINTS; j++) {
        parents[j] = j ? (int32_t)(random_bits(&r) % (unsigned)j) : -1;
        trs[j] = draw_trs(&r);
    }
    const nkw_skeleton skeleton = {parents, JOINTS};
    nkw_mat4 models[JOINTS], converted[JOINTS];
    nkw_pose_from_trs(trs, pose_span(pose, JOINTS));
    nkw_skeleton_models_from_pose(&skeleton, pose_view(pose, JOINTS), NULL, NULL, models);
    for (unsigned i = 0; i < MAPS; i++) {
        assert_int_equal(nkw_pose_convert_axes(pose_view(pose, JOINTS), map_at(i), pose_span(other, JOINTS)), NKW_OK);
        nkw_skeleton_models_from_pose(&skeleton, pose_view(other, JOINTS), NULL, NULL, converted);
        for (int j = 0; j < JOINTS; j++) {
            nkw_mat4 want = nkw_axes_convert_mat4(map_at(i), &models[j]);
            expect_floats_near(converted[j].m, want.m, 16, 2e-3);
        }
        nkw_pose_convert_axes(pose_view(other, JOINTS), nkw_axes_map_inverse(map_at(i)), pose_span(other, JOINTS));
        expect_floats_bits(other, pose, NKW_POSE_FLOATS(JOINTS));
    }
    assert_int_equal(nkw_pose_convert_axes(pose_view(pose, JOINTS), map_at(9), pose_span(other, JOINTS - 1)),
                     NKW_MISMATCHED);
    expect_floats_bits(other, pose, NKW_POSE_FLOATS(JOINTS));
}

static const float times[3] = {0, 0.5f, 2};

static void samples_of_converted_tracks_are_converted_samples(void **state)
{
    (void)state;
    random_source r = random_from(7);
    float values[36], converted[36], got[4], want[4];
    for (int i = 0; i < 36; i += 4) {
        nkw_quat q = random_rotation(&r);
        memcpy(values + i, &q, sizeof q);
    }
    for (unsigned i = 0; i < MAPS; i++)
        for (int mode = 0; mode < 3; mode++)
            for (int kind = 0; kind < NKW_AXES_KIND_COUNT; kind++) {
                size_t width = NKW_AXES_WIDTH((nkw_axes_kind)kind);
                nkw_track_kind track_kind = width == 4 ? NKW_TRACK_ROTATION : NKW_TRACK_FLOATS;
                nkw_track track = {times, values, 3, width, track_kind, (nkw_interpolation)mode, NULL}, other = track;
                assert_int_equal(nkw_track_convert_axes(&track, map_at(i), (nkw_axes_kind)kind, converted), NKW_OK);
                other.values = converted;
                for (int k = -1; k < 12; k++) {
                    nkw_track_sample(&track, 0.2f * (float)k, NULL, got);
                    nkw_track_sample(&other, 0.2f * (float)k, NULL, want);
                    nkw_axes_convert_values(map_at(i), got, 1, (nkw_axes_kind)kind, got);
                    expect_floats_near(got, want, width, width == 4 ? 5e-7 : 0);
                }
            }
}

static void tracks_that_do_not_fit_are_not_converted(void **state)
{
    (void)state;
    float values[8] = {1, 2, 3, 4, 5, 6, 7, 8}, out[8] = {0};
    const float nothing[8] = {0};
    nkw_axes_map map = map_at(9), odd = {NKW_AXIS_X, NKW_AXIS_X, NKW_AXIS_Z};
    nkw_clip_track c = {NKW_CLIP_SCALE, 0, {times, values, 2, 3, NKW_TRACK_FLOATS, NKW_INTERPOLATION_STEP, NULL}};
    assert_int_equal(nkw_track_convert_axes(&c.track, map, NKW_AXES_QUAT, out), NKW_BAD_WIDTH);
    assert_int_equal(nkw_track_convert_axes(&c.track, map, (nkw_axes_kind)9, out), NKW_BAD_METHOD);
    assert_int_equal(nkw_track_convert_axes(&c.track, odd, NKW_AXES_SCALE, out), NKW_OUT_OF_RANGE);
    nkw_track huge = c.track;
    huge.count = SIZE_MAX;
    assert_int_equal(nkw_track_convert_axes(&huge, map, NKW_AXES_SCALE, out), NKW_TOO_SMALL);
    c.target = NKW_CLIP_ROTATION;
    assert_int_equal(nkw_track_convert_axes(&c.track, map, NKW_CLIP_AXES(c.target), out), NKW_BAD_WIDTH);
    expect_floats_bits(out, nothing, 8);
    nkw_axes_convert_values(map, values, 2, (nkw_axes_kind)-1, out);
    nkw_axes_convert_values(map, values, 2, NKW_AXES_VEC3, values);
    expect_floats_bits(out, values, 6);
}

static void tracks_of_clips_convert_by_their_target(void **state)
{
    (void)state;
    const nkw_axes gltf = NKW_AXES_GLTF, unity = NKW_AXES_UNITY;
    nkw_axes_map map = nkw_axes_map_from_axes(gltf, unity);
    const float values[8] = {1, 2, 3, 4, 5, 6, 7, 8};
    static const float want[3][8] = {{-1, 2, 3, -4, 5, 6}, {1, -2, -3, 4, 5, -6, -7, 8}, {1, 2, 3, 4, 5, 6}};
    for (int target = 0; target < NKW_CLIP_FLOATS; target++) {
        float out[8] = {0};
        size_t width = target == NKW_CLIP_ROTATION ? 4 : 3;
        nkw_track_kind kind = width == 4 ? NKW_TRACK_ROTATION : NKW_TRACK_FLOATS;
        nkw_clip_track c = {(nkw_clip_target)target, 0, {times, values, 2, width, kind, NKW_INTERPOLATION_STEP, NULL}};
        assert_int_equal(nkw_track_convert_axes(&c.track, map, NKW_CLIP_AXES(c.target), out), NKW_OK);
        expect_floats_bits(out, want[target], 8);
        c.track.values = out;
        assert_int_equal(nkw_track_convert_axes(&c.track, map, NKW_CLIP_AXES(c.target), out), NKW_OK);
        expect_floats_bits(out, values, 2 * width);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_identity_changes_nothing),
        cmocka_unit_test(there_and_back_restores_every_bit),
        cmocka_unit_test(all_maps_differ_and_half_of_them_mirror),
        cmocka_unit_test(vectors_are_multiplied_by_the_matrix_of_the_map),
        cmocka_unit_test(rotations_turn_converted_vectors_as_before),
        cmocka_unit_test(transforms_and_their_matrices_convert_alike),
        cmocka_unit_test(axes_of_tools_convert_as_their_documents_say),
        cmocka_unit_test(models_of_godot_usd_and_unreal_face_as_they_say),
        cmocka_unit_test(cameras_look_against_the_direction_that_characters_face),
        cmocka_unit_test(directions_of_one_tool_become_those_of_the_other),
        cmocka_unit_test(axes_that_are_not_three_have_no_valid_map),
        cmocka_unit_test(euler_angles_and_their_order_are_the_same_rotation),
        cmocka_unit_test(poses_convert_as_their_models),
        cmocka_unit_test(samples_of_converted_tracks_are_converted_samples),
        cmocka_unit_test(tracks_that_do_not_fit_are_not_converted),
        cmocka_unit_test(tracks_of_clips_convert_by_their_target),
    };
    return cmocka_run_group_tests_name("axes", tests, NULL, NULL);
}
