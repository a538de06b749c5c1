/* SPDX-License-Identifier: MIT */
/*
 * One hash per function over a fixed stream of inputs, compared with golden.txt: the same file must hold for every
 * compiler, flag level, processor and language (this file is C and C++).
 *
 *     golden golden.txt          compares; names each function that differs; exit status 1 if any does
 *     golden --write             prints the table
 *     golden --exceptions        see exceptions.h
 */
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <nakawari/nakawari.h>

#include "../support/data.h"
#include "../support/exceptions.h"
#include "../support/hash.h"
#include "../support/joint_limits.h"
#include "../support/put.h"
#include "../support/random.h"
#include "../support/motion_span.h"
#include "../support/resample.h"
#include "edits.h"
#include "handles.h"

#define ROUNDS 4000

typedef struct input {
    float x[8], s[8], t;
    nkw_vec3 v[4];
    nkw_quat q[4];
    nkw_mat4 m, n;
    nkw_mat3 r;
    nkw_trs trs;
    float cubic[4];
    float times[4];
    nkw_keyframe keys[5];
    nkw_euler_order order;
    nkw_path path;
    nkw_unwrap unwrap;
    int is_seldom; /* in one round of 16: for functions that take long */
} input;

/* Without elementary functions of the library: a fault there must not hide behind other inputs. */
static nkw_quat some_rotation(random_source *r, nkw_quat near, unsigned kind)
{
    if (kind == 0)
        return near;
    if (kind == 1)
        return nkw_quat_negate(near);
    if (kind < 5) {
        float angle = kind == 2 ? 1e-5f : kind == 3 ? 1e-2f : 0.3f;
        return random_near(r, near, angle);
    }
    return random_rotation(r);
}

static void draw_keys(random_source *r, input *i)
{
    float time = -2.0f;
    for (unsigned k = 0; k < 5; k++) {
        time += k % 2 ? random_unit(r) : 1.0f;
        i->keys[k].time = time;
        i->keys[k].position = random_vec3(r, -4.0f, 4.0f);
        i->keys[k].orientation = random_rotation(r);
    }
    for (unsigned k = 0; k < 4; k++)
        i->times[k] = i->keys[k].time;
}

static void draw_matrices(random_source *r, input *i)
{
    i->trs.translation = random_vec3(r, -100.0f, 100.0f);
    i->trs.rotation = i->q[3];
    i->trs.scale = random_vec3(r, -2.0f, 2.0f);
    i->r = nkw_mat3_from_quat(i->q[2]);
    nkw_mat3 linear = i->r;
    for (unsigned k = 0; k < 9; k++)
        linear.m[k] *= random_between(r, 0.9f, 1.1f);
    i->m = nkw_mat4_from_mat3(&linear, i->trs.translation);
    for (unsigned k = 0; k < 16; k++)
        i->n.m[k] = random_between(r, -3.0f, 3.0f);
}

static void draw(random_source *r, input *i)
{
    for (unsigned k = 0; k < 8; k++) {
        i->x[k] = random_finite(r);
        i->s[k] = random_scaled(r, -6, 3);
        i->cubic[k % 4] = i->s[k];
    }
    uint64_t bits = random_bits(r);
    i->t = bits % 16 == 0 ? 0.0f : bits % 16 == 1 ? 1.0f : random_unit(r);
    i->order = (nkw_euler_order)((bits >> 8) % 6);
    i->path = (nkw_path)((bits >> 16) % 3);
    i->unwrap = (nkw_unwrap)((bits >> 24) % 3);
    for (unsigned k = 0; k < 4; k++)
        i->v[k] = random_vec3(r, -4.0f, 4.0f);
    i->q[0] = random_rotation(r);
    for (unsigned k = 1; k < 4; k++)
        i->q[k] = some_rotation(r, i->q[0], (unsigned)(bits >> (32 + 4 * k)) % 8);
    draw_matrices(r, i);
    draw_keys(r, i);
}

static void put_weights(float *o, nkw_weights w)
{
    memcpy(o, &w, sizeof w);
}

/* A cubic of numbers, as the x of one of vectors. */
static nkw_vec3_cubic cubic_of(const float c[4])
{
    nkw_vec3_cubic r;
    memset(&r, 0, sizeof r);
    for (unsigned k = 0; k < 4; k++)
        r.c[k].x = c[k];
    return r;
}

static void put_cubic(float *o, const nkw_vec3_cubic *c)
{
    for (unsigned k = 0; k < 4; k++)
        o[k] = c->c[k].x;
}

