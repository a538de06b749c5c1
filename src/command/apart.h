/* SPDX-License-Identifier: MIT */
/**
 * @file
 * Reading a file in a process of its own, so that a fault of a foreign reader ends that process and not the program.
 *
 *     parent                         child
 *     fork            ->             limits of memory, time and files; reads the file, prepares the document
 *     reads a parcel  <- pipe <-     writes the error, or the parcel of the document
 *     waits                          ends
 *
 * Price: a fork, and the bytes of the document through a pipe.
 */
#ifndef APART_H
#define APART_H

#include "parcel.h"

/** What a child reads. Returns the document; NULL, and the error, without one. */
typedef nkw_document *(*apart_reader)(const nkw_import_memory *memory, nkw_import_error *error);

/** Whether the system has such processes: POSIX. */
int apart_possible(void);

/** The CPU seconds of a child; 0: 10, and 1 for each MiB of the file. */
void apart_set_seconds(size_t seconds);

/**
 * Calls `read` in a child. `p` receives the block of the document, to be freed by parcel_free, also after an error. The
 * error of a child that a signal ends, or that exceeds a limit, is NKW_IMPORT_INVALID or NKW_IMPORT_TOO_LARGE.
 */
nkw_document *apart_read(const nkw_import_memory *memory, apart_reader read, parcel *p, nkw_import_error *error);

#endif
