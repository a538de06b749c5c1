/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <math.h>

#include <nakawari/mat.h>
#include <nakawari/mirror.h>
#include <nakawari/quat.h>
#include <nakawari/skeleton.h>
#include <nakawari/vec.h>

#include "report.h"
#include "work.h"

/* ---- Poses ---- */

static nkw_vec3 reflected(nkw_mirror plane, nkw_vec3 v)
{
    nkw_vec3 r = {plane == NKW_MIRROR_X ? -v.x : v.x, plane == NKW_MIRROR_Y ? -v.y : v.y,
                  plane == NKW_MIRROR_Z ? -v.z : v.z};
    return r;
}

/* M R M: the axis reflected, and turned the other way. */
static nkw_quat reflected_turn(nkw_mirror plane, nkw_quat q)
{
    const nkw_vec3 axis = {q.x, q.y, q.z}, v = nkw_vec3_negate(reflected(plane, axis));
    const nkw_quat r = {v.x, v.y, v.z, q.w};
    return r;
}

static nkw_result check_joint(const nkw_mirror_rig *rig, size_t j)
{
    const size_t joints = rig->rest.joint_count;
    const int32_t parent = rig->parents[j], partner = rig->pair[j];
    if (partner < 0 || (size_t)partner >= joints || parent < NKW_NO_JOINT)
        return NKW_OUT_OF_RANGE;
    if (parent != NKW_NO_JOINT && (size_t)parent >= j)
        return (size_t)parent >= joints ? NKW_OUT_OF_RANGE : NKW_NOT_ORDERED;
    const int32_t other = rig->parents[partner];
    if (rig->pair[partner] < 0 || (size_t)rig->pair[partner] != j)
        return NKW_BAD_MIRROR;
    return (parent == NKW_NO_JOINT ? other == NKW_NO_JOINT : other == rig->pair[parent]) ? NKW_OK : NKW_BAD_MIRROR;
}

static nkw_result check_rig(const nkw_mirror_rig *rig, size_t *offender)
{
    if (rig->plane != NKW_MIRROR_X && rig->plane != NKW_MIRROR_Y && rig->plane != NKW_MIRROR_Z)
        return NKW_BAD_METHOD;
    for (size_t j = 0; j < rig->rest.joint_count; j++) {
        const nkw_result result = check_joint(rig, j);
        if (result == NKW_OK)
            continue;
        *offender = j;
        return result;
    }
    return NKW_OK;
}

/* C of all joints. Returns their largest angle. */
static float find_turns(const nkw_mirror_rig *rig, nkw_quat *c)
{
    const size_t joints = rig->rest.joint_count;
    float most = 0.0f;
    for (size_t j = 0; j < joints; j++) {
        const nkw_quat local = nkw_pose_get(rig->rest, j).rotation;
        c[j] = rig->parents[j] < 0 ? local : nkw_quat_mul(c[rig->parents[j]], local);
    }
    /* A pair at once: C_j and C_p need W_j and W_p. */
    for (size_t j = 0; j < joints; j++) {
        const size_t p = (size_t)rig->pair[j];
        if (p < j)
            continue;
        const nkw_quat w = c[j], other = c[p];
        c[j] = nkw_quat_normalize(nkw_quat_mul(nkw_quat_conjugate(w), reflected_turn(rig->plane, other)));
        c[p] = nkw_quat_normalize(nkw_quat_mul(nkw_quat_conjugate(other), reflected_turn(rig->plane, w)));
        const float angle = nkw_quat_angle(c[j], nkw_quat_identity());
        most = angle > most ? angle : most;
    }
    return most;
}

/* The sum over k of R_ik^2 s_k, R the matrix of c. */
static nkw_vec3 turned_scale(nkw_quat c, nkw_vec3 s)
{
    const nkw_vec3 x = nkw_quat_rotate(c, (nkw_vec3){1.0f, 0.0f, 0.0f}),
                   y = nkw_quat_rotate(c, (nkw_vec3){0.0f, 1.0f, 0.0f}),
                   z = nkw_quat_rotate(c, (nkw_vec3){0.0f, 0.0f, 1.0f});
    const nkw_vec3 a = nkw_vec3_scale(nkw_vec3_mul(x, x), s.x), b = nkw_vec3_scale(nkw_vec3_mul(y, y), s.y);
    return nkw_vec3_add(nkw_vec3_add(a, b), nkw_vec3_scale(nkw_vec3_mul(z, z), s.z));
}

/* What maps the values of the partner to those of joint j. */
typedef struct joint_map {
    nkw_mirror plane;
    nkw_quat parent, own; /* C_q, C_j */
    nkw_vec3 from, to; /* the rest translations of the partner and of j */
} joint_map;

static joint_map map_to(const nkw_mirror_rig *rig, const nkw_quat *c, size_t j)
{
    const joint_map r = {rig->plane, rig->parents[j] < 0 ? nkw_quat_identity() : c[rig->parents[j]], c[j],
                         nkw_pose_get(rig->rest, (size_t)rig->pair[j]).translation,
                         nkw_pose_get(rig->rest, j).translation};
    return r;
}

