/* SPDX-License-Identifier: MIT */
/** @file The times of --at T,T,... */
#ifndef TIMELIST_H
#define TIMELIST_H

#include <stddef.h>

/** The next number of a list, from *at on, which is moved behind it. Returns 0 at the end and for what is no number. */
int timelist_next(const char **at, float *time);
/** The number of times of a list, 0 if it is not a list of numbers. */
size_t timelist_count(const char *list);

#endif
