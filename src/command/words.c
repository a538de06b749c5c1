/* SPDX-License-Identifier: MIT */
#include "command.h"

#include <string.h>

int words_find(const char *word, const char *const *words, int count)
{
    for (int i = 0; i < count; i++)
        if (strcmp(word, words[i]) == 0)
            return i;
    return -1;
}
