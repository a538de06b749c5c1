/* SPDX-License-Identifier: MIT */
/* The fingerprint of a mixer: its numbers as words, a slot at a time, then its poses. */
#include "lane/strict.h"

#include <string.h>

#include <nakawari/fingerprint.h>
#include <nakawari/transition.h>

#include "fingerprint_words.h"
#include "mixer_state.h"

#define WORDS 64 /* at least those of a slot */

/* The component arrays of the offsets of a transition. */
#define ARRAYS_OF(floats) ((floats) / NKW_POSE_STRIDE(1))
enum { INERTIA = ARRAYS_OF(NKW_POSE_INERTIA_FLOATS(1)), DEAD_BLEND = ARRAYS_OF(NKW_POSE_DEAD_BLEND_FLOATS(1)) };

typedef struct word_list {
    uint32_t words[WORDS];
    size_t count;
} word_list;

static void put_word(word_list *list, uint32_t word)
{
    list->words[list->count++] = word;
}

static void put_float(word_list *list, float x)
{
    put_word(list, fingerprint_word(x));
}

/* The low word first; every NaN is one. */
static void put_double(word_list *list, double x)
{
    uint64_t bits;
    memcpy(&bits, &x, sizeof bits);
    bits = x != x ? UINT64_C(0x7ff8000000000000) : bits;
    put_word(list, (uint32_t)(bits & 0xffffffffu));
    put_word(list, (uint32_t)(bits >> 32));
}

static void put_trs(word_list *list, const nkw_trs *trs)
{
    float numbers[10];
    memcpy(numbers, trs, sizeof numbers);
    for (size_t i = 0; i < 10; i++)
        put_float(list, numbers[i]);
}

static uint64_t hash_of(const word_list *list, uint64_t from)
{
    fingerprint_sums sums = nkwi_fingerprint_begin(from);
    return nkwi_fingerprint_end(&sums, list->words, list->count);
}

static uint64_t hash_of_slot(const nkw_mixer_slot *s, size_t index, uint64_t from)
{
    word_list list = {{0}, 0};
    const uint32_t numbers[] = {(uint32_t)index, s->playing,        s->clip,           s->mask,           s->layer,
                                s->group,        (uint32_t)s->sync, (uint32_t)s->mode, (uint32_t)s->blend};
    for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++)
        put_word(&list, numbers[i]);
    put_double(&list, s->time);
    put_double(&list, s->fade.elapsed);
    put_double(&list, s->fade.duration);
    put_float(&list, s->fade.from);
    put_float(&list, s->fade.to);
    put_double(&list, s->cycle);
    put_trs(&list, &s->motion);
    put_trs(&list, &s->first);
    put_trs(&list, &s->last);
    put_float(&list, s->weight);
    put_float(&list, s->speed);
    return hash_of(&list, from);
}

static uint64_t hash_of_rest(const nkw_mixer *m, uint64_t from)
{
    const int moves = m->transition != NKW_MIXER_CROSS_FADE;
    word_list list = {{0}, 0};
    put_word(&list, (uint32_t)m->transition);
    put_word(&list, m->pending);
    put_word(&list, m->shown < 2 ? m->shown : 2);
    put_double(&list, moves ? m->elapsed : 0.0);
    put_double(&list, moves ? m->duration : 0.0);
    put_float(&list, m->shown > 1 ? m->step : 0.0f);
    return hash_of(&list, from);
}

static uint64_t hash_of_poses(const nkw_mixer *m, const float *poses, size_t joint_count, uint64_t from)
{
    const size_t floats = NKW_POSE_FLOATS(joint_count);
    const size_t last = m->shown_at == 1, arrays = m->transition == NKW_MIXER_DEAD_BLEND ? DEAD_BLEND : INERTIA;
    if (m->shown > 0)
        from = nkwi_fingerprint_arrays(poses + last * floats, 10, joint_count, from);
    if (m->shown > 1)
        from = nkwi_fingerprint_arrays(poses + (1 - last) * floats, 10, joint_count, from);
    if (m->transition != NKW_MIXER_CROSS_FADE && !m->pending)
        from = nkwi_fingerprint_arrays(poses + 2 * floats, arrays, joint_count, from);
    return from;
}

uint64_t nkw_mixer_fingerprint(const nkw_mixer *mixer, const float *poses, size_t joint_count, uint64_t from)
{
    for (size_t i = 0; i < mixer_slot_count(mixer); i++)
        if (mixer->slot[i].playing != MIXER_FREE)
            from = hash_of_slot(&mixer->slot[i], i, from);
    from = hash_of_rest(mixer, from);
    return poses ? hash_of_poses(mixer, poses, joint_count, from) : from;
}
