/* SPDX-License-Identifier: MIT */
/* The mixer: weights of cross-fades that interrupt each other, and the phases of clips in step. */
#include "figure.h"

#include <string.h>

#include <nakawari/mixer.h>

enum { IDLE, WALK, RUN, CLIPS, FRAMES = 480 };

static const svg_colour colours[CLIPS] = {FIGURE_GREY, FIGURE_CATMULL_ROM, FIGURE_HERMITE};
static const float lengths[CLIPS] = {1.0f, 1.0f, 0.5f}, seconds = 3.0f;

/* What a frame has: weights and phases of the clips; 0 where a clip does not play. */
typedef struct state {
    float weight[CLIPS], phase[CLIPS];
    int plays[CLIPS];
} state;

static float blocks[CLIPS][256];

/* Clips of one joint that is turned, of three lengths. */
static int build(nkw_mixer_clip *clips)
{
    const float turns[8] = {0.0f, 0.0f, 0.0f, 1.0f, 0.0f, 0.6f, 0.0f, 0.8f};
    NKW_STACK_WORK(work, NKW_CLIP_BUILD_WORK(1));
    for (int i = 0; i < CLIPS; i++) {
        const float times[2] = {0.0f, lengths[i]};
        const nkw_clip_track track = {
            NKW_CLIP_ROTATION,
            0,
            {.times = times, .values = turns, .count = 2, .width = 4, .kind = NKW_TRACK_ROTATION}};
        const nkw_clip_source source = {.tracks = &track, .track_count = 1, .joint_count = 1};
        const nkw_bytes_span block = {blocks[i], sizeof blocks[i]};
        size_t bytes;
        if (nkw_clip_build(&source, block, &bytes, NULL, work) != NKW_OK)
            return 0;
        clips[i].clip = (const nkw_clip *)(const void *)blocks[i];
    }
    return 1;
}

static void look(const nkw_mixer *m, state *out)
{
    memset(out, 0, sizeof *out);
    for (size_t i = 0; i < NKW_MIXER_SLOTS; i++) {
        const nkw_mixer_slot *s = &m->slot[i];
        if (!s->playing)
            continue;
        const double cycles = s->time / (double)lengths[s->clip];
        const double u = s->fade.elapsed < s->fade.duration ? s->fade.elapsed / s->fade.duration : 1.0;
        out->weight[s->clip] = (float)((double)s->fade.from + (double)(s->fade.to - s->fade.from) * u);
        out->phase[s->clip] = (float)(cycles - (double)(long)cycles);
        out->plays[s->clip] = 1;
    }
}

/* Idle; a walk from 0.5 s on, by a fade of 1 s; a run from 1.1 s on, by a fade of 1.2 s, in step with the walk. */
static int record(state *states)
{
    nkw_mixer_clip clips[CLIPS];
    float rest[NKW_POSE_FLOATS(1)], pose[NKW_POSE_FLOATS(1)];
    const nkw_pose_span rest_span = {rest, 1};
    const nkw_mixer_set set = {.clips = clips, .clip_count = CLIPS, .rest = {rest, 1}};
    nkw_mixer_frame frame = {.pose = {pose, 1}};
    nkw_mixer_options o = {.mode = NKW_PLAYBACK_LOOP};
    nkw_mixer m;
    NKW_STACK_WORK(work, NKW_MIXER_WORK(CLIPS, 1, 0));
    memset(&m, 0, sizeof m);
    memset(clips, 0, sizeof clips);
    nkw_pose_identity(rest_span);
    if (!build(clips))
        return 0;
    nkw_mixer_play(&m, &set, &o, NULL);
    for (int i = 0; i <= FRAMES; i++) {
        if (i == 80 || i == 176) {
            o.clip = i == 80 ? WALK : RUN;
            o.group = 1;
            o.sync = NKW_MIXER_SYNC_PHASE;
            o.fade = i == 80 ? 1.0f : 1.2f;
            nkw_mixer_play(&m, &set, &o, NULL);
        }
        if (nkw_mixer_advance(&m, &set, i ? (double)seconds / FRAMES : 0.0, &frame, work) != NKW_OK)
            return 0;
        look(&m, &states[i]);
    }
    return 1;
}

/* Pieces of a line, without the jumps of a phase from 1 to 0. */
static void draw_clip(svg *s, const svg_plot *plot, const state *states, int clip, int phase)
{
    svg_paint paint =
        svg_stroke(colours[clip], clip == WALK && phase ? 5.0f : 2.4f, clip == WALK && phase ? 0.45f : 1.0f);
    svg_point line[FRAMES + 1];
    size_t n = 0;
    float before = 0.0f;
    for (int i = 0; i <= FRAMES; i++) {
        const float y = phase ? states[i].phase[clip] : states[i].weight[clip];
        const int plays = states[i].plays[clip], jumps = phase && y < before;
        if ((!plays || jumps) && n > 1)
            svg_polyline(s, line, n, &paint);
        if (!plays || jumps)
            n = 0;
        if (plays)
            line[n++] = svg_plot_at(plot, seconds * (float)i / (float)FRAMES, y);
        before = y;
    }
    if (n > 1)
        svg_polyline(s, line, n, &paint);
}

int figure_mixer_fades(const char *path)
{
    static const char *const names[CLIPS] = {"idle, 1 s", "walk, 1 s", "run, 0.5 s"};
    static state states[FRAMES + 1];
    svg s;
    svg_plot weights = {{70.0f, 100.0f, 890.0f, 220.0f}, {0.0f, 3.0f, 0.5f, ""}, {0.0f, 1.0f, 0.5f, "weight"}};
    svg_plot phases = {{70.0f, 370.0f, 890.0f, 200.0f}, {0.0f, 3.0f, 0.5f, "time, s"}, {0.0f, 1.0f, 0.5f, "phase"}};
    if (!record(states) ||
        !figure_open(&s, path, 1000.0f, 650.0f, "A cross-fade interrupts another, and a run in step with a walk",
                     "The weights sum to 1 at any time. Walk and run have one phase; a cycle becomes shorter as "
                     "the weight passes to the run."))
        return 0;
    svg_plot_frame(&s, &weights);
    svg_plot_frame(&s, &phases);
    for (int clip = 0; clip < CLIPS; clip++) {
        svg_paint paint = svg_stroke(colours[clip], 2.4f, 1.0f);
        draw_clip(&s, &weights, states, clip, 0);
        if (clip != IDLE)
            draw_clip(&s, &phases, states, clip, 1);
        figure_legend(&s, 70.0f + 190.0f * (float)clip, 630.0f, &paint, names[clip]);
    }
    return svg_close(&s);
}
