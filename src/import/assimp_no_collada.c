/* SPDX-License-Identifier: MIT */
/* Without libxml2 Collada files are refused: Assimp alone loses their curves. */
#include <string.h>

#include "assimp.h"

int nkwi_assimp_collada_trim(nkw_import_memory *memory, void **copy)
{
    (void)memory;
    *copy = NULL;
    return 1;
}

int nkwi_assimp_collada_open(nkwi_assimp *a, const nkw_import_memory *memory)
{
    return strcmp(nkwi_assimp_extension(memory), ".dae") != 0 ||
           nkwi_fail(a->error, NULL, NKW_IMPORT_UNSUPPORTED,
                     "Collada is read by libxml2, without which this library was built");
}

int nkwi_assimp_collada_animations(nkwi_assimp *a)
{
    (void)a;
    return 1;
}

const char *nkwi_assimp_collada_name(const nkwi_assimp *a, size_t node)
{
    (void)a, (void)node;
    return NULL;
}

void nkwi_assimp_collada_close(nkwi_assimp *a)
{
    (void)a;
}
