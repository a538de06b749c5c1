/* SPDX-License-Identifier: MIT */
#include "accuracy.h"

#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static char *text_of(const char *header)
{
    char path[1024];
    char *text;
    FILE *file;
    long size;
    snprintf(path, sizeof path, "%s/%s", NKW_HEADER_DIR, header);
    file = fopen(path, "rb");
    if (!file || fseek(file, 0, SEEK_END) || (size = ftell(file)) < 0 || fseek(file, 0, SEEK_SET)) {
        fprintf(stderr, "cannot read %s\n", path);
        exit(2);
    }
    text = calloc((size_t)size + 1, 1);
    if (!text || fread(text, 1, (size_t)size, file) != (size_t)size) {
        fprintf(stderr, "cannot read %s\n", path);
        exit(2);
    }
    fclose(file);
    return text;
}

accuracy accuracy_begin(const char *header, int argc, char **argv)
{
    accuracy a;
    memset(&a, 0, sizeof a);
    a.header = header;
    a.text = text_of(header);
    a.effort = 1;
    for (int i = 1; i < argc; i++) {
        if (strcmp(argv[i], "--exhaustive") == 0) {
            a.exhaustive = 1;
        } else if (strncmp(argv[i], "--effort=", 9) == 0 && atof(argv[i] + 9) > 0) {
            a.effort = atof(argv[i] + 9);
        } else if (strncmp(argv[i], "--only=", 7) == 0) {
            a.only = argv[i] + 7;
        } else if (strncmp(argv[i], "--out=", 6) == 0 &&
                   (a.out = fopen(argv[i] + 6, "w")) != NULL) {
            continue;
        } else {
            fprintf(stderr, "unknown argument or file not writable: %s\n", argv[i]);
            exit(2);
        }
    }
    return a;
}

int accuracy_wants(const accuracy *a, const char *function)
{
    return !a->only || strcmp(a->only, function) == 0;
}

uint32_t accuracy_stride(const accuracy *a, uint32_t otherwise)
{
    return a->exhaustive ? 1 : otherwise;
}

static int is_name(char c)
{
    return isalnum((unsigned char)c) || c == '_';
}

/* The start of the line on which `p` stands. */
static const char *line_of(const char *text, const char *p)
{
    while (p > text && p[-1] != '\n')
        p--;
    return p;
}

/* The prototype of a function: a line that begins with NKW_API or NKW_ALGEBRA and has "name(". */
static const char *prototype_of(const char *text, const char *function)
{
    size_t length = strlen(function);
    for (const char *p = strstr(text, function); p; p = strstr(p + 1, function)) {
        const char *line = line_of(text, p);
        int declares = strncmp(line, "NKW_API", 7) == 0 || strncmp(line, "NKW_ALGEBRA", 11) == 0;
        if (declares && p[length] == '(' && !is_name(p[-1]))
            return line;
    }
    return NULL;
}

/* The number after "Error" in a comment that ends before `end`, from `p` on. */
static accuracy_error error_between(const char *p, const char *end)
{
    accuracy_error none = {-1.0, ""};
    accuracy_error error;
    char unit[8] = "";
    for (; p < end; p++) {
        if (strncmp(p, "* Error ", 8) == 0) {
            char *rest;
            error.number = strtod(p + 8, &rest);
            if (rest == p + 8 || sscanf(rest, " %7[A-Za-z]", unit) != 1)
                return none;
            memcpy(error.unit, unit, sizeof unit);
            return strcmp(unit, "ULP") == 0 || strcmp(unit, "u") == 0 ? error : none;
        }
    }
    return none;
}

accuracy_error declared_error(const accuracy *a, const char *function)
{
    accuracy_error none = {-1.0, ""};
    const char *prototype = prototype_of(a->text, function);
    const char *comment = NULL;
    if (!prototype)
        return none;
    for (const char *p = strstr(a->text, "/**"); p && p < prototype; p = strstr(p + 1, "/**"))
        comment = p;
    return comment ? error_between(comment, prototype) : none;
}

