/* SPDX-License-Identifier: MIT */
/*
 * Real animated models, sampled track by track and composed node by node, against tables of independent implementations
 * (three.js, SciPy). The files are not in the repository: without the folder NKW_DATA_DIR every test is skipped.
 */
#if !defined(_POSIX_C_SOURCE)
#define _POSIX_C_SOURCE 200809L /* popen */
#endif
#include <math.h>
#include <stdlib.h>

#include "support/expect.h"

#define NODES    64
#define CHANNELS 80
#define ANIMS    16

typedef struct node {
    int parent, is_matrix;
    nkw_trs rest;
    nkw_mat4 matrix;
} node;

typedef struct channel {
    int node, anim;
    char path[16];
    nkw_track track;
    float *times, *values;
} channel;

typedef struct scene {
    int nodes, channels;
    node node[NODES];
    channel channel[CHANNELS];
} scene;

static void read_floats(FILE *file, float *out, size_t n)
{
    for (size_t i = 0; i < n; i++)
        assert_int_equal(fscanf(file, "%f", &out[i]), 1);
}

static void read_node(FILE *file, scene *s)
{
    int index, parent;
    char kind;
    float v[16];
    assert_int_equal(fscanf(file, "%d %d %*d %c", &index, &parent, &kind), 3);
    assert_true(index >= 0 && index < NODES);
    node *n = &s->node[index];
    s->nodes = index >= s->nodes ? index + 1 : s->nodes;
    n->parent = parent;
    n->is_matrix = kind == 'M';
    read_floats(file, v, n->is_matrix ? 16 : 10);
    if (n->is_matrix)
        memcpy(&n->matrix, v, sizeof n->matrix);
    else
        memcpy(&n->rest, v, sizeof n->rest);
}

static void read_channel(FILE *file, scene *s, int anim)
{
    char mode[16];
    channel *c = &s->channel[s->channels++];
    assert_true(s->channels <= CHANNELS);
    assert_int_equal(fscanf(file, "%d %15s %15s %zu %zu", &c->node, c->path, mode, &c->track.count, &c->track.width), 5);
    c->anim = anim;
    c->track.kind = strcmp(c->path, "rotation") == 0 ? NKW_TRACK_ROTATION : NKW_TRACK_FLOATS;
    c->track.interpolation = strcmp(mode, "LINEAR") == 0 ? NKW_INTERPOLATION_LINEAR
                             : strcmp(mode, "STEP") == 0 ? NKW_INTERPOLATION_STEP
                                                         : NKW_INTERPOLATION_CUBICSPLINE;
    size_t count = nkw_track_value_count(&c->track);
    c->times = (float *)malloc(c->track.count * sizeof(float));
    c->values = (float *)malloc(count * sizeof(float));
    assert_true(c->times && c->values);
    read_floats(file, c->times, c->track.count);
    read_floats(file, c->values, count);
    c->track.times = c->times;
    c->track.values = c->values;
    assert_int_equal(nkw_track_validate(&c->track, NULL), NKW_OK);
}

static void read_scene(const char *name, scene *s)
{
    char path[512], word[256];
    int anim = -1;
    memset(s, 0, sizeof *s);
    snprintf(path, sizeof path, "%s/scenes/%s.scene.txt", NKW_DATA_DIR, name);
    FILE *file = fopen(path, "r");
    assert_non_null(file);
    while (fscanf(file, "%255s", word) == 1) {
        if (strcmp(word, "node") == 0)
            read_node(file, s);
        else if (strcmp(word, "anim") == 0)
            assert_int_equal(fscanf(file, "%d %*d", &anim), 1);
        else if (strcmp(word, "channel") == 0)
            read_channel(file, s, anim);
        else if (strcmp(word, "skinmeshes") == 0)
            break;
    }
    fclose(file);
}

static void free_scene(scene *s)
{
    for (int i = 0; i < s->channels; i++) {
        free(s->channel[i].times);
        free(s->channel[i].values);
    }
}

