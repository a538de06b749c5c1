/* SPDX-License-Identifier: MIT */
#include "rig.h"

#include <stdlib.h>

#include <nakawari/curve.h>
#include <nakawari/palette.h>
#include <nakawari/scalar.h>
#include <nakawari/skin.h>
#include <nakawari/transform.h>
#include <nakawari/vec.h>

/* ---- key frames ---- */

enum { KEYS = 5, TRACKS = 4 };
static const float times[KEYS] = {0.0f, 1.0f, RIG_TWIST, 3.0f, RIG_END};

/* An angle about an axis, radians: how a joint is turned at a key. */
typedef struct turn {
    char axis;
    float angle;
} turn;

/* The lesson's bend of joint 1 and back of joint 2; a twist of joint 2 by 170 degrees; a hook; rest. */
static const turn turns[RIG_JOINTS - 1][KEYS] = {
    {{'x', 0.0f}, {'x', 0.5f}, {'y', 0.0f}, {'z', -0.7f}, {'x', 0.0f}},
    {{'x', 0.0f}, {'x', -0.5f}, {'y', 2.9670597f}, {'z', -0.7f}, {'x', 0.0f}},
    {{'x', 0.0f}, {'x', 0.0f}, {'y', 0.0f}, {'z', -0.7f}, {'x', 0.0f}},
};

/* How far joint 0 is lifted, in spacings: in-tangent, height, out-tangent. */
static const float lifts[KEYS][3] = {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0.5f, 0}, {0, 0, 0}};

typedef struct keys {
    float rotation[RIG_JOINTS - 1][KEYS][4];
    float translation[KEYS][3][3]; /* three vectors at each key */
} keys;

static void set_rotation(const turn *t, float out[4])
{
    nkw_vec3 axis = {t->axis == 'x', t->axis == 'y', t->axis == 'z'};
    nkw_quat q = nkw_quat_from_axis_angle(axis, t->angle);
    out[0] = q.x;
    out[1] = q.y;
    out[2] = q.z;
    out[3] = q.w;
}

static void set_keys(const rig *r, keys *out)
{
    for (int k = 0; k < KEYS; k++) {
        for (int j = 0; j < RIG_JOINTS - 1; j++)
            set_rotation(&turns[j][k], out->rotation[j][k]);
        for (int part = 0; part < 3; part++) {
            out->translation[k][part][0] = out->translation[k][part][2] = 0.0f;
            out->translation[k][part][1] = r->spacing * lifts[k][part];
        }
        out->translation[k][1][1] += r->foot;
    }
}

/* ---- tracks and the clip ---- */

static void set_tracks(const keys *k, nkw_clip_track out[TRACKS])
{
    const nkw_track rise = {times, k->translation[0][0], KEYS, 3, NKW_TRACK_FLOATS, NKW_INTERPOLATION_CUBICSPLINE,
                            NULL};
    out[0].target = NKW_CLIP_TRANSLATION;
    out[0].index = 0;
    out[0].track = rise;
    for (uint32_t j = 1; j < RIG_JOINTS; j++) {
        const nkw_track turning = {times, k->rotation[j - 1][0], KEYS, 4, NKW_TRACK_ROTATION, NKW_INTERPOLATION_LINEAR,
                                   NULL};
        out[j].target = NKW_CLIP_ROTATION;
        out[j].index = j;
        out[j].track = turning;
    }
}

/* The pose in which the mesh was made: each joint one spacing above its parent, not turned. */
static void bind_pose(const rig *r, float *pose)
{
    nkw_trs trs = nkw_trs_identity();
    for (size_t j = 0; j < RIG_JOINTS; j++) {
        trs.translation.y = j ? r->spacing : r->foot;
        nkw_pose_set((nkw_pose_span){pose, RIG_JOINTS}, j, &trs);
    }
}

static const char *build_clip(rig *r, const float *rest)
{
    keys k;
    nkw_clip_track tracks[TRACKS];
    NKW_STACK_WORK(work, NKW_CLIP_BUILD_WORK(TRACKS));
    const nkw_clip_source source = {tracks, TRACKS, RIG_JOINTS, 0, {rest, RIG_JOINTS}, NULL, NKW_CLIP_FLOAT32, NULL};
    size_t bytes;
    set_keys(r, &k);
    set_tracks(&k, tracks);
    nkw_result result = nkw_clip_build(&source, (nkw_bytes_span){NULL, 0}, &bytes, NULL, work);
    if (bytes == 0)
        return nkw_result_text(result);
    r->clip = malloc(bytes);
    if (!r->clip)
        return "not enough memory";
    result = nkw_clip_build(&source, (nkw_bytes_span){r->clip, bytes}, &bytes, NULL, work);
    return result == NKW_OK ? NULL : nkw_result_text(result);
}

/* ---- the mesh on its joints ---- */

