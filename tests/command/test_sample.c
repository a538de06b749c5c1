/* SPDX-License-Identifier: MIT */
/* nakawari sample: formats, selections, misuse; values against the tables of expected values. */
#if !defined(_POSIX_C_SOURCE)
#define _POSIX_C_SOURCE 200809L
#endif
#include "program.h"

#include <glob.h>
#include <math.h>
#include <stdlib.h>

#include "scene.h"

#define MODEL "sample '" NKW_CHARACTER "' "

static void csv_has_a_header_and_a_line_for_each_node(void **state)
{
    (void)state;
    char *csv = program_run(NULL, MODEL "--clip 0 --at 0,0.25");
    const char *header = "clip,time,index,name,tx,ty,tz,qx,qy,qz,qw,sx,sy,sz\n";
    assert_memory_equal(csv, header, strlen(header));
    assert_int_equal(lines_with(csv, "\n0,0,") + lines_with(csv, "\n0,0.25,"), lines_with(csv, "\n") - 1);
    assert_int_equal(lines_with(csv, "\n0,0,"), lines_with(csv, "\n0,0.25,"));
    free(csv);
}

static void clips_are_selected_by_number_and_name(void **state)
{
    (void)state;
    char *by_name = program_run(NULL, MODEL "--clip wave --at 0.5 --what model");
    char *by_number = program_run(NULL, MODEL "--clip 1 --at 0.5 --what model");
    assert_string_equal(by_name, by_number);
    free(by_name);
    free(by_number);
    program_says(1, "no clip 3: it has 3", MODEL "--clip 3 --at 0");
    program_says(0, "\n-1,0,0,", MODEL "--clip rest --at 0");
    program_says(0, "\n2,0,0,", MODEL "--clip all --at 0");
}

static void the_standard_input_is_a_file(void **state)
{
    (void)state;
    char *piped = program_run(NULL, "sample - --at 0.5 --what vertices < '" NKW_CHARACTER "'");
    char *read = program_run(NULL, MODEL "--at 0.5 --what vertices");
    assert_string_equal(piped, read);
    free(piped);
    free(read);
}

static void a_rate_samples_from_the_start_to_the_end(void **state)
{
    (void)state;
    char *csv = program_run(NULL, MODEL "--clip 0 --rate 2.5 | cut -d, -f2 | uniq | tr '\\n' ' '");
    assert_string_equal(csv, "time 0 0.400000006 0.800000012 1 ");
    free(csv);
}

static void json_has_the_numbers_of_csv(void **state)
{
    (void)state;
    char *json = program_run(NULL, MODEL "--clip 2 --at 0.5 --what weights --json");
    assert_non_null(strstr(json, "\"what\": \"weights\""));
    assert_non_null(
        strstr(json, "{\"clip\": 2, \"time\": 0.5, \"index\": 0, \"name\": \"face\", \"values\": [0.825000048], "
                     "\"target\": \"puff\"}"));
    free(json);
}

/* The header: "nkwsampl", version, what, clip, times, rows, numbers; then for each time the time and its rows. */
static void raw_bytes_have_a_header(void **state)
{
    (void)state;
    char *dump = program_run(NULL, MODEL "--clip 2 --at 0.5,1 --what weights --raw | od -An -tx1 -v | tr -d ' \\n'");
    const char *header = "6e6b7773616d706c"
                         "01000000"
                         "04000000"
                         "02000000"
                         "02000000"
                         "01000000"
                         "01000000";
    assert_memory_equal(dump, header, strlen(header));
    assert_memory_equal(dump + strlen(header), "0000003f3433533f0000803f", 24); /* 0.5, 0.825; 1 */
    assert_int_equal(strlen(dump), strlen(header) + 32);
    free(dump);
}

