/* SPDX-License-Identifier: MIT */
/*
 * The bridge to Assimp: small files of each format, tests/data/import, whose values follow from their texts; and
 * captured motion against tables of an independent implementation, where it is at hand.
 */
#include <math.h>
#include <stdio.h>

#include <nakawari/euler.h>
#include <nakawari/mat.h>
#include <nakawari/mixer.h>
#include <nakawari/pose.h>
#include <nakawari/quat.h>

#include "moment.h"
#include "scene.h"

static nkw_quat product(nkw_quat a, nkw_quat b, nkw_quat c)
{
    return nkw_quat_mul(nkw_quat_mul(a, b), c);
}

/* The vertex of the first primitive at a place of the bind pose; its number. */
static size_t vertex_at(const moment *m, nkw_vec3 place)
{
    const nkw_document_primitive *p = &m->d->meshes[0].primitives[0];
    size_t v = 0;
    while (v < p->vertex_count && nkw_vec3_distance(p->positions[v], place) > 1e-6f)
        v++;
    assert_in_range(v, 0, p->vertex_count - 1);
    return v;
}

/* The weight of a joint of the skin for a vertex. */
static float weight(const moment *m, size_t vertex, const char *name)
{
    const nkw_document_primitive *p = &m->d->meshes[0].primitives[0];
    float sum = 0.0f;
    for (size_t i = 0; i < p->influence_count; i++)
        if ((size_t)m->d->skins[0].joints[p->joints[vertex * p->influence_count + i]] == joint(m, name))
            sum += p->weights[vertex * p->influence_count + i];
    return sum;
}

#define FILES NKW_TEST_DATA "/import/"

static void collada_has_its_unit_and_its_axis_in_the_root(void **state)
{
    (void)state;
    moment *m = open_file(FILES "arm.dae");
    const nkw_document_node *root = &m->d->nodes[0];
    assert_string_equal(m->d->format, "Collada Importer");
    expect_rotation_near(root->rest.rotation, turn('x', -90), 3e-7);
    expect_vec3_near(root->rest.scale, at(0.01f, 0.01f, 0.01f), 1e-8);
    play(m, 0.25f); /* keys 0 and 90 degrees at 0 and 0.5 s; 0 2 0 and 1 2 3 at 0 and 1 s */
    expect_rotation_near(local(m, "arm").rotation, turn('z', 45), 3e-7);
    expect_vec3_near(local(m, "arm").translation, at(0.25f, 2, 0.75f), 3e-7);
    play(m, 2.0f);
    expect_rotation_near(local(m, "arm").rotation, turn('z', 30), 3e-7);
    expect_vec3_near(local(m, "arm").translation, at(1, 2, 3), 3e-7);
    size_t both = vertex_at(m, at(0, 3, 0));
    expect_near(weight(m, both, "base"), 0.25, 1e-7);
    expect_near(weight(m, both, "arm"), 0.75, 1e-7);
    /* The bind shape moves by 0.25 along z, then the unit and the axis: z is y. */
    play(m, 0.0f);
    expect_vec3_near(nkw_mat4_transform_point(&m->palette[0], at(1, 0, 0)), at(0.01f, 0.0025f, 0), 1e-8);
    assert_string_equal(m->d->materials[0].name, "red");
    expect_near(m->d->materials[0].color[2], 0.5, 1e-7);
    close_file(m);
}

static void x_is_mirrored_to_a_right_handed_space(void **state)
{
    (void)state;
    moment *m = open_file(FILES "arm.x");
    play(m, 0.0f);
    expect_vec3_near(local(m, "arm").translation, at(0, 2, -0.5f), 0);
    play(m, 2.0f); /* tick 20 of 10 a second: 60 degrees about x, mirrored */
    expect_vec3_near(local(m, "arm").translation, at(1, 2, -0.5f), 3e-7);
    expect_rotation_near(local(m, "arm").rotation, turn('x', 60), 3e-7);
    size_t both = vertex_at(m, at(0, 3, 0));
    expect_near(weight(m, both, "base"), 0.25, 0);
    expect_near(weight(m, both, "arm"), 0.75, 0);
    vertex_at(m, at(1, 3, -0.25f));
    assert_int_equal(m->d->meshes[0].primitives[0].vertex_count, 4); /* six corners */
    close_file(m);
}

