/* SPDX-License-Identifier: MIT */
/*
 * The animations of a file that is rewritten (rewrite.h).
 *
 * Invariant: channels keep their order, target and extensions. Only the member "sampler" of a channel changes, and the
 * list of samplers.
 *
 *     channels    0  1  2  3  4  5   2 and 4 have no track: their targets are not known here; 5 is left out
 *     old         0  1  1  1  1  0   channels 1 to 4 share a sampler
 *     replaced    a  b  1  c  1      a, b and c are new, one for each track that remains
 *     shared      0  1  2  3  2      the index of each in the list a b 1 c: equal samplers are in it once
 */
#include "rewrite.h"

/* The track of a channel of the file; SIZE_MAX if it has none. */
static size_t track_of(const nkw_document_animation *a, size_t channel)
{
    for (size_t i = 0; i < a->track_count; i++)
        if (a->channels[i].number == channel)
            return i;
    return SIZE_MAX;
}

/* Arrays are compared by address: `to` names those of `from` where nothing is replaced. Then no key is written anew. */
static int is_replaced(const nkw_track *from, const nkw_track *to)
{
    return from->times != to->times || from->values != to->values || from->count != to->count ||
           from->interpolation != to->interpolation || from->key_interpolation != to->key_interpolation;
}

/* The type of the old values; another than an integer of at most 16 bits counts as float. */
static nkwi_component component_of(const nkwi_rewriter *r, size_t accessor)
{
    size_t type = nkwi_rewriter_index(json_array_get(r->sink.accessors, accessor), "componentType");
    return type >= NKWI_I8 && type <= NKWI_U16 ? (nkwi_component)type : NKWI_F32;
}

/* Channel i of animation a, with a new sampler at the end of the list. */
static int replace_channel(nkwi_rewriter *r, size_t a, size_t i, const json_t *old, json_t *samplers)
{
    const nkw_document_animation *to = &r->rewriting->to->animations[a];
    json_t *channel =
        json_array_get(json_object_get(json_array_get(json_object_get(r->root, "animations"), a), "channels"), i);
    const nkwi_place root = {NULL, NULL, 0}, list = {&root, "animations", 0}, at = {&list, NULL, a};
    const nkwi_place channels = {&at, "channels", 0}, place = {&channels, NULL, i};
    const size_t track = track_of(to, i), number = nkwi_rewriter_index(channel, "sampler");
    json_t *sampler = json_array_get(old, number), *made = NULL;
    if (track != SIZE_MAX) {
        made = nkwi_sink_sampler(&r->sink, &to->tracks[track], &place,
                                 component_of(r, nkwi_rewriter_index(sampler, "output")));
        if (!made)
            return r->sink.failed ? nkwi_rewriter_no_memory(r) : 0;
    }
    nkwi_set(&r->sink, channel, "sampler", json_integer((json_int_t)json_array_size(samplers)));
    nkwi_put(&r->sink, samplers, made ? made : json_incref(sampler));
    return 1;
}

/* Samplers that several channels share, and that are not replaced, remain shared. */
static void share_samplers(nkwi_rewriter *r, json_t *channels, json_t *samplers)
{
    json_t *list = json_array();
    for (size_t i = 0; i < json_array_size(channels); i++) {
        const json_t *sampler = json_array_get(samplers, i);
        size_t k = 0;
        while (k < json_array_size(list) && json_array_get(list, k) != sampler)
            k++;
        if (k == json_array_size(list))
            nkwi_put(&r->sink, list, json_incref((json_t *)json_array_get(samplers, i)));
        nkwi_set(&r->sink, json_array_get(channels, i), "sampler", json_integer((json_int_t)k));
    }
    json_array_clear(samplers);
    json_array_extend(samplers, list);
    json_decref(list);
}

/* Whether a channel of the file has a track in `from` and none in `to`. */
static int is_left_out(const nkwi_rewriter *r, size_t a, size_t channel)
{
    return track_of(&r->rewriting->from->animations[a], channel) != SIZE_MAX &&
           track_of(&r->rewriting->to->animations[a], channel) == SIZE_MAX;
}

/* The samplers of an animation: after an error the list is short, and the file is not written. */
static int replace_animation(nkwi_rewriter *r, size_t a)
{
    json_t *object = json_array_get(json_object_get(r->root, "animations"), a);
    json_t *channels = json_object_get(object, "channels"), *old = json_object_get(object, "samplers");
    json_t *samplers = json_array(), *kept = json_array();
    int done = 1;
    for (size_t i = 0; done && i < json_array_size(channels); i++)
        if (!is_left_out(r, a, i)) {
            done = replace_channel(r, a, i, old, samplers);
            nkwi_put(&r->sink, kept, json_incref(json_array_get(channels, i)));
        }
    json_array_clear(channels);
    json_array_extend(channels, kept);
    json_decref(kept);
    if (done)
        share_samplers(r, channels, samplers);
    nkwi_set(&r->sink, object, "samplers", samplers);
    return done;
}

/* Whether a track has other arrays in `to`, or is left out. */
static int replaces_any(const nkw_gltf_rewriting *w)
{
    for (size_t a = 0; a < w->from->animation_count; a++) {
        const nkw_document_animation *from = &w->from->animations[a], *to = &w->to->animations[a];
        if (from->track_count != to->track_count)
            return 1;
        for (size_t i = 0; i < from->track_count; i++)
            if (is_replaced(&from->tracks[i].track, &to->tracks[i].track))
                return 1;
    }
    return 0;
}

/*
 * Whether the channels of `to` are some of those of `from`, both in the order of the file, with the same targets. One
 * of an animation remains: an animation without channels is not valid (5.2.1).
 */
static int has_channels_of(const nkw_document_animation *to, const nkw_document_animation *from)
{
    size_t found = 0;
    for (size_t i = 0; found < to->track_count && i < from->track_count; i++)
        found += to->channels[found].number == from->channels[i].number &&
                 to->tracks[found].target == from->tracks[i].target && to->tracks[found].index == from->tracks[i].index;
    return found == to->track_count && (found > 0 || from->track_count == 0);
}

/* Whether both documents have as many animations as the file, and `to` no channels but those of `from`. */
static int matches(const nkw_gltf_rewriting *w, size_t count)
{
    int same = w->from->animation_count == w->to->animation_count && w->from->animation_count == count;
    for (size_t a = 0; same && a < count; a++)
        same = has_channels_of(&w->to->animations[a], &w->from->animations[a]);
    return same;
}

int nkwi_rewriter_animations(nkwi_rewriter *r)
{
    const size_t count = json_array_size(json_object_get(r->root, "animations"));
    if (!matches(r->rewriting, count))
        return nkwi_fail(r->sink.error, NULL, NKW_IMPORT_REFUSED, "other animations than those of the file");
    if (!replaces_any(r->rewriting))
        return 1;
    r->accessor_count = json_array_size(r->sink.accessors);
    r->freed = (unsigned char *)nkwi_take(&r->sink.scratch, r->accessor_count, 1);
    if (!r->freed)
        return nkwi_rewriter_no_memory(r);
    nkwi_rewriter_mark_samplers(r, 1);
    for (size_t a = 0; a < count; a++)
        if (!replace_animation(r, a))
            return 0;
    nkwi_rewriter_mark_samplers(r, 0);
    nkwi_rewriter_keep_others(r);
    nkwi_rewriter_move_accessors(r);
    return !r->sink.failed || nkwi_rewriter_no_memory(r);
}
