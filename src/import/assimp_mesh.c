/* SPDX-License-Identifier: MIT */
/* Meshes of a scene of Assimp: attributes, indices, morph targets. */
#include <stdio.h>
#include <string.h>

#include "assimp.h"

/* An error at /meshes/INDEX, or below it. */
static int fail_mesh(nkwi_assimp *a, size_t mesh, const char *part, size_t index, const char *reason)
{
    const nkwi_place root = {NULL, NULL, 0}, list = {&root, "meshes", 0}, at = {&list, NULL, mesh};
    const nkwi_place parts = {&at, part, 0}, element = {&parts, NULL, index};
    return nkwi_fail(a->error, part ? &element : &at, NKW_IMPORT_INVALID, "%s", reason);
}

static int check_faces(nkwi_assimp *a, size_t index, const struct aiMesh *m)
{
    if (m->mNumFaces > 0 && !m->mFaces)
        return fail_mesh(a, index, NULL, 0, "the mesh has no faces");
    for (size_t f = 0; f < m->mNumFaces; f++) {
        const struct aiFace *face = &m->mFaces[f];
        if (face->mNumIndices > 0 && !face->mIndices)
            return fail_mesh(a, index, "faces", f, "the face has no vertices");
        for (unsigned i = 0; i < face->mNumIndices; i++)
            if (face->mIndices[i] >= m->mNumVertices)
                return fail_mesh(a, index, "faces", f, "a vertex of the face does not exist");
    }
    return 1;
}

static int check_bones(nkwi_assimp *a, size_t index, const struct aiMesh *m)
{
    if (m->mNumBones > 0 && !m->mBones)
        return fail_mesh(a, index, NULL, 0, "the mesh has no bones");
    for (size_t b = 0; b < m->mNumBones; b++) {
        const struct aiBone *bone = m->mBones[b];
        if (!bone || (bone->mNumWeights > 0 && !bone->mWeights))
            return fail_mesh(a, index, "bones", b, "the bone has no weights");
        for (unsigned i = 0; i < bone->mNumWeights; i++)
            if (bone->mWeights[i].mVertexId >= m->mNumVertices)
                return fail_mesh(a, index, "bones", b, "a vertex of the bone does not exist");
    }
    return 1;
}

static int check_targets(nkwi_assimp *a, size_t index, const struct aiMesh *m)
{
    if (m->mNumAnimMeshes > 0 && !m->mAnimMeshes)
        return fail_mesh(a, index, NULL, 0, "the mesh has no morph targets");
    for (size_t t = 0; t < m->mNumAnimMeshes; t++)
        if (!m->mAnimMeshes[t] || m->mAnimMeshes[t]->mNumVertices != m->mNumVertices)
            return fail_mesh(a, index, "targets", t, "the morph target has another number of vertices");
    return 1;
}

int nkwi_assimp_check(nkwi_assimp *a)
{
    if (a->scene->mNumMeshes > INT32_MAX || (a->scene->mNumMeshes > 0 && !a->scene->mMeshes))
        return nkwi_fail(a->error, NULL, NKW_IMPORT_INVALID, "the scene has no list of meshes");
    for (size_t i = 0; i < a->scene->mNumMeshes; i++) {
        const struct aiMesh *m = a->scene->mMeshes[i];
        if (!m || m->mNumVertices >= UINT32_MAX || (m->mNumVertices > 0 && !m->mVertices))
            return fail_mesh(a, i, NULL, 0, "the mesh has no vertices");
        if (!check_faces(a, i, m) || !check_bones(a, i, m) || !check_targets(a, i, m))
            return 0;
    }
    return 1;
}

int nkwi_assimp_check_node(nkwi_assimp *a, size_t node)
{
    const nkwi_place root = {NULL, NULL, 0}, list = {&root, "nodes", 0}, at = {&list, NULL, node};
    const struct aiNode *n = a->nodes[node];
    for (unsigned i = 0; i < n->mNumMeshes; i++)
        if (!n->mMeshes || n->mMeshes[i] >= a->scene->mNumMeshes)
            return nkwi_fail(a->error, &at, NKW_IMPORT_INVALID, "a mesh of the node does not exist");
    return 1;
}

static void copy_vectors(const struct aiVector3D *from, nkw_vec3 *out, size_t n)
{
    for (size_t v = 0; v < n; v++) {
        const nkw_vec3 vector = {from[v].x, from[v].y, from[v].z};
        out[v] = vector;
    }
}

