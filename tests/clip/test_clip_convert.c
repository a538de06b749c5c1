/* SPDX-License-Identifier: MIT */
/* Blocks of the other byte order: those of the files of golden/byte_order, the same with words damaged, and cut off. */
#include <stdlib.h>

#include "random.h"
#include "support/clips.h"
#include "support/views.h"

enum { CLIPS = 3, MOST = 1 << 14, GUARD = 16 };

/* Words of a header, of layout 7: the number of words, and the place and number of the groups. */
enum { WORDS = 2, GROUPS = 9, GROUP_COUNT = 10, GROUP_WORDS = 11 };

static const uint32_t guard = 0xfb5a5a5au;

/* A clip as this machine writes it, and as one of the other order does. */
typedef struct pair {
    size_t words;
    uint32_t own[MOST], other[MOST];
} pair;

static pair pairs[CLIPS];

/* An output of exactly `words`, with guards around it. */
typedef struct output {
    uint32_t before[GUARD], words[MOST + GUARD];
} output;

static uint32_t swapped(uint32_t w)
{
    return w >> 24 | (w >> 8 & 0xff00u) | (w << 8 & 0xff0000u) | w << 24;
}

static int read_pairs(void **state)
{
    (void)state;
    const uint32_t one = 1;
    const int is_little = *(const unsigned char *)&one == 1;
    FILE *own = fopen(is_little ? NKW_CLIPS_LITTLE : NKW_CLIPS_BIG, "rb");
    FILE *other = fopen(is_little ? NKW_CLIPS_BIG : NKW_CLIPS_LITTLE, "rb");
    int is_read = own && other;
    for (int i = 0; i < CLIPS && is_read; i++) {
        pair *p = &pairs[i];
        is_read = fread(p->own, 4, WORDS + 1, own) == WORDS + 1 && p->own[WORDS] <= MOST;
        p->words = is_read ? p->own[WORDS] : 0;
        is_read = is_read && fread(p->own + WORDS + 1, 4, p->words - WORDS - 1, own) == p->words - WORDS - 1 &&
                  fread(p->other, 4, p->words, other) == p->words;
    }
    if (own)
        fclose(own);
    if (other)
        fclose(other);
    return !is_read;
}

/* Converts into guarded memory; nothing outside it is written. */
static nkw_result convert(const void *block, size_t bytes, output *out, const nkw_clip **clip)
{
    for (size_t i = 0; i < GUARD; i++)
        out->before[i] = guard;
    for (size_t i = 0; i < (size_t)GUARD * 4; i++)
        ((unsigned char *)out->words)[bytes + i] = 0x5a;
    nkw_result result = nkw_clip_convert(block, bytes, out->words, clip);
    for (size_t i = 0; i < GUARD; i++)
        assert_int_equal(out->before[i], guard);
    for (size_t i = 0; i < (size_t)GUARD * 4; i++)
        assert_int_equal(((unsigned char *)out->words)[bytes + i], 0x5a);
    assert_ptr_equal(*clip, result == NKW_OK ? out->words : NULL);
    return result;
}

static void a_block_of_the_other_order_becomes_that_of_this_machine(void **state)
{
    (void)state;
    static output out;
    static unsigned char odd[4 * MOST + 1];
    const nkw_clip *clip;
    for (int i = 0; i < CLIPS; i++) {
        const pair *p = &pairs[i];
        const size_t bytes = 4 * p->words;
        assert_int_equal(nkw_clip_open(p->other, bytes, &clip), NKW_NOT_A_CLIP);
        assert_int_equal(convert(p->other, bytes, &out, &clip), NKW_OK);
        assert_memory_equal(out.words, p->own, bytes);
        memcpy(odd + 1, p->other, bytes);
        assert_int_equal(convert(odd + 1, bytes, &out, &clip), NKW_OK);
        assert_memory_equal(out.words, p->own, bytes);
        memcpy(out.words, p->other, bytes);
        assert_int_equal(convert(out.words, bytes, &out, &clip), NKW_OK);
        assert_memory_equal(out.words, p->own, bytes);
        assert_string_equal(nkw_clip_describe(clip).name, "walk");
        /* Once more: it is of this order now. */
        assert_int_equal(convert(out.words, bytes, &out, &clip), NKW_OK);
        assert_memory_equal(out.words, p->own, bytes);
    }
}

/* Value `how` for a word of a block: next to it, next to the ends of the block and of the numbers, another word. */
enum { LARGEST = 8 };

static uint32_t damaged(random_source *r, const pair *p, size_t at, unsigned how)
{
    const uint32_t w = p->own[at], words = (uint32_t)p->words;
    const uint32_t values[12] = {w + 1,
                                 w - 1,
                                 0,
                                 1,
                                 words,
                                 words - (uint32_t)at,
                                 words - 1u,
                                 0x7fffffffu,
                                 0xffffffffu,
                                 w ^ 1u << 31,
                                 (uint32_t)random_bits(r),
                                 p->own[random_bits(r) % words]};
    return values[how];
}