double accuracy_ulps(float got, double exact)
{
    int exponent;
    double g = (double)got;
    if (g != g || exact != exact)
        return g != g && exact != exact ? 0.0 : INFINITY;
    if (isinf(g) || fabs(exact) >= 0x1.ffffffp127)
        return g == (double)(float)exact ? 0.0 : INFINITY;
    if (exact == 0.0)
        return fabs(g) * 0x1p149;
    frexp(exact, &exponent);
    return fabs(g - exact) * ldexp(1.0, 24 - (exponent < -125 ? -125 : exponent));
}

double accuracy_units(double got, double exact, double magnitude)
{
    double difference = fabs(got - exact);
    if (got != got || exact != exact)
        return INFINITY;
    return difference == 0.0 ? 0.0 : difference / magnitude * 0x1p24;
}

accuracy_worst accuracy_worst_begin(int arguments)
{
    accuracy_worst w;
    memset(&w, 0, sizeof w);
    w.arguments = arguments;
    w.worst = -1.0;
    return w;
}

void accuracy_worst_add(accuracy_worst *w, double error, const float *arguments)
{
    w->squares += error * error;
    w->count++;
    if (error > w->worst) {
        w->worst = error;
        memcpy(w->witness, arguments, (size_t)w->arguments * sizeof *arguments);
    }
}

static void note_name(accuracy *a, const char *function)
{
    if (a->named < ACCURACY_NAMES)
        snprintf(a->names[a->named++], sizeof a->names[0], "%s", function);
}

void accuracy_row(accuracy *a, const char *function, const char *region, const accuracy_worst *w)
{
    accuracy_error declared = declared_error(a, function);
    double rms = w->count ? sqrt(w->squares / (double)w->count) : 0.0;
    char witness[32 * 20] = "";
    size_t used = 0;
    for (int i = 0; i < w->arguments; i++)
        used += (size_t)snprintf(witness + used, sizeof witness - used, i ? ", %a" : "%a",
                                 (double)w->witness[i]);
    printf("%-26s %-38s worst %.7g rms %.3g %s (declared %.7g) of %.0f, at (%s)\n", function,
           region, w->worst, rms, declared.unit, declared.number, (double)w->count, witness);
    fflush(stdout);
    if (a->out)
        fprintf(a->out, "| `%s` | %s | %.7g | %.3g | %s | `%s` | %.0f |\n", function, region,
                w->worst, rms, declared.unit, witness, (double)w->count);
    if (!(w->worst <= declared.number)) {
        printf("FAILED: %s: the error exceeds the Error line in %s\n", function, a->header);
        a->failures++;
    }
    note_name(a, function);
}

static int has_row(const accuracy *a, const char *function)
{
    for (int i = 0; i < a->named; i++)
        if (strcmp(a->names[i], function) == 0)
            return 1;
    return 0;
}

/* Every prototype whose Error line has a number needs a row. */
static void check_all_measured(accuracy *a)
{
    for (const char *p = strstr(a->text, "nkw_"); p; p = strstr(p + 1, "nkw_")) {
        char name[48];
        size_t length = 0;
        while (is_name(p[length]) && length + 1 < sizeof name)
            length++;
        memcpy(name, p, length);
        name[length] = '\0';
        if (prototype_of(a->text, name) == line_of(a->text, p) && p[length] == '(' &&
            declared_error(a, name).number >= 0.0 && !has_row(a, name)) {
            printf("FAILED: %s of %s has an Error line and was not measured\n", name, a->header);
            a->failures++;
        }
    }
}

int accuracy_end(accuracy *a)
{
    if (!a->only)
        check_all_measured(a);
    if (a->out && fclose(a->out))
        a->failures++;
    free(a->text);
    printf("%s: %s\n", a->header, a->failures ? "FAILED" : "every error within its declaration");
    return a->failures ? 1 : 0;
}
