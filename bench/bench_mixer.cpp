/* SPDX-License-Identifier: MIT */
/*
 * Frames of a mixer, 1/60 s apart, beside the calls of which they consist, as programs without a mixer have them: play
 * heads, samples, blends. An element is a joint, so the time of a frame is 67 times that in the table.
 */
#include <algorithm>
#include <memory>

#include "bench.h"
#include "scene.h"

using namespace bench;

static const size_t joints = 67, voices = 4, marks = 8;
static const double step = 1.0 / 60, checked = 3.21;
static const float shares[2] = {0.7f, 0.3f}, strength = 0.5f;

/* What is played: a walk and a run, a gesture of the upper body over them, and an aim that is added. */
enum class playing { one, two, four, moving };

struct stage {
    playing what;
    std::shared_ptr<scene> source[voices];
    nkw_mixer_clip clips[voices];
    std::vector<float> rest, upper, reference, pose, other, memory, mark_times;
    nkw_mask_view masks[2];
    nkw_mixer_mark instants[marks];
    nkw_mixer_event events[2 * marks];
    size_t keys[2 * marks], passed;
    nkw_mixer_set set;
    nkw_mixer begun, mixer;
    nkw_mixer_frame frame;
    /* Of the calls: running times, and the root's motion. */
    nkw_playback_range range[voices];
    double time, cycle;
    nkw_root_rule rule;
    nkw_root_cycle ends;
    nkw_trs motion, moved;

    nkw_pose_span out(std::vector<float> &block) const
    {
        return {block.data(), joints};
    }
    nkw_pose_view in(const std::vector<float> &block) const
    {
        return {block.data(), joints};
    }
    nkw_work work()
    {
        return {memory.data(), memory.size() * sizeof(float)};
    }
};

static const size_t voice_count[] = {1, 2, 4, 1};

static void set_clips(stage &s)
{
    for (size_t i = 0; i < voices; i++) {
        s.source[i] = draw_scene(joints, 301 - 20 * i);
        const nkw_clip_description about = nkw_clip_describe(s.source[i]->clip(0));
        s.clips[i] = {};
        s.clips[i].clip = s.source[i]->clip(0);
        s.range[i] = {};
        s.range[i].duration = static_cast<double>(about.end);
        s.range[i].before = s.range[i].after = NKW_PLAYBACK_LOOP;
    }
    for (std::vector<float> *block : {&s.rest, &s.reference, &s.pose, &s.other})
        block->resize(NKW_POSE_FLOATS(joints));
    nkw_pose_identity(s.out(s.rest));
    nkw_clip_sample(s.clips[3].clip, 0, nullptr, s.out(s.reference), nullptr);
    s.clips[3].reference = s.in(s.reference);
    s.upper.assign(NKW_POSE_STRIDE(joints), 0);
    std::fill_n(s.upper.begin() + joints / 2, joints - joints / 2, 1.0f);
    s.masks[0] = {nullptr, joints};
    s.masks[1] = {s.upper.data(), joints};
    s.memory.resize(NKW_MIXER_WORK(voices, joints, 0) / sizeof(float));
    s.set = {};
    s.set.clips = s.clips, s.set.clip_count = voices;
    s.set.masks = s.masks, s.set.mask_count = 2;
    s.set.rest = s.in(s.rest);
    s.frame = {};
    s.frame.pose = s.out(s.pose);
}

/* The root moves in the plane and turns, and eight instants are passed in ten seconds. */
static void set_motion(stage &s)
{
    for (size_t i = 0; i < marks; i++) {
        s.instants[i] = {1.2f * static_cast<float>(i), 0};
        s.mark_times.push_back(s.instants[i].time);
    }
    s.clips[0].events = s.instants, s.clips[0].event_count = marks;
    s.rule = {{0, 1, 0}, NKW_ROOT_PLANE | NKW_ROOT_YAW};
    s.set.up = s.rule.up, s.set.root_parts = s.rule.parts;
    s.frame.events = s.events, s.frame.event_capacity = 2 * marks;
    const nkw_trs first = s.source[0]->joint_at(0, 0), last = s.source[0]->joint_at(0, s.source[0]->times.back());
    s.ends = {nkw_root_split(&s.rule, &first).motion, nkw_root_split(&s.rule, &last).motion};
}

