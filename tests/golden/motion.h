/* SPDX-License-Identifier: MIT */
/* Results of the motion kit for kernels.h; included where `input` is known. */
static nkw_spring some_spring(const input *i)
{
    return nkw_spring_from_frequency(4.0f * i->t + 0.125f, nkw_abs(i->s[5]));
}

static nkw_state motion_at(const input *i, unsigned k)
{
    nkw_state m = {i->s[k], i->s[k + 1]};
    return m;
}

static nkw_vec3_state vec3_motion_at(const input *i, unsigned k)
{
    nkw_vec3_state m = {i->v[k], i->v[k + 1]};
    return m;
}

static nkw_quat_state quat_motion_at(const input *i, unsigned k)
{
    nkw_quat_state m = {i->q[k], i->v[k]};
    return m;
}

static void put_motion(float *o, nkw_state m)
{
    o[0] = m.value;
    o[1] = m.velocity;
}

static void put_motion_quat(float *o, nkw_quat_state m)
{
    put_quat(o, m.value);
    put_vec3(o + 4, m.velocity);
}

static void spring_constants(float *o, float half_life, float ratio)
{
    nkw_spring a = nkw_spring_from_half_life(half_life, ratio), b = nkw_spring_from_frequency(half_life, ratio);
    o[0] = a.stiffness;
    o[1] = a.damping;
    o[2] = b.stiffness;
    o[3] = b.damping;
    nkw_spring_description d = nkw_spring_describe(a);
    o[4] = d.frequency;
    o[5] = d.damping_ratio;
    o[6] = d.half_life;
}

static nkw_quat_state quat_spring(const input *i)
{
    nkw_quat_state from = quat_motion_at(i, 0), goal = quat_motion_at(i, 1);
    return nkw_quat_spring_step(some_spring(i), &from, &goal, i->t);
}

static void spring_timed(float *o, const input *i)
{
    nkw_spring_timed timed = {some_spring(i), nkw_abs(i->s[4]), motion_at(i, 0), motion_at(i, 2)};
    nkw_spring_timed_step(&timed, i->s[6], i->t);
    put_motion(o, timed.state);
    put_motion(o + 2, timed.point);
    o[4] = timed.time_left;
}

static void quat_spring_timed(float *o, const input *i)
{
    nkw_quat_spring_timed timed = {some_spring(i), nkw_abs(i->s[4]), quat_motion_at(i, 0), quat_motion_at(i, 1)};
    nkw_quat_spring_timed_step(&timed, i->q[3], i->t);
    put_motion_quat(o, timed.state);
    put_motion_quat(o + 7, timed.point);
}

static void dampers(float *o, const input *i)
{
    o[0] = nkw_damper_step(i->s[0], i->s[1], nkw_abs(i->s[2]), i->t);
    put_quat(o + 1, nkw_quat_damper_step(i->q[0], i->q[1], nkw_abs(i->s[2]), i->t));
}

static nkw_offset offset_of(nkw_offset_kind kind, float duration, float half_life)
{
    nkw_offset o = {kind, duration, half_life, 0.0f, {0.0f, 0.0f}, {0.0f, 0.0f, 0.0f}};
    return o;
}

static nkw_quat_offset quat_offset_of(nkw_offset_kind kind, float duration, float half_life)
{
    nkw_quat_offset o;
    memset(&o, 0, sizeof o);
    o.kind = kind;
    o.duration = duration;
    o.half_life = half_life;
    return o;
}

static void offset(float *o, const input *i)
{
    nkw_offset x = offset_of(NKW_OFFSET_INERTIA, nkw_abs(i->s[4]), 0.0f);
    nkw_offset_begin(&x, motion_at(i, 0), motion_at(i, 2));
    for (int k = 0; k < 3; k++)
        o[k] = x.c[k];
    o[3] = x.end;
    put_motion(o + 4, nkw_offset_evaluate(&x, motion_at(i, 2), i->t));
}

static void vec3_offset(float *o, const input *i)
{
    nkw_vec3_state from = vec3_motion_at(i, 0), to = vec3_motion_at(i, 2);
    nkw_vec3_offset x;
    memset(&x, 0, sizeof x);
    x.duration = nkw_abs(i->s[4]);
    nkw_vec3_offset_begin(&x, &from, &to);
    nkw_vec3_state m = nkw_vec3_offset_evaluate(&x, &to, i->t);
    for (int k = 0; k < 3; k++)
        put_vec3(o + 3 * k, x.c[k]);
    o[9] = x.end;
    put_vec3(o + 10, m.value);
    put_vec3(o + 13, m.velocity);
}

static void quat_offset(float *o, const input *i)
{
    nkw_quat_state from = quat_motion_at(i, 0), to = quat_motion_at(i, 1);
    nkw_quat_offset x = quat_offset_of(NKW_OFFSET_INERTIA, nkw_abs(i->s[4]), 0.0f);
    nkw_quat_offset_begin(&x, &from, &to);
    for (int k = 0; k < 3; k++)
        put_vec3(o + 3 * k, x.c[k]);
    put_motion_quat(o + 9, nkw_quat_offset_evaluate(&x, &to, i->t));
}