/* The place of (1, 2, 3) of a joint at a time. */
static nkw_vec3 far_point(moment *m, const char *name, float time)
{
    play(m, time);
    nkw_document_models(m->d, pose_view(m->pose, m->d->skeleton.joint_count), NULL, m->models);
    return nkw_mat4_transform_point(&m->models[joint(m, name)], at(1, 2, 3));
}

/*
 * Columns of the file with the z row and the z column negated: at tick 10 (-2 0 0) (0 0 -1) (0 3 0), at tick 20
 * (0 -2 0) (-1 0 0) (0 0 1); left: (-1 0 0) (0 1 0) (0 0 1).
 */
static void matrix_keys_of_x_that_mirror_have_a_negative_scale(void **state)
{
    (void)state;
    moment *m = open_file(FILES "mirror.x");
    assert_int_equal(m->d->animation_count, 1);
    expect_vec3_near(far_point(m, "arm", 0.0f), at(1, 4, 2.5f), 1e-6);
    expect_vec3_near(far_point(m, "arm", 1.0f), at(-2, 11, -2.5f), 2e-6);
    expect_vec3_near(far_point(m, "arm", 2.0f), at(-1, 0, 2.5f), 2e-6);
    expect_vec3_near(far_point(m, "left", 1.0f), at(0, 2, 1), 1e-6);
    assert_int_equal(m->d->warning_count, 2);
    assert_non_null(strstr(m->d->warnings[0], "joint arm: 2 keys mirror: they have a negative scale x"));
    assert_non_null(strstr(m->d->warnings[1], "joint left: 2 keys mirror"));
    close_file(m);
}

/* The muzzle, 2 m ahead in the gun, which is 1 m ahead in the turret: ahead is -z here. Angles in degrees. */
static void expect_muzzle(const moment *m, double way, double turned, double rise)
{
    const double to_radians = 3.14159265358979 / 180.0, ahead = 1.0 + 2.0 * cos(rise * to_radians);
    const nkw_vec3 tip = nkw_mat4_transform_point(&m->models[joint(m, "gun")], at(0, 0, -2));
    expect_near(tip.x, -ahead * sin(turned * to_radians), 1e-5);
    expect_near(tip.y, 1.0 + 2.0 * sin(rise * to_radians), 1e-5);
    expect_near(tip.z, -way - ahead * cos(turned * to_radians), 1e-5);
}

/*
 * The program of the matrix stack: AdvanceTime, then the models of the frames. In 2 s the tank drives 6 m and turns its
 * turret by 60 degrees; the other set raises the gun by 60 degrees in a second, and is faded in.
 */
static void a_tank_of_an_x_file_is_played_by_the_mixer(void **state)
{
    (void)state;
    moment *m = open_file(FILES "tank.x");
    const size_t joints = m->d->skeleton.joint_count;
    nkw_clip *aim = NULL;
    assert_int_equal(m->d->animation_count, 2);
    assert_int_equal(nkw_document_clip(m->d, 1, NKW_CLIP_FLOAT32, &aim, NULL), NKW_IMPORT_OK);
    const nkw_mixer_clip clips[2] = {{.clip = m->clip}, {.clip = aim}};
    float rest[NKW_POSE_FLOATS(JOINTS)];
    nkw_clip_sample(m->clip, 0.0f, NULL, pose_span(rest, joints), NULL);
    const nkw_mixer_set set = {.clips = clips, .clip_count = 2, .rest = pose_view(rest, joints)};
    assert_int_equal(nkw_mixer_set_validate(&set, NULL), NKW_OK);
    NKW_STACK_WORK(work, NKW_MIXER_WORK(2, JOINTS, 0));
    nkw_mixer_frame frame = {.pose = pose_span(m->pose, joints)};
    nkw_mixer_options drive = {.mode = NKW_PLAYBACK_LOOP}, raise = {.clip = 1, .fade = 0.5f};
    nkw_mixer mixer;
    memset(&mixer, 0, sizeof mixer);
    assert_int_equal(nkw_mixer_play(&mixer, &set, &drive, NULL), NKW_OK);
    for (int k = 1; k <= 90; k++) {
        const double share = (k % 60) / 60.0;
        assert_int_equal(nkw_mixer_advance(&mixer, &set, 1.0 / 30.0, &frame, work), NKW_OK);
        nkw_document_models(m->d, pose_view(m->pose, joints), NULL, m->models);
        if (k != 60) /* the end or the start, by the rounding of 60 steps */
            expect_muzzle(m, 6.0 * share, 60.0 * share, 0.0);
    }
    assert_int_equal(nkw_mixer_play(&mixer, &set, &raise, NULL), NKW_OK);
    assert_int_equal(nkw_mixer_advance(&mixer, &set, 0.25, &frame, work), NKW_OK);
    nkw_document_models(m->d, pose_view(m->pose, joints), NULL, m->models);
    expect_muzzle(m, 0.5 * 6.0 * 0.625, 0.5 * 60.0 * 0.625, 0.5 * 60.0 * 0.25);
    assert_int_equal(nkw_mixer_advance(&mixer, &set, 5.0, &frame, work), NKW_OK);
    nkw_document_models(m->d, pose_view(m->pose, joints), NULL, m->models);
    expect_muzzle(m, 0.0, 0.0, 60.0);
    nkw_import_free(aim);
    close_file(m);
}