static void misuse_ends_with_2(void **state)
{
    (void)state;
    program_says(0, "Usage: nakawari sample", "sample --help");
    program_says(0, "nakawari COMMAND --help", "--help");
    program_says(0, "nakawari 0.1.0", "--version");
    program_says(2, "Usage: nakawari", "");
    program_says(2, "unknown command", "smaple");
    program_says(2, "--nonsense: unknown option", "sample --nonsense");
    program_says(2, "FILE: missing", "sample --at 0");
    program_says(2, "one argument too many", "sample a b --at 0");
    program_says(2, "one of them is needed", MODEL);
    program_says(2, "only one of them", MODEL "--at 0 --rate 30");
    program_says(2, "not a list of times", MODEL "--at 0,,1");
    program_says(2, "not a list of times", MODEL "--at nan");
    program_says(2, "not above 0 and up to 1000000", MODEL "--rate -1");
    program_says(2, "not above 0 and up to 1000000", MODEL "--rate 0");
    program_says(2, "not above 0 and up to 1000000", MODEL "--rate nan");
    program_says(2, "not local, model", MODEL "--at 0 --what pose");
    program_says(2, "not with --json", MODEL "--at 0 --json --raw");
}

static void files_that_cannot_be_used_end_with_1(void **state)
{
    (void)state;
    program_says(1, "no-such-file.glb: ", "sample no-such-file.glb --at 0");
    program_says(1, "-: ", "sample - --at 0 < /dev/null");
    program_says(1, "/no/such/folder/x: cannot be written: ", MODEL "--at 0 -o /no/such/folder/x");
    program_says(1, "/dev/full: cannot be written: No space left on device", MODEL "--at 0 -o /dev/full");
    program_says(0, "", MODEL "--at 0,1 --json > said.json");
    program_says(0, "", MODEL "--at 0,1 -o named.json && cmp said.json named.json");
    program_says(1, "/dev/full: cannot be written: No space left on device", MODEL "--rate 60 --raw -o /dev/full");
}

/* ---- expected values ---- */

/* The rows of a table with the same clip and tag, which need one call of the program. */
enum { ROWS = 16384 };
static table_row rows[ROWS];

static const struct {
    const char *tag, *what;
    int width;
} kinds[] = {{"L", "local", 10}, {"W", "model", 16}, {"J", "palette", 16}, {"V", "vertices", 3}, {"M", "weights", 1}};

/* The index of an expected row: skins and meshes of these files are single. */
static int index_of(const table_row *row)
{
    return row->tag[0] == 'L' || row->tag[0] == 'W' ? row->a : row->b;
}

/* A difference; rotations of local transforms may be negated. */
static double difference(const float *got, const table_row *want, int width)
{
    double worst = 0.0, dot = 0.0;
    for (int i = 3; width == 10 && i < 7; i++)
        dot += (double)got[i] * (double)want->values[i];
    for (int i = 0; i < width; i++) {
        double sign = width == 10 && i >= 3 && i < 7 && dot < 0.0 ? -1.0 : 1.0;
        worst = fmax(worst, fabs(sign * (double)got[i] - (double)want->values[i]));
    }
    return worst;
}

/* One line of CSV: the numbers after the name. */
static int read_line(const char **csv, float *time, int *index, float *numbers, int width)
{
    int used = 0, clip;
    if (sscanf(*csv, "%d,%f,%d,%*[^,]%n", &clip, time, index, &used) != 3)
        return 0;
    *csv += used;
    for (int i = 0; i < width; i++) {
        assert_int_equal(sscanf(*csv, ",%f%n", &numbers[i], &used), 1);
        *csv += used;
    }
    *csv = strchr(*csv, '\n') + 1;
    return 1;
}

/* Compares the output with the rows of a tag and clip. */
static double compare(const char *csv, size_t count, const char *tag, int anim, int width, size_t *compared)
{
    double worst = 0.0;
    float time, numbers[16];
    int index;
    csv = strchr(csv, '\n') + 1;
    while (read_line(&csv, &time, &index, numbers, width))
        for (size_t r = 0; r < count; r++)
            if (rows[r].anim == anim && rows[r].time == time && index_of(&rows[r]) == index &&
                strcmp(rows[r].tag, tag) == 0) {
                worst = fmax(worst, difference(numbers, &rows[r], width));
                ++*compared;
            }
    return worst;
}

static size_t read_table(const char *path, double *largest)
{
    size_t count = 0;
    FILE *file = table_open(path);
    while (count < ROWS && table_read(file, &rows[count])) {
        const table_row *row = &rows[count];
        if (row->tag[0] == '#')
            continue;
        for (size_t i = 0; i < (size_t)row->count; i++)
            *largest = fmax(*largest, fabs((double)row->values[i]));
        count++;
    }
    assert_true(count < ROWS);
    table_close(file);
    return count;
}