static void put_point(float *o, nkw_motion p)
{
    memcpy(o, &p, sizeof p);
}

static nkw_motion point_of(const float s[3])
{
    nkw_motion p = {s[0], s[1], s[2]};
    return p;
}

static void put_trs(float *o, nkw_trs t)
{
    memcpy(o, &t, sizeof t);
}

static void put_axis_angle(float *o, nkw_axis_angle a)
{
    memcpy(o, &a, sizeof a);
}

static void put_swing_twist(float *o, nkw_swing_twist s)
{
    memcpy(o, &s, sizeof s);
}

static void filter_angles(float *o, const input *i)
{
    nkw_vec3 angles[4];
    nkw_euler_filter(i->v, 4, i->order, angles);
    put_vec3(o, angles[3]);
}

static nkw_rotation_segment rotation_of(const input *i, int kind)
{
    nkw_tcb tcb[2] = {{i->t, i->s[0], i->s[1]}, {i->s[2], i->s[3], i->t}};
    float duration = i->t + 0.25f;
    switch (kind) {
    case 0:
        return nkw_rotation_from_slerp(i->q[0], i->q[1], duration, i->path, (int32_t)i->s[0]);
    case 1:
        return nkw_rotation_from_hermite(i->q[0], i->v[0], i->q[1], i->v[1], duration);
    case 2:
        return nkw_rotation_from_catmull_rom(i->q, i->times);
    case 3:
        return nkw_rotation_from_tcb(i->q, i->times, tcb);
    case 4:
        return nkw_rotation_from_squad(i->q, duration);
    }
    return nkw_rotation_from_bspline(i->q, duration);
}

static void rotate_along(float *o, const input *i, int kind)
{
    nkw_rotation_segment s = rotation_of(i, kind);
    nkw_quat_motion at = nkw_rotation_evaluate(&s, i->t);
    memcpy(o, &at, sizeof at);
}

static void put_segment(float *o, nkw_segment s)
{
    o[0] = (float)s.index;
    o[1] = s.t;
}

/* Three keys of four floats, with tangents where the mode has them, from the quaternions at hand. */
static void sample_track(float *o, const input *i, nkw_track_kind kind, nkw_interpolation mode)
{
    float values[36];
    for (unsigned k = 0; k < 9; k++)
        memcpy(values + 4 * k, &i->q[k % 4], 4 * sizeof(float));
    nkw_track track = {i->times, values, 3, 4, kind, mode, NULL};
    nkw_track_sample(&track, i->s[0], NULL, o);
}

static void align_track(float *o, const input *i)
{
    float values[16];
    size_t negated;
    for (unsigned k = 0; k < 4; k++)
        memcpy(values + 4 * k, &i->q[k], 4 * sizeof(float));
    nkw_track track = {i->times, values, 4, 4, NKW_TRACK_ROTATION, NKW_INTERPOLATION_LINEAR, NULL};
    nkw_track_align(&track, values, &negated, NULL);
    memcpy(o, values + 8, 7 * sizeof(float));
    o[7] = (float)negated;
}

static float find_rate(float start, float rate)
{
    float times[32];
    for (size_t k = 0; k < 32; k++)
        times[k] = nkw_timeline_time((nkw_timeline){start, rate, 0}, k);
    return uniform_rate(times, 32);
}

/* Sums of a step. */
static void find_even(float *o, float start, float step, float time)
{
    float times[32];
    for (size_t k = 0; k < 32; k++, start += step)
        times[k] = start;
    o[2] = even_rate(times, 32);
    put_segment(o, nkwi_segment_find_even(times, 32, o[2], time));
}

static void resample_track(float *o, const input *i, nkw_interpolation mode)
{
    float values[36], times[3], made[12];
    NKW_STACK_WORK(work, NKW_TRACK_WORK(4));
    for (unsigned k = 0; k < 9; k++)
        memcpy(values + 4 * k, &i->q[k % 4], 4 * sizeof(float));
    nkw_track track = {i->times, values, 3, 4, NKW_TRACK_ROTATION, mode, NULL}, out;
    float rate = resample_within(&track, 2.0f, times, made, work, &out);
    o[0] = rate;
    o[1] = (float)resample_count(&track, 17.0f);
    o[2] = rate > 0.0f ? track_difference(&track, &out, work) : 0.0f;
    memcpy(o + 3, rate > 0.0f ? made + 4 * (out.count / 2) : values, 4 * sizeof(float));
}

