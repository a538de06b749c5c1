/* SPDX-License-Identifier: MIT */
/*
 * Times of a mixer. A step is divided where fades end, so that weights are linear in each piece:
 *
 *     piece = min(what remains of the step, what remains of each fade)
 */
#include "mixer_state.h"

/* q^13/14 < 2^-55: the series below has all bits. */
#define SMALL_RATIO  0.0625
#define SERIES_TERMS 13

/*
 * The mean of (n0 + u (n1 - n0)) / (m0 + u (m1 - m0)) over u in 0..1, for m0, m1 >= 0. With q = (m1 - m0)/m0,
 *
 *     n0/m0 L + (n1 - n0)/m0 (1 - L)/q,    L = ln(1 + q)/q = 1 - q/2 + q^2/3 ...,    (1 - L)/q = 1/2 - q/3 + q^2/4 ...
 *
 * Where one of m0, m1 is 0, all weights grow or shrink in proportion: the quotient is constant.
 */
static double mean_quotient(double n0, double n1, double m0, double m1)
{
    if (!(m1 > m0 * 0x1p-50))
        return m0 > 0.0 ? n0 / m0 : 0.0;
    if (!(m0 > m1 * 0x1p-50))
        return n1 / m1;
    const double q = (m1 - m0) / m0;
    double l = 0.0, rest = 0.0;
    if (q < SMALL_RATIO && q > -SMALL_RATIO)
        for (int k = SERIES_TERMS; k > 0; k--) {
            rest = 1.0 / (double)(k + 1) - q * rest;
            l = 1.0 / (double)k - q * l;
        }
    else {
        l = lane_log2_64(m1 / m0) * LANE_LN_2 / q;
        rest = (1.0 - l) / q;
    }
    return n0 / m0 * l + (n1 - n0) / m0 * rest;
}

static double speed_of(const nkw_mixer_slot *s)
{
    return lane_is_finite(s->speed) ? (double)s->speed : 0.0;
}

static double fade_after(const nkw_mixer_fade *f, double seconds)
{
    return f->duration - f->elapsed > seconds ? f->elapsed + seconds : f->duration;
}

/* The cycles of a group in a piece. Weights that are all 0 count as equal. */
static double group_cycles(const nkw_mixer *m, const nkw_mixer_set *set, uint32_t group, double seconds)
{
    double n[2] = {0.0, 0.0}, d[2] = {0.0, 0.0}, n_equal = 0.0, d_equal = 0.0;
    for (size_t i = 0; i < m->slot_count; i++) {
        const nkw_mixer_slot *s = &m->slot[i];
        const double length = mixer_plays(s) && s->group == group ? mixer_range_of(set, s).length : 0.0;
        if (!(length > 0.0))
            continue;
        const double own = (double)mixer_own_weight(s), ends[2] = {s->fade.elapsed, fade_after(&s->fade, seconds)};
        for (int k = 0; k < 2; k++) {
            const double w = own * mixer_fade_at(&s->fade, ends[k]);
            n[k] += w * speed_of(s);
            d[k] += w * length;
        }
        n_equal += speed_of(s);
        d_equal += length;
    }
    if (d[0] > 0.0 || d[1] > 0.0)
        return seconds * mean_quotient(n[0], n[1], d[0], d[1]);
    return d_equal > 0.0 ? seconds * (n_equal / d_equal) : 0.0;
}

/* ---- In step with a leader ---- */

static int has_markers(const nkw_mixer_set *set, const nkw_mixer_slot *leader, const nkw_mixer_slot *s)
{
    const size_t count = set->clips[leader->clip].marker_count;
    return s->sync == NKW_MIXER_SYNC_MARKERS && count > 0 && count == set->clips[s->clip].marker_count;
}

