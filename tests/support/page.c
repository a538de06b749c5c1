/* SPDX-License-Identifier: MIT */
#include "page.h"

#include <ctype.h>

#include "expect.h"

enum { MOST = 1 << 17 };

static char previous(const char *from, const char *at, size_t back)
{
    return at >= from + back ? at[-(long)back] : ' ';
}

/* In place. */
static void normalise(char *text)
{
    char *out = text;
    for (const char *c = text; *c; c++) {
        int digit = isdigit((unsigned char)previous(text, out, 1)), next = isdigit((unsigned char)c[1]);
        if (isspace((unsigned char)*c)) {
            if (previous(text, out, 1) != ' ')
                *out++ = ' ';
        } else if (*c == ',' && digit && next)
            continue;
        else if (*c == '0' && next && previous(text, out, 2) == 'e' && strchr("+-", previous(text, out, 1)))
            continue;
        else
            *out++ = *c;
    }
    *out = '\0';
}

void expect_page_at(const char *file, int line, const char *page, const char *format, ...)
{
    static char text[MOST], sought[1024];
    char path[1024];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(sought, sizeof sought, format, arguments);
    va_end(arguments);
    snprintf(path, sizeof path, NKW_DOCS "/%s", page);
    FILE *f = fopen(path, "rb");
    assert_non_null(f);
    size_t n = fread(text, 1, MOST - 1, f);
    fclose(f);
    assert_in_range(n, 1, MOST - 2);
    text[n] = '\0';
    normalise(text);
    normalise(sought);
    if (!strstr(text, sought)) {
        print_error("%s:%d: docs/%s does not state: %s\n", file, line, page, sought);
        _fail(file, line);
    }
}
