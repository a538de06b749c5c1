/* SPDX-License-Identifier: MIT */
/* Progress on the standard error: on a terminal, of long work, without --quiet. */
#if !defined(_XOPEN_SOURCE)
#define _XOPEN_SOURCE 600 /* posix_openpt */
#endif
#include "program.h"

#include <fcntl.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

/* More output than a pipe contains, and a reader that waits a second. */
#define LONG  "sample '" NKW_CHARACTER "' --clip walk --rate 1000 --what palette"
#define SLOW  " | { sleep 1; cat > /dev/null; }"
#define SHORT "sample '" NKW_CHARACTER "' --clip walk --at 0 > /dev/null"

/* What the shell command `line` prints on a terminal; its standard error is one. */
static size_t run_on_terminal(const char *line, char *text, size_t room)
{
    int terminal = posix_openpt(O_RDWR | O_NOCTTY), status;
    size_t count = 0;
    ssize_t got;
    assert_true(terminal >= 0 && grantpt(terminal) == 0 && unlockpt(terminal) == 0);
    int other = open(ptsname(terminal), O_RDWR | O_NOCTTY);
    assert_true(other >= 0);
    pid_t child = fork();
    if (child == 0) {
        dup2(other, STDERR_FILENO);
        close(terminal);
        close(other);
        execl("/bin/sh", "sh", "-c", line, (char *)NULL);
        _exit(127);
    }
    close(other);
    while (count < room - 1 && (got = read(terminal, text + count, room - 1 - count)) > 0)
        count += (size_t)got;
    text[count] = 0;
    close(terminal);
    assert_true(child > 0);
    assert_int_equal(waitpid(child, &status, 0), child);
    assert_true(WIFEXITED(status) && WEXITSTATUS(status) == 0);
    return count;
}

/* The line is drawn over itself, and removed at the end. */
static void long_work_shows_one_line_on_a_terminal(void **state)
{
    (void)state;
    static char text[1 << 16];
    size_t count = run_on_terminal("'" NKW_PROGRAM "' " LONG SLOW, text, sizeof text);
    assert_non_null(strstr(text, "\rsampling time "));
    assert_non_null(strstr(text, " of 1001"));
    assert_null(strchr(text, '\n'));
    assert_int_equal(text[count - 1], '\r');
    assert_int_equal(text[count - 2], ' ');
}

static void short_work_shows_nothing(void **state)
{
    (void)state;
    char text[256];
    assert_int_equal(run_on_terminal("'" NKW_PROGRAM "' " SHORT, text, sizeof text), 0);
}

static void quiet_shows_nothing(void **state)
{
    (void)state;
    char text[256];
    assert_int_equal(run_on_terminal("'" NKW_PROGRAM "' " LONG " --quiet" SLOW, text, sizeof text), 0);
}

static void a_file_receives_nothing(void **state)
{
    (void)state;
    char *said = program_run(NULL, "%s 2> progress.txt" SLOW "; cat progress.txt", LONG);
    assert_string_equal(said, "");
    free(said);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(long_work_shows_one_line_on_a_terminal),
        cmocka_unit_test(short_work_shows_nothing),
        cmocka_unit_test(quiet_shows_nothing),
        cmocka_unit_test(a_file_receives_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
