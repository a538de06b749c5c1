/* SPDX-License-Identifier: MIT */
#include "data.h"
#include "hash.h"
#include "random.h"
#include "views.h"

#define MOST 67

typedef struct palettes {
    nkw_mat4 models[MOST], inverse_bind[MOST], palette[MOST];
    nkw_mat3x4 rows[MOST];
    nkw_dual_quat duals[MOST];
    nkw_mat3 normals[MOST];
    int32_t joints[MOST];
} palettes;

/* Every seventh scales unevenly, mirrors among them; every eleventh is flat; every fifth joint is none. */
static void draw(random_source *r, palettes *p, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        nkw_trs trs = nkw_trs_identity();
        trs.translation = random_vec3(r, -5, 5);
        trs.rotation = random_rotation(r);
        if (i % 7 == 3)
            trs.scale = random_vec3(r, -2, 2);
        if (i % 11 == 5)
            trs.scale.y = 0.0f;
        p->models[i] = nkw_mat4_from_trs(&trs);
        p->joints[i] = i % 5 == 4 ? -(int32_t)i : (int32_t)(random_bits(r) % count);
    }
}

static uint64_t hash_all(uint64_t hash, palettes *p, size_t n, const int32_t *joints, const nkw_mat4 *ib,
                         const nkw_mat4 *g)
{
    const nkw_palette_source source = {p->models, n, joints, ib, g, n};
    const float dropped = nkw_palette_residual(&source, NULL);
    hash = hash_floats(hash, &dropped, 1);
    palette_from_models(p->models, n, joints, ib, g, n, p->palette);
    palette_3x4_from_models(p->models, n, joints, ib, g, n, p->rows);
    palette_dual_from_models(p->models, n, joints, ib, g, n, p->duals);
    hash = hash_floats(hash, p->palette[0].m, 16 * n);
    hash = hash_floats(hash, p->rows[0].m, 12 * n);
    hash = hash_floats(hash, &p->duals[0].real.x, 8 * n);
    palette_normals(p->palette, n, p->normals);
    hash = hash_floats(hash, p->normals[0].m, 9 * n);
    palette_normals_rows(p->palette, n, p->rows);
    hash = hash_floats(hash, p->rows[0].m, 12 * n);
    palette_normals_columns(p->palette, n, p->rows[0].m);
    return hash_floats(hash, p->rows[0].m, 12 * n);
}

uint64_t data_palette(void)
{
    static const size_t counts[] = {1, 2, 3, 15, 16, 17, 33, MOST};
    static palettes p;
    random_source r = random_from(32);
    uint64_t hash = HASH_START;
    for (size_t k = 0; k < sizeof counts / sizeof counts[0]; k++) {
        size_t n = counts[k];
        nkw_mat4 g;
        draw(&r, &p, n);
        g = nkw_mat4_inverse_affine(&p.models[0]);
        inverse_bind_from_models(p.models, n, p.joints, &g, n, p.inverse_bind);
        hash = hash_floats(hash, p.inverse_bind[0].m, 16 * n);
        draw(&r, &p, n);
        hash = hash_all(hash, &p, n, p.joints, p.inverse_bind, &g);
        hash = hash_all(hash, &p, n, NULL, p.inverse_bind, NULL);
        hash = hash_all(hash, &p, n, p.joints, NULL, NULL);
        hash = hash_all(hash, &p, n, NULL, NULL, &g);
        nkw_palette_to_mat4(palette_view(NKW_PALETTE_DUAL_QUAT, p.duals, n), p.palette);
        hash = hash_floats(hash, p.palette[0].m, 16 * n);
        nkw_palette_to_mat4(palette_view(NKW_PALETTE_MAT3X4, p.rows, n), p.palette);
        hash = hash_floats(hash, p.palette[0].m, 16 * n);
    }
    return hash;
}
