/* SPDX-License-Identifier: MIT */
/* The clips of the mannequin. Angles are radians; a rotation is that of the joint against its parent. */
#include "mannequin.h"

#include <nakawari/quat.h>
#include <nakawari/scalar.h>
#include <nakawari/vec.h>

static const float tau = 6.28318531f;

static nkw_quat about(char axis, float angle)
{
    const nkw_vec3 v = {axis == 'x', axis == 'y', axis == 'z'};
    return nkw_quat_from_axis_angle(v, angle);
}

/* ---- channels ---- */

static mannequin_channel *add_channel(mannequin_clip *c, int joint, mannequin_path path, nkw_interpolation mode)
{
    mannequin_channel *ch = &c->channels[c->channel_count++];
    ch->path = path;
    ch->joint = joint;
    ch->mode = mode;
    ch->key_count = 0;
    ch->width = path == PATH_ROTATION ? 4 : path == PATH_PUFF ? 1 : 3;
    return ch;
}

/* Values of CUBICSPLINE channels are spread to their places, and tangents set, by finish. */
static void add_key(mannequin_channel *ch, float time, const float *value)
{
    for (size_t i = 0; i < ch->width; i++)
        ch->values[ch->key_count * ch->width + i] = value[i];
    ch->times[ch->key_count++] = time;
}

static void add_rotation(mannequin_channel *ch, float time, nkw_quat q)
{
    const float value[4] = {q.x, q.y, q.z, q.w};
    add_key(ch, time, value);
}

static void add_vec3(mannequin_channel *ch, float time, nkw_vec3 v)
{
    const float value[3] = {v.x, v.y, v.z};
    add_key(ch, time, value);
}

/*
 * Tangents of Catmull and Rom: (next - previous) / (time between them); 0 at the ends. From the last key on, in place.
 */
static void finish(mannequin_channel *ch)
{
    float plain[CHANNEL_FLOATS];
    const size_t w = ch->width, n = ch->key_count;
    for (size_t i = 0; i < n * w; i++)
        plain[i] = ch->values[i];
    for (size_t k = 0; k < n; k++)
        for (size_t i = 0; i < w; i++) {
            float tangent = 0.0f;
            if (k > 0 && k + 1 < n)
                tangent = (plain[(k + 1) * w + i] - plain[(k - 1) * w + i]) / (ch->times[k + 1] - ch->times[k - 1]);
            float *key = ch->values + 3 * k * w + i;
            key[0] = tangent;
            key[w] = plain[k * w + i];
            key[2 * w] = tangent;
        }
}

/* ---- walk: one second, two steps ---- */

enum { STRIDE = 8 };

static void swing(mannequin_clip *c, int joint, nkw_quat rest, float mean, float amount, float phase)
{
    mannequin_channel *ch = add_channel(c, joint, PATH_ROTATION, NKW_INTERPOLATION_LINEAR);
    for (int k = 0; k <= STRIDE; k++) {
        float angle = mean + amount * nkw_sin(tau * ((float)(k % STRIDE) / STRIDE + phase));
        add_rotation(ch, (float)k / STRIDE, nkw_quat_mul(about('x', angle), rest));
    }
}

static void walk(mannequin_clip *c)
{
    const nkw_quat none = nkw_quat_identity(), down_l = about('z', -1.3f), down_r = about('z', 1.3f);
    c->name = "walk";
    c->channel_count = 0;
    mannequin_channel *hips = add_channel(c, HIPS, PATH_TRANSLATION, NKW_INTERPOLATION_LINEAR);
    for (int k = 0; k <= STRIDE; k++) {
        nkw_vec3 at = mannequin_bones[HIPS].translation;
        at.y += 0.02f * nkw_cos(2.0f * tau * (float)(k % STRIDE) / STRIDE) - 0.03f;
        add_vec3(hips, (float)k / STRIDE, at);
    }
    swing(c, THIGH_L, none, -0.1f, 0.55f, 0.0f);
    swing(c, THIGH_R, none, -0.1f, 0.55f, 0.5f);
    swing(c, SHIN_L, none, 0.5f, 0.45f, 0.72f);
    swing(c, SHIN_R, none, 0.5f, 0.45f, 0.22f);
    swing(c, FOOT_L, none, -0.1f, 0.2f, 0.9f);
    swing(c, FOOT_R, none, -0.1f, 0.2f, 0.4f);
    swing(c, ARM_L, down_l, 0.0f, 0.5f, 0.5f);
    swing(c, ARM_R, down_r, 0.0f, 0.5f, 0.0f);
    mannequin_channel *spine = add_channel(c, SPINE, PATH_ROTATION, NKW_INTERPOLATION_LINEAR);
    for (int k = 0; k <= STRIDE; k++)
        add_rotation(spine, (float)k / STRIDE, about('y', 0.12f * nkw_sin(tau * (float)(k % STRIDE) / STRIDE)));
}

