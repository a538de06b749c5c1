/* SPDX-License-Identifier: MIT */
/* Nodes and animations of Collada, read beside Assimp (collada.h). Assimp's scene has the meshes, skins and nodes. */
#ifndef NAKAWARI_IMPORT_ASSIMP_COLLADA_H
#define NAKAWARI_IMPORT_ASSIMP_COLLADA_H

#include "assimp.h"
#include "collada.h"

typedef struct nkwi_assimp_collada {
    nkwi_collada file;
    const xmlNode **tags; /* of each node of the tree; NULL: there is none, and it stays at rest */
} nkwi_assimp_collada;

#endif