static nkw_quat map_turn(const joint_map *m, nkw_quat q)
{
    return nkw_quat_mul(m->parent, nkw_quat_mul(reflected_turn(m->plane, q), nkw_quat_conjugate(m->own)));
}

static nkw_vec3 map_way(const joint_map *m, nkw_vec3 v)
{
    return nkw_quat_rotate(m->parent, reflected(m->plane, v));
}

static nkw_vec3 map_place(const joint_map *m, nkw_vec3 t)
{
    return nkw_vec3_add(m->to, map_way(m, nkw_vec3_sub(t, m->from)));
}

/* The transform of joint j from that of its partner. */
static nkw_trs mirrored(const nkw_mirror_rig *rig, const nkw_quat *c, size_t j, const nkw_trs *from)
{
    const joint_map m = map_to(rig, c, j);
    const nkw_trs r = {map_place(&m, from->translation), map_turn(&m, from->rotation), turned_scale(m.own, from->scale)};
    return r;
}

nkw_result nkw_pose_mirror_rest(nkw_pose_view pose, const nkw_mirror_rig *rig, nkw_pose_span out, float *difference,
                                size_t *bad, nkw_work work)
{
    const size_t joints = pose.joint_count;
    size_t offender = 0;
    nkw_result result =
        out.joint_count != joints || rig->rest.joint_count != joints ? NKW_MISMATCHED : check_rig(rig, &offender);
    if (result == NKW_OK && !work_fits_each(work, joints, NKW_MIRROR_WORK(1)))
        result = NKW_TOO_SMALL;
    if (result != NKW_OK)
        return report(result, offender, bad);
    nkw_quat *c = work.data;
    const float most = find_turns(rig, c);
    for (size_t j = 0; j < joints; j++) {
        const size_t p = (size_t)rig->pair[j];
        if (p < j)
            continue;
        const nkw_trs at_j = nkw_pose_get(pose, j), at_p = nkw_pose_get(pose, p);
        const nkw_trs to_j = mirrored(rig, c, j, &at_p), to_p = mirrored(rig, c, p, &at_j);
        nkw_pose_set(out, j, &to_j);
        nkw_pose_set(out, p, &to_p);
    }
    if (difference)
        *difference = most;
    return report(NKW_OK, 0, bad);
}

/* ---- Tracks ---- */

/* One value, or a tangent: a vector of the same kind without a place. */
static void map_value(const joint_map *m, nkw_axes_kind kind, int is_tangent, const float *v, float *out)
{
    const nkw_vec3 from = {v[0], v[1], v[2]};
    if (kind == NKW_AXES_QUAT) {
        const nkw_quat q = {v[0], v[1], v[2], v[3]}, r = map_turn(m, q);
        out[0] = r.x, out[1] = r.y, out[2] = r.z, out[3] = r.w;
        return;
    }
    const nkw_vec3 r = kind == NKW_AXES_SCALE ? turned_scale(m->own, from)
                       : is_tangent           ? map_way(m, from)
                                              : map_place(m, from);
    out[0] = r.x, out[1] = r.y, out[2] = r.z;
}

nkw_result nkw_track_mirror_rest(const nkw_track *track, const nkw_mirror_rig *rig, size_t joint, nkw_axes_kind kind,
                                 float *values, nkw_work work)
{
    const size_t joints = rig->rest.joint_count, count = nkw_track_value_count(track);
    size_t offender;
    nkw_result result = check_rig(rig, &offender);
    if (result == NKW_OK && joint >= joints)
        result = NKW_OUT_OF_RANGE;
    if (result == NKW_OK && kind != NKW_AXES_QUAT && kind != NKW_AXES_VEC3 && kind != NKW_AXES_SCALE)
        result = NKW_BAD_METHOD;
    if (result == NKW_OK && track->width != NKW_AXES_WIDTH(kind))
        result = NKW_BAD_WIDTH;
    if (result == NKW_OK && (count == SIZE_MAX || !work_fits_each(work, joints, NKW_MIRROR_WORK(1))))
        result = NKW_TOO_SMALL;
    if (result != NKW_OK)
        return result;
    find_turns(rig, work.data);
    const joint_map m = map_to(rig, work.data, (size_t)rig->pair[joint]);
    const size_t parts = track->interpolation == NKW_INTERPOLATION_CUBICSPLINE ? 3 : 1;
    for (size_t i = 0; i < count / track->width; i++)
        map_value(&m, kind, parts == 3 && i % 3 != 1, track->values + i * track->width, values + i * track->width);
    return NKW_OK;
}

/* ---- Places ---- */

static int32_t parent_of(const nkw_skeleton *skeleton, size_t j)
{
    const int32_t parent = skeleton->parents[j];
    return parent >= 0 && (size_t)parent < j ? parent : NKW_NO_JOINT;
}

static size_t descendants_of(const nkw_skeleton *skeleton, size_t j)
{
    size_t count = 0;
    for (size_t k = j + 1; k < skeleton->joint_count; k++) {
        int32_t at = (int32_t)k;
        while (at > (int32_t)j)
            at = parent_of(skeleton, (size_t)at);
        count += at == (int32_t)j;
    }
    return count;
}

