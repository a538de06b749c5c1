/* SPDX-License-Identifier: MIT */
/* nakawari plot. */
#if !defined(_POSIX_C_SOURCE)
#define _POSIX_C_SOURCE 200809L /* fork, kill, nanosleep */
#endif
#include "program.h"

#include <signal.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#define CHARACTER "plot '" NKW_CHARACTER "' "

/* How often the pen is set down in the curve that moves most of the first four, w, z, y and x of a rotation. */
static int moves_of(const char *svg)
{
    int most = 0;
    for (int i = 0; i < 4; i++) {
        int moves = 0;
        svg = strstr(svg + 1, "<path d=\"");
        assert_non_null(svg);
        for (const char *at = svg + strlen("<path d=\""); *at != '"'; at++)
            moves += *at == 'm';
        most = moves > most ? moves : most;
    }
    return most;
}

/* 601 keys that move, too many for dots: one path for each component, of some 20 bytes between two keys. */
static void a_curve_is_one_path(void **state)
{
    (void)state;
    FILE *f = fopen("long.csv", "wb");
    assert_non_null(f);
    fputs("name,time,tx,ty,tz\n", f);
    for (int k = 0; k <= 600; k++)
        fprintf(f, "box,%d,%d,%d,0\n", k, k % 7, k * k % 11);
    assert_int_equal(fclose(f), 0);
    char *svg = program_run(NULL, "plot long.csv");
    assert_int_equal(lines_with(svg, "<path"), 2 * 3);
    assert_int_equal(lines_with(svg, "<polyline"), 0);
    assert_true(strlen(svg) < 100000);
    free(svg);
}