/* The text with `instead` in place of `word`; to be freed. */
static char *replaced(const char *text, const char *word, const char *instead)
{
    const char *found = strstr(text, word);
    char *whole = (char *)malloc(strlen(text) + strlen(instead) + 1);
    assert_non_null(found);
    assert_non_null(whole);
    memcpy(whole, text, (size_t)(found - text));
    strcpy(whole + (found - text), instead);
    strcat(whole, found + strlen(word));
    return whole;
}

/* The same of a file. */
static char *edited(const char *path, const char *word, const char *instead)
{
    static char text[65536];
    FILE *file = fopen(path, "rb");
    assert_non_null(file);
    text[fread(text, 1, sizeof text - 1, file)] = 0;
    fclose(file);
    return replaced(text, word, instead);
}

static nkw_import_result open_bytes(const char *text, const char *name, nkw_document **d, nkw_import_error *error)
{
    const nkw_import_memory memory = {text, strlen(text), name, NULL, NULL, NULL, 0, 0};
    return nkw_document_from_memory(&memory, d, error);
}

/* Text that ends in any place, as Assimp reads it: nothing is read beyond it, and numbers are finite. */
static void x_that_ends_early_has_finite_keys(void **state)
{
    (void)state;
    char *whole = edited(FILES "mirror.x", "empty", "empty");
    const size_t bytes = strlen(whole), first = (size_t)(strstr(whole, "AnimationSet bend") - whole);
    size_t read = 0;
    for (size_t end = first; end < bytes; end++) {
        char *part = (char *)malloc(end);
        nkw_document *d;
        assert_non_null(part);
        memcpy(part, whole, end);
        const nkw_import_memory memory = {part, end, "part.x", NULL, NULL, NULL, 0, 0};
        if (nkw_document_from_memory(&memory, &d, NULL) == NKW_IMPORT_OK) {
            read++;
            for (size_t a = 0; a < d->animation_count; a++)
                for (size_t i = 0; i < d->animations[a].track_count; i++)
                    assert_int_equal(nkw_track_validate(&d->animations[a].tracks[i].track, NULL), NKW_OK);
        }
        nkw_document_close(d);
        free(part);
    }
    assert_true(read > 0);
    free(whole);
}

static void x_without_ticks_has_4800_a_second(void **state)
{
    (void)state;
    nkw_document *d;
    nkw_import_error error;
    char *text = edited(FILES "arm.x", "AnimTicksPerSecond {\n 10;\n}\n", "");
    assert_int_equal(open_bytes(text, "-", &d, &error), NKW_IMPORT_OK);
    const nkw_track *t = &d->animations[0].tracks[0].track;
    expect_near(t->times[t->count - 1], 20.0 / 4800.0, 1e-9);
    nkw_document_close(d);
    free(text);
}

