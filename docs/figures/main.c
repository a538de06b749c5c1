/* SPDX-License-Identifier: MIT */
/* nakawari-figures DIR: draws every figure of the floor pages into DIR. */
#include <stdio.h>
#include <string.h>

#include "figure.h"

static const struct {
    const char *name;
    int (*draw)(const char *path);
} figures[] = {
#define F(name, draw) {name, draw},
#include "list.h"
#undef F
};

int main(int argc, char **argv)
{
    char path[1024];
    if (argc != 2 || strlen(argv[1]) + 32 > sizeof path) {
        fputs("usage: nakawari-figures DIR\n", stderr);
        return 2;
    }
    for (size_t i = 0; i < sizeof figures / sizeof *figures; i++) {
        sprintf(path, "%s/%s.svg", argv[1], figures[i].name);
        if (!figures[i].draw(path)) {
            perror(path);
            return 1;
        }
    }
    return 0;
}