/* ---- wave: two seconds, the right arm up ---- */

static void wave(mannequin_clip *c)
{
    static const float times[6] = {0, 0.4f, 0.8f, 1.2f, 1.6f, 2};
    static const float arm[6] = {1.3f, -0.5f, -0.6f, -0.5f, -0.6f, 1.3f},
                       fore[6] = {0.1f, -1.0f, -0.3f, -1.0f, -0.3f, 0.1f}, tilt[6] = {0, 0.1f, 0.12f, 0.1f, 0.12f, 0};
    c->name = "wave";
    c->channel_count = 0;
    mannequin_channel *left = add_channel(c, ARM_L, PATH_ROTATION, NKW_INTERPOLATION_STEP);
    add_rotation(left, 0.0f, about('z', -1.3f));
    mannequin_channel *a = add_channel(c, ARM_R, PATH_ROTATION, NKW_INTERPOLATION_CUBICSPLINE);
    mannequin_channel *f = add_channel(c, FOREARM_R, PATH_ROTATION, NKW_INTERPOLATION_CUBICSPLINE);
    mannequin_channel *s = add_channel(c, SPINE, PATH_ROTATION, NKW_INTERPOLATION_CUBICSPLINE);
    for (int k = 0; k < 6; k++) {
        add_rotation(a, times[k], about('z', arm[k]));
        add_rotation(f, times[k], about('z', fore[k]));
        add_rotation(s, times[k], about('z', tilt[k]));
    }
    finish(a);
    finish(f);
    finish(s);
}

/* ---- hop: 1.6 seconds; all modes and all paths ---- */

static void hop(mannequin_clip *c)
{
    static const float times[5] = {0, 0.4f, 0.8f, 1.2f, 1.6f}, heights[5] = {0, -0.16f, 0.3f, -0.16f, 0},
                       bends[5] = {0, 0.65f, 0.1f, 0.65f, 0}, puffs[5] = {0, 1, 0.3f, 1, 0},
                       looks[5] = {0, 0.6f, 0, -0.6f, 0};
    const nkw_vec3 one = {1, 1, 1}, flat = {1.06f, 0.92f, 1.06f};
    c->name = "hop";
    c->channel_count = 0;
    mannequin_channel *hips = add_channel(c, HIPS, PATH_TRANSLATION, NKW_INTERPOLATION_CUBICSPLINE);
    mannequin_channel *head = add_channel(c, HEAD, PATH_SCALE, NKW_INTERPOLATION_LINEAR);
    mannequin_channel *look = add_channel(c, HEAD, PATH_ROTATION, NKW_INTERPOLATION_STEP);
    mannequin_channel *puff = add_channel(c, HEAD, PATH_PUFF, NKW_INTERPOLATION_LINEAR);
    static const int legs[6] = {THIGH_L, THIGH_R, SHIN_L, SHIN_R, FOOT_L, FOOT_R};
    for (int k = 0; k < 5; k++) {
        add_vec3(hips, times[k],
                 nkw_vec3_add_scaled(mannequin_bones[HIPS].translation, (nkw_vec3){0, 1, 0}, heights[k]));
        add_vec3(head, times[k], k % 2 ? flat : one);
        add_rotation(look, times[k], about('y', looks[k]));
        add_key(puff, times[k], &puffs[k]);
    }
    for (int l = 0; l < 6; l++) {
        mannequin_channel *ch = add_channel(c, legs[l], PATH_ROTATION, NKW_INTERPOLATION_LINEAR);
        for (int k = 0; k < 5; k++)
            add_rotation(ch, times[k], about('x', (l < 2 ? -1.0f : l < 4 ? 2.0f : -1.0f) * bends[k]));
    }
    for (int side = 0; side < 2; side++) {
        mannequin_channel *ch = add_channel(c, side ? ARM_R : ARM_L, PATH_ROTATION, NKW_INTERPOLATION_LINEAR);
        for (int k = 0; k < 5; k++)
            add_rotation(ch, times[k], about('z', (side ? 1.0f : -1.0f) * (1.3f - (k == 2 ? 1.5f : 0.0f))));
    }
    finish(hips);
}

void mannequin_clips(mannequin_clip clips[MANNEQUIN_CLIPS])
{
    walk(&clips[0]);
    wave(&clips[1]);
    hop(&clips[2]);
}
