/* SPDX-License-Identifier: MIT */
/* The motion kit: springs, transitions, play heads, timecode. Total on any floats; unit rotations of finite ones. */
#include "fuzz.h"

static nkw_state draw_motion(fuzz *f)
{
    nkw_state m = {fuzz_float(f), fuzz_float(f)};
    return m;
}

static nkw_vec3 draw_vec3(fuzz *f)
{
    nkw_vec3 v = {fuzz_float(f), fuzz_float(f), fuzz_float(f)};
    return v;
}

static nkw_quat draw_quat(fuzz *f)
{
    nkw_quat q = {fuzz_float(f), fuzz_float(f), fuzz_float(f), fuzz_float(f)};
    return fuzz_byte(f) % 2 ? nkw_quat_normalize(q) : q;
}

static nkw_quat_state draw_rotation(fuzz *f)
{
    nkw_quat_state m = {draw_quat(f), draw_vec3(f)};
    return m;
}

static void check_unit(nkw_quat q, int is_finite)
{
    float length = nkw_quat_length(q);
    FUZZ_CHECK((length > 0.99f && length < 1.01f) || !is_finite);
}

static int finite_rotation(const nkw_quat_state *m)
{
    float length = nkw_quat_length(m->value);
    return length > 1e-15f && length < 1e15f && fuzz_finite(&m->velocity.x, 3);
}

static int same_motion(nkw_state a, nkw_state b)
{
    return fuzz_same(&a.value, &b.value, 1) && fuzz_same(&a.velocity, &b.velocity, 1);
}

static void springs(fuzz *f)
{
    nkw_spring s = {fuzz_float(f), fuzz_float(f)};
    float a = fuzz_float(f), b = fuzz_float(f), h = fuzz_float(f);
    if (fuzz_byte(f) % 2)
        s = fuzz_byte(f) % 2 ? nkw_spring_from_half_life(a, b) : nkw_spring_from_frequency(a, b);
    nkw_spring_description d = nkw_spring_describe(s);
    FUZZ_CHECK(!(d.frequency < 0.0f) && !(d.damping_ratio < 0.0f) && !(d.half_life < 0.0f));
    nkw_state from = draw_motion(f), goal = draw_motion(f);
    nkw_state to = nkw_spring_step(s, from, goal, h);
    FUZZ_CHECK(h > 0.0f || h != h || same_motion(from, to));
    nkw_quat_state q = draw_rotation(f), g = draw_rotation(f), r = nkw_quat_spring_step(s, &q, &g, h);
    int known = fuzz_finite(&s.stiffness, 1) && fuzz_finite(&s.damping, 1) && fuzz_finite(&h, 1);
    check_unit(r.value, known && h > 0.0f && finite_rotation(&q) && finite_rotation(&g));
    nkw_spring_timed timed = {s, b, from, from};
    nkw_quat_spring_timed turning = {s, b, q, g};
    nkw_spring_timed_step(&timed, a, h);
    nkw_quat_spring_timed_step(&turning, draw_quat(f), h);
    FUZZ_CHECK(timed.time_left >= 0.0f || h <= 0.0f);
    FUZZ_CHECK(fuzz_same(&timed.time_left, &turning.time_left, 1));
    nkw_damper_step(a, b, from.value, h);
    nkw_quat_damper_step(q.value, g.value, a, h);
}

static void transitions(fuzz *f)
{
    float duration = fuzz_float(f), t = fuzz_float(f);
    nkw_state from = draw_motion(f), to = draw_motion(f);
    nkw_offset x = {.kind = (nkw_offset_kind)fuzz_choice(f, 2), .duration = duration, .half_life = fuzz_float(f)};
    nkw_offset_begin(&x, from, to);
    FUZZ_CHECK(x.end >= 0.0f || x.end != x.end);
    FUZZ_CHECK(x.end <= duration || x.end == 0.0f || duration != duration);
    FUZZ_CHECK(t < x.end || t != t || x.end != x.end || same_motion(nkw_offset_evaluate(&x, to, t), to) || t <= 0.0f);
    nkw_quat_state q = draw_rotation(f), g = draw_rotation(f);
    nkw_quat_offset y = {.duration = duration};
    nkw_quat_offset_begin(&y, &q, &g);
    nkw_quat_state r = nkw_quat_offset_evaluate(&y, &g, t);
    nkw_quat_offset d = {.kind = NKW_OFFSET_DEAD_BLEND, .duration = duration, .half_life = fuzz_float(f)};
    nkw_quat_offset_begin(&d, &q, &g);
    d.difference = draw_quat(f);
    nkw_quat_state blended = nkw_quat_offset_evaluate(&d, &g, t);
    float length = nkw_quat_length(g.value);
    int known = finite_rotation(&q) && finite_rotation(&g) && length > 0.999f && length < 1.001f;
    check_unit(r.value, known);
    check_unit(blended.value,
               known && fuzz_finite(&d.half_life, 1) && fuzz_finite(&d.difference.x, 4) && fuzz_finite(&t, 1));
    nkw_vec3_state u = {draw_vec3(f), draw_vec3(f)}, v = {draw_vec3(f), draw_vec3(f)};
    nkw_vec3_offset z = {.kind = x.kind, .duration = duration, .half_life = fuzz_float(f)};
    nkw_vec3_offset_begin(&z, &u, &v);
    nkw_vec3_offset_evaluate(&z, &v, t);
}

