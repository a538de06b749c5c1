/* SPDX-License-Identifier: MIT */
#include "planted.h"

#include <math.h>

#include "expect.h"

static float *rotation(planted *p, int key)
{
    return p->rotations[p->cubic ? 3 * key + 1 : key];
}

void planted_turn(planted *p, int key, double degrees)
{
    float *q = rotation(p, key);
    q[0] = q[1] = 0.0f;
    q[2] = (float)sin(degrees / 114.59155902616465);
    q[3] = (float)cos(degrees / 114.59155902616465);
}

planted planted_cubic(void)
{
    planted p = planted_clean();
    p.cubic = 1;
    memset(p.rotations, 0, sizeof p.rotations);
    for (int k = 0; k < PLANTED_KEYS; k++)
        planted_turn(&p, k, 10.0 * k);
    return p;
}

planted planted_clean(void)
{
    static const double turns[PLANTED_KEYS] = {0.0, 40.0, 10.0, 60.0, 0.0};
    static const float waves[PLANTED_KEYS] = {0.0f, 2.0f, 1.0f, 3.0f, 0.0f};
    planted p;
    memset(&p, 0, sizeof p);
    for (int k = 0; k < PLANTED_KEYS; k++) {
        p.times[k] = 0.5f * (float)k;
        planted_turn(&p, k, turns[k]);
        p.translations[k][1] = 1.0f + 0.25f * waves[k];
        for (int i = 0; i < 3; i++)
            p.scales[k][i] = 1.0f + 0.125f * waves[k];
    }
    for (int i = 0; i < 3; i++)
        p.rest_scale[i] = 1.0f;
    for (int j = 0; j < 2; j++)
        for (int i = 0; i < 4; i++)
            p.inverse_bind[j][5 * i] = 1.0f;
    p.inverse_bind[1][13] = -1.0f;
    for (int v = 0; v < PLANTED_VERTICES; v++) {
        p.joints[v][1] = 1;
        p.weights[v][0] = 0.75f;
        p.weights[v][1] = 0.25f;
    }
    return p;
}

float planted_texcoord(int set, int vertex, int component)
{
    return component == 0 ? 0.25f * (float)vertex + (float)set / 32.0f : 0.25f * (float)vertex + (float)set / 64.0f;
}

/* A buffer view and its accessor for each array. */
typedef struct arrays {
    FILE *bin;
    char views[4096], accessors[4096];
    size_t offset;
    int count;
} arrays;

static void add(arrays *a, const void *data, size_t bytes, size_t count, int component, const char *type)
{
    size_t used = strlen(a->views), written = strlen(a->accessors);
    assert_int_equal(fwrite(data, 1, bytes, a->bin), bytes);
    snprintf(a->views + used, sizeof a->views - used, "%s{\"buffer\":0,\"byteOffset\":%zu,\"byteLength\":%zu}",
             used ? "," : "", a->offset, bytes);
    snprintf(a->accessors + written, sizeof a->accessors - written,
             "%s{\"bufferView\":%d,\"componentType\":%d,\"count\":%zu,\"type\":\"%s\"}", written ? "," : "", a->count++,
             component, count, type);
    a->offset += bytes;
}

static void put_json(FILE *f, const planted *p, const arrays *a, const char *name)
{
    fprintf(f,
            "{\"asset\":{\"version\":\"2.0\"},\"scene\":0,\"scenes\":[{\"nodes\":[0,2]}],\"nodes\":["
            "{\"name\":\"hip\",\"children\":[1]},"
            "{\"name\":\"knee\",\"translation\":[0,1,0],\"scale\":[%.9g,%.9g,%.9g]},"
            "{\"name\":\"leg\",\"mesh\":0,\"skin\":0}],",
            (double)p->rest_scale[0], (double)p->rest_scale[1], (double)p->rest_scale[2]);
    fprintf(f, "\"skins\":[{\"name\":\"bones\",\"joints\":[0,1],\"inverseBindMatrices\":4}],"
               "\"meshes\":[{\"name\":\"skin\",\"primitives\":[{\"attributes\":"
               "{\"POSITION\":5,\"JOINTS_0\":6,\"WEIGHTS_0\":7");
    for (int set = 0; set < p->texcoord_count; set++)
        fprintf(f, ",\"TEXCOORD_%d\":%d", set, 8 + set);
    fprintf(f, "}}]}],");
    fprintf(f,
            "\"animations\":[{\"name\":\"kick\",\"samplers\":[{\"input\":0,\"output\":1,\"interpolation\":\"%s\"},"
            "{\"input\":0,\"output\":2},{\"input\":0,\"output\":3}],\"channels\":["
            "{\"sampler\":0,\"target\":{\"node\":1,\"path\":\"rotation\"}},"
            "{\"sampler\":1,\"target\":{\"node\":1,\"path\":\"translation\"}},"
            "{\"sampler\":2,\"target\":{\"node\":1,\"path\":\"scale\"}}]}],",
            p->cubic ? "CUBICSPLINE" : "LINEAR");
    fprintf(f, "\"buffers\":[{\"uri\":\"%s.bin\",\"byteLength\":%zu}],\"bufferViews\":[%s],\"accessors\":[%s]}\n", name,
            a->offset, a->views, a->accessors);
}

void planted_write(const planted *p, const char *name)
{
    static const float positions[PLANTED_VERTICES][3] = {{0.0f, 0.0f, 0.0f}, {1.0f, 0.0f, 0.0f}, {0.0f, 2.0f, 0.0f}};
    enum { FLOATS = 5126, SHORTS = 5123 };
    size_t rotations = p->cubic ? 3 * PLANTED_KEYS : PLANTED_KEYS;
    char path[256];
    arrays a = {NULL, "", "", 0, 0};
    snprintf(path, sizeof path, "%s.bin", name);
    assert_non_null(a.bin = fopen(path, "wb"));
    add(&a, p->times, sizeof p->times, PLANTED_KEYS, FLOATS, "SCALAR");
    add(&a, p->rotations, rotations * 16, rotations, FLOATS, "VEC4");
    add(&a, p->translations, sizeof p->translations, PLANTED_KEYS, FLOATS, "VEC3");
    add(&a, p->scales, sizeof p->scales, PLANTED_KEYS, FLOATS, "VEC3");
    add(&a, p->inverse_bind, sizeof p->inverse_bind, 2, FLOATS, "MAT4");
    add(&a, positions, sizeof positions, PLANTED_VERTICES, FLOATS, "VEC3");
    add(&a, p->joints, sizeof p->joints, PLANTED_VERTICES, SHORTS, "VEC4");
    add(&a, p->weights, sizeof p->weights, PLANTED_VERTICES, FLOATS, "VEC4");
    for (int set = 0; set < p->texcoord_count; set++) {
        float texcoords[PLANTED_VERTICES][2];
        for (int i = 0; i < 2 * PLANTED_VERTICES; i++)
            texcoords[i / 2][i % 2] = planted_texcoord(set, i / 2, i % 2);
        add(&a, texcoords, sizeof texcoords, PLANTED_VERTICES, FLOATS, "VEC2");
    }
    assert_int_equal(fclose(a.bin), 0);
    snprintf(path, sizeof path, "%s.gltf", name);
    FILE *f = fopen(path, "wb");
    assert_non_null(f);
    put_json(f, p, &a, name);
    assert_int_equal(fclose(f), 0);
}