static int read_vectors(nkwi_assimp *a, const struct aiVector3D *from, size_t n, const nkw_vec3 **out)
{
    nkw_vec3 *vectors = from ? (nkw_vec3 *)nkwi_assimp_take(a, "meshes", n, sizeof *vectors) : NULL;
    *out = vectors;
    if (vectors)
        copy_vectors(from, vectors, n);
    return !from || vectors;
}

/* The first set of colours. */
static int read_colors(nkwi_assimp *a, const struct aiMesh *m, nkw_document_primitive *out)
{
    const struct aiColor4D *from = m->mColors[0];
    float *to = from ? (float *)nkwi_assimp_take(a, "meshes", m->mNumVertices, 4 * sizeof *to) : NULL;
    for (size_t v = 0; to && v < m->mNumVertices; v++) {
        const float color[4] = {from[v].r, from[v].g, from[v].b, from[v].a};
        memcpy(to + 4 * v, color, sizeof color);
    }
    out->colors = to;
    return !from || to;
}

/* All sets of texture coordinates, u and v. Assimp's v is upwards. */
static int read_texcoords(nkwi_assimp *a, const struct aiMesh *m, nkw_document_primitive *out)
{
    const int is_up = a->document->v_is_up;
    while (out->texcoord_count < AI_MAX_NUMBER_OF_TEXTURECOORDS && m->mTextureCoords[out->texcoord_count])
        out->texcoord_count++;
    if (out->texcoord_count == 0)
        return 1;
    const float **sets = (const float **)nkwi_assimp_take(a, "meshes", out->texcoord_count, sizeof *sets);
    out->texcoords = sets;
    for (size_t set = 0; sets && set < out->texcoord_count; set++) {
        const struct aiVector3D *from = m->mTextureCoords[set];
        float *to = (float *)nkwi_assimp_take(a, "meshes", m->mNumVertices, 2 * sizeof *to);
        if (!to)
            return 0;
        for (size_t v = 0; v < m->mNumVertices; v++) {
            to[2 * v] = from[v].x;
            to[2 * v + 1] = is_up ? from[v].y : 1.0f - from[v].y;
        }
        sets[set] = to;
    }
    return sets != NULL;
}

/* Texture coordinates, colours, and tangents with the sign of the bitangent. */
static int read_attributes(nkwi_assimp *a, const struct aiMesh *m, nkw_document_primitive *out)
{
    size_t n = m->mNumVertices;
    out->vertex_count = n;
    if (!read_vectors(a, m->mVertices, n, &out->positions) || !read_vectors(a, m->mNormals, n, &out->normals) ||
        !read_colors(a, m, out) || !read_texcoords(a, m, out))
        return 0;
    if (!m->mTangents || !m->mBitangents || !m->mNormals)
        return 1;
    float *to = (float *)nkwi_assimp_take(a, "meshes", n, 4 * sizeof *to);
    for (size_t v = 0; to && v < n; v++) {
        struct aiVector3D x = m->mNormals[v], y = m->mTangents[v], z = m->mBitangents[v];
        float volume = (x.y * y.z - x.z * y.y) * z.x + (x.z * y.x - x.x * y.z) * z.y + (x.x * y.y - x.y * y.x) * z.z;
        const float tangent[4] = {y.x, y.y, y.z, volume < 0.0f ? -1.0f : 1.0f};
        memcpy(to + 4 * v, tangent, sizeof tangent);
    }
    out->tangents = to;
    return to != NULL;
}

/* Faces of one kind: that of the first; Assimp has made meshes of one kind each. */
static int read_indices(nkwi_assimp *a, const struct aiMesh *m, nkw_document_primitive *out)
{
    size_t corners = m->mNumFaces > 0 ? m->mFaces[0].mNumIndices : 3, count = 0;
    corners = corners < 1 || corners > 3 ? 3 : corners;
    uint32_t *list = (uint32_t *)nkwi_assimp_take(a, "meshes", m->mNumFaces, corners * sizeof *list);
    if (!list)
        return 0;
    for (size_t f = 0; f < m->mNumFaces; f++)
        if (m->mFaces[f].mNumIndices == corners)
            for (size_t c = 0; c < corners; c++)
                list[count++] = m->mFaces[f].mIndices[c];
    out->topology = (nkw_document_topology)(corners - 1);
    out->indices = list;
    out->index_count = count;
    return 1;
}