static void each_channel_is_a_row_with_its_keys(void **state)
{
    (void)state;
    char *svg = program_run(NULL, CHARACTER "--clip hop --joint head,thigh.L --what rotation");
    assert_int_equal(lines_with(svg, "head rotation: STEP, 5 keys</text>"), 1);
    assert_int_equal(lines_with(svg, "thigh.L rotation: LINEAR, 5 keys</text>"), 1);
    assert_int_equal(lines_with(svg, " rotation: "), 2);
    assert_int_equal(lines_with(svg, "<circle"), 2 * 5 * 4);
    assert_int_equal(lines_with(svg, ">angular velocity, rad/s<"), 2);
    /* four values and three velocities each. A curve is interrupted where it jumps: STEP at the three keys within */
    assert_int_equal(lines_with(svg, "<path d=\"m"), 2 * 7);
    assert_int_equal(moves_of(strstr(svg, "head rotation")), 4);
    assert_int_equal(moves_of(strstr(svg, "thigh.L rotation")), 1);
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
    program_says(0, "arm.L rotation: STEP, 1 key</text>", CHARACTER "--clip wave --joint arm.L");
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

/* ---- paths ---- */

static void write_keys(const char *path, const char *text)
{
    FILE *f = fopen(path, "wb");
    assert_non_null(f);
    fputs(text, f);
    fclose(f);
}

/* The first and the last point of line `index` of a page. */
static void ends_of(const char *svg, int index, float ends[2][2])
{
    const char *at = svg;
    for (int i = 0; i <= index; i++) {
        at = strstr(at + 1, "<polyline points=\"");
        assert_non_null(at);
    }
    at += strlen("<polyline points=\"");
    assert_int_equal(sscanf(at, "%f,%f", &ends[0][0], &ends[0][1]), 2);
    const char *close = strchr(at, '"'), *last = close;
    while (last[-1] != ' ')
        last--;
    assert_int_equal(sscanf(last, "%f,%f", &ends[1][0], &ends[1][1]), 2);
}

/* From 0, 0, 0 to 3, 2, 1: to the right of the map and down; from the front up; from the left to the left and up. */
static void a_path_is_drawn_from_four_sides(void **state)
{
    (void)state;
    float above[2][2], camera[2][2], front[2][2], left[2][2];
    write_keys("path.csv", "name,time,tx,ty,tz\nbox,0,0,0,0\nbox,2,3,2,1\n");
    char *svg = program_run(NULL, "plot path.csv --what path");
    assert_int_equal(lines_with(svg, "<polyline"), 4);
    ends_of(svg, 0, above);
    ends_of(svg, 1, camera);
    ends_of(svg, 2, front);
    ends_of(svg, 3, left);
    expect_near((above[1][1] - above[0][1]) / (above[1][0] - above[0][0]), 1.0 / 3.0, 1e-3);
    assert_true(above[1][0] > above[0][0] + 300.0f);
    expect_near((front[1][1] - front[0][1]) / (front[1][0] - front[0][0]), -2.0 / 3.0, 1e-3);
    assert_true(front[1][0] > front[0][0] + 300.0f);
    expect_near((left[1][1] - left[0][1]) / (left[1][0] - left[0][0]), 2.0, 1e-2);
    assert_true(left[1][1] < left[0][1] - 300.0f);
    assert_true(camera[1][0] > camera[0][0] && camera[1][1] < camera[0][1]);
    assert_non_null(strstr(svg, ">end, 2 s<"));
    free(svg);
}

/* The hands and feet of a walk have the longest paths. */
static void without_a_list_the_longest_paths_are_drawn(void **state)
{
    (void)state;
    char *svg = program_run(NULL, CHARACTER "--clip walk --what path");
    assert_int_equal(lines_with(svg, "<polyline"), 4 * 5);
    assert_int_equal(lines_with(svg, ">foot.L<"), 1);
    assert_int_equal(lines_with(svg, ">foot.R<"), 1);
    assert_int_equal(lines_with(svg, "nan"), 0);
    free(svg);
    svg = program_run(NULL, CHARACTER "--clip walk --what path --joint head,hips");
    assert_int_equal(lines_with(svg, "<polyline"), 4 * 2);
    free(svg);
    program_says(1, "no joint elbow", CHARACTER "--what path --joint elbow");
}

/* ---- Euler angles ---- */

/* A half of the way from key 0 to key 1 of the exercise: docs/coursework.md. */
static void interpolated_angles_leave_the_arc(void **state)
{
    (void)state;
    char *svg = program_run(NULL, "plot '" NKW_KEYS "' --what euler --order yxz");
    assert_non_null(strstr(svg, "at most 20.6 at 0.5 s"));
    assert_int_equal(lines_with(svg, "<path d=\"m"), 3 + 3 + 1);
    assert_int_equal(lines_with(svg, "<circle"), 3 * 7);
    free(svg);
}

/* About one axis the two are equal; the angles unwrap beyond half a turn. */
static void angles_about_one_axis_are_the_arc(void **state)
{
    (void)state;
    write_keys("turn.csv", "name,time,yaw,pitch,roll\nbox,0,0,0,0\nbox,1,100,0,0\nbox,2,200,0,0\nbox,3,300,0,0\n");
    char *svg = program_run(NULL, "plot turn.csv --what euler --order yxz");
    const char *at = strstr(svg, "at most ");
    assert_non_null(at);
    assert_true(strtod(at + 8, NULL) < 1e-4);
    assert_int_equal(lines_with(svg, "<path d=\"m"), 3 + 3 + 1); /* none is interrupted */
    assert_non_null(strstr(svg, ">300<"));
    free(svg);
}

/* ---- files ---- */

static void png_is_twice_as_large(void **state)
{
    (void)state;
#if defined(NKW_CAIRO)
    static const unsigned char signature[8] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
    unsigned char head[24];
    free(program_run(NULL, CHARACTER "--clip hop --joint hips -o plotted.png"));
    FILE *f = fopen("plotted.png", "rb");
    assert_non_null(f);
    assert_int_equal(fread(head, 1, sizeof head, f), sizeof head);
    fclose(f);
    assert_memory_equal(head, signature, sizeof signature);
    assert_int_equal(head[18] << 8 | head[19], 2 * 1090);
    assert_int_equal(head[22] << 8 | head[23], 2 * 280);
    f = fopen("many.csv", "wb");
    assert_non_null(f);
    fputs("name,time,tx,ty,tz\n", f);
    for (int i = 0; i < 100; i++)
        fprintf(f, "n%d,0,0,0,0\n", i);
    fclose(f);
    program_says(1, "too many rows for a PNG", "plot many.csv --most 100 -o plotted.png");
#else
    program_says(2, "it needs cairo", CHARACTER "-o plotted.png");
#endif
}

static void pause_for(long milliseconds)
{
    struct timespec time = {milliseconds / 1000, milliseconds % 1000 * 1000000};
    nanosleep(&time, NULL);
}

/* Waits at most ten seconds until a file contains a text. */
static int appears(const char *path, const char *text)
{
    static char content[1 << 16];
    for (int i = 0; i < 200; i++) {
        FILE *f = fopen(path, "rb");
        size_t count = f ? fread(content, 1, sizeof content - 1, f) : 0;
        content[count] = 0;
        if (f)
            fclose(f);
        if (strstr(content, text) && strstr(content, "</svg>"))
            return 1;
        pause_for(50);
    }
    return 0;
}

/* A change is drawn; a file with an error is reported and watched further; an interrupt is the end. */
static void watch_draws_again_when_the_file_changes(void **state)
{
    (void)state;
    int status;
    remove("watched.svg");
    write_keys("watched.csv", "name,time,tx,ty,tz\nbox,0,0,0,0\nbox,2,3,2,1\n");
    pid_t child = fork();
    if (child == 0) {
        if (!freopen("/dev/null", "w", stderr))
            _exit(126);
        execl(NKW_PROGRAM, NKW_PROGRAM, "plot", "watched.csv", "--watch", "-o", "watched.svg", (char *)NULL);
        _exit(127);
    }
    assert_true(child > 0);
    int first = appears("watched.svg", "box translation: LINEAR, 2 keys");
    write_keys("watched.csv", "name,time,tx\nbox,0\n");
    pause_for(900);
    write_keys("watched.csv", "name,time,tx,ty,tz\nball,0,0,0,0\nball,1,3,2,1\nball,2,0,0,0\n");
    int second = appears("watched.svg", "ball translation: LINEAR, 3 keys");
    kill(child, SIGINT);
    assert_int_equal(waitpid(child, &status, 0), child);
    assert_true(first && second);
    assert_true(WIFEXITED(status));
    assert_int_equal(WEXITSTATUS(status), 0);
}

static void misuse_and_files_in_error(void **state)
{
    (void)state;
    program_says(0, "Usage: nakawari plot", "plot --help");
    program_says(2, "not translation", CHARACTER "--what matrix");
    program_says(2, "not in 1..1000", CHARACTER "--most 0");
    program_says(2, "not an order", CHARACTER "--what euler --order xyx");
    program_says(2, "only with --what euler", CHARACTER "--order xyz");
    program_says(2, "only with --output", CHARACTER "--watch");
    program_says(2, "not with the standard input", "plot - --watch -o x.svg");
    program_says(1, "no joint elbow", CHARACTER "--joint hips,elbow");
    program_says(2, "x.pdf: only .svg and .png are written", CHARACTER "-o x.pdf");
    program_says(1, "no channel of the clip", CHARACTER "--joint hips --what scale");
    program_says(0, "", CHARACTER "--joint hips > name.svg");
    program_says(0, "", CHARACTER "--joint 3 | cmp - name.svg");
    program_says(1, "no joint 200", CHARACTER "--joint 3,200");
    program_says(1, "choose a clip", CHARACTER "--clip rest");
    program_says(1, "/no/such/folder/x: cannot be written", CHARACTER "-o /no/such/folder/x");
    program_says(1, "no-such-file: ", "plot no-such-file");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_curve_is_one_path),
        cmocka_unit_test(each_channel_is_a_row_with_its_keys),
        cmocka_unit_test(all_kinds_are_drawn),
        cmocka_unit_test(a_track_of_one_key_is_drawn),
        cmocka_unit_test(output_goes_to_a_file),
        cmocka_unit_test(a_path_is_drawn_from_four_sides),
        cmocka_unit_test(without_a_list_the_longest_paths_are_drawn),
        cmocka_unit_test(interpolated_angles_leave_the_arc),
        cmocka_unit_test(angles_about_one_axis_are_the_arc),
        cmocka_unit_test(png_is_twice_as_large),
        cmocka_unit_test(watch_draws_again_when_the_file_changes),
        cmocka_unit_test(misuse_and_files_in_error),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
