/* SPDX-License-Identifier: CC0-1.0 */
/* vectors_json FILE.txt: the same vectors as JSON, to the standard output. NaN and infinities become strings. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int in_count, out_count, read, cases, groups;
static char declared[16][96]; /* the lines `in` and `out` of the group */
static char size[256];

static void put_text(const char *text)
{
    putchar('"');
    for (; *text && *text != '\n'; text++) {
        if (*text == '"' || *text == '\\')
            putchar('\\');
        putchar(*text);
    }
    putchar('"');
}

/* The number of a text: hexadecimal becomes decimal with the digits that return to the bits. */
static void put_number(const char *text)
{
    double x = strtod(text, NULL);
    if (x != x || x - x != 0.0)
        printf(x != x ? "\"nan\"" : x > 0.0 ? "\"inf\"" : "\"-inf\"");
    else
        printf("%.17g", x);
}

static void put_numbers(char *line)
{
    char *name = strtok(line, " "), *end = strchr(name + strlen(name) + 1, ';');
    printf("%s\"%s\": [", read <= 0 || read == in_count ? "" : ", ", name);
    *end = '\0';
    int first = 1;
    for (char *x = strtok(NULL, " "); x; x = strtok(NULL, " "), first = 0) {
        fputs(first ? "" : ", ", stdout);
        put_number(x);
    }
    putchar(']');
}

static void begin_case(const char *line)
{
    char kind[32], name[128], check[16] = "";
    sscanf(line, "case %31s %127s %15s", kind, name, check);
    printf("%s\n     {\"class\": \"%s\", \"name\": \"%s\"", cases++ ? "," : "", kind, name);
    if (*check)
        printf(", \"check\": \"%s\"", check);
    read = 0;
    strcpy(size, "size 1 ;");
}

static void numbers(char *line)
{
    if (read == 0) {
        fputs(", ", stdout);
        read = -1;
        put_numbers(size);
        read = 0;
        fputs(", \"in\": {", stdout);
    }
    if (read == in_count)
        fputs("}, \"out\": {", stdout);
    put_numbers(line);
    if (++read == in_count + out_count)
        fputs("}}", stdout);
}

static void end_group(void)
{
    if (groups)
        fputs("]}", stdout);
}

static void begin_group(const char *line)
{
    end_group();
    printf("%s\n  {\"name\": ", groups++ ? "," : "],\n \"groups\": [");
    put_text(line + 6);
    in_count = out_count = cases = 0;
}

/* The declarations stand before the tolerance, which has its reason after the colon. */
static void tolerance(const char *line)
{
    for (int side = 0; side < 2; side++) {
        printf(", \"%s\": [", side ? "out" : "in");
        for (int i = side ? in_count : 0; i < (side ? in_count + out_count : in_count); i++) {
            char name[32] = "", count[16] = "", compare[16] = "";
            sscanf(declared[i], "%*s %31s %15s %15s", name, count, compare);
            printf("%s{\"name\": \"%s\", \"count\": \"%s\"", i == 0 || i == in_count ? "" : ", ", name, count);
            if (side)
                printf(", \"compare\": \"%s\"", compare);
            putchar('}');
        }
        putchar(']');
    }
    fputs(", \"tolerance\": ", stdout);
    put_number(line + 10);
    fputs(", \"reason\": ", stdout);
    put_text(strstr(line, ": ") + 2);
    fputs(", \"cases\": [", stdout);
}

int main(int argc, char **argv)
{
    static char line[8192];
    FILE *file = argc == 2 ? fopen(argv[1], "r") : NULL;
    int notes = 0;
    if (!file) {
        fputs("usage: vectors_json FILE.txt\n", stderr);
        return 2;
    }
    while (fgets(line, sizeof line, file)) {
        line[strcspn(line, "\n")] = '\0';
        if (strncmp(line, "vectors ", 8) == 0) {
            printf("{\"format\": \"vectors 1\", \"name\": ");
            put_text(line + 10);
            fputs(", \"license\": \"CC0-1.0\",\n \"notes\": [", stdout);
        } else if (line[0] == '#') {
            fputs(notes++ ? ",\n  " : "\n  ", stdout);
            put_text(line + 2);
        } else if (strncmp(line, "group ", 6) == 0)
            begin_group(line);
        else if (strncmp(line, "in ", 3) == 0 || strncmp(line, "out ", 4) == 0) {
            snprintf(declared[in_count + out_count], sizeof declared[0], "%.95s", line);
            *(line[0] == 'i' ? &in_count : &out_count) += 1;
        } else if (strncmp(line, "tolerance ", 10) == 0)
            tolerance(line);
        else if (strncmp(line, "case ", 5) == 0)
            begin_case(line);
        else if (strncmp(line, "size ", 5) == 0)
            snprintf(size, sizeof size, "%.255s", line);
        else if (line[0])
            numbers(line);
    }
    end_group();
    fputs("]}\n", stdout);
    return fclose(file) != 0;
}
