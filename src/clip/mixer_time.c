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

static double fade_after(const nkw_mixer_fade *f, double seconds)
{
    return f->duration - f->elapsed > seconds ? f->elapsed + seconds : f->duration;
}

/* The cycles of a group in a piece. Weights that are all 0 count as equal. */
static double group_cycles(const mixer_voices *all, uint32_t group, double seconds)
{
    double n[2] = {0.0, 0.0}, d[2] = {0.0, 0.0}, n_equal = 0.0, d_equal = 0.0;
    for (const mixer_voice *v = all->voice; v < all->voice + all->count; v++) {
        const nkw_mixer_slot *s = v->slot;
        if (v->has_ended || s->group != group || !(v->range.length > 0.0))
            continue;
        /* Not a loop over both: a vector of two would divide by the duration of a fade that has none. */
        const double own = (double)mixer_own_weight(s);
        const double w0 = own * mixer_fade_at(&s->fade, s->fade.elapsed);
        const double w1 = own * mixer_fade_at(&s->fade, fade_after(&s->fade, seconds));
        n[0] += w0 * mixer_speed(s), d[0] += w0 * v->range.length;
        n[1] += w1 * mixer_speed(s), d[1] += w1 * v->range.length;
        n_equal += mixer_speed(s);
        d_equal += v->range.length;
    }
    if (d[0] > 0.0 || d[1] > 0.0)
        return seconds * mean_quotient(n[0], n[1], d[0], d[1]);
    return d_equal > 0.0 ? seconds * (n_equal / d_equal) : 0.0;
}

/* ---- In step with a leader ---- */

static int has_markers(const mixer_voice *leader, const mixer_voice *v)
{
    const size_t count = leader->clip->marker_count;
    return v->slot->sync == NKW_MIXER_SYNC_MARKERS && count > 0 && count == v->clip->marker_count;
}

/* The time of marker k, counted from the start of a clip on through its cycles: of markers 0..count. */
static double marker_at(const mixer_voice *v, size_t k)
{
    const nkw_mixer_clip *c = v->clip;
    const double next = k < c->marker_count ? 0.0 : v->range.length;
    return (double)c->markers[k % c->marker_count] - (double)v->range.start + next;
}

/* The share u of the way between two markers is the same for both: before the first marker is after the last. */
static double time_between_markers(const mixer_voice *leader, const mixer_voice *v)
{
    const double lead = leader->range.length, own = v->range.length;
    const size_t count = v->clip->marker_count;
    const double first = marker_at(leader, 0), cycle = lane_floor64((leader->slot->time - first) / lead);
    const double time = leader->slot->time - cycle * lead;
    size_t k = 0;
    while (k + 1 < count && marker_at(leader, k + 1) <= time)
        k++;
    const double a = marker_at(leader, k), b = marker_at(leader, k + 1);
    const double u = b > a ? (time - a) / (b - a) : 0.0;
    const double x = marker_at(v, k), y = marker_at(v, k + 1);
    return cycle * own + (x + u * (y - x));
}

double nkwi_mixer_time_in_step(const mixer_voice *leader, const mixer_voice *v)
{
    const double lead = leader->range.length, own = v->range.length;
    if (leader->slot == v->slot || v->slot->sync == NKW_MIXER_SYNC_LENGTH || !(lead > 0.0) || !(own > 0.0))
        return v->slot->time;
    if (has_markers(leader, v))
        return time_between_markers(leader, v);
    return leader->slot->time / lead * own;
}

/* ---- Steps ---- */

/* The first slot of a group that has not ended. */
static mixer_voice *leader_of(mixer_voices *all, uint32_t group)
{
    mixer_voice *leader = NULL;
    for (mixer_voice *v = all->voice; v < all->voice + all->count; v++)
        if (!v->has_ended && v->slot->group == group && (!leader || v->slot < leader->slot))
            leader = v;
    return leader;
}

/* Moves the group of which v is the leader. */
static void move_group(mixer_voices *all, mixer_voice *v, double seconds)
{
    const uint32_t group = v->slot->group;
    const double cycles = group_cycles(all, group, seconds);
    v->slot->time += cycles * v->range.length;
    for (mixer_voice *other = all->voice; other < all->voice + all->count; other++) {
        if (other == v || other->has_ended || other->slot->group != group)
            continue;
        other->slot->time += cycles * other->range.length;
        other->slot->time = nkwi_mixer_time_in_step(v, other);
    }
}

static void move_piece(mixer_voices *all, double seconds)
{
    for (mixer_voice *v = all->voice; v < all->voice + all->count; v++) {
        if (v->has_ended)
            continue;
        v->seconds += seconds;
        if (!v->slot->group)
            mixer_move_alone(v->slot, seconds);
        else if (leader_of(all, v->slot->group) == v)
            move_group(all, v, seconds);
    }
}

/* Ends the piece for the fades. Returns the next piece: to the end of the next fade, at most `seconds`. */
static double move_fades(mixer_voices *all, double piece, double seconds)
{
    for (mixer_voice *v = all->voice; v < all->voice + all->count; v++) {
        nkw_mixer_fade *f = &v->slot->fade;
        if (f->elapsed < f->duration)
            f->elapsed = fade_after(f, piece);
        const double left = f->duration - f->elapsed;
        if (!(left > 0.0))
            v->has_ended |= f->to == 0.0f;
        else if (left < seconds)
            seconds = left;
    }
    return seconds;
}

void nkwi_mixer_move(mixer_voices *all, double seconds)
{
    double piece = move_fades(all, 0.0, seconds);
    while (piece > 0.0) {
        move_piece(all, piece);
        seconds -= piece;
        piece = move_fades(all, piece, seconds);
    }
}
