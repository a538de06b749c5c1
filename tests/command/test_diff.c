/* SPDX-License-Identifier: MIT */
/* nakawari diff: a difference is planted in a copy, and is found where and when it is. */
#if !defined(_POSIX_C_SOURCE)
#define _POSIX_C_SOURCE 200809L
#endif
#include "program.h"

#include <stdlib.h>

#include "planted.h"
#include "samples.h"

static void write_clean(void)
{
    planted p = planted_clean();
    planted_write(&p, "diff_a");
}

static void a_file_with_itself_is_exactly_0(void **state)
{
    (void)state;
    write_clean();
    char *said = program_run(NULL, "diff diff_a.gltf diff_a.gltf");
    assert_string_equal(said, "clip 0 kick and clip 0 kick: 9 times\n        distance          time  joint\n"
                              "               0                3 joints\n");
    free(said);
    said = program_run(NULL, "diff '" NKW_CHARACTER "' '" NKW_CHARACTER "'");
    assert_int_equal(lines_with(said, "\n               0                20 joints"), 3);
    assert_int_equal(lines_with(said, "\n               0             0  morph weights"), 3);
    free(said);
}

static void expect_no_difference(const char *file)
{
    free(program_run(NULL, "diff '%s' '%s'", file, file));
}

static void real_files_with_themselves_are_exactly_0(void **state)
{
    (void)state;
    each_sample(expect_no_difference);
}

static void a_moved_key_is_found_with_its_time(void **state)
{
    (void)state;
    write_clean();
    planted p = planted_clean();
    p.translations[3][0] = 0.25f;
    planted_write(&p, "diff_b");
    program_says(1, "\n            0.25           1.5  knee\n", "diff diff_a.gltf diff_b.gltf");
    program_says(0, "  knee\n", "diff --tolerance 0.25 diff_a.gltf diff_b.gltf");
    program_says(1, "  knee\n", "diff --tolerance 0.2499 diff_a.gltf diff_b.gltf");
}

/* The farthest vertex is sqrt 2 from the knee, whose scale is 1.25: 2 sin(0.5 degrees) 1.25 sqrt 2. */
static void a_turn_counts_at_the_distance_of_the_skin(void **state)
{
    (void)state;
    write_clean();
    planted p = planted_clean();
    planted_turn(&p, 1, 41.0);
    planted_write(&p, "diff_b");
    program_says(1, " 0.030852", "diff diff_a.gltf diff_b.gltf");
    program_says(1, "0.5  knee\n", "diff diff_a.gltf diff_b.gltf");
    program_says(1, " 0.218162", "diff --distance 10 diff_a.gltf diff_b.gltf");
    program_says(0, "3 joints", "diff --distance 0 diff_a.gltf diff_b.gltf");
}

static void times_between_keys_are_compared(void **state)
{
    (void)state;
    planted p = planted_cubic();
    planted_write(&p, "diff_a");
    p.rotations[3 * 1 + 2][2] = 0.5f; /* the out-tangent of key 1 */
    planted_write(&p, "diff_b");
    program_says(1, "0.75  knee\n", "diff diff_a.gltf diff_b.gltf");
}

static void what_is_in_one_file_only_is_a_finding(void **state)
{
    (void)state;
    write_clean();
    program_says(1, "only in diff_a.gltf: joint knee\n", "diff diff_a.gltf '" NKW_CHARACTER "'");
    program_says(1, "character.glb: clip hop\n", "diff diff_a.gltf '" NKW_CHARACTER "'");
    program_says(1, "\"what\": \"joint\",\n   \"name\": \"knee\"", "diff --json diff_a.gltf '" NKW_CHARACTER "'");
}

static void misuse_and_files_in_error(void **state)
{
    (void)state;
    program_says(0, "Usage: nakawari diff", "diff --help");
    program_says(2, "FILE: missing", "diff a");
    program_says(2, "not a distance", "diff --tolerance -1 a b");
    program_says(2, "only one file", "diff - -");
    program_says(1, "no-such-file: ", "diff '" NKW_CHARACTER "' no-such-file");
    program_says(1, "no clip 5", "diff --clip 5 '" NKW_CHARACTER "' '" NKW_CHARACTER "'");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_file_with_itself_is_exactly_0),
        cmocka_unit_test(real_files_with_themselves_are_exactly_0),
        cmocka_unit_test(a_moved_key_is_found_with_its_time),
        cmocka_unit_test(a_turn_counts_at_the_distance_of_the_skin),
        cmocka_unit_test(times_between_keys_are_compared),
        cmocka_unit_test(what_is_in_one_file_only_is_a_finding),
        cmocka_unit_test(misuse_and_files_in_error),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