/* The node's local transform at a time of a clip; clip -1 is the rest pose. */
static nkw_trs local_at(const scene *s, int index, int anim, float time)
{
    nkw_trs t = s->node[index].rest;
    for (int i = 0; i < s->channels; i++) {
        const channel *c = &s->channel[i];
        if (c->node != index || c->anim != anim)
            continue;
        float *to = strcmp(c->path, "translation") == 0 ? &t.translation.x
                    : strcmp(c->path, "rotation") == 0  ? &t.rotation.x
                    : strcmp(c->path, "scale") == 0     ? &t.scale.x
                                                        : NULL;
        if (to)
            nkw_track_sample(&c->track, time, to);
    }
    return t;
}

static nkw_mat4 world_at(const scene *s, int index, int anim, float time)
{
    const node *n = &s->node[index];
    nkw_trs t = local_at(s, index, anim, time);
    nkw_mat4 local = n->is_matrix ? n->matrix : nkw_mat4_from_trs(&t);
    if (n->parent < 0)
        return local;
    nkw_mat4 parent = world_at(s, n->parent, anim, time);
    return nkw_mat4_mul_affine(&parent, &local);
}

/* A table of expected values, packed or not. */
static FILE *open_table(const char *name)
{
    char command[1024];
    snprintf(command, sizeof command, "gzip -dcf '%s/expected/%s.expected.csv'*", NKW_DATA_DIR, name);
    FILE *file = popen(command, "r");
    assert_non_null(file);
    return file;
}

/* tag, clip, time, a, b and as many values as the row has; 0 at the end. */
typedef struct table_row {
    char tag[8];
    int clip, a, b, count;
    float time, values[16];
} table_row;

static int read_row(FILE *file, table_row *r)
{
    char line[1024], *at = line;
    int used = 0;
    if (!fgets(line, sizeof line, file))
        return 0;
    r->count = 0;
    if (sscanf(line, "%7[^,],%d,%f,%d,%d%n", r->tag, &r->clip, &r->time, &r->a, &r->b, &used) != 5)
        return r->tag[0] = '#', 1;
    for (at += used; r->count < 16 && sscanf(at, ",%f%n", &r->values[r->count], &used) == 1; at += used)
        r->count++;
    return 1;
}

static void expect_same(const float *got, const float *want, int count, double bound)
{
    expect_floats_near(got, want, (size_t)count, bound);
}

/* Translation and scale as they are, rotation with either sign. */
static void expect_local(nkw_trs got, const float *want, double bound)
{
    nkw_quat rotation = {want[3], want[4], want[5], want[6]};
    expect_same(&got.translation.x, want, 3, bound);
    expect_rotation_near(got.rotation, rotation, bound);
    expect_same(&got.scale.x, want + 7, 3, bound);
}

/* Compares all rows of local values, morph weights and world matrices; gives how many. */
static int compare_scene(const char *name, double bound)
{
    static scene s;
    table_row r;
    int compared = 0;
    read_scene(name, &s);
    FILE *file = open_table(name);
    while (read_row(file, &r)) {
        if (strcmp(r.tag, "L") == 0 && r.a < s.nodes && ++compared)
            expect_local(local_at(&s, r.a, r.clip, r.time), r.values, bound);
        if (strcmp(r.tag, "W") == 0 && r.a < s.nodes && ++compared) {
            nkw_mat4 world = world_at(&s, r.a, r.clip, r.time);
            expect_same(world.m, r.values, 16, bound);
        }
    }
    pclose(file);
    free_scene(&s);
    return compared;
}

/* 5e-6 of the largest value in the file is fair for binary32, says the format. */
static void scenes_are_met(void **state)
{
    (void)state;
    assert_true(compare_scene("BoxAnimated", 2e-5) > 500);
    assert_true(compare_scene("InterpolationTest", 5e-5) > 5000);
    assert_true(compare_scene("Fox", 1.2e-3) > 5000);
}

/* Its keys are off unit by 2.3e-4. */
static void scene_with_keys_off_unit_is_met(void **state)
{
    (void)state;
    assert_true(compare_scene("SimpleSkin", 5e-4) > 200);
}

#define JOINTS 64

static nkw_euler_order order_of(const char channels[3])
{
    static const char orders[6][4] = {"XYZ", "XZY", "YXZ", "YZX", "ZXY", "ZYX"};
    int found = 0;
    for (int i = 0; i < 6; i++)
        found = memcmp(orders[i], channels, 3) == 0 ? i : found;
    return (nkw_euler_order)found;
}

typedef struct motion {
    int joints, channels[JOINTS];
    char kind[JOINTS][6][4];
    int frames[64], frame_count, values;
    float *value;
} motion;

