/* SPDX-License-Identifier: MIT */
/* nakawari exercise: the exercise with keys from files. */
#if !defined(_POSIX_C_SOURCE)
#define _POSIX_C_SOURCE 200809L
#endif
#include "program.h"

#include <stdlib.h>

#define EXAMPLES NKW_FIGURES "/../examples/"

/* The row of a table without its last 16 fields; the 16 numbers of the matrix. */
typedef struct row {
    char scene[32], position[32], orientation[32];
    double keys, time, segment, t, m[16];
} row;

static int read_row(const char *line, row *r)
{
    int used = 0;
    if (sscanf(line, "%31[^,],%lf,%31[^,],%31[^,],%lf,%lf,%lf%n", r->scene, &r->keys, r->position, r->orientation,
               &r->time, &r->segment, &r->t, &used) != 7)
        return 0;
    for (int i = 0; i < 16; i++) {
        int more = 0;
        if (sscanf(line + used, ",%lf%n", &r->m[i], &more) != 1)
            return 0;
        used += more;
    }
    return 1;
}

static size_t read_table(const char *path, row *rows, size_t most)
{
    char line[1024];
    size_t count = 0;
    FILE *f = fopen(path, "rb");
    assert_non_null(f);
    while (count < most && fgets(line, sizeof line, f))
        count += (size_t)read_row(line, &rows[count]);
    fclose(f);
    return count;
}

static const row *find_row(const row *rows, size_t count, const row *like, const char *position, const char *orientation)
{
    for (size_t i = 0; i < count; i++)
        if (strcmp(rows[i].scene, like->scene) == 0 && strcmp(rows[i].position, position) == 0 &&
            strcmp(rows[i].orientation, orientation) == 0 && rows[i].time > like->time - 1e-4 &&
            rows[i].time < like->time + 1e-4)
            return &rows[i];
    fail_msg("no row of %s at %g", like->scene, like->time);
    return NULL;
}

enum { MOST = 6000 };
typedef struct tables {
    row want[MOST], got[MOST];
    size_t want_count, got_count;
} tables;

/* The largest difference of an element from the row's curve in one row of the table and its orientation in another. */
static double distance(const tables *t, const row *r, const char *curve)
{
    const row *p = find_row(t->want, t->want_count, r, curve, "euler");
    const row *q = find_row(t->want, t->want_count, r, "linear", r->orientation);
    double most = 0.0;
    for (int k = 0; k < 16; k++) {
        double d = r->m[k] - (k < 12 ? q : p)->m[k];
        most = d > most ? d : -d > most ? -d : most;
    }
    return most;
}

static void read_written(tables *t, int scene, const char *rule)
{
    char path[64];
    snprintf(path, sizeof path, "scene%d_%s.csv", scene, rule);
    t->got_count = read_table(path, t->got, MOST);
    assert_int_equal(t->got_count, 12 * (scene == 1 ? 71 : 21));
}

/* Against the table that a program of its own computed in binary64. */
static void the_scenes_of_the_exercise_have_its_matrices(void **state)
{
    (void)state;
    tables *t = calloc(1, sizeof *t);
    assert_non_null(t);
    t->want_count = read_table(NKW_FIGURES "/../../tests/data/coursework_expected.csv", t->want, MOST);
    for (int scene = 1; scene <= 2; scene++) {
        free(program_run(NULL, "exercise '" EXAMPLES "scenes.json' --clip scene%d -o .", scene));
        read_written(t, scene, "exercise");
        for (size_t i = 0; i < t->got_count; i++)
            expect_near((float)distance(t, &t->got[i], t->got[i].position), 0.0, 2e-6);
    }
    free(t);
}

/* Bezier is clamped; the orientation of a key holds from its time on. All other rows are those of the exercise. */
static void the_table_of_the_library_differs_where_the_page_says(void **state)
{
    (void)state;
    tables *t = calloc(1, sizeof *t);
    size_t steps = 0;
    assert_non_null(t);
    t->want_count = read_table(NKW_FIGURES "/../../tests/data/coursework_expected.csv", t->want, MOST);
    char *said = program_run(NULL, "exercise '" EXAMPLES "scenes.json' --clip scene1 -o . --rule library");
    assert_non_null(strstr(said, "69 of their 852 rows differ"));
    free(said);
    read_written(t, 1, "library");
    for (size_t i = 0; i < t->got_count; i++) {
        const row *r = &t->got[i];
        const int on_key = r->time == (int)r->time && r->time >= 1.0, step = strcmp(r->orientation, "none") == 0;
        const double d = distance(t, r, strcmp(r->position, "bezier") == 0 ? "bezier_clamped" : r->position);
        if (step && (on_key || r->time > 6.0)) {
            assert_true(d > 0.1);
            steps++;
        } else
            expect_near((float)d, 0.0, 2e-6);
    }
    assert_int_equal(steps, 4 * 11);
    free(t);
}

