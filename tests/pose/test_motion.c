/* SPDX-License-Identifier: MIT */
/*
 * Captured motion (BVH): Euler channels in the order of the file, composed joint by joint, against tables of an
 * independent implementation (SciPy). The files are not in the repository: without the folder NKW_DATA_DIR every test
 * is skipped.
 */
#if !defined(_POSIX_C_SOURCE)
#define _POSIX_C_SOURCE 200809L /* glob */
#endif
#include <glob.h>
#include <math.h>
#include <stdlib.h>

#include "scene.h"
#include "support/expect.h"

#define JOINTS 256
#define FRAMES 1024

typedef struct motion {
    int joints, channels[JOINTS];
    int32_t parents[JOINTS];
    nkw_vec3 offset[JOINTS];
    char kind[JOINTS][6][4]; /* Tx Ty Tz Rx Ry Rz, in the order of the file */
    int frames[FRAMES], frame_count, values;
    float *value;
} motion;

static void read_joint(FILE *file, motion *m)
{
    int index, parent;
    assert_int_equal(fscanf(file, "%d %d", &index, &parent), 2);
    assert_in_range(index, 0, JOINTS - 1);
    m->parents[index] = parent;
    scene_read_floats(file, &m->offset[index].x, 3);
    assert_int_equal(fscanf(file, "%d", &m->channels[index]), 1);
    assert_in_range(m->channels[index], 0, 6);
    for (int i = 0; i < m->channels[index]; i++)
        assert_int_equal(fscanf(file, "%3s", m->kind[index][i]), 1);
}

static void read_frame(FILE *file, motion *m)
{
    assert_true(m->value && m->frame_count < FRAMES);
    assert_int_equal(fscanf(file, "%d", &m->frames[m->frame_count]), 1);
    scene_read_floats(file, m->value + m->frame_count++ * m->values, (size_t)m->values);
}

static void read_motion(const char *path, motion *m)
{
    char word[256];
    memset(m, 0, sizeof *m);
    FILE *file = table_open(path);
    while (fscanf(file, "%255s", word) == 1) {
        if (strcmp(word, "joints") == 0)
            assert_int_equal(fscanf(file, "%d", &m->joints), 1);
        else if (strcmp(word, "joint") == 0)
            read_joint(file, m);
        else if (strcmp(word, "frames") == 0) {
            assert_int_equal(fscanf(file, "%*d %d %*f", &m->values), 1);
            m->value = (float *)malloc(FRAMES * (size_t)m->values * sizeof(float));
        } else if (strcmp(word, "frame") == 0)
            read_frame(file, m);
    }
    table_close(file);
    const nkw_skeleton skeleton = {m->parents, (size_t)m->joints};
    assert_int_equal(nkw_skeleton_validate(&skeleton, NULL), NKW_OK);
}

static nkw_euler_order order_of(const char axes[3])
{
    static const char orders[6][4] = {"xyz", "xzy", "yxz", "yzx", "zxy", "zyx"};
    int found = 0;
    while (found < 5 && memcmp(orders[found], axes, 3) != 0)
        found++;
    assert_memory_equal(orders[found], axes, 3);
    return (nkw_euler_order)found;
}

static float *component(nkw_vec3 *v, char axis)
{
    return axis == 'x' ? &v->x : axis == 'y' ? &v->y : &v->z;
}

/* offset + T channels; R(first) R(second) R(third). `v` are the joint's channels in a frame. */
static nkw_trs joint_local(const motion *m, int joint, const float *v)
{
    nkw_trs local = nkw_trs_identity();
    nkw_vec3 angles = {0, 0, 0};
    char axes[3] = {'x', 'y', 'z'};
    int turns = 0;
    local.translation = m->offset[joint];
    for (int i = 0; i < m->channels[joint]; i++) {
        char axis = m->kind[joint][i][1];
        if (m->kind[joint][i][0] == 'T')
            *component(&local.translation, axis) += v[i];
        else {
            *component(&angles, axis) = nkw_radians_from_degrees(v[i]);
            axes[turns++ % 3] = axis;
        }
    }
    local.rotation = nkw_quat_from_euler(angles, order_of(axes));
    return local;
}