/* And the half-life of spring.md. */
static void offset_dead(float *o, const input *i)
{
    nkw_offset d = offset_of(NKW_OFFSET_DEAD_BLEND, nkw_abs(i->s[5]), nkw_abs(i->s[4]));
    nkw_offset_begin(&d, motion_at(i, 0), motion_at(i, 2));
    put_motion(o, nkw_offset_evaluate(&d, motion_at(i, 2), i->t));
    float v = i->s[1];
    o[2] = v != 0.0f ? nkw_clamp(0.5f * ((i->s[2] - i->s[0]) / v), 0.125f, 2.0f) : 2.0f;
}

static void quat_offset_dead(float *o, const input *i)
{
    nkw_quat_offset d = quat_offset_of(NKW_OFFSET_DEAD_BLEND, nkw_abs(i->s[5]), nkw_abs(i->s[4]));
    nkw_quat_state from = quat_motion_at(i, 0), to = quat_motion_at(i, 1);
    nkw_quat_offset_begin(&d, &from, &to);
    d.difference = i->q[3];
    put_motion_quat(o, nkw_quat_offset_evaluate(&d, &to, i->t));
    put_quat(o + 7, d.difference);
}

static void put_f64(float *o, double x)
{
    o[0] = (float)x;
    o[1] = (float)((x - (double)o[0]) * 0x1p24);
}

static void head_f64(float *o, const input *i)
{
    nkw_playback_range range = {
        i->s[0], (double)i->t + 0.1, 0.3 * (double)nkw_abs(i->s[1]), NKW_PLAYBACK_LOOP, NKW_PLAYBACK_PING_PONG, 0.0,
        50.0};
    nkw_play_head_f64 head = nkw_playback_head_f64(&range, 1e3 * (double)i->s[2]);
    put_f64(o, head.time);
    put_f64(o + 2, head.cycle);
    put_f64(o + 4, head.closing);
}

static void passed_far(float *o, const input *i)
{
    nkw_playback_step step = {i->times, 4, 4.7, 1e6 * (double)i->s[0],
                                  1e6 * (double)i->s[0] + 9.0 * (double)i->s[1], 0};
    size_t keys[1] = {0}, passed;
    nkw_playback_passed(&step, keys, 1, &passed);
    o[0] = (float)passed;
    o[1] = (float)keys[0];
}

static void timecode(float *o, const input *i)
{
    const nkw_rate ntsc = {30000, 1001}, fbx = {NKW_RATE_FBX, 1};
    const nkw_round round = i->s[1] > 0.0f ? NKW_ROUND_DOWN : NKW_ROUND_UP;
    int64_t ticks, frames, frame;
    nkw_timecode label;
    nkw_ticks_from_seconds(1e4 * (double)i->s[0], fbx, round, &ticks);
    nkw_ticks_convert(ticks, fbx, ntsc, round, &frames);
    put_f64(o, (double)ticks);
    o[2] = (float)frames;
    double seconds;
    nkw_ticks_to_seconds(frames, ntsc, &seconds);
    put_f64(o + 3, seconds);
    nkw_timecode_from_frame(frames < 0 ? -frames : frames, 30, 1, &label);
    nkw_timecode_to_frame(label, 30, 1, &frame);
    o[5] = (float)label.minutes;
    o[6] = (float)label.seconds;
    o[7] = (float)label.frames;
    o[8] = (float)frame;
}

static nkw_trs place_at(const input *i, unsigned k)
{
    nkw_trs t = {i->v[k], i->q[k], {1.0f, 1.0f, 1.0f}};
    return t;
}

static void put_place(float *o, nkw_trs t)
{
    put_vec3(o, t.translation);
    put_quat(o + 3, t.rotation);
}

static void root_split(float *o, const input *i)
{
    const nkw_root_rule rule = {i->v[3], NKW_ROOT_PLANE | NKW_ROOT_YAW};
    nkw_trs root = place_at(i, 0);
    nkw_root_motion parts = nkw_root_split(&rule, &root);
    put_place(o, parts.motion);
    put_place(o + 7, parts.rest);
}

static nkw_trs root_delta(const input *i)
{
    nkw_root_cycle cycle = {place_at(i, 0), place_at(i, 1)};
    nkw_trs from = place_at(i, 2), to = place_at(i, 3);
    return nkw_root_delta(&cycle, &from, &to, (double)(int)(100.0f * i->t));
}

static nkw_trs root_place(const input *i)
{
    nkw_root_cycle cycle = {place_at(i, 0), place_at(i, 1)};
    nkw_trs origin = place_at(i, 2), now = place_at(i, 3);
    return nkw_root_place(&cycle, &origin, &now, -(double)(int)(1000.0f * i->t));
}

static nkw_trs root_blend(const input *i)
{
    const nkw_trs motions[3] = {place_at(i, 0), place_at(i, 1), place_at(i, 2)};
    return nkw_root_blend(motions, i->s, 3);
}

static void body_between(float *o, const input *i)
{
    nkw_body_motion a = {vec3_motion_at(i, 0), quat_motion_at(i, 0)}, b = {vec3_motion_at(i, 2), quat_motion_at(i, 1)};
    nkw_body_motion m = nkw_body_motion_between(&a, &b, nkw_abs(i->s[0]), i->t);
    put_vec3(o, m.position.value);
    put_vec3(o + 3, m.position.velocity);
    put_motion_quat(o + 6, m.rotation);
}