typedef struct place_search {
    const nkw_skeleton *skeleton;
    const nkw_mat4 *models;
    const int32_t *pair; /* -1: not known yet */
    nkw_mirror plane;
} place_search;

/* How far the mirrored joint j is from k, or more than `most` if they cannot be partners. */
static float distance_of(const place_search *s, size_t j, size_t k, float most)
{
    const int32_t parent = parent_of(s->skeleton, j), other = parent == NKW_NO_JOINT ? NKW_NO_JOINT : s->pair[parent];
    if (s->pair[k] >= 0 || parent_of(s->skeleton, k) != other)
        return INFINITY;
    const nkw_vec3 at = reflected(s->plane, nkw_mat4_translation(&s->models[j]));
    const float distance = nkw_vec3_length(nkw_vec3_sub(at, nkw_mat4_translation(&s->models[k])));
    return distance <= most ? distance : INFINITY;
}

/* The partner of j among the joints from j on; j itself if there is none. */
static size_t nearest_partner(const place_search *s, size_t j, float tolerance)
{
    const size_t joints = s->skeleton->joint_count;
    float least = INFINITY;
    size_t found = j, alike = 0, own = 0;
    for (size_t k = j; k < joints; k++) {
        const float distance = distance_of(s, j, k, tolerance);
        least = distance < least ? distance : least;
    }
    for (size_t k = j; k < joints && !alike; k++) {
        if (!(distance_of(s, j, k, tolerance) <= least + tolerance / 16.0f) || least == INFINITY)
            continue;
        own = own ? own : 1 + descendants_of(s->skeleton, j);
        alike = 1 + descendants_of(s->skeleton, k) == own;
        found = alike || found == j ? k : found;
    }
    return found;
}

size_t nkw_mirror_pairs_from_models(const nkw_skeleton *skeleton, const nkw_mat4 *models, nkw_mirror plane,
                                    float tolerance, int32_t *pair)
{
    const place_search search = {skeleton, models, pair, plane};
    size_t pairs = 0;
    for (size_t j = 0; j < skeleton->joint_count; j++)
        pair[j] = -1;
    for (size_t j = 0; j < skeleton->joint_count; j++) {
        if (pair[j] >= 0)
            continue;
        const size_t k = nearest_partner(&search, j, tolerance);
        pair[j] = (int32_t)k;
        pair[k] = (int32_t)j;
        pairs += k != j;
    }
    return pairs;
}

/* ---- Names ---- */

typedef struct side_words {
    const char *left, *right;
    int is_letter; /* of its own, not a part of a word */
} side_words;

static const side_words words[] = {
    {"Left", "Right", 0}, {"left", "right", 0}, {"LEFT", "RIGHT", 0}, {"\xE5\xB7\xA6", "\xE5\x8F\xB3", 0},
    {"L", "R", 1},        {"l", "r", 1},
};

static int is_end(char c)
{
    return c == 0 || c == '_' || c == '.' || c == '-' || c == ':' || c == ' ';
}

/* Whether the letter at `at` of a name is a word: between ends, or first and before a capital. */
static int is_word(const char *name, size_t at)
{
    const char next = name[at + 1];
    const int begins = at == 0 || is_end(name[at - 1]);
    return begins && (is_end(next) || (at == 0 && next >= 'A' && next <= 'Z'));
}

/* The length of the word if the text begins with it, else 0. */
static size_t beginning(const char *text, const char *word)
{
    size_t i = 0;
    while (word[i] && text[i] == word[i])
        i++;
    return word[i] ? 0 : i;
}

static int is_equal(const char *a, const char *b)
{
    for (; *a && *a == *b; a++)
        b++;
    return *a == *b;
}

static int have_sides(const char *a, const char *b, size_t at, const side_words *w)
{
    const size_t left = beginning(a + at, w->left), right = beginning(b + at, w->right);
    return left && right && is_equal(a + at + left, b + at + right) && (!w->is_letter || is_word(a, at));
}

static int are_partners(const char *a, const char *b)
{
    for (size_t at = 0;; at++) {
        for (size_t k = 0; k < sizeof words / sizeof *words; k++)
            if (have_sides(a, b, at, &words[k]) || have_sides(b, a, at, &words[k]))
                return 1;
        if (a[at] == 0 || a[at] != b[at])
            return 0;
    }
}

size_t nkw_mirror_pairs_from_names(const char *const *names, size_t joint_count, int32_t *pair)
{
    size_t pairs = 0;
    for (size_t j = 0; j < joint_count; j++)
        pair[j] = (int32_t)j;
    for (size_t j = 0; j < joint_count; j++)
        for (size_t k = j + 1; k < joint_count && names[j] && pair[j] == (int32_t)j; k++)
            if (names[k] && pair[k] == (int32_t)k && are_partners(names[j], names[k])) {
                pair[j] = (int32_t)k;
                pair[k] = (int32_t)j;
                pairs++;
            }
    return pairs;
}
