/* SPDX-License-Identifier: MIT */
/* nakawari diff of two logs, written by the program of docs/subjects/clip/fingerprint.md. */
#if !defined(_POSIX_C_SOURCE)
#define _POSIX_C_SOURCE 200809L
#endif
#include <math.h>
#include <stdlib.h>

#include "subjects_clip_fingerprint_1.c"

#include "program.h"

enum { JOINTS = 3, FRAMES = 5 };

/* A difference of one number in one frame; frame FRAMES: none. */
typedef struct planted_difference {
    unsigned long frame;
    size_t joint;
    int is_in_mixer;
} planted_difference;

static const planted_difference none = {FRAMES, 0, 0};

static void write_log(const char *path, planted_difference d, unsigned long count, int numbers)
{
    static float data[NKW_POSE_FLOATS(JOINTS)];
    const nkw_pose_span pose = {data, JOINTS};
    nkw_mixer mixer;
    memset(&mixer, 0, sizeof mixer);
    FILE *log = fopen(path, "w");
    assert_non_null(log);
    for (unsigned long f = 0; f < count; f++) {
        nkw_pose_identity(pose);
        for (size_t j = 0; j < JOINTS; j++) {
            nkw_trs t = nkw_trs_identity();
            t.translation.x = 0.1f * (float)(f + j);
            if (f == d.frame && j == d.joint && !d.is_in_mixer)
                t.rotation.y = 0x1p-24f, t.scale.z = nextafterf(1.0f, 2.0f);
            nkw_pose_set(pose, j, &t);
        }
        mixer.slot_count = 1;
        mixer.slot[0].playing = 2;
        mixer.slot[0].time = f == d.frame && d.is_in_mixer ? 0.5 : 0.25;
        log_frame(log, f, NKW_VIEW(nkw_pose, pose), &mixer, NULL, numbers);
    }
    fclose(log);
}

static void write_text(const char *path, const char *text)
{
    FILE *f = fopen(path, "w");
    assert_non_null(f);
    fputs(text, f);
    fclose(f);
}

static void equal_logs_are_the_same(void **state)
{
    (void)state;
    write_log("a.log", none, FRAMES, 1);
    program_says(0, "5 frames are the same\n", "diff a.log a.log");
    write_log("b.log", none, FRAMES, 0);
    program_says(0, "5 frames are the same\n", "diff a.log b.log");
    program_says(0, "\"same\": true", "diff --json a.log b.log");
}

static void the_first_difference_has_its_frame_joint_and_component(void **state)
{
    (void)state;
    const planted_difference d = {3, 1, 0};
    write_log("a.log", none, FRAMES, 1);
    write_log("b.log", d, FRAMES, 1);
    program_says(1, "3 frames are the same\nframe 3: joint 1 rotation.y: 0 and 5.96046448e-08,", "diff a.log b.log");
    program_says(1, "; 2 numbers differ\n", "diff a.log b.log");
    program_says(1, "\"component\": \"rotation.y\"", "diff --json a.log b.log");
    program_says(1, "\"joint\": 1", "diff --json a.log b.log");
    program_says(1, "joint 1 scale.z: 1 and 1.00000012, 1 ulp; 1 number differs\n",
                 "diff --tolerance 1e-7 a.log b.log");
    program_says(0, "5 frames are the same\n", "diff --tolerance 1e-6 a.log b.log");
}

static void without_numbers_the_fingerprints_are_printed(void **state)
{
    (void)state;
    const planted_difference d = {2, 0, 0}, in_mixer = {4, 0, 1};
    write_log("a.log", none, FRAMES, 0);
    write_log("b.log", d, FRAMES, 0);
    program_says(1, "2 frames are the same\nframe 2: ", "diff a.log b.log");
    program_says(1, "; log the joints of this frame\n", "diff a.log b.log");
    write_log("a.log", none, FRAMES, 1);
    write_log("b.log", in_mixer, FRAMES, 1);
    program_says(1, "4 frames are the same\nframe 4: ", "diff a.log b.log");
    program_says(1, "; the numbers are the same\n", "diff a.log b.log");
}

static void logs_of_other_lengths_and_frames_differ(void **state)
{
    (void)state;
    write_log("a.log", none, FRAMES, 0);
    write_log("b.log", none, FRAMES - 2, 0);
    program_says(1, "3 frames are the same\nb.log has no frame 3\n", "diff a.log b.log");
    program_says(1, "3 frames are the same\nb.log has no frame 3\n", "diff b.log a.log");
    write_text("b.log", "frame 0 0\n");
    write_text("a.log", "frame 1 0\n");
    program_says(1, "0 frames are the same\nthen frame 1 and frame 0\n", "diff a.log b.log");
}

static void names_floats_zeros_and_nans_are_read(void **state)
{
    (void)state;
    write_text("a.log", "frame 7 1\n# a comment\n\njoint 4 0 0 0 0 0 0 1 1 1 1 left hand\nfloats 1 nan\nfloats 0 5\n");
    write_text("b.log", "frame 7 2\njoint 4 0 0 0 0 0 0 1 1 1 1 left hand\nfloats 1 -nan\nfloats -0 6\n");
    program_says(1, "frame 7: float 2: 0 and -0, -1 ulp; 2 numbers differ\n", "diff a.log b.log");
    write_text("b.log", "frame 7 2\njoint 4 0 0 0 0 0 0 -1 1 1 1 left hand\nfloats 1 -nan\nfloats 0 5\n");
    program_says(1, "frame 7: joint 4 left hand rotation.w: 1 and -1,", "diff a.log b.log");
}

static void faults_have_their_line(void **state)
{
    (void)state;
    write_text("a.log", "frame 0 0\n");
    write_text("b.log", "frame 0 0\njoint 1 2 3\n");
    program_says(1, "b.log:line 2: a joint has an index and ten numbers\n", "diff a.log b.log");
    write_text("b.log", "frame 0 0\nfloats 1 x\n");
    program_says(1, "b.log:line 2: no number\n", "diff a.log b.log");
    write_text("b.log", "frame 0 0\nFrame 1 0\n");
    program_says(1, "b.log:line 2: neither frame, joint nor floats\n", "diff a.log b.log");
    write_text("b.log", "frame 0 hash\n");
    program_says(1, "b.log:line 1: no frame: frame NUMBER HASH\n", "diff a.log b.log");
    program_says(2, "a log has no clips", "diff --clip 1 a.log b.log");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(equal_logs_are_the_same),
        cmocka_unit_test(the_first_difference_has_its_frame_joint_and_component),
        cmocka_unit_test(without_numbers_the_fingerprints_are_printed),
        cmocka_unit_test(logs_of_other_lengths_and_frames_differ),
        cmocka_unit_test(names_floats_zeros_and_nans_are_read),
        cmocka_unit_test(faults_have_their_line),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