static void read_joint(FILE *file, motion *m)
{
    int index;
    assert_int_equal(fscanf(file, "%d %*d %*f %*f %*f", &index), 1);
    assert_true(index >= 0 && index < JOINTS);
    assert_int_equal(fscanf(file, "%d", &m->channels[index]), 1);
    for (int i = 0; i < m->channels[index]; i++)
        assert_int_equal(fscanf(file, "%3s", m->kind[index][i]), 1);
}

static void read_motion(const char *name, motion *m)
{
    char path[512], word[256];
    memset(m, 0, sizeof *m);
    snprintf(path, sizeof path, "%s/scenes/%s.bvhscene.txt", NKW_DATA_DIR, name);
    FILE *file = fopen(path, "r");
    assert_non_null(file);
    while (fscanf(file, "%255s", word) == 1) {
        if (strcmp(word, "joints") == 0)
            assert_int_equal(fscanf(file, "%d", &m->joints), 1);
        else if (strcmp(word, "joint") == 0)
            read_joint(file, m);
        else if (strcmp(word, "frames") == 0) {
            assert_int_equal(fscanf(file, "%*d %d %*f", &m->values), 1);
            m->value = (float *)malloc(64 * (size_t)m->values * sizeof(float));
            assert_non_null(m->value);
        } else if (strcmp(word, "frame") == 0 && m->frame_count < 64) {
            assert_int_equal(fscanf(file, "%d", &m->frames[m->frame_count]), 1);
            read_floats(file, m->value + m->frame_count++ * m->values, (size_t)m->values);
        }
    }
    fclose(file);
}

/* The joint's local rotation in a frame of the list, from its Euler channels in the file's own order. */
static nkw_quat joint_rotation(const motion *m, int joint, int frame)
{
    const float *v = m->value + frame * m->values;
    nkw_vec3 angles = {0, 0, 0};
    char order[3] = {'X', 'Y', 'Z'};
    int turns = 0;
    for (int j = 0; j < joint; j++)
        v += m->channels[j];
    for (int i = 0; i < m->channels[joint]; i++) {
        char axis = m->kind[joint][i][1];
        if (m->kind[joint][i][0] != 'R')
            continue;
        *(axis == 'x' ? &angles.x : axis == 'y' ? &angles.y : &angles.z) = nkw_radians_from_degrees(v[i]);
        order[turns++ % 3] = (char)(axis - 'x' + 'X');
    }
    return nkw_quat_from_euler(angles, order_of(order));
}

static int frame_index(const motion *m, int number)
{
    for (int i = 0; i < m->frame_count; i++)
        if (m->frames[i] == number)
            return i;
    return -1;
}

/* Euler channels in the order of the file, and slerp half-way between frames. */
static void captured_motion_is_met(void **state)
{
    (void)state;
    static motion m;
    char line[1024];
    int compared = 0;
    read_motion("cmu_12_01_walk", &m);
    FILE *file = open_table("cmu_12_01_walk.bvh");
    while (fgets(line, sizeof line, file)) {
        float frame;
        int joint;
        nkw_quat want;
        if (sscanf(line, "Q,%f,%d,%f,%f,%f,%f", &frame, &joint, &want.x, &want.y, &want.z, &want.w) != 6)
            continue;
        int a = frame_index(&m, (int)frame), b = frame_index(&m, (int)frame + 1);
        int between = frame != (float)(int)frame;
        if (a < 0 || (between && b < 0))
            continue;
        nkw_quat q = joint_rotation(&m, joint, a);
        expect_rotation_near(between ? nkw_quat_slerp(q, joint_rotation(&m, joint, b), 0.5f) : q, want, 1e-6);
        compared++;
    }
    pclose(file);
    free(m.value);
    assert_true(compared > 300);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(scenes_are_met),
        cmocka_unit_test(scene_with_keys_off_unit_is_met),
        cmocka_unit_test(captured_motion_is_met),
    };
    FILE *there = fopen(NKW_DATA_DIR "/README.md", "r");
    if (!there) {
        printf("skipped: no models at %s\n", NKW_DATA_DIR);
        return 77;
    }
    fclose(there);
    return cmocka_run_group_tests_name("scene", tests, NULL, NULL);
}