/* Joints beyond the ends count as the end ones. */
void rig_weights(const rig *r, float height, float out[RIG_JOINTS])
{
    float u = nkw_clamp((height - r->foot) / r->spacing - 0.5f, -1.0f, (float)RIG_JOINTS - 1.0f);
    int k = (int)(u + 1.0f) - 1;
    nkw_weights w = nkw_cubic_weights(NKW_CUBIC_BSPLINE, 0, u - (float)k);
    for (int j = 0; j < RIG_JOINTS; j++)
        out[j] = 0.0f;
    for (int i = 0; i < 4; i++) {
        int j = k - 1 + i;
        out[j < 0 ? 0 : j > RIG_JOINTS - 1 ? RIG_JOINTS - 1 : j] += w.w[i];
    }
}

static void hang(const rig *r, mesh *m)
{
    for (size_t i = 0; i < m->vertex_count; i++) {
        mesh_vertex *v = &m->vertices[i];
        float weights[RIG_JOINTS];
        const nkw_skin_view in = {weights, 0, NKW_SKIN_F32};
        const nkw_skin_span out = {v->weights, 0, NKW_SKIN_U16};
        rig_weights(r, v->position.y, weights);
        nkw_skin_normalize_weights(in, RIG_JOINTS, 1, out);
        for (uint16_t j = 0; j < RIG_JOINTS; j++)
            v->joints[j] = j;
    }
}

static nkw_skin skin_of(const mesh *m)
{
    const size_t stride = sizeof *m->vertices;
    const nkw_skin skin = {m->vertex_count,
                           MESH_INFLUENCES,
                           {m->vertices->joints, stride, NKW_SKIN_U16},
                           {m->vertices->weights, stride, NKW_SKIN_U16}};
    return skin;
}

/* ---- */

const char *rig_build(rig *r, mesh *m)
{
    static const int32_t parents[RIG_JOINTS] = {NKW_NO_JOINT, 0, 1, 2};
    float rest[NKW_POSE_FLOATS(RIG_JOINTS)];
    nkw_mat4 bind[RIG_JOINTS];
    nkw_vec3 low, high;
    mesh_box(m, &low, &high);
    r->skeleton.parents = parents;
    r->skeleton.joint_count = RIG_JOINTS;
    r->foot = low.y;
    r->spacing = (high.y - low.y) / 3.0f;
    r->clip = NULL;
    if (!(r->spacing > 0.0f))
        return "the mesh has no height";
    hang(r, m);
    nkw_skin skin = skin_of(m);
    bind_pose(r, rest);
    nkw_skeleton_models_from_pose(&r->skeleton, (nkw_pose_view){rest, r->skeleton.joint_count}, NULL, NULL, bind);
    const nkw_palette_source bound = {bind, RIG_JOINTS, NULL, NULL, NULL, RIG_JOINTS};
    nkw_palette_inverse_bind(&bound, r->inverse_bind);
    nkw_result result = nkw_skin_validate(&skin, RIG_JOINTS, NULL);
    return result == NKW_OK ? build_clip(r, rest) : nkw_result_text(result);
}

void rig_free(rig *r)
{
    free(r->clip);
    r->clip = NULL;
}

rig_state rig_at(const rig *r, float time)
{
    rig_state s;
    float pose[NKW_POSE_FLOATS(RIG_JOINTS)];
    nkw_clip_sample(r->clip, time, NULL, (nkw_pose_span){pose, nkw_clip_describe(r->clip).joint_count}, NULL);
    for (size_t j = 0; j < RIG_JOINTS; j++) {
        nkw_trs trs = nkw_pose_get((nkw_pose_view){pose, RIG_JOINTS}, j);
        s.local[j] = nkw_mat4_from_trs(&trs);
    }
    nkw_skeleton_models_from_pose(&r->skeleton, (nkw_pose_view){pose, r->skeleton.joint_count}, NULL, NULL, s.model);
    const nkw_palette_source source = {s.model, RIG_JOINTS, NULL, r->inverse_bind, NULL, RIG_JOINTS};
    nkw_palette_from_models(&source, (nkw_palette_span){s.palette, RIG_JOINTS, NKW_PALETTE_MAT4});
    return s;
}

void rig_skin(const rig_state *state, const mesh *m, int dual, nkw_vec3 *positions, nkw_vec3 *normals)
{
    const size_t stride = sizeof *m->vertices;
    const nkw_skin skin = skin_of(m);
    const nkw_vertices_view in = {
        {&m->vertices->position, stride}, {&m->vertices->normal, stride}, {NULL, 0}, {NULL, 0}};
    const nkw_vertices_span out = {{positions, 0}, {normals, 0}, {NULL, 0}, {NULL, 0}};
    const nkw_skin_palette matrices = {
        {state->palette, RIG_JOINTS, NKW_PALETTE_MAT4}, {NULL, 0, NKW_PALETTE_NORMAL_MAT3}, {0, 0, 0}};
    nkw_dual_quat motions[RIG_JOINTS];
    const nkw_palette_span dual_quats = {motions, RIG_JOINTS, NKW_PALETTE_DUAL_QUAT};
    const nkw_palette_source joint_matrices = {state->palette, RIG_JOINTS, NULL, NULL, NULL, RIG_JOINTS};
    nkw_palette_from_models(&joint_matrices, dual_quats);
    if (dual)
        nkw_skin_dual_quat(&skin, NKW_VIEW(nkw_palette, dual_quats), in, out);
    else
        nkw_skin_linear(&skin, &matrices, in, out);
}