static double draw_double(fuzz *f)
{
    union {
        uint64_t bits;
        double value;
    } any = {(uint64_t)fuzz_bits(f) << 32 | fuzz_bits(f)};
    return fuzz_byte(f) % 4 ? (double)fuzz_float(f) : any.value;
}

static void heads(fuzz *f)
{
    nkw_playback_range range = {draw_double(f),
                                draw_double(f),
                                draw_double(f),
                                (nkw_playback)fuzz_choice(f, 2),
                                (nkw_playback)fuzz_choice(f, 2),
                                draw_double(f),
                                draw_double(f)};
    nkw_play_head_f64 head = nkw_playback_head_f64(&range, draw_double(f));
    double end = range.start + range.duration;
    FUZZ_CHECK(!(head.time < range.start) && (!(head.time > end) || !(range.duration > 0.0)));
    FUZZ_CHECK(head.closing >= 0.0 && head.closing <= 1.0);
    nkw_quat q = draw_quat(f), r = nkw_quat_playback_offset(q, draw_quat(f), draw_quat(f), head.cycle);
    (void)r;
    nkw_playback_offset(fuzz_float(f), fuzz_float(f), fuzz_float(f), head.cycle);
    const float *times = fuzz_floats(f, 8, 1);
    nkw_playback_step step = {times, fuzz_upto(f, 8), draw_double(f), draw_double(f), draw_double(f),
                              fuzz_byte(f) % 2};
    size_t capacity = fuzz_upto(f, 20), *out = fuzz_block(f, capacity * sizeof *out), passed;
    nkw_playback_passed(&step, out, capacity, &passed);
    for (size_t i = 0; i < passed && i < capacity; i++)
        FUZZ_CHECK(out[i] < step.key_count);
}

static int64_t draw_count(fuzz *f)
{
    uint64_t bits = (uint64_t)fuzz_bits(f) << 32 | fuzz_bits(f);
    return (int64_t)(bits >> fuzz_byte(f) % 64);
}

static void counts(fuzz *f)
{
    nkw_rate a = {draw_count(f), draw_count(f)}, b = {draw_count(f), fuzz_byte(f)};
    nkw_round round = (nkw_round)fuzz_choice(f, 2);
    int64_t count = draw_count(f), out, back;
    if (fuzz_byte(f) % 2)
        a.denominator &= 0x3fffff, a.numerator &= 0xffffffffff, b.numerator &= 0xffffffffff;
    if (nkw_ticks_convert(count, a, b, NKW_ROUND_DOWN, &out) == NKW_OK &&
        nkw_ticks_convert(count, a, b, NKW_ROUND_UP, &back) == NKW_OK)
        FUZZ_CHECK(back == out || back == out + 1);
    double seconds;
    nkw_result result = nkw_ticks_to_seconds(count, a, &seconds);
    if (count > -(INT64_C(1) << 51) && count < INT64_C(1) << 51 && result == NKW_OK)
        FUZZ_CHECK(nkw_ticks_from_seconds(seconds, a, NKW_ROUND_NEAREST, &back) == NKW_OK && back == count);
    nkw_ticks_from_seconds(draw_double(f), b, round, &out);
    nkw_timecode t;
    int32_t rate = (int32_t)fuzz_bits(f) >> fuzz_byte(f) % 32;
    int drop = fuzz_byte(f) % 2;
    if (nkw_timecode_from_frame(count, rate, drop, &t) == NKW_OK)
        FUZZ_CHECK(nkw_timecode_to_frame(t, rate, drop, &back) == NKW_OK && back == count);
    nkw_timecode any = {(int32_t)fuzz_bits(f), fuzz_byte(f) % 70, fuzz_byte(f) % 70, (int32_t)fuzz_byte(f)};
    nkw_timecode_to_frame(any, rate, drop, &out);
}