static void md5_has_the_frame_rate_of_its_animation(void **state)
{
    (void)state;
    moment *m = open_file(FILES "arm.md5mesh");
    expect_rotation_near(m->d->nodes[0].rest.rotation, turn('x', -90), 3e-7);
    const nkw_quat rest = {0, 0, 0.5f, -sqrtf(0.75f)}, last = {0, 0.6f, 0, -0.8f};
    expect_rotation_near(m->d->nodes[joint(m, "arm")].rest.rotation, rest, 3e-7);
    play(m, 0.5f); /* frame 2 of 4 a second */
    expect_vec3_near(local(m, "base").translation, at(2, 0, 0), 0);
    expect_rotation_near(local(m, "arm").rotation, last, 3e-7);
    expect_vec3_near(local(m, "arm").translation, at(0, 0, 2), 0);
    /* Vertex 1: a quarter of 0 1 2 of the base, three quarters of 0 1 0 of the arm, turned by -60 degrees about z. */
    nkw_vec3 far = nkw_quat_rotate(rest, at(0, 1, 0));
    size_t v = vertex_at(m, at(0.75f * far.x, 0.25f + 0.75f * far.y, 0.5f + 0.75f * (2 + far.z)));
    expect_near(weight(m, v, "arm"), 0.75, 0);
    close_file(m);
    m = open_file(FILES "arm.md5anim");
    assert_int_equal(m->d->mesh_count, 0);
    expect_near(m->d->animations[0].tracks[0].track.times[2], 0.5, 0);
    close_file(m);
}

static void fbx_pivots_are_one_node_where_this_is_exact(void **state)
{
    (void)state;
    moment *m = open_file(FILES "arm.fbx");
    play(m, 0.0f);
    expect_rotation_near(local(m, "arm").rotation, product(turn('z', 90), turn('x', 10), turn('y', -20)), 4e-7);
    play(m, 1.0f);
    expect_rotation_near(local(m, "arm").rotation, product(turn('z', 90), turn('x', 100), turn('y', -20)), 4e-7);
    expect_vec3_near(local(m, "arm").translation, at(0, 3, 0), 3e-7);
    assert_int_equal(m->d->skeleton.parents[joint(m, "arm")], joint(m, "base"));
    const nkw_trs rest = m->d->nodes[joint(m, "arm")].rest;
    expect_rotation_near(rest.rotation, product(turn('z', 90), turn('x', 10), turn('y', -20)), 4e-7);
    expect_vec3_near(rest.translation, at(0, 2, 0), 3e-7);
    /* From 100 to 400 degrees in a second: the turn that the angles state. */
    play(m, 1.5f);
    expect_rotation_near(local(m, "arm").rotation, product(turn('z', 90), turn('x', 250), turn('y', -20)), 2e-6);
    /* A quarter turn about z at 2 s, of the point 0 1 0 above 0 3 0 of the base at 1 0 0. */
    play(m, 2.0f);
    nkw_vec3 origin = nkw_mat4_transform_point(&m->models[joint(m, "lever")], at(0, 0, 0));
    expect_vec3_near(origin, at(2, 4, 0), 1e-6);
    close_file(m);
}

static const nkw_track *rotations(const nkw_document *d)
{
    const nkw_clip_track *t = d->animations[0].tracks;
    while (t->target != NKW_CLIP_ROTATION)
        t++;
    return &t->track;
}

/* A key for each frame of 30 a second, of which two are 179 and -179 degrees. */
static void fbx_angles_of_each_frame_do_not_spin(void **state)
{
    (void)state;
    nkw_document *d;
    nkw_import_error error;
    nkw_clip *clip;
    float pose[NKW_POSE_FLOATS(JOINTS)];
    char *times = edited(FILES "arm.fbx", "KeyTime: *3 {\n\t\t\ta: 0,46186158000,92372316000",
                         "KeyTime: *10 {\na: 0,1539538600,3079077200,4618615800,6158154400,7697693000,9237231600,"
                         "10776770200,12316308800,13855847400");
    char *text = replaced(times, "KeyValueFloat: *3 {\n\t\t\ta: 10,100,400",
                          "KeyValueFloat: *10 {\na: 99,119,139,159,179,-179,-159,-139,-119,-99");
    assert_int_equal(open_bytes(text, "-", &d, &error), NKW_IMPORT_OK);
    assert_int_equal(rotations(d)->count, 11); /* and one at the last key of the translation */
    assert_int_equal(nkw_document_clip(d, 0, NKW_CLIP_FLOAT32, &clip, &error), NKW_IMPORT_OK);
    assert_int_equal(nkw_clip_sample(clip, 4.5f / 30.0f, NULL, pose_span(pose, d->skeleton.joint_count), NULL), NKW_OK);
    const nkw_trs arm = nkw_pose_get(pose_view(pose, d->skeleton.joint_count), 2);
    assert_string_equal(d->nodes[2].name, "arm");
    expect_rotation_near(arm.rotation, product(turn('z', 90), turn('x', 180), turn('y', -20)), 2e-6);
    nkw_import_free(clip);
    nkw_document_close(d);
    free(times);
    free(text);
}

