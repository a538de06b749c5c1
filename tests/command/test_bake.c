/* SPDX-License-Identifier: MIT */
/* nakawari bake: the files are read back by the library, and hold what `sample` prints. */
#include "program.h"

#include <math.h>
#include <stdlib.h>

#define CHARACTER "bake '" NKW_CHARACTER "' "
#define JOINTS    20

static union {
    float aligned;
    unsigned char bytes[1 << 20];
} file;

static size_t read_baked(const char *arguments)
{
    free(program_run(NULL, CHARACTER "%s -o baked.nkw", arguments));
    FILE *f = fopen("baked.nkw", "rb");
    assert_non_null(f);
    size_t bytes = fread(file.bytes, 1, sizeof file.bytes, f);
    fclose(f);
    return bytes;
}

/* The local transforms of `sample` at a time, by nodes of the file. */
static void read_sample(const char *clip, float time, float want[JOINTS][10])
{
    char *csv = program_run(NULL, "sample '" NKW_CHARACTER "' --clip %s --at %.9g", clip, (double)time);
    const char *at = strchr(csv, '\n') + 1;
    for (size_t j = 0; j < JOINTS; j++) {
        int used = 0;
        assert_int_equal(sscanf(at, "%*d,%*f,%*d,%*[^,]%n", &used), 0);
        for (int i = 0; i < 10; i++) {
            at += used;
            assert_int_equal(sscanf(at, ",%f%n", &want[j][i], &used), 1);
        }
        at = strchr(at, '\n') + 1;
    }
    free(csv);
}

/*
 * The joints of a clip may be in another order than the nodes of the file, and rotations negated: compares sums of
 * weighted absolute values.
 */
static double largest_difference(const nkw_clip *clip, const char *name, float time)
{
    static float data[NKW_POSE_FLOATS(JOINTS)];
    float want[JOINTS][10];
    nkw_pose_span pose = {data, JOINTS};
    double sum_got = 0.0, sum_want = 0.0;
    assert_int_equal(nkw_clip_joint_count(clip), JOINTS);
    assert_int_equal(nkw_clip_sample(clip, time, NULL, pose, NULL), NKW_OK);
    read_sample(name, time, want);
    for (size_t j = 0; j < JOINTS; j++) {
        nkw_trs t = nkw_pose_get(nkw_pose_view_from_span(pose), j);
        float got[10] = {t.translation.x, t.translation.y, t.translation.z, t.rotation.x, t.rotation.y,
                         t.rotation.z,    t.rotation.w,    t.scale.x,       t.scale.y,    t.scale.z};
        for (int i = 0; i < 10; i++) {
            sum_got += fabs((double)got[i]) * (1.0 + i);
            sum_want += fabs((double)want[j][i]) * (1.0 + i);
        }
    }
    return fabs(sum_got - sum_want);
}

static void clips_map_back(void **state)
{
    (void)state;
    static const struct {
        const char *arguments;
        double bound;
    } forms[] = {{"--clip walk", 1e-9},
                 {"--clip walk --as compact", 5e-3},
                 {"--clip walk --as reduced", 5e-2},
                 {"--clip walk --as reduced --tolerance 0.00001", 5e-3}};
    for (size_t i = 0; i < sizeof forms / sizeof forms[0]; i++) {
        const nkw_clip *clip;
        size_t bytes = read_baked(forms[i].arguments);
        assert_int_equal(nkw_clip_open(file.bytes, bytes, &clip), NKW_OK);
        assert_int_equal(nkw_clip_bytes(clip), bytes);
        assert_true(nkw_clip_end(clip) == 1.0f);
        for (int k = 0; k <= 8; k++)
            assert_true(largest_difference(clip, "walk", (float)k / 8.0f) <= forms[i].bound);
    }
}

static uint32_t u32_at(size_t at)
{
    uint32_t value = 0;
    for (int i = 3; i >= 0; i--)
        value = value << 8 | file.bytes[at + (size_t)i];
    return value;
}

/* Frames 0, 1/4, 1/2, 3/4, 1 s; 12 floats for each of the 17 joints of the first skin. */
static void palettes_are_rows_of_the_joint_matrices(void **state)
{
    (void)state;
    size_t bytes = read_baked("--clip walk --as palette --rate 4");
    assert_memory_equal(file.bytes, "nkwpalet", 8);
    assert_int_equal(u32_at(8), 1);
    assert_int_equal(u32_at(12), 17);
    assert_int_equal(u32_at(16), 5);
    assert_int_equal(u32_at(28), 0x3f800000);
    assert_int_equal(bytes, 32 + 5 * 17 * 48);
    char *csv = program_run(NULL, "sample '" NKW_CHARACTER "' --clip walk --at 0.5 --what palette | sed -n 4p");
    const char *at = csv;
    for (int i = 0; i < 4; i++)
        at = strchr(at, ',') + 1;
    for (int i = 0; i < 16; i++) {
        float want = strtof(at, NULL);
        if (i % 4 < 3)
            expect_bits(float_of(u32_at(32 + ((2 * 17 + 2) * 12 + (size_t)(4 * (i % 4) + i / 4)) * 4)), want);
        at = strchr(at, ',') ? strchr(at, ',') + 1 : at;
    }
    free(csv);
}

static void misuse_and_files_in_error(void **state)
{
    (void)state;
    program_says(0, "Usage: nakawari bake", "bake --help");
    program_says(2, "not clip, compact", CHARACTER "--as mp4");
    program_says(2, "needed for palettes", CHARACTER "--as palette");
    program_says(2, "only with --as palette", CHARACTER "--rate 30");
    program_says(2, "not a distance", CHARACTER "--tolerance -2");
    program_says(1, "no such skin", CHARACTER "--as palette --rate 30 --skin 2");
    program_says(1, "choose one clip", CHARACTER "--clip all");
    program_says(1, "cannot be written", CHARACTER "-o /no/such/folder/x");
    program_says(1, "no-such-file: ", "bake no-such-file");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(clips_map_back),
        cmocka_unit_test(palettes_are_rows_of_the_joint_matrices),
        cmocka_unit_test(misuse_and_files_in_error),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
