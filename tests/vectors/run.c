/* SPDX-License-Identifier: CC0-1.0 */
/*
 * vectors_run [--all] FILE.txt...: runs vectors against the functions of an adapter (adapter.h). With --all a function
 * that the adapter does not have is a failure. The format: docs/vectors.md.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "adapter.h"

typedef struct group {
    char name[64], compare[VECTORS_VALUES][16];
    int in_count, out_count;
    double tolerance, sizes[VECTORS_VALUES];
} group;

static int passed, failed, skipped;

/* The numbers of a line after its first word, up to the semicolon. */
static void read_numbers(char *line, vectors_value *v)
{
    char *p = line + strcspn(line, " "), *end;
    snprintf(v->name, sizeof v->name, "%.*s", (int)(p - line), line);
    for (v->count = 0; v->count < VECTORS_NUMBERS; v->count++, p = end) {
        v->x[v->count] = strtod(p, &end);
        if (end == p)
            return;
    }
}

/* One size for all results, or one for each. */
static void read_sizes(char *line, group *g)
{
    vectors_value v;
    read_numbers(line, &v);
    for (int i = 0; i < VECTORS_VALUES; i++)
        g->sizes[i] = i < v.count ? v.x[i] : v.x[v.count - 1];
}

/* The largest difference of `got` times sign from `want`; infinity where only one is a NaN. */
static double difference(const vectors_value *got, const vectors_value *want, double sign)
{
    double largest = got->count == want->count ? 0.0 : INFINITY;
    for (int i = 0; i < want->count && largest < INFINITY; i++) {
        double g = sign * got->x[i], w = want->x[i];
        double d = isnan(g) && isnan(w) ? 0.0 : g == w ? 0.0 : fabs(g - w);
        largest = d > largest ? d : d != d ? INFINITY : largest;
    }
    return largest;
}

static int is_nan(const vectors_value *v)
{
    for (int i = 0; i < v->count; i++)
        if (isnan(v->x[i]))
            return 1;
    return 0;
}

static double length(const vectors_value *v)
{
    double sum = 0.0;
    for (int i = 0; i < v->count; i++)
        sum += v->x[i] * v->x[i];
    return sqrt(sum);
}

static int holds(const char *compare, const vectors_value *got, const vectors_value *want, double bound)
{
    if (strcmp(compare, "nan") == 0)
        return is_nan(got);
    if (strcmp(compare, "unit") == 0)
        return fabs(length(got) - 1.0) <= bound;
    if (strcmp(compare, "exact") == 0)
        return difference(got, want, 1.0) == 0.0;
    double d = difference(got, want, 1.0), back = difference(got, want, -1.0);
    return (strcmp(compare, "sign") == 0 && back < d ? back : d) <= bound;
}

static void run_case(const group *g, const char *name, const char *check, const vectors_value *in, vectors_value *want)
{
    vectors_value got[VECTORS_VALUES];
    if (!vectors_answer(g->name, in, got)) {
        skipped++;
        return;
    }
    for (int i = 0; i < g->out_count; i++) {
        double bound = g->tolerance * g->sizes[i];
        if (holds(*check ? check : g->compare[i], &got[i], &want[i], bound)) {
            passed++;
            continue;
        }
        failed++;
        printf("FAILED %s %s %s, bound %g:\n", g->name, name, want[i].name, bound);
        for (int k = 0; k < want[i].count; k++)
            printf("  got %.9g want %.17g\n", k < got[i].count ? got[i].x[k] : NAN, want[i].x[k]);
    }
}

static int run_file(const char *path)
{
    static char line[8192];
    char one[] = "size 1";
    group g = {"", {""}, 0, 0, 0.0, {0.0}};
    vectors_value values[VECTORS_VALUES];
    char kind[32], name[128] = "", check[16] = "";
    int read = 0;
    FILE *file = fopen(path, "r");
    if (!file)
        return 0;
    while (fgets(line, sizeof line, file)) {
        if (sscanf(line, "group %63s", g.name) == 1)
            g.in_count = g.out_count = 0;
        else if (strncmp(line, "in ", 3) == 0)
            g.in_count++;
        else if (strncmp(line, "out ", 4) == 0)
            sscanf(line, "out %*s %*s %15s", g.compare[g.out_count++]);
        else if (strncmp(line, "tolerance ", 10) == 0)
            g.tolerance = strtod(line + 10, NULL);
        else if (strncmp(line, "size ", 5) == 0)
            read_sizes(line, &g);
        else if (strncmp(line, "case ", 5) == 0) {
            check[0] = '\0';
            sscanf(line, "case %31s %127s %15s", kind, name, check);
            read_sizes(one, &g);
            read = 0;
        } else if (line[0] != '#' && line[0] != '\n' && strncmp(line, "vectors ", 8) != 0) {
            read_numbers(line, &values[read++]);
            if (read == g.in_count + g.out_count)
                run_case(&g, name, check, values, values + g.in_count);
        }
    }
    return fclose(file) == 0;
}

int main(int argc, char **argv)
{
    int all = argc > 1 && strcmp(argv[1], "--all") == 0;
    for (int i = 1 + all; i < argc; i++)
        if (!run_file(argv[i])) {
            perror(argv[i]);
            return 2;
        }
    printf("%d results passed, %d failed, %d cases without a function\n", passed, failed, skipped);
    return failed > 0 || (all && skipped > 0) || passed == 0;
}