static void formats_are_known_by_their_content(void **state)
{
    (void)state;
    static const char *const files[] = {"arm.bvh",     "arm.dae",     "arm.x",  "arm.fbx",
                                        "arm.md5mesh", "arm.md5anim", "bar.obj"};
    for (size_t i = 0; i < sizeof files / sizeof *files; i++) {
        char path[512];
        nkw_document *d;
        nkw_import_error error;
        snprintf(path, sizeof path, FILES "%s", files[i]);
        char *text = edited(path, "\n", "\n");
        nkw_import_result result = open_bytes(text, "-", &d, &error);
        if (result != NKW_IMPORT_OK)
            print_error("%s: %s\n", files[i], error.reason);
        assert_int_equal(result, NKW_IMPORT_OK);
        nkw_document_close(d);
        free(text);
    }
}

static void files_of_no_format_are_refused(void **state)
{
    (void)state;
    static const struct {
        nkw_import_result code;
        const char *name, *text;
    } list[] = {
        {NKW_IMPORT_UNKNOWN, "-", "to be or not to be"},
        {NKW_IMPORT_UNKNOWN, "a.gltf", "HIERARCH"},
        {NKW_IMPORT_UNKNOWN, "a.glb", "to be"},
        {NKW_IMPORT_UNKNOWN, "a.VRM", "to be"},
        {NKW_IMPORT_INVALID, "a.bvh", "to be"},
        {NKW_IMPORT_INVALID, "-", "HIERARCHY\nROOT a\n{\n"},
        {NKW_IMPORT_INVALID, "a.fbx", "; FBX 7.4.0\n{{{{"},
        {NKW_IMPORT_INVALID, "a.dae", "<COLLADA>"},
        {NKW_IMPORT_INVALID, "a.x", "xof 0303txt 0032\nFrame {"},
    };
    for (size_t i = 0; i < sizeof list / sizeof *list; i++) {
        nkw_document *d;
        nkw_import_error error;
        nkw_import_result result = open_bytes(list[i].text, list[i].name, &d, &error);
        if (result != list[i].code)
            print_error("%zu: %d: %s\n", i, (int)result, error.reason);
        assert_int_equal(result, list[i].code);
        assert_true(error.reason[0]);
        assert_null(d);
    }
}

static void channels_of_one_name_belong_to_the_nodes_in_their_order(void **state)
{
    (void)state;
    static const char text[] = "HIERARCHY\nROOT a\n{\nOFFSET 0 0 0\nCHANNELS 3 Xrotation Yrotation Zrotation\n"
                               "JOINT b\n{\nOFFSET 1 0 0\nCHANNELS 3 Xrotation Yrotation Zrotation\n}\n"
                               "JOINT b\n{\nOFFSET 2 0 0\nCHANNELS 3 Xrotation Yrotation Zrotation\n}\n}\n"
                               "MOTION\nFrames: 2\nFrame Time: 1\n0 0 0 10 0 0 20 0 0\n0 0 0 30 0 0 40 0 0\n";
    nkw_document *d;
    nkw_import_error error;
    nkw_clip *clip;
    float pose[NKW_POSE_FLOATS(3)];
    assert_int_equal(open_bytes(text, "-", &d, &error), NKW_IMPORT_OK);
    assert_int_equal(d->skeleton.joint_count, 3);
    assert_int_equal(nkw_document_clip(d, 0, NKW_CLIP_FLOAT32, &clip, &error), NKW_IMPORT_OK);
    assert_int_equal(nkw_clip_sample(clip, 1.0f, NULL, pose_span(pose, 3), NULL), NKW_OK);
    for (size_t j = 1; j < 3; j++) {
        const nkw_trs joint = nkw_pose_get(pose_view(pose, 3), j);
        expect_vec3_near(joint.translation, at((float)j, 0, 0), 0);
        expect_rotation_near(joint.rotation, turn('x', j == 1 ? 30 : 40), 3e-7);
    }
    nkw_import_free(clip);
    nkw_document_close(d);
}

