/* SPDX-License-Identifier: MIT */
/* nakawari info. */
#include "program.h"

#include <stdlib.h>

#define CHARACTER "info '" NKW_CHARACTER "' "

static void each_clip_has_a_line(void **state)
{
    (void)state;
    char *text = program_run(NULL, CHARACTER "--clips");
    assert_non_null(strstr(text, "20 nodes, 2 skins, 2 meshes, 4 materials, 3 clips, 1 morph weight\n"));
    assert_non_null(strstr(text, "\n   0  walk        10      10       90          0          1       1440"));
    assert_int_equal(lines_with(text, "CUBICSPLINE"), 0);
    free(text);
}

static void each_channel_has_a_line(void **state)
{
    (void)state;
    char *text = program_run(NULL, CHARACTER);
    assert_int_equal(lines_with(text, "LINEAR  "), 20);
    assert_int_equal(lines_with(text, "STEP  "), 2);
    assert_int_equal(lines_with(text, "CUBICSPLINE  "), 4);
    assert_int_equal(lines_with(text, "  8/s  "), 10);
    free(text);
}

static void json_has_the_channels(void **state)
{
    (void)state;
    char *all = program_run(NULL, CHARACTER "--json"), *clips = program_run(NULL, CHARACTER "--json --clips");
    assert_int_equal(lines_with(all, "\"mode\": \"CUBICSPLINE\""), 4);
    assert_int_equal(lines_with(all, "\"spacing\": \"uniform\""), 25);
    assert_int_equal(lines_with(all, "\"keys\": 90,"), 1);
    assert_int_equal(lines_with(clips, "\"mode\""), 0);
    free(all);
    free(clips);
}

static void output_is_the_same_each_time(void **state)
{
    (void)state;
    char *once = program_run(NULL, CHARACTER), *again = program_run(NULL, CHARACTER);
    assert_string_equal(once, again);
    free(once);
    free(again);
}

/* The walk has 9 keys; a large tolerance makes every track constant. */
static void reduced_bytes_depend_on_the_tolerance(void **state)
{
    (void)state;
    char *fine = program_run(NULL, CHARACTER "--clips --reduced | awk '$2 == \"walk\" { print $NF }'");
    char *coarse = program_run(NULL, CHARACTER "--clips --tolerance 10 | awk '$2 == \"walk\" { print $NF }'");
    assert_true(atoi(fine) > atoi(coarse) && atoi(coarse) > 0);
    free(fine);
    free(coarse);
    program_says(0, "\"reduced_bytes\": ", CHARACTER "--json -r");
    program_says(2, "not a distance", CHARACTER "--tolerance -2");
}

static void misuse_and_files_in_error(void **state)
{
    (void)state;
    program_says(0, "Usage: nakawari info", "info --help");
    program_says(2, "--at: unknown option", CHARACTER "--at 0");
    program_says(1, "no-such-file: ", "info no-such-file");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_clip_has_a_line),
        cmocka_unit_test(each_channel_has_a_line),
        cmocka_unit_test(json_has_the_channels),
        cmocka_unit_test(output_is_the_same_each_time),
        cmocka_unit_test(reduced_bytes_depend_on_the_tolerance),
        cmocka_unit_test(misuse_and_files_in_error),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