/* Targets are whole meshes: differences to the mesh. */
static int read_difference(nkwi_assimp *a, const struct aiVector3D *to, const struct aiVector3D *from, size_t n,
                           const nkw_vec3 **out)
{
    nkw_vec3 *vectors = to && from ? (nkw_vec3 *)nkwi_assimp_take(a, "meshes", n, sizeof *vectors) : NULL;
    *out = vectors;
    for (size_t v = 0; vectors && v < n; v++) {
        const nkw_vec3 difference = {to[v].x - from[v].x, to[v].y - from[v].y, to[v].z - from[v].z};
        vectors[v] = difference;
    }
    return !to || !from || vectors;
}

static int read_targets(nkwi_assimp *a, const struct aiMesh *m, nkw_document_primitive *out)
{
    size_t n = m->mNumVertices;
    nkw_document_target *targets =
        (nkw_document_target *)nkwi_assimp_take(a, "meshes", m->mNumAnimMeshes, sizeof *targets);
    for (size_t t = 0; targets && t < m->mNumAnimMeshes; t++) {
        const struct aiAnimMesh *from = m->mAnimMeshes[t];
        if (!read_difference(a, from->mVertices, m->mVertices, n, &targets[t].positions) ||
            !read_difference(a, from->mNormals, m->mNormals, n, &targets[t].normals) ||
            !read_difference(a, from->mTangents, m->mTangents, n, &targets[t].tangents))
            return 0;
    }
    out->targets = targets;
    out->target_count = m->mNumAnimMeshes;
    return targets != NULL;
}

/* The influences of each vertex: all that are not 0, in the order of the bones. joints are bones of the mesh. */
static int read_influences(nkwi_assimp *a, size_t index, const struct aiMesh *m, nkw_document_primitive *out)
{
    size_t n = m->mNumVertices, most = 0;
    if (m->mNumBones == 0)
        return 1;
    if (m->mNumBones > UINT16_MAX)
        return fail_mesh(a, index, NULL, 0, "the mesh has more than 65535 bones");
    uint32_t *counts = (uint32_t *)nkwi_assimp_scratch(a, "meshes", n, sizeof *counts);
    for (size_t b = 0; counts && b < m->mNumBones; b++)
        for (unsigned i = 0; i < m->mBones[b]->mNumWeights; i++)
            if (m->mBones[b]->mWeights[i].mWeight != 0.0f) {
                uint32_t count = ++counts[m->mBones[b]->mWeights[i].mVertexId];
                most = count > most ? count : most;
            }
    size_t width = most < 4 ? 4 : (most + 3) / 4 * 4;
    uint16_t *joints = counts ? (uint16_t *)nkwi_assimp_take(a, "meshes", n, width * sizeof *joints) : NULL;
    float *weights = joints ? (float *)nkwi_assimp_take(a, "meshes", n, width * sizeof *weights) : NULL;
    if (!weights)
        return 0;
    memset(counts, 0, n * sizeof *counts);
    for (size_t b = 0; b < m->mNumBones; b++)
        for (unsigned i = 0; i < m->mBones[b]->mNumWeights; i++) {
            const struct aiVertexWeight *w = &m->mBones[b]->mWeights[i];
            if (w->mWeight == 0.0f)
                continue;
            size_t to = w->mVertexId * width + counts[w->mVertexId]++;
            joints[to] = (uint16_t)b;
            weights[to] = w->mWeight;
        }
    out->joints = joints;
    out->weights = weights;
    out->influence_count = width;
    return 1;
}

int nkwi_assimp_meshes(nkwi_assimp *a)
{
    size_t count = a->scene->mNumMeshes;
    a->primitives = (nkw_document_primitive *)nkwi_assimp_scratch(a, "meshes", count, sizeof *a->primitives);
    for (size_t i = 0; a->primitives && i < count; i++) {
        const struct aiMesh *m = a->scene->mMeshes[i];
        nkw_document_primitive *out = &a->primitives[i];
        out->material = m->mMaterialIndex < a->document->all.material_count ? (int32_t)m->mMaterialIndex : NKW_NO_JOINT;
        if (!read_attributes(a, m, out) || !read_indices(a, m, out) || !read_targets(a, m, out) ||
            !read_influences(a, i, m, out) || !nkwi_assimp_join(a, out, (uint32_t *)out->indices))
            return 0;
    }
    return a->primitives != NULL;
}