static std::shared_ptr<stage> begin(playing what)
{
    auto s = std::make_shared<stage>();
    s->what = what;
    set_clips(*s);
    if (what == playing::moving)
        set_motion(*s);
    s->begun = {};
    for (size_t i = 0; i < voice_count[static_cast<int>(what)]; i++) {
        nkw_mixer_options o = {};
        o.clip = static_cast<uint32_t>(i);
        o.mode = NKW_PLAYBACK_LOOP;
        o.transition = NKW_MIXER_FADE_IN;
        o.layer = o.mask = i == 2;
        o.layer += 2 * (i == 3);
        o.blend = i == 3 ? NKW_MIXER_ADD : NKW_MIXER_BLEND;
        nkw_mixer_play(&s->begun, &s->set, &o, nullptr);
        if (i > 0 || what == playing::two || what == playing::four)
            s->begun.slot[i].weight = i < 2 ? shares[i] : i == 3 ? strength : 1;
    }
    return s;
}

/* The calls of a frame. */
static void sample(stage &s, size_t i, nkw_pose_span pose)
{
    const double time = nkw_playback_head_f64(&s.range[i], s.time).time;
    nkw_clip_sample(s.clips[i].clip, static_cast<float>(time), s.source[i]->cursors.data(), pose, nullptr);
}

static void move_root(stage &s, double before)
{
    const nkw_play_head_f64 head = nkw_playback_head_f64(&s.range[0], s.time);
    const nkw_trs root = nkw_pose_get(s.in(s.pose), 0);
    const nkw_root_motion parts = nkw_root_split(&s.rule, &root);
    nkw_pose_set(s.out(s.pose), 0, &parts.rest);
    s.moved = nkw_root_delta(&s.ends, &s.motion, &parts.motion, head.cycle - s.cycle);
    s.motion = parts.motion, s.cycle = head.cycle;
    const nkw_playback_step passing = {s.mark_times.data(), marks, s.range[0].duration, before, s.time, before < 0};
    nkw_playback_passed(&passing, s.keys, 2 * marks, &s.passed);
}

static void call(stage &s, double seconds)
{
    const nkw_pose_span pose = s.out(s.pose), other = s.out(s.other);
    const double before = s.time;
    s.time += seconds;
    sample(s, 0, pose);
    if (s.what == playing::moving)
        move_root(s, before);
    if (s.what == playing::one || s.what == playing::moving)
        return;
    sample(s, 1, other);
    nkw_pose_blend(s.in(s.pose), s.in(s.other), shares[1], s.masks[0], pose);
    if (s.what == playing::two)
        return;
    sample(s, 2, other);
    nkw_pose_blend(s.in(s.pose), s.in(s.other), 1, s.masks[1], pose);
    sample(s, 3, other);
    nkw_pose_additive_build(s.in(s.other), s.in(s.reference), NKW_ADDITIVE_LOCAL, other);
    nkw_pose_additive_apply(s.in(s.pose), s.in(s.other), strength, s.masks[0], NKW_ADDITIVE_LOCAL, pose);
}

static void call_first(stage &s)
{
    s.time = 0, s.cycle = 0, s.motion = s.ends.first;
    call(s, checked);
}

static void advance(stage &s, double seconds)
{
    nkw_mixer_advance(&s.mixer, &s.set, seconds, &s.frame, s.work());
}

static void advance_first(stage &s)
{
    s.mixer = s.begun;
    advance(s, checked);
}

template <class First, class Next>
static void row(const operation &op, const char *who, std::shared_ptr<stage> s, First first, Next next)
{
    auto check = [=](size_t) {
        first(*s);
        for (size_t j = 0; j < joints; j++)
            for (size_t c = 0; c < 10; c++)
                answer.part[c][j] = s->pose[c * NKW_POSE_STRIDE(joints) + j];
    };
    add(op, who, layout::components, joints, check, [=](benchmark::State &state) {
        first(*s);
        for (auto _ : state) {
            next(*s, step);
            benchmark::ClobberMemory();
        }
    });
}

/* The reference is the frame of the calls, whose functions other files and the accuracy programs measure. */
static void rows(const char *name, playing what, double samples, double blends)
{
    auto s = begin(what), exact = begin(what);
    call_first(*exact);
    auto truth = [=](size_t j, double *out) {
        for (size_t c = 0; c < 10; c++)
            out[c] = static_cast<double>(exact->pose[c * NKW_POSE_STRIDE(joints) + j]);
    };
    operation op = {"mixer", name, 10, 120 * (samples + blends), 125 * samples + 60 * blends, truth, 4, 4096,
                    same::transform};
    op.sizes = {joints};
    op.elements = joints;
    row(op, "nkw", s, advance_first, advance);
    row(op, "nkw calls", s, call_first, call);
}

static const suite all([] {
    rows("one clip", playing::one, 1, 0);
    rows("two clips", playing::two, 2, 1);
    rows("four clips, mask, additive", playing::four, 4, 4);
    rows("one clip, root, events", playing::moving, 1, 0);
});
