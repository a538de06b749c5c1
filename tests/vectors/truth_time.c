/* SPDX-License-Identifier: CC0-1.0 */
/* Time in a clip, the segment of a time, and the keys that a step of time passes. */
#include "truth.h"

#if WIDE_AVAILABLE

#include <math.h>
#include <quadmath.h>

static void head(const char *kind, const char *name, int mode, float start, float duration, float time)
{
    wide passed = (wide)time - start, cycle = floorq(passed / duration), rest = passed - cycle * duration, at;
    float m = (float)mode;
    at = mode == 2 && fmodq(fabsq(cycle), 2) == 1 ? start + duration - rest : start + rest;
    if (mode == 0) {
        at = passed < 0 ? start : passed > duration ? (wide)start + duration : (wide)time;
        cycle = 0;
    }
    truth_case(kind, name, NULL);
    truth_scale(fmax(fabs((double)start) + (double)duration, fabs((double)cycle)));
    truth_in("mode", &m, 1);
    truth_in("start", &start, 1);
    truth_in("duration", &duration, 1);
    truth_in("time", &time, 1);
    truth_out("at", &at, 1);
    truth_out("cycle", &cycle, 1);
}

static void head_group(void)
{
    static const char *const lines[] = {"in mode 1",        "in start 1", "in duration 1", "in time 1", "out at 1 near",
                                        "out cycle 1 near", NULL};
    static const char *const modes[3] = {"clamp", "loop", "ping-pong"};
    truth_group("play_head", lines, 2.0, "one rounding; the play head is computed from the time, not accumulated");
    for (int mode = 0; mode < 3; mode++) {
        for (int i = 0; i < 5; i++) {
            float start = i % 2 ? random_between(truth_random(), -1.0f, 1.0f) : 0.0f;
            head("ordinary", modes[mode], mode, start, random_between(truth_random(), 0.5f, 3.0f),
                 random_between(truth_random(), -10.0f, 20.0f));
        }
        head("boundary", "at-the-start", mode, 0.5f, 2.0f, 0.5f);
        head("boundary", "at-the-end", mode, 0.5f, 2.0f, 2.5f);
        head("boundary", "two-loops", mode, 0.0f, 1.5f, 3.0f);
        head("boundary", "one-loop-before", mode, 0.0f, 1.5f, -1.5f);
        head("hostile", "a-million-loops", mode, 0.0f, 0.25f, 250000.125f);
        head("hostile", "before-the-start-by-little", mode, 0.0f, 1.0f, -0x1p-20f);
    }
}

static void segment(const char *kind, const char *name, const float *times, int n, float time)
{
    int k = 0;
    while (k + 2 < n && time >= times[k + 1])
        k++;
    wide d = n > 1 ? (wide)times[k + 1] - times[k] : 0, t = d > 0 ? ((wide)time - times[k]) / d : 0, index = k;
    t = t < 0 ? 0 : t > 1 ? 1 : t;
    truth_case(kind, name, NULL);
    truth_in("times", times, n);
    truth_in("time", &time, 1);
    truth_out("index", &index, 1);
    truth_out("t", &t, 1);
}

static void segment_group(void)
{
    static const char *const lines[] = {"in times n", "in time 1", "out index 1 exact", "out t 1 near", NULL};
    const float times[5] = {0, 1, 3, 4, 8}, jump[4] = {0, 1, 1, 2}, late[2] = {100.0f, 100.5f};
    static const float inside[6] = {0.25f, 1.5f, 2.999f, 3.5f, 5.0f, 7.75f};
    truth_group("segment", lines, 2.0,
                "half open: a key belongs to the segment that begins there, the last one to the last");
    for (int i = 0; i < 6; i++)
        segment("ordinary", "inside", times, 5, inside[i]);
    for (int i = 0; i < 5; i++)
        segment("boundary", "at-a-key", times, 5, times[i]);
    segment("boundary", "before", times, 5, -1.0f);
    segment("boundary", "after", times, 5, 9.0f);
    segment("hostile", "two-keys-at-one-time", jump, 4, 1.0f);
    segment("hostile", "an-ulp-before-a-key", times, 5, 0x1.7ffffep1f);
    segment("hostile", "late-times", late, 2, 100.25f);
}

