/* SPDX-License-Identifier: MIT */
#include "verdict.h"

#include <stdlib.h>

#include <nakawari/scalar.h>

#include "command.h"

static const char *method_name(const compare_finding *f, int method)
{
    return (f->part == COMPARE_POSITION ? report_positions : report_orientations)[method].name;
}

static void print_cause(const compare_finding *f, const compare_cause *c)
{
    if (c->mistake)
        printf("what you get if %s in %s", c->mistake->name, c->mistake->where);
    else if (c->method == COMPARE_UNSTATED)
        fputs("what you get if the angles are in degrees: --angles degrees", stdout);
    else
        printf("those of the method %s", method_name(f, c->method));
}

static void print_causes(const compare_finding *f)
{
    for (size_t i = 0; i < f->cause_count; i++) {
        if (i > 0)
            fputs("  or ", stdout);
        else if (f->first < f->last)
            printf("  rows %.6g to %.6g are ", (double)f->first, (double)f->last);
        else
            printf("  row %.6g is ", (double)f->first);
        print_cause(f, &f->causes[i]);
        putchar('\n');
    }
    if (f->cause_count > 0)
        return;
    fputs("  no known mistake reproduces all of them", stdout);
    if (f->nearest.reproduced > 0) {
        printf("; %zu of them are ", f->nearest.reproduced);
        print_cause(f, &f->nearest);
    }
    putchar('\n');
}

static void print_finding(const compare_finding *f)
{
    printf("%s, %s%s: ", f->part == COMPARE_POSITION ? "position" : "orientation", method_name(f, f->method),
           f->is_guess ? " (the most likely method)" : "");
    if (f->differing == 0) {
        printf("%zu %s\n", COUNT(f->rows, "row agrees", "rows agree"));
        return;
    }
    printf("%zu of %zu %s, from %.6g s (line %zu) on, by %.3g at most, at %.6g s\n", f->differing,
           COUNT(f->rows, "row differs", "rows differ"), (double)f->first, f->line, (double)f->worst,
           (double)f->worst_time);
    print_causes(f);
}

static int has_degrees(const compare_row *rows, size_t count)
{
    for (size_t i = 0; i < count; i++)
        if (rows[i].degrees)
            return 1;
    return 0;
}

static void print_result(const scene *s, const char *path, const compare_options *o, const compare_row *rows,
                         size_t count, const compare_result *result)
{
    output_text(stdout, path);
    printf(": %zu %s against %s by the rule of the %s, within %g%s\n", COUNT(count, "row", "rows"), s->name,
           s->rule == NKW_KEYFRAME_RULE_EXERCISE ? "exercise" : "library", (double)o->tolerance,
           has_degrees(rows, count) ? "; angles in degrees" : "");
    if (result->is_transposed)
        puts("the matrices are transposed: glMultMatrixf takes them column by column (1.7); compared as --matrix rows");
    for (size_t i = 0; i < result->count; i++)
        print_finding(&result->findings[i]);
}

static int report_fault(const char *path, const answers_fault *fault)
{
    output_text(stderr, path);
    if (fault->line > 0)
        fprintf(stderr, ":%zu", fault->line);
    fprintf(stderr, ": %s\n", fault->what);
    return COMMAND_MISUSE;
}

static int compare_text(const scene *s, const char *path, const char *text, size_t bytes, const answers_options *read,
                        const compare_options *compare)
{
    const size_t most = answers_most(text, bytes);
    answers_fault fault = {0, "not enough memory"};
    compare_result result;
    size_t count;
    compare_row *rows = most < SIZE_MAX / sizeof *rows ? malloc(most * sizeof *rows) : NULL;
    if (!rows || !answers_read(text, bytes, read, rows, most, &count, &fault)) {
        free(rows);
        return report_fault(path, &fault);
    }
    const int agrees = compare_rows(s, compare, rows, count, &result);
    print_result(s, path, compare, rows, count, &result);
    free(rows);
    return agrees ? COMMAND_FINE : COMMAND_FINDINGS;
}

int verdict_print(const scene *s, const char *path, const answers_options *read, const compare_options *compare)
{
    size_t bytes;
    unsigned char *text = input_read(path, &bytes);
    if (!text)
        return COMMAND_MISUSE;
    const int code = compare_text(s, path, (const char *)text, bytes, read, compare);
    free(text);
    return code;
}