static void vertices_without_weights_move_with_the_node_of_the_mesh(void **state)
{
    (void)state;
    nkw_document *d;
    nkw_import_error error;
    char *text = edited(FILES "arm.x", "    2;\n    2,3;\n    0.75,1.0;", "    1;\n    2;\n    0.75;");
    assert_int_equal(open_bytes(text, "-", &d, &error), NKW_IMPORT_OK);
    assert_int_equal(nkw_document_validate(d, &error), NKW_IMPORT_OK);
    const nkw_document_primitive *p = &d->meshes[0].primitives[0];
    const nkw_document_skin *skin = &d->skins[0];
    assert_int_equal(skin->joint_count, 3);
    assert_string_equal(d->nodes[skin->joints[2]].name, "body");
    expect_near(skin->inverse_bind[2].m[0], 1, 0);
    int found = 0;
    for (size_t v = 0; v < p->vertex_count; v++)
        if (nkw_vec3_distance(p->positions[v], at(1, 3, -0.25f)) < 1e-6f) {
            found++;
            assert_int_equal(p->joints[v * p->influence_count], 2);
            expect_near(p->weights[v * p->influence_count], 1, 0);
        }
    assert_int_equal(found, 1);
    nkw_document_close(d);
    free(text);
}

/* What Assimp reads and returns is checked: a bone without a node, a matrix that is not finite, a missing vertex. */
static void scenes_are_checked(void **state)
{
    (void)state;
    static const struct {
        const char *file, *word, *instead, *place;
    } list[] = {
        {"arm.x", "\"arm\";", "\"nobody\";", "/meshes/0/bones/1"},
        {"arm.x", "0.0,2.0,0.5,1.0", "nan,2.0,0.5,1.0", "/nodes/1"},
        {"arm.md5mesh", "tri 0 0 2 1", "tri 0 0 2 9", "line 28"},
        {"arm.md5mesh", "weight 3 1 1", "weight 3 7 1", "line 27"},
        {"arm.md5mesh", "vert 2 ( 0 1 ) 3 1", "vert 2 ( 0 1 ) 3 2", "line 28"},
        {"arm.md5mesh", "numtris 1\n", "numtris 2\n", "line 28"},
        {"arm.md5mesh", "\"arm\"\t0", "\"arm\"\t1", "line 9"},
        {"arm.md5anim", "\"arm\"\t0 56 1", "\"arm\"\t0 63 1", "line 27"},
        {"arm.md5anim", "\t2 0 0.6 0\n}", "\t2 0 0.6 0\n", "line 36"},
    };
    for (size_t i = 0; i < sizeof list / sizeof *list; i++) {
        char path[512];
        nkw_document *d;
        nkw_import_error error;
        snprintf(path, sizeof path, FILES "%s", list[i].file);
        char *text = edited(path, list[i].word, list[i].instead);
        assert_int_equal(open_bytes(text, "-", &d, &error), NKW_IMPORT_INVALID);
        assert_string_equal(error.place, list[i].place);
        free(text);
    }
}

/* A reader without files, which counts the questions. */
static size_t refuse(void *user, const char *path, void *out, size_t size)
{
    (void)out, (void)size;
    assert_true(path[0] != '/' && !strstr(path, ".."));
    *(int *)user += 1;
    return SIZE_MAX;
}

