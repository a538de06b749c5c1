/* SPDX-License-Identifier: MIT */
/** @file Work that is repeated when a file changes. */
#ifndef WATCH_H
#define WATCH_H

/**
 * Does the work once, and again after each change of the time or the size of a file, until the program is interrupted
 * (SIGINT, SIGTERM). Five times a second it looks for a change; a file that is not there is not changed.
 */
void watch_file(const char *path, void (*work)(void *user), void *user);

#endif