/* Every passing times[k] + n duration in (from, to], in order of time; backwards in [to, from), the latest first. */
static void passed(const char *kind, const char *name, const float *times, int count, float duration, float from,
                   float to)
{
    wide keys[64], total = 0;
    int n = 0, back = to < from;
    float low = back ? to : from, high = back ? from : to;
    int first = duration > 0 ? (int)floorf((low - times[count - 1]) / duration) - 1 : 0;
    int last = duration > 0 ? (int)ceilf((high - times[0]) / duration) + 1 : 0;
    for (int i = 0; i < (last - first + 1) * count; i++) {
        int j = back ? (last - first + 1) * count - 1 - i : i, k = j % count;
        wide at = times[k] + (wide)(first + j / count) * duration;
        if (back ? at >= low && at < high : at > low && at <= high)
            keys[n++] = k;
    }
    total = n;
    truth_case(kind, name, NULL);
    truth_in("times", times, count);
    truth_in("duration", &duration, 1);
    truth_in("from", &from, 1);
    truth_in("to", &to, 1);
    truth_out("count", &total, 1);
    truth_out("keys", keys, n);
}

void truth_time(const char *folder)
{
    static const char *const about[] = {
        "Time in a clip that covers [start, start + duration], seconds. mode 0 clamp, 1 loop, 2 ping-pong.",
        "cycle = floor((time - start)/duration); loop: start + rest; ping-pong: backwards in odd cycles; clamp: cycle "
        "0.",
        "segment: the index of its first key, and t in 0..1 in it; clamped outside the keys.",
        NULL,
    };
    truth_open(folder, "time", about);
    head_group();
    segment_group();
    truth_close();
    static const char *const events[] = {
        "Events: the keys that a step of the running time passes, (from, to]: `from` is excluded, `to` included.",
        "A clip of `duration` seconds repeats for ever in both directions: key k is passed at times[k] + n duration.",
        "Duration 0: the clip does not repeat. Steps that follow one another report each passing once.",
        "to < from plays backwards: the keys in [to, from), the latest first.",
        NULL,
    };
    static const char *const lines[] = {"in times n",        "in duration 1",    "in from 1", "in to 1",
                                        "out count 1 exact", "out keys n exact", NULL};
    const float times[3] = {0.0f, 0.25f, 0.75f}, once[2] = {1.0f, 2.0f};
    truth_open(folder, "events", events);
    truth_group("events_passed", lines, 0.0, "indices are exact");
    passed("ordinary", "within-a-loop", times, 3, 1.0f, 0.125f, 0.5f);
    passed("ordinary", "across-the-end-of-a-loop", times, 3, 1.0f, 0.5f, 1.5f);
    passed("ordinary", "three-loops", times, 3, 1.0f, 0.1f, 3.1f);
    passed("ordinary", "does-not-repeat", once, 2, 0.0f, 0.5f, 1.5f);
    passed("boundary", "from-is-excluded", times, 3, 1.0f, 0.25f, 0.75f);
    passed("boundary", "to-is-included", times, 3, 1.0f, 0.125f, 0.25f);
    passed("boundary", "the-key-at-0-belongs-to-the-next-loop", times, 3, 1.0f, 0.875f, 1.0f);
    passed("boundary", "no-step", times, 3, 1.0f, 0.25f, 0.25f);
    passed("hostile", "before-the-first-loop", times, 3, 1.0f, -2.5f, -1.0f);
    passed("hostile", "far-in-time", times, 3, 1.0f, 100000.125f, 100001.125f);
    passed("ordinary", "backwards", times, 3, 1.0f, 0.875f, 0.125f);
    passed("boundary", "backwards-from-is-excluded-to-is-included", times, 3, 1.0f, 0.75f, 0.25f);
    passed("hostile", "backwards-across-the-start", times, 3, 1.0f, 0.5f, -1.5f);
    truth_close();
}

#else
typedef int truth_time_is_skipped;
#endif
