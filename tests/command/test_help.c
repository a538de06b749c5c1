/* SPDX-License-Identifier: MIT */
/* The manual and the completions have the commands and options that --help prints. */
#include "program.h"

#include <stdlib.h>

static char *read_file(const char *path)
{
    FILE *f = fopen(path, "rb");
    assert_non_null(f);
    char *text = calloc(1, 1 << 18);
    assert_non_null(text);
    assert_true(fread(text, 1, (1 << 18) - 1, f) > 0);
    fclose(f);
    return text;
}

/* Calls `visit` with each word of the output of a shell command after the program's name. */
static void each_word(const char *arguments, void (*visit)(const char *word, void *user), void *user)
{
    char *words = program_run(NULL, "%s", arguments);
    for (char *word = strtok(words, "\n"); word; word = strtok(NULL, "\n"))
        visit(word, user);
    free(words);
}

/* An option in roff: \-\-no\-notes at the start of an entry. */
static void in_manual(const char *word, void *user)
{
    char roff[256] = "\\-\\-";
    size_t n = 4;
    for (const char *c = word + 2; *c && n + 3 < sizeof roff; c++) {
        if (*c == '-')
            roff[n++] = '\\';
        roff[n++] = *c;
    }
    snprintf(roff + n, sizeof roff - n, "\\fR");
    if (!strstr(user, roff))
        fail_msg("the manual has no %s", word);
}

typedef struct commands {
    char name[16][16];
    size_t count;
} commands;

static void add_command(const char *word, void *user)
{
    commands *all = user;
    assert_true(all->count < 16);
    snprintf(all->name[all->count++], 16, "%s", word);
}

#define LIST_COMMANDS "--help | sed -n 's/^  \\([a-z]*\\) .*/\\1/p'"

static void the_manual_has_all_options(void **state)
{
    (void)state;
    char *manual = read_file(NKW_COMMAND_SOURCE "/nakawari.1"), line[256];
    commands all = {{{0}}, 0};
    each_word(LIST_COMMANDS, add_command, &all);
    assert_in_range(all.count, 6, 16);
    for (size_t i = 0; i < all.count; i++) {
        snprintf(line, sizeof line, ".SH \"nakawari %s ", all.name[i]);
        assert_non_null(strstr(manual, line));
        snprintf(line, sizeof line, "%s --help | sed '/^$/,$d' | grep -oE -- '--[a-z-]+' | grep -v -- --help || true",
                 all.name[i]);
        each_word(line, in_manual, manual);
    }
    free(manual);
}

/* The part of docs/command.md before its sections, and the section of the command. */
static void on_page(const char *word, void *user)
{
    const char *const *parts = user;
    size_t n = strlen(word);
    for (int i = 0; i < 2; i++)
        for (const char *at = strstr(parts[i], word); at; at = strstr(at + 1, word))
            if (!strchr("-abcdefghijklmnopqrstuvwxyz", at[n]))
                return;
    fail_msg("docs/command.md has no %s in the section of the command", word);
}

static void the_page_has_all_commands_and_options(void **state)
{
    (void)state;
    commands all = {{{0}}, 0};
    each_word(LIST_COMMANDS, add_command, &all);
    for (size_t i = 0; i < all.count; i++) {
        char *page = read_file(NKW_PAGE), line[256];
        snprintf(line, sizeof line, "\n| [`%s`](#%s) |", all.name[i], all.name[i]);
        assert_non_null(strstr(page, line));
        snprintf(line, sizeof line, "\n## %s\n", all.name[i]);
        char *section = strstr(page, line), *end = section ? strstr(section + 1, "\n## ") : NULL;
        assert_non_null(section);
        if (end)
            *end = '\0';
        *strstr(page, "\n## ") = '\0';
        const char *parts[2] = {page, section + 1};
        snprintf(line, sizeof line,
                 "%s --help | sed '/^$/,$d' | grep -oE -- '--[a-z-]+' | grep -vE -- '--help|--quiet' || true", all.name[i]);
        each_word(line, on_page, parts);
        free(page);
    }
}

static void bash_completes_commands_and_options(void **state)
{
    (void)state;
    const char *complete = "--version > /dev/null; command -v bash > /dev/null || { printf \"sample\\n--rate "
                           "--raw\\n--what --watch\\n\"; exit; }; bash -c '"
                           "source \"$0/completion/nakawari.bash\";"
                           "COMP_WORDS=(\"$1\" sam); COMP_CWORD=1; _nakawari; echo \"${COMPREPLY[@]}\";"
                           "COMP_WORDS=(\"$1\" sample --ra); COMP_CWORD=2; _nakawari; echo \"${COMPREPLY[@]}\";"
                           "COMP_WORDS=(\"$1\" plot --w); COMP_CWORD=2; _nakawari; echo \"${COMPREPLY[@]}\"' "
                           "'" NKW_COMMAND_SOURCE "' '" NKW_PROGRAM "'";
    char *said = program_run(NULL, "%s", complete);
    assert_string_equal(said, "sample\n--rate --raw\n--what --watch\n");
    free(said);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_manual_has_all_options),
        cmocka_unit_test(the_page_has_all_commands_and_options),
        cmocka_unit_test(bash_completes_commands_and_options),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