static void outer_files_are_those_of_the_folder(void **state)
{
    (void)state;
    static const char *const names[] = {"../arm.md5mesh", "/etc/arm.md5mesh", "a/../../arm.md5mesh"};
    char *text = edited(FILES "arm.md5mesh", "\n", "\n");
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        nkw_document *d;
        nkw_import_error error;
        int questions = 0;
        const nkw_import_memory memory = {text, strlen(text), names[i], NULL, refuse, &questions, 0, 0};
        assert_int_equal(nkw_document_from_memory(&memory, &d, &error), NKW_IMPORT_OK);
        assert_int_equal(d->bytes, strlen(text));
        assert_true(questions > 0); /* for arm.md5anim */
        nkw_document_close(d);
    }
    free(text);
}

/* 5e-6 of the largest value of a table of such rows. */
static double motion_bound(const char *table)
{
    FILE *file = table_open(table);
    char line[1024];
    double most = 1.0;
    while (fgets(line, sizeof line, file)) {
        const char *next = line;
        for (int column = 0; *next; column++, next += strcspn(next, ",") + (next[strcspn(next, ",")] != 0))
            most = column < 3 || line[0] == 't' ? most : fmax(most, fabs(strtod(next, NULL)));
    }
    table_close(file);
    return 5e-6 * most;
}

/* Rows Q (a local rotation) and W (a world matrix) of a frame number, of which k.5 is between two frames. */
static void captured_motion_is_that_of_an_independent_implementation(void **state)
{
    (void)state;
    static const float frame_time = 0.0083333f;
    const char *const table = NKW_DATA_DIR "/expected/cmu_12_01_walk.bvh.expected.csv";
    if (!scene_folder_is_there())
        skip();
    moment *m = open_file(NKW_DATA_DIR "/motion/cmu_12_01_walk.bvh");
    FILE *file = table_open(table);
    double bound = motion_bound(table);
    char line[1024], tag;
    int rows = 0, index, used;
    float frame;
    while (fgets(line, sizeof line, file)) {
        float values[16];
        if (sscanf(line, "%c,%f,%d%n", &tag, &frame, &index, &used) != 3)
            continue;
        size_t j = (size_t)m->d->joint_of_node[index];
        const char *next = line + used;
        for (int i = 0; i < (tag == 'Q' ? 4 : 16); i++, next += used)
            assert_int_equal(sscanf(next, ",%f%n", &values[i], &used), 1);
        play(m, frame * frame_time);
        if (tag == 'Q') {
            const nkw_quat want = {values[0], values[1], values[2], values[3]};
            expect_rotation_near(nkw_pose_get(pose_view(m->pose, m->d->skeleton.joint_count), j).rotation, want, bound);
        } else
            expect_floats_near(m->models[j].m, values, 16, bound);
        rows++;
    }
    table_close(file);
    assert_true(rows > 1000);
    close_file(m);
}

/* Every other file of the folder can be read. */
static void models_at_hand_are_read(void **state)
{
    (void)state;
    if (!scene_folder_is_there())
        skip();
    close_file(open_file(NKW_DATA_DIR "/motion/bvh_example.bvh"));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(collada_has_its_unit_and_its_axis_in_the_root),
        cmocka_unit_test(x_is_mirrored_to_a_right_handed_space),
        cmocka_unit_test(matrix_keys_of_x_that_mirror_have_a_negative_scale),
        cmocka_unit_test(x_that_ends_early_has_finite_keys),
        cmocka_unit_test(a_tank_of_an_x_file_is_played_by_the_mixer),
        cmocka_unit_test(x_without_ticks_has_4800_a_second),
        cmocka_unit_test(md5_has_the_frame_rate_of_its_animation),
        cmocka_unit_test(fbx_pivots_are_one_node_where_this_is_exact),
        cmocka_unit_test(fbx_angles_of_each_frame_do_not_spin),
        cmocka_unit_test(formats_are_known_by_their_content),
        cmocka_unit_test(files_of_no_format_are_refused),
        cmocka_unit_test(channels_of_one_name_belong_to_the_nodes_in_their_order),
        cmocka_unit_test(vertices_without_weights_move_with_the_node_of_the_mesh),
        cmocka_unit_test(scenes_are_checked),
        cmocka_unit_test(outer_files_are_those_of_the_folder),
        cmocka_unit_test(captured_motion_is_that_of_an_independent_implementation),
        cmocka_unit_test(models_at_hand_are_read),
    };
    return cmocka_run_group_tests_name("import_assimp", tests, NULL, NULL);
}