/* The time of marker k, counted from the start of a clip on through its cycles: of markers 0..count. */
static double marker_at(const nkw_mixer_set *set, const nkw_mixer_slot *s, size_t k)
{
    const nkw_mixer_clip *c = &set->clips[s->clip];
    const mixer_range range = mixer_range_of(set, s);
    const double next = k < c->marker_count ? 0.0 : range.length;
    return (double)c->markers[k % c->marker_count] - (double)range.start + next;
}

/* The share u of the way between two markers is the same for both: before the first marker is after the last. */
static double time_between_markers(const nkw_mixer_set *set, const nkw_mixer_slot *leader, const nkw_mixer_slot *s)
{
    const double lead = mixer_range_of(set, leader).length, own = mixer_range_of(set, s).length;
    const size_t count = set->clips[s->clip].marker_count;
    const double first = marker_at(set, leader, 0), cycle = lane_floor64((leader->time - first) / lead);
    const double time = leader->time - cycle * lead;
    size_t k = 0;
    while (k + 1 < count && marker_at(set, leader, k + 1) <= time)
        k++;
    const double a = marker_at(set, leader, k), b = marker_at(set, leader, k + 1);
    const double u = b > a ? (time - a) / (b - a) : 0.0;
    const double x = marker_at(set, s, k), y = marker_at(set, s, k + 1);
    return cycle * own + (x + u * (y - x));
}

double nkwi_mixer_time_in_step(const nkw_mixer_set *set, const nkw_mixer_slot *leader, const nkw_mixer_slot *s)
{
    const double lead = mixer_range_of(set, leader).length, own = mixer_range_of(set, s).length;
    if (s == leader || s->sync == NKW_MIXER_SYNC_LENGTH || !(lead > 0.0) || !(own > 0.0))
        return s->time;
    if (has_markers(set, leader, s))
        return time_between_markers(set, leader, s);
    return leader->time / lead * own;
}

/* ---- Steps ---- */

static void move_slot(nkw_mixer *m, const nkw_mixer_set *set, nkw_mixer_slot *s, double seconds, double cycles)
{
    if (s->group == 0)
        s->time += seconds * speed_of(s);
    else {
        s->time += cycles * mixer_range_of(set, s).length;
        s->time = nkwi_mixer_time_in_step(set, mixer_leader(m, s->group), s);
    }
}

static void move_piece(nkw_mixer *m, const nkw_mixer_set *set, double seconds)
{
    double cycles[NKW_MIXER_SLOTS] = {0.0};
    for (size_t i = 0; i < m->slot_count; i++) {
        nkw_mixer_slot *s = &m->slot[i];
        const size_t leader = mixer_plays(s) && s->group ? (size_t)(mixer_leader(m, s->group) - m->slot) : i;
        if (mixer_plays(s) && s->group && leader == i)
            cycles[i] = group_cycles(m, set, s->group, seconds);
        if (mixer_plays(s))
            move_slot(m, set, s, seconds, cycles[leader]);
    }
    for (size_t i = 0; i < m->slot_count; i++)
        m->slot[i].fade.elapsed = fade_after(&m->slot[i].fade, seconds);
}

static void end_faded(nkw_mixer *m)
{
    for (size_t i = 0; i < m->slot_count; i++) {
        nkw_mixer_slot *s = &m->slot[i];
        if (mixer_plays(s) && s->fade.to == 0.0f && !(s->fade.elapsed < s->fade.duration))
            s->playing |= MIXER_ENDED;
    }
}

static double piece_of(const nkw_mixer *m, double seconds)
{
    double piece = seconds;
    for (size_t i = 0; i < m->slot_count; i++) {
        const double left = m->slot[i].fade.duration - m->slot[i].fade.elapsed;
        if (mixer_plays(&m->slot[i]) && left > 0.0 && left < piece)
            piece = left;
    }
    return piece;
}

void nkwi_mixer_move(nkw_mixer *m, const nkw_mixer_set *set, double seconds)
{
    end_faded(m);
    while (seconds > 0.0) {
        const double piece = piece_of(m, seconds);
        move_piece(m, set, piece);
        end_faded(m);
        seconds -= piece;
    }
}