static void all_pictures_and_the_page_are_written(void **state)
{
    (void)state;
    program_says(0, "5 pictures, all on one page: ./index.html", "exercise '" EXAMPLES "flight.csv' -o .");
    program_says(0, "all of them",
                 "--version >/dev/null; grep -l '</svg>' trajectory-top.svg trajectory-perspective.svg frames.svg "
                 "frames-compare.svg orientation-compare.svg | wc -l | grep -q 5 && grep -q '10 keys' index.html && "
                 "echo all of them");
}

static void a_trace_explains_one_time(void **state)
{
    (void)state;
    program_says(0, "segment 1, from key 1 to key 2", "exercise '" EXAMPLES "flight.csv' --trace 1.7");
    program_says(0, "position: Bezier", "exercise '" EXAMPLES "flight.csv' --trace 1.7 -p bezier -q euler");
    program_says(0, "segment 1, from key 1", "exercise '" EXAMPLES "scenes.json' --clip scene1 --trace 2");
    program_says(0, "segment 2, from key 2", "exercise '" EXAMPLES "scenes.json' --clip scene1 --trace 2 -r library");
    char *piped = program_run(NULL, "exercise - --trace 1.25 < '" EXAMPLES "scenes.json'");
    char *named = program_run(NULL, "exercise '" EXAMPLES "scenes.json' --trace 1.25");
    assert_string_equal(piped, named);
    free(piped);
    free(named);
}

static void joints_of_models_have_keys_too(void **state)
{
    (void)state;
    program_says(0, "segment 0", "exercise '" NKW_CHARACTER "' --clip hop --joint hips --trace 0.05");
    program_says(0, "segment 0", "exercise '" NKW_CHARACTER "' --clip hop --joint 3 --trace 0.05");
    program_says(1, "does not move that joint", "exercise '" NKW_CHARACTER "' --joint tail --trace 0");
    program_says(1, "choose one clip", "exercise '" NKW_CHARACTER "' --clip all --trace 0");
    program_says(1, "has no clip", "exercise '" NKW_CHARACTER "' --clip rest --trace 0");
}

static void too_many_keys_and_misuse_are_reported(void **state)
{
    (void)state;
    FILE *f = fopen("long.csv", "wb");
    assert_non_null(f);
    fputs("name,time,tx,ty,tz\n", f);
    for (int k = 0; k < 65; k++)
        fprintf(f, "a,%d,%d,0,0\n", k, k);
    assert_int_equal(fclose(f), 0);
    program_says(1, "more than 64 keys", "exercise long.csv -o .");
    program_says(2, "not linear, hermite", "exercise long.csv --trace 0 -p cubic");
    program_says(2, "not none, euler", "exercise long.csv --trace 0 -q squad");
    program_says(2, "not exercise or library", "exercise long.csv --rule mine");
    program_says(2, "not in 0.0001..1000", "exercise long.csv --step 0");
    program_says(2, "not 2 or more", "exercise long.csv --keys 1");
    program_says(1, "no/such/folder: cannot be written: ", "exercise '" EXAMPLES "flight.csv' -o no/such/folder");
    program_says(1, "cannot write", "exercise '" EXAMPLES "flight.csv' -o long.csv");
    program_says(0, "made/index.html", "exercise '" EXAMPLES "flight.csv' -o made");
    program_says(0, "made/index.html", "exercise '" EXAMPLES "flight.csv' -o made");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_scenes_of_the_exercise_have_its_matrices),
        cmocka_unit_test(the_table_of_the_library_differs_where_the_page_says),
        cmocka_unit_test(all_pictures_and_the_page_are_written),
        cmocka_unit_test(a_trace_explains_one_time),
        cmocka_unit_test(joints_of_models_have_keys_too),
        cmocka_unit_test(too_many_keys_and_misuse_are_reported),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
