/* SPDX-License-Identifier: MIT */
/* nakawari plot. */
#include "program.h"

#include <stdlib.h>

#define CHARACTER "plot '" NKW_CHARACTER "' "

static void each_channel_is_a_row_with_its_keys(void **state)
{
    (void)state;
    char *svg = program_run(NULL, CHARACTER "--clip hop --joint head,thigh.L --what rotation");
    assert_int_equal(lines_with(svg, "head rotation: STEP, 5 keys</text>"), 1);
    assert_int_equal(lines_with(svg, "thigh.L rotation: LINEAR, 5 keys</text>"), 1);
    assert_int_equal(lines_with(svg, " rotation: "), 2);
    assert_int_equal(lines_with(svg, "<circle"), 2 * 5 * 4);
    assert_int_equal(lines_with(svg, ">angular velocity, rad/s<"), 2);
    /* four segments, of seven components each */
    assert_int_equal(lines_with(svg, "<polyline"), 2 * 4 * 7);
    assert_string_equal(svg + strlen(svg) - 7, "</svg>\n");
    free(svg);
}

static void all_kinds_are_drawn(void **state)
{
    (void)state;
    char *svg = program_run(NULL, CHARACTER "--clip hop");
    assert_int_equal(lines_with(svg, "hips translation: CUBICSPLINE, 5 keys</text>"), 1);
    assert_int_equal(lines_with(svg, "head scale: LINEAR, 5 keys</text>"), 1);
    assert_int_equal(lines_with(svg, "face weights: LINEAR, 5 keys</text>"), 1);
    assert_int_equal(lines_with(svg, "nan"), 0);
    free(svg);
    program_says(0, "3 of 12 channels", CHARACTER "--clip hop --most 3");
}

/* One key has no velocity; its value is a line of no length. */
static void a_track_of_one_key_is_drawn(void **state)
{
    (void)state;
    program_says(0, "arm.L rotation: STEP, 1 keys</text>", CHARACTER "--clip wave --joint arm.L");
}

static void output_goes_to_a_file(void **state)
{
    (void)state;
    char *svg = program_run(NULL, CHARACTER "--joint hips"), *none;
    none = program_run(NULL, CHARACTER "--joint hips -o plotted.svg");
    assert_string_equal(none, "");
    free(none);
    program_says(0, "", CHARACTER "--joint hips | cmp plotted.svg -");
    free(svg);
}

static void misuse_and_files_in_error(void **state)
{
    (void)state;
    program_says(0, "Usage: nakawari plot", "plot --help");
    program_says(2, "not translation", CHARACTER "--what matrix");
    program_says(2, "not in 1..1000", CHARACTER "--most 0");
    program_says(1, "no channel of the clip", CHARACTER "--joint elbow");
    program_says(1, "choose a clip", CHARACTER "--clip rest");
    program_says(1, "/no/such/folder/x: cannot be written", CHARACTER "-o /no/such/folder/x");
    program_says(1, "no-such-file: ", "plot no-such-file");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_channel_is_a_row_with_its_keys), cmocka_unit_test(all_kinds_are_drawn),
        cmocka_unit_test(a_track_of_one_key_is_drawn),         cmocka_unit_test(output_goes_to_a_file),
        cmocka_unit_test(misuse_and_files_in_error),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