/* Nine keys on an arc between arcs. */
static void reduce_track(float *o, const input *i, nkw_track_kind kind, nkw_interpolation mode, float tolerance)
{
    float values[108], times[9], new_times[9], made[108];
    const unsigned parts = mode == NKW_INTERPOLATION_CUBICSPLINE ? 3 : 1;
    for (unsigned k = 0; k < 9; k++) {
        const float t = (float)k / 8.0f;
        nkw_quat q = nkw_quat_slerp(i->q[0], nkw_quat_slerp(i->q[1], i->q[2], t), t);
        times[k] = nkw_lerp(i->times[0], i->times[3], t);
        for (unsigned part = 0; part < parts; part++)
            memcpy(values + 4 * (parts * k + part), &q, sizeof q);
    }
    const nkw_track track = {times, values, 9, 4, kind, mode, NULL};
    const nkw_track_span memory = {new_times, made, NULL, 9};
    nkw_track out;
    float difference;
    nkw_track_reduce(&track, tolerance, memory, &out, &difference);
    o[0] = (float)out.count;
    o[1] = difference;
    o[2] = out.count > 1 ? out.times[1] : 0.0f;
}

/* Two joints that turn, the second at a distance from the first. */
static void reduce_clip(float *o, const input *i)
{
    float values[2][36], times[9];
    const int32_t parents[2] = {-1, 0};
    const nkw_clip_reduction reduction = {parents, 0.25f, 1.0f, NULL, NULL, 0.0f};
    NKW_STACK_WORK(work, NKW_CLIP_REDUCE_WORK(2, 2, 0));
    double block[128];
    const nkw_bytes_span span = {block, sizeof block};
    nkw_clip_track tracks[2];
    for (unsigned n = 0; n < 2; n++) {
        const nkw_clip_track track = {
            NKW_CLIP_ROTATION, n, {times, values[n], 9, 4, NKW_TRACK_ROTATION, NKW_INTERPOLATION_LINEAR, NULL}};
        tracks[n] = track;
        for (unsigned k = 0; k < 9; k++) {
            const float t = (float)k / 8.0f;
            nkw_quat q = nkw_quat_slerp(i->q[n], nkw_quat_slerp(i->q[1 + n], i->q[2 + n], t), t);
            memcpy(values[n] + 4 * k, &q, sizeof q);
            times[k] = (float)k;
        }
    }
    const nkw_clip_source source = {tracks, 2, 2, 0, {NULL, 0}, NULL, NKW_CLIP_FLOAT32, NULL};
    nkw_clip_source_reduced reduced;
    nkw_clip_source_reduce(&source, &reduction, span, &reduced, NULL, work);
    o[0] = (float)reduced.reached.key_count;
    o[1] = reduced.reached.distance;
}

static void put_head(float *o, nkw_play_head head)
{
    o[0] = head.time;
    o[1] = head.cycle;
}

static size_t keys_passed(const float *times, size_t count, float duration, float from, float to)
{
    nkw_playback_step step = {times, count, duration, from, to, 0};
    size_t passed;
    nkw_playback_passed(&step, NULL, 0, &passed);
    return passed;
}

static void find_many(float *o, const input *i)
{
    nkw_segment found[8];
    nkw_segment_find_n(i->times, 4, i->s, found, 8);
    for (unsigned k = 0; k < 8; k++) {
        o[0] += (float)found[k].index;
        o[1] += found[k].t;
    }
}

/* steps() has no derivatives to keep. */
static void easing(float *o, nkw_easing_kind kind, const input *i)
{
    const nkw_easing e = {kind,
                          {nkw_abs(i->s[0]), i->s[1], nkw_abs(i->s[2]), i->s[3]},
                          (nkw_ease_jump)i->path,
                          kind == NKW_EASING_STEPS ? 1 + (size_t)i->order : 4,
                          i->times,
                          i->s};
    const float at = kind == NKW_EASING_CUBIC_BEZIER ? i->t : i->s[kind == NKW_EASING_STEPS ? 0 : 5];
    const nkw_motion p = nkw_easing_evaluate(&e, at);
    o[0] = p.value;
    if (kind != NKW_EASING_STEPS)
        put_point(o, p);
}

static void convert(float *o, nkw_cubic_kind kind, nkw_cubic_kind to, const float c[4])
{
    nkw_vec3_cubic from = cubic_of(c), converted = nkw_vec3_cubic_convert(&from, kind, to);
    put_cubic(o, &converted);
}

