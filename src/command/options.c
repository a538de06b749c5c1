/* SPDX-License-Identifier: MIT */
#include "command.h"

#include <errno.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "apart.h"
#include "progress.h"

int options_misuse(const options *o, const char *which, const char *what)
{
    const char *program = poptGetInvocationName(o->context);
    fprintf(stderr, "%s: %s: %s\n", program, which, what);
    fprintf(stderr, "Try '%s --help'.\n", program);
    return COMMAND_MISUSE;
}

static int help(const options *o, const options_text *text)
{
    poptPrintHelp(o->context, stdout, 0);
    printf("\n%s\nExamples:\n%s", text->about, text->examples);
    printf(
        "\nExit code: 0 if all is well, 1 for findings and for files that cannot be read or written, 2 for misuse.\n");
    return output_close(stdout, NULL) ? COMMAND_FINE : COMMAND_FINDINGS;
}

/* The arguments that are no options: as many as the text states. */
static int take_files(options *o, const options_text *text)
{
    int count = 0;
    o->files = poptGetArgs(o->context);
    while (o->files && o->files[count])
        count++;
    if (count < text->file_count) {
        o->code = options_misuse(o, "FILE", text->file_count == 1 ? "missing; - reads the standard input" : "missing");
        return 0;
    }
    if (count > text->file_count && !text->more) {
        o->code = options_misuse(o, o->files[text->file_count], "one argument too many");
        return 0;
    }
    return 1;
}

/* --bvh-offset */
static int read_habit(options *o)
{
    static const char *const habits[] = {"replace", "add"};
    char *text = poptGetOptArg(o->context);
    const int habit = words_find(text ? text : "", habits, 2);
    if (habit < 0)
        o->code = options_misuse(o, "--bvh-offset", "not replace or add");
    else
        input_set_bvh(habit);
    free(text);
    return habit >= 0;
}

/* --read-limit */
static int read_limit(options *o)
{
    size_t seconds = 0;
    char *text = poptGetOptArg(o->context);
    const int fine = text && options_index(text, &seconds) && seconds >= 1 && seconds <= 1000000;
    if (fine)
        apart_set_seconds(seconds);
    else
        o->code = options_misuse(o, "--read-limit", "not in 1..1000000");
    free(text);
    return fine;
}

/* An option of all subcommands, by its letter. Returns 0 after a misuse. */
static int read_common(options *o, int option)
{
    if (option == 'q')
        progress_silence();
    if (option == 'i')
        input_set_in_process(1);
    if (option == 's')
        input_set_holding(0);
    return option == 'b' ? read_habit(o) : option == 'l' ? read_limit(o) : 1;
}

int options_read(options *o, const options_text *text, const struct poptOption *table, int argc, const char **argv)
{
    o->context = poptGetContext(argv[0], argc, argv, table, 0);
    o->files = NULL;
    o->code = COMMAND_FINE;
    poptSetOtherOptionHelp(o->context, text->usage);
    for (;;) {
        int option = poptGetNextOpt(o->context);
        if (option == 'h') {
            o->code = help(o, text);
            return 0;
        }
        if (!read_common(o, option))
            return 0;
        if (option < -1) {
            o->code = options_misuse(o, poptBadOption(o->context, POPT_BADOPTION_NOALIAS), poptStrerror(option));
            return 0;
        }
        if (option == -1)
            return take_files(o, text);
    }
}

void options_close(options *o)
{
    poptFreeContext(o->context);
    o->context = NULL;
}

int options_number(const char *text, float *number)
{
    char *end;
    *number = strtof(text, &end);
    return end != text && *end == 0 && isfinite(*number);
}

int options_index(const char *text, size_t *index)
{
    char *end;
    errno = 0;
    unsigned long long value = strtoull(text, &end, 10);
    *index = (size_t)value;
    return text[0] >= '0' && text[0] <= '9' && *end == 0 && errno == 0 && value < SIZE_MAX;
}