/* A clip that is accepted may be sampled, and is the same if it is converted again. */
static void expect_sound(const nkw_clip *clip, size_t bytes)
{
    static float pose[NKW_POSE_FLOATS(4 * MOST) + 1], floats[4 * MOST + 1];
    static output again;
    const nkw_clip *same;
    const size_t joints = nkw_clip_describe(clip).joint_count;
    assert_true(joints + nkw_clip_describe(clip).float_count < bytes);
    assert_int_equal(convert(clip, bytes, &again, &same), NKW_OK);
    assert_memory_equal(same, clip, bytes);
    float *pose_end = pose + NKW_POSE_FLOATS(joints), *floats_end = floats + nkw_clip_describe(clip).float_count;
    *pose_end = *floats_end = 77.0f;
    nkw_clip_sample(clip, 0.5f * (nkw_clip_describe(clip).start + nkw_clip_describe(clip).end), NULL,
                    pose_span(pose, joints), floats);
    assert_true(*pose_end == 77.0f && *floats_end == 77.0f);
}

/*
 * The words of the header, of timelines and groups mean the same in both orders. So a block of the other order with a
 * damaged one is refused where this machine's own block with the same damage is. (It is refused too where the damage
 * places keys over these parts, which are then converted twice.)
 */
static void damage_to_the_parts_is_seen_as_in_the_order_of_this_machine(void **state)
{
    (void)state;
    random_source r = random_from(1);
    static output out;
    static uint32_t own[MOST], other[MOST];
    size_t refused = 0, accepted = 0;
    for (int i = 0; i < CLIPS; i++) {
        const pair *p = &pairs[i];
        const size_t end = p->own[GROUPS] + (size_t)p->own[GROUP_COUNT] * GROUP_WORDS, bytes = 4 * p->words;
        memcpy(own, p->own, bytes);
        memcpy(other, p->other, bytes);
        assert_true(end < p->words);
        for (size_t at = WORDS; at < end; at++)
            for (unsigned how = 0; how < 12; how++) {
                const nkw_clip *clip, *got;
                own[at] = damaged(&r, p, at, how);
                other[at] = swapped(own[at]);
                const nkw_result want = nkw_clip_open(own, bytes, &clip), result = convert(other, bytes, &out, &got);
                assert_true(result != NKW_OK || want == NKW_OK);
                if (result == NKW_OK)
                    expect_sound(got, bytes);
                *(result == NKW_OK ? &accepted : &refused) += 1;
                own[at] = p->own[at];
                other[at] = p->other[at];
            }
    }
    assert_true(refused > 1000 && accepted > 100);
}

/* Widths, slots, offsets of streams and of texts, times, keys: every word of a block, by some of the values. */
static void no_damaged_word_leads_outside_the_block(void **state)
{
    (void)state;
    random_source r = random_from(2);
    static output out;
    static uint32_t other[MOST];
    for (int i = 0; i < CLIPS; i++) {
        const pair *p = &pairs[i];
        const size_t bytes = 4 * p->words;
        memcpy(other, p->other, bytes);
        for (size_t at = WORDS; at < p->words; at++)
            for (unsigned how = 0; how < 12; how++) {
                if (how % 3 != at % 3 && how != LARGEST)
                    continue;
                const nkw_clip *clip;
                other[at] = swapped(damaged(&r, p, at, how));
                if (convert(other, bytes, &out, &clip) == NKW_OK)
                    expect_sound(clip, bytes);
                other[at] = p->other[at];
            }
    }
}

static void a_block_that_is_cut_off_is_refused(void **state)
{
    (void)state;
    static output out;
    for (int i = 0; i < CLIPS; i++) {
        const pair *p = &pairs[i];
        for (size_t bytes = 0; bytes < 4 * p->words; bytes += bytes < 200 || bytes % 64 == 63 ? 1 : 63 - bytes % 64) {
            const nkw_clip *clip;
            void *exact = malloc(bytes + !bytes);
            assert_non_null(exact);
            memcpy(exact, p->other, bytes);
            assert_int_equal(convert(exact, bytes, &out, &clip), NKW_TOO_SMALL);
            free(exact);
        }
    }
}

static void a_block_of_another_version_or_none_is_refused(void **state)
{
    (void)state;
    static output out;
    static uint32_t other[MOST];
    const nkw_clip *clip;
    const pair *p = &pairs[0];
    for (uint32_t version = 0; version < 99; version++) {
        memcpy(other, p->other, 4 * p->words);
        other[1] = swapped(version);
        assert_int_equal(convert(other, 4 * p->words, &out, &clip), version == p->own[1] ? NKW_OK : NKW_NOT_A_CLIP);
    }
    memset(other, 0, sizeof other);
    assert_int_equal(convert(other, 4 * p->words, &out, &clip), NKW_NOT_A_CLIP);
    assert_int_equal(nkw_clip_convert(p->other, 4 * p->words, (unsigned char *)out.words + 1, &clip), NKW_NOT_A_CLIP);
    assert_null(clip);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_block_of_the_other_order_becomes_that_of_this_machine),
        cmocka_unit_test(damage_to_the_parts_is_seen_as_in_the_order_of_this_machine),
        cmocka_unit_test(no_damaged_word_leads_outside_the_block),
        cmocka_unit_test(a_block_that_is_cut_off_is_refused),
        cmocka_unit_test(a_block_of_another_version_or_none_is_refused),
    };
    return cmocka_run_group_tests_name("clip_convert", tests, read_pairs, NULL);
}