static void split(float *o, const float c[4], float t)
{
    nkw_vec3_cubic whole = cubic_of(c), left, right;
    nkw_vec3_bezier_split(&whole, t, &left, &right);
    put_cubic(o, &left);
    put_cubic(o + 4, &right);
}

/* A number of the input, 0..17. */
static unsigned some(const input *i)
{
    return (unsigned)i->order + 6 * (unsigned)i->path;
}

static void put_vec3_cubic(float *o, nkw_vec3_cubic c)
{
    memcpy(o, &c, sizeof c);
}

static nkw_vec3_cubic vec3_cubic(const input *i)
{
    nkw_vec3_cubic c = {{i->v[0], i->v[1], i->v[2], i->v[3]}};
    return c;
}

static void inner_control(float *o, const input *i)
{
    put_quat(o, nkw_rotation_from_squad(i->q, 1.0f).control[1]);
}

static void weigh(float *o, nkw_vec3_cubic c, nkw_weights weights)
{
    put_vec3(o, nkw_vec3_cubic_sum(&c, weights));
}

/* Keys at any times, of vectors and of numbers. */
static nkw_vec3 through(const input *i)
{
    const nkw_vec3_cubic c = nkw_vec3_cubic_from_catmull_rom(i->v, i->times);
    return nkw_vec3_hermite(c.c[0], c.c[1], c.c[2], c.c[3], i->t);
}

static nkw_motion timed(const input *i)
{
    float c[4];
    nkw_cubic_from_catmull_rom(i->s, i->times, c);
    return nkw_cubic_evaluate(c, i->t, NKW_CUBIC_HERMITE);
}

static void with_cubic(float *o, const input *i, nkw_cubic_kind kind, nkw_cubic_kind to)
{
    nkw_vec3_cubic from = vec3_cubic(i);
    put_vec3_cubic(o, nkw_vec3_cubic_convert(&from, kind, to));
}

static void split_right(float *o, const input *i)
{
    nkw_vec3_cubic whole = vec3_cubic(i), left, right;
    nkw_vec3_bezier_split(&whole, i->t, &left, &right);
    put_vec3_cubic(o, right);
    put_vec3(o + 12, left.c[2]);
}

/* Any of the 48 signed permutations. */
static nkw_axes_map some_axes(const input *i)
{
    nkw_axes_map turned = {NKW_AXIS_X, NKW_AXIS_Y, NKW_AXIS_Z};
    const nkw_axis x = turned.x, y = turned.y, z = turned.z;
    const nkw_axis named[6][3] = {{x, y, z}, {x, z, y}, {y, x, z}, {y, z, x}, {z, x, y}, {z, y, x}};
    const nkw_axis *n = named[i->order];
    turned.x = (nkw_axis)(i->s[0] < 0.0f ? -(int)n[0] : (int)n[0]);
    turned.y = (nkw_axis)(i->s[1] < 0.0f ? -(int)n[1] : (int)n[1]);
    turned.z = (nkw_axis)(i->s[2] < 0.0f ? -(int)n[2] : (int)n[2]);
    return turned;
}

static nkw_quat limited(const input *i)
{
    nkw_limit limit = {i->q[1], i->v[1], i->v[2], i->t, nkw_abs(i->s[0]), -nkw_abs(i->s[1]), nkw_abs(i->s[2])};
    return nkw_limit_apply(&limit, i->q[0]);
}

static void weights_of_four(float *o, const input *i, nkw_skin_format format)
{
    float weights[8];
    unsigned short whole[8] = {0};
    for (unsigned k = 0; k < 8; k++)
        weights[k] = nkw_abs(i->s[k]);
    nkw_skin_view in = {weights, 0, NKW_SKIN_F32};
    nkw_skin_span to_floats = {o, 0, format}, to_whole = {whole, 0, format};
    nkw_skin_normalize_weights(in, 4, 2, format == NKW_SKIN_F32 ? to_floats : to_whole);
    for (unsigned k = 0; k < 8 && format != NKW_SKIN_F32; k++)
        o[k] = (float)whole[k];
}