/* The locals of all joints in frame number `frame`; returns 0 if the file omits it. */
static int locals_at(const motion *m, int frame, nkw_trs *locals)
{
    for (int f = 0; f < m->frame_count; f++) {
        const float *v = m->value + f * m->values;
        for (int j = 0; j < m->joints && m->frames[f] == frame; v += m->channels[j++])
            locals[j] = joint_local(m, j, v);
        if (m->frames[f] == frame)
            return 1;
    }
    return 0;
}

typedef struct moment {
    nkw_trs locals[JOINTS];
    nkw_mat4 models[JOINTS];
} moment;

/* k.5 is half-way between frames k and k + 1. */
static int move_to(const motion *m, float frame, moment *at)
{
    static nkw_trs next[JOINTS];
    const nkw_skeleton skeleton = {m->parents, (size_t)m->joints};
    int whole = (int)frame;
    float t = frame - (float)whole;
    if (!locals_at(m, whole, at->locals) || (t > 0.0f && !locals_at(m, whole + 1, next)))
        return 0;
    for (int j = 0; j < m->joints && t > 0.0f; j++) {
        nkw_trs *local = &at->locals[j];
        local->translation = nkw_vec3_lerp(local->translation, next[j].translation, t);
        local->rotation = nkw_quat_slerp(local->rotation, next[j].rotation, t);
    }
    for (int j = 0; j < m->joints; j++)
        at->models[j] = nkw_mat4_from_trs(&at->locals[j]);
    nkw_skeleton_models_from_locals(&skeleton, at->models, NULL, NULL, at->models);
    return 1;
}

/* "Q,frame,joint,x,y,z,w" and "W,frame,joint,m0..m15": returns the number of values. */
static int read_row(const char *line, char *tag, float *frame, int *joint, float values[16])
{
    int used = 0, count = 0;
    if (sscanf(line, "%c,%f,%d%n", tag, frame, joint, &used) != 3)
        return 0;
    for (line += used; count < 16 && sscanf(line, ",%f%n", &values[count], &used) == 1; line += used)
        count++;
    return count;
}

static int compare_motion(const char *path, const char *table)
{
    static motion m;
    static moment at;
    char line[1024], tag;
    float frame, was = -1.0f, v[16];
    int joint, compared = 0, there = 0;
    read_motion(path, &m);
    FILE *file = table_open(table);
    while (fgets(line, sizeof line, file)) {
        int count = read_row(line, &tag, &frame, &joint, v);
        if (count == 0)
            continue; /* the header */
        assert_in_range(joint, 0, m.joints - 1);
        if (frame != was)
            there = move_to(&m, was = frame, &at);
        assert_true(there);
        if (tag == 'Q') {
            nkw_quat want = {v[0], v[1], v[2], v[3]};
            expect_rotation_near(at.locals[joint].rotation, want, 1e-6);
        } else {
            double largest = fabs((double)v[12]) + fabs((double)v[13]) + fabs((double)v[14]);
            expect_floats_near(at.models[joint].m, v, 16, 5e-6 * (1.0 + largest));
        }
        compared++;
    }
    table_close(file);
    free(m.value);
    return compared;
}

static void captured_motions_are_met(void **state)
{
    (void)state;
    const char *const folder = NKW_DATA_DIR "/expected/";
    glob_t found;
    assert_int_equal(glob(NKW_DATA_DIR "/expected/*.bvh.expected.csv*", 0, NULL, &found), 0);
    for (size_t i = 0; i < found.gl_pathc; i++) {
        char name[64], path[512];
        assert_int_equal(sscanf(found.gl_pathv[i] + strlen(folder), "%63[^.]", name), 1);
        snprintf(path, sizeof path, "%s/scenes/%s.bvhscene.txt", NKW_DATA_DIR, name);
        int rows = compare_motion(path, found.gl_pathv[i]);
        printf("%s: %d rows\n", name, rows);
        assert_true(rows > 0);
    }
    globfree(&found);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(captured_motions_are_met)};
    if (!scene_folder_is_there())
        return 77;
    return cmocka_run_group_tests_name("motion", tests, NULL, NULL);
}