static nkw_trs draw_place(fuzz *f)
{
    nkw_trs t = {draw_vec3(f), draw_quat(f), draw_vec3(f)};
    return t;
}

static void roots(fuzz *f)
{
    nkw_trs a = draw_place(f), b = draw_place(f);
    nkw_root_rule rule = {draw_vec3(f), fuzz_byte(f)};
    nkw_root_cycle cycle = {draw_place(f), draw_place(f)};
    nkw_trs motion = nkw_root_split(&rule, &a).motion;
    FUZZ_CHECK(motion.scale.x == 1.0f && motion.scale.y == 1.0f && motion.scale.z == 1.0f);
    nkw_root_delta(&cycle, &a, &b, draw_double(f));
    nkw_root_place(&cycle, &a, &b, draw_double(f));
    size_t count = fuzz_upto(f, 6);
    const float *weights = fuzz_floats(f, count, 1);
    nkw_trs *motions = fuzz_block(f, count * sizeof *motions);
    nkw_vec3 *translations = fuzz_block(f, count * sizeof *translations);
    nkw_quat *rotations = fuzz_block(f, count * sizeof *rotations);
    for (size_t i = 0; i < count; i++) {
        translations[i] = draw_vec3(f);
        rotations[i] = draw_quat(f);
    }
    nkw_root_split_keys(&rule, fuzz_byte(f) % 4 ? translations : NULL, fuzz_byte(f) % 4 ? rotations : NULL, motions,
                        count);
    nkw_root_blend(motions, weights, count);
}

static void poses(fuzz *f)
{
    size_t joints = fuzz_upto(f, 20);
    nkw_pose_view a = {fuzz_pose(f, joints, 1), joints}, b = {fuzz_pose(f, joints, 1), joints};
    nkw_pose_velocity_span v = {fuzz_room(f, NKW_POSE_VELOCITY_FLOATS(joints)), joints};
    nkw_pose_span out = {fuzz_room(f, NKW_POSE_FLOATS(joints)), joints};
    nkw_pose_inertia inertia = {fuzz_room(f, NKW_POSE_INERTIA_FLOATS(joints)), joints};
    nkw_pose_dead_blend dead = {fuzz_room(f, NKW_POSE_DEAD_BLEND_FLOATS(joints)), joints, fuzz_float(f), fuzz_float(f)};
    FUZZ_CHECK(nkw_pose_velocity_from_poses(a, b, fuzz_float(f), v) == NKW_OK);
    nkw_pose_state from = {a, NKW_VIEW(nkw_pose_velocity, v)}, to = {b, {NULL, 0}};
    float duration = fuzz_float(f), t = fuzz_float(f);
    FUZZ_CHECK(nkw_pose_inertia_begin(inertia, &from, &to, duration) == NKW_OK);
    FUZZ_CHECK(nkw_pose_inertia_evaluate(inertia, b, t, out) == NKW_OK);
    for (size_t j = 0; j < joints && t >= duration; j++) {
        nkw_trs got = nkw_pose_get(NKW_VIEW(nkw_pose, out), j), want = nkw_pose_get(b, j);
        FUZZ_CHECK(fuzz_same(&got.translation.x, &want.translation.x, 10));
    }
    FUZZ_CHECK(nkw_pose_dead_blend_begin(&dead, &from) == NKW_OK);
    FUZZ_CHECK(nkw_pose_dead_blend_evaluate(&dead, b, t, out) == NKW_OK);
    FUZZ_CHECK(nkw_pose_inertia_evaluate(inertia, a, t, out) == NKW_OK);
    nkw_body_motion p = {{draw_vec3(f), draw_vec3(f)}, draw_rotation(f)},
                    q = {{draw_vec3(f), draw_vec3(f)}, draw_rotation(f)};
    nkw_body_motion_between(&p, &q, duration, t);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    fuzz f = fuzz_begin(data, size);
    springs(&f);
    transitions(&f);
    heads(&f);
    counts(&f);
    roots(&f);
    poses(&f);
    return fuzz_end(&f);
}
