/* SPDX-License-Identifier: MIT */
/* The glTF files of NKW_DATA_DIR. */
#ifndef NAKAWARI_SAMPLES_H
#define NAKAWARI_SAMPLES_H

#include <glob.h>

#include "expect.h"

/* Calls `use` for each file; skips the test where there is none. */
static inline void each_sample(void (*use)(const char *file))
{
    glob_t found;
    if (glob(NKW_DATA_DIR "/gltf/*.gl[tb]*", 0, NULL, &found) != 0) {
        print_message("skipped: there is no " NKW_DATA_DIR "/gltf/\n");
        skip();
    }
    for (size_t i = 0; i < found.gl_pathc; i++)
        use(found.gl_pathv[i]);
    globfree(&found);
}

#endif