/* Whether no row before r has its tag and clip and, if `same_time`, its time. */
static int first_of_group(size_t r, int same_time)
{
    for (size_t i = r; i-- > 0;)
        if (rows[i].anim == rows[r].anim && strcmp(rows[i].tag, rows[r].tag) == 0 &&
            (!same_time || rows[i].time == rows[r].time))
            return 0;
    return 1;
}

/* The times of all rows with the tag and clip of row r, with commas. */
static void times_of(size_t r, size_t count, char *list, size_t room)
{
    size_t used = 0;
    for (size_t i = r; i < count; i++)
        if (rows[i].anim == rows[r].anim && strcmp(rows[i].tag, rows[r].tag) == 0 && first_of_group(i, 1))
            used += (size_t)snprintf(list + used, room - used, used ? ",%.9g" : "%.9g", (double)rows[i].time);
    assert_true(used < room);
}

/* 5e-6 of the largest value is adequate for binary32, 5e-4 for keys that are not unit: those have two tables. */
static void compare_file(const char *model, const char *table, int off_unit)
{
    static char list[32768];
    double largest = off_unit ? 100.0 : 1.0, worst = 0.0;
    size_t count = read_table(table, &largest), compared = 0;
    for (size_t r = 0; r < count; r++) {
        if (!first_of_group(r, 0))
            continue;
        times_of(r, count, list, sizeof list);
        for (size_t k = 0; k < sizeof kinds / sizeof kinds[0]; k++) {
            if (strcmp(kinds[k].tag, rows[r].tag) != 0)
                continue;
            char *csv =
                program_run(NULL, "sample '%s' --clip %d --at %s --what %s", model, rows[r].anim, list, kinds[k].what);
            worst = fmax(worst, compare(csv, count, kinds[k].tag, rows[r].anim, kinds[k].width, &compared));
            free(csv);
        }
    }
    print_message("%s: %zu rows, worst %.3g of %.3g\n", model, compared, worst, 5e-6 * largest);
    assert_int_equal(compared, count);
    assert_true(worst <= 5e-6 * largest);
}

static int exists(const char *path)
{
    FILE *f = fopen(path, "rb");
    if (f)
        fclose(f);
    return f != NULL;
}

/* Tables NAME.expected.csv of the folder; those of normalised keys are another choice of values. */
static void samples_are_the_expected_values(void **state)
{
    (void)state;
    const char *const folder = NKW_DATA_DIR "/expected/", *const end = ".expected.csv";
    glob_t found;
    if (glob(NKW_DATA_DIR "/expected/*.expected.csv*", 0, NULL, &found) != 0) {
        print_message("skipped: there is no %s\n", folder);
        skip();
    }
    for (size_t i = 0; i < found.gl_pathc; i++) {
        char name[256], model[1024], table[1024], normalized[1024];
        const char *file = found.gl_pathv[i] + strlen(folder);
        snprintf(name, sizeof name, "%.*s", (int)(strstr(file, end) - file), file);
        if (strstr(name, ".bvh") || strstr(name, ".keynorm"))
            continue;
        snprintf(model, sizeof model, NKW_DATA_DIR "/gltf/%s.glb", name);
        if (!exists(model))
            snprintf(model, sizeof model, NKW_DATA_DIR "/gltf/%s.gltf", name);
        snprintf(table, sizeof table, "%s%s%s", folder, name, end);
        snprintf(normalized, sizeof normalized, "%s%s.keynorm%s", folder, name, end);
        compare_file(model, table, exists(normalized));
    }
    globfree(&found);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(csv_has_a_header_and_a_line_for_each_node),
        cmocka_unit_test(clips_are_selected_by_number_and_name),
        cmocka_unit_test(the_standard_input_is_a_file),
        cmocka_unit_test(a_rate_samples_from_the_start_to_the_end),
        cmocka_unit_test(json_has_the_numbers_of_csv),
        cmocka_unit_test(raw_bytes_have_a_header),
        cmocka_unit_test(misuse_ends_with_2),
        cmocka_unit_test(files_that_cannot_be_used_end_with_1),
        cmocka_unit_test(samples_are_the_expected_values),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
