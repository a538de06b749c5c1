/* SPDX-License-Identifier: MIT */
#if !defined(_POSIX_C_SOURCE)
#define _POSIX_C_SOURCE 200809L /* popen */
#endif
#include "program.h"

#include <stdlib.h>
#include <sys/wait.h>

static char *read_all(FILE *f)
{
    size_t room = 1 << 16, count = 0, got;
    char *text = malloc(room);
    assert_non_null(text);
    while ((got = fread(text + count, 1, room - count - 1, f)) > 0) {
        count += got;
        if (count + 1 == room) {
            text = realloc(text, room *= 2);
            assert_non_null(text);
        }
    }
    text[count] = 0;
    return text;
}

static char *run(int *code, const char *arguments)
{
    char line[65536];
    assert_true(snprintf(line, sizeof line, "'%s' %s", NKW_PROGRAM, arguments) < (int)sizeof line);
    FILE *f = popen(line, "r");
    assert_non_null(f);
    char *text = read_all(f);
    int status = pclose(f);
    assert_true(WIFEXITED(status));
    *code = WEXITSTATUS(status);
    return text;
}

char *program_run(int *code, const char *arguments, ...)
{
    char formatted[65536];
    int ended;
    va_list list;
    va_start(list, arguments);
    assert_true(vsnprintf(formatted, sizeof formatted, arguments, list) < (int)sizeof formatted);
    va_end(list);
    char *text = run(&ended, formatted);
    if (code)
        *code = ended;
    else
        assert_int_equal(ended, 0);
    return text;
}

void program_says(int code, const char *text, const char *arguments)
{
    int ended;
    char *said = program_run(&ended, "%s 2>&1", arguments);
    if (ended != code || !strstr(said, text))
        fail_msg("nakawari %s: exit code %d, not %d, or without '%s':\n%s", arguments, ended, code, text, said);
    free(said);
}

size_t lines_with(const char *text, const char *part)
{
    size_t count = 0;
    for (const char *at = strstr(text, part); at; at = strstr(at, part)) {
        count++;
        at = strchr(at + 1, '\n');
        if (!at)
            break;
    }
    return count;
}