static void trace(float *o, const input *i, nkw_position_method position, nkw_orientation_method orientation)
{
    nkw_keyframe_options options = {position, orientation, NKW_KEYFRAME_RULE_LIBRARY};
    nkw_keyframe_trace t;
    if (nkw_keyframes_trace(i->keys, 5, i->s[0], &options, &t) != NKW_OK)
        return;
    memcpy(o, t.weight, sizeof t.weight);
    put_vec3(o + 4, t.control[1]);
    put_quat(o + 7, t.orientation[1]);
    put_vec3(o + 11, t.angles[0]);
    o[14] = t.half_angle;
    o[15] = t.orientation_weight[1];
}

static void sample(float *o, const input *i, nkw_position_method position, nkw_orientation_method orientation)
{
    nkw_mat4 m;
    if (nkw_keyframes_sample(i->keys, 5, i->s[0], position, orientation, &m) == NKW_OK)
        put_mat4(o, m);
}

#include "motion.h"
#include "rare.h"

#define K(name, count, results)                                                                                        \
    static void run_##name(const input *i, float *o)                                                                   \
    {                                                                                                                  \
        results;                                                                                                       \
    }
#include "kernels.h"
#undef K

typedef struct kernel {
    const char *name;
    unsigned count;
    void (*run)(const input *i, float *o);
} kernel;

static const kernel kernels[] = {
#define K(name, count, results) {#name, count, run_##name},
#include "kernels.h"
#undef K
};

#define KERNELS (sizeof kernels / sizeof kernels[0])

/* All functions take the same inputs, which are drawn once. */
static void hash_kernels(uint64_t hashes[KERNELS])
{
    random_source r = random_from(0x6e616b61);
    for (size_t k = 0; k < KERNELS; k++)
        hashes[k] = HASH_START;
    for (unsigned round = 0; round < ROUNDS; round++) {
        input i;
        draw(&r, &i);
        i.is_seldom = round % 16 == 0;
        for (size_t k = 0; k < KERNELS; k++) {
            float o[16] = {0};
            kernels[k].run(&i, o);
            hashes[k] = hash_floats(hashes[k], o, kernels[k].count);
        }
    }
}

/* One line of the table. */
typedef struct line {
    const char *name;
    uint64_t hash;
} line;

#define DATA_NAME(stem) {"data_" #stem, data_##stem},

static const struct {
    const char *name;
    uint64_t (*hash)(void);
} data[] = {DATA_LIST(DATA_NAME)};

#define LINES (KERNELS + sizeof data / sizeof data[0])

/* The values' functions first, then the data's. */
static void make_table(line table[LINES])
{
    uint64_t hashes[KERNELS];
    hash_kernels(hashes);
    for (size_t i = 0; i < LINES; i++) {
        table[i].name = i < KERNELS ? kernels[i].name : data[i - KERNELS].name;
        table[i].hash = i < KERNELS ? hashes[i] : data[i - KERNELS].hash();
    }
}

static int write_table(const line table[LINES])
{
    for (size_t i = 0; i < LINES; i++)
        printf("%-36s %016llx\n", table[i].name, (unsigned long long)table[i].hash);
    return 0;
}

static int compare_table(const line table[LINES], const char *path)
{
    FILE *file = fopen(path, "r");
    unsigned failed = 0;
    if (!file) {
        fprintf(stderr, "golden: cannot read %s\n", path);
        return 1;
    }
    for (size_t i = 0; i < LINES; i++) {
        char name[64] = "";
        unsigned long long want = 0, got = (unsigned long long)table[i].hash;
        int read = fscanf(file, "%63s %llx", name, &want);
        if (read != 2 || strcmp(name, table[i].name) != 0) {
            fprintf(stderr, "golden: %s has '%s' where '%s' should be\n", path, name, table[i].name);
            fclose(file);
            return 1;
        }
        if (got != want) {
            fprintf(stderr, "golden: %s: %016llx, not %016llx\n", name, got, want);
            failed++;
        }
    }
    char stale[64];
    if (fscanf(file, "%63s", stale) == 1) {
        fprintf(stderr, "golden: %s has '%s', which is no function here\n", path, stale);
        failed++;
    }
    fclose(file);
    printf("golden: %zu functions, %u differ\n", LINES, failed);
    return failed > 0;
}

#include "exceptions.h"

int main(int argc, char **argv)
{
    static line table[LINES];
    if (argc != 2) {
        fprintf(stderr, "usage: golden golden.txt | --write | --exceptions\n");
        return 2;
    }
    if (strcmp(argv[1], "--exceptions") == 0)
        return test_exceptions();
    make_table(table);
    return strcmp(argv[1], "--write") == 0 ? write_table(table) : compare_table(table, argv[1]);
}
