/* SPDX-License-Identifier: MIT */
#include "timelist.h"

#include <math.h>
#include <stdlib.h>

int timelist_next(const char **at, float *time)
{
    char *end;
    if (!**at)
        return 0;
    *time = strtof(*at, &end);
    if (end == *at || !isfinite(*time) || (*end && *end != ',') || (*end && !end[1]))
        return 0;
    *at = *end ? end + 1 : end;
    return 1;
}

size_t timelist_count(const char *list)
{
    float time;
    size_t count = 0;
    while (timelist_next(&list, &time))
        count++;
    return *list ? 0 : count;
}
