/* SPDX-License-Identifier: MIT */
/*
 * Matrix keys of X in its text form. Assimp takes the lengths of the columns for the scale and the rest for a rotation,
 * so a mirror is lost. The matrices are read again from the file; a key that mirrors gets the rotation and the negative
 * scale x of its matrix.
 *
 *     AnimationSet NAME { Animation { {FRAME} AnimationKey { 4; n; time; 16; m0, ... m15;;, ... } } }
 *
 * Rows of a matrix for row vectors are the columns of that for column vectors. X is left-handed: of the matrix M the
 * document has S M S, S = diag(1, 1, -1, 1), as Assimp does.
 */
#include <math.h>
#include <string.h>

#include <nakawari/transform.h>

#include "assimp.h"
#include "decimal.h"

/* A part of the text: a word, a brace, or a text in quotes without them; bytes 0 at the end. */
typedef struct token {
    const char *text;
    size_t bytes;
} token;

typedef struct scanner {
    const char *at, *end;
} scanner;

static int ends_word(char c)
{
    return (unsigned char)c <= ' ' || strchr(",;{}\"", c) != NULL;
}

/* Blanks, separators, and comments, which begin with # or // and end with the line. */
static void skip_blanks(scanner *s)
{
    while (s->at < s->end) {
        const int slashes = s->end - s->at > 1 && s->at[0] == '/' && s->at[1] == '/';
        if (*s->at == '#' || slashes)
            while (s->at < s->end && *s->at != '\n')
                s->at++;
        else if ((unsigned char)*s->at <= ' ' || *s->at == ',' || *s->at == ';')
            s->at++;
        else
            return;
    }
}

static token next(scanner *s)
{
    skip_blanks(s);
    token t = {s->at, 0};
    if (s->at == s->end)
        return t;
    if (*s->at == '"') {
        const char *close = (const char *)memchr(s->at + 1, '"', (size_t)(s->end - s->at) - 1);
        t.text++;
        t.bytes = (size_t)((close ? close : s->end) - t.text);
        s->at = close ? close + 1 : s->end;
        t.bytes += close && t.bytes == 0; /* "" is not the end of the text: it is a quote */
        return t;
    }
    do
        s->at++;
    while (s->at < s->end && *t.text != '{' && *t.text != '}' && !ends_word(*s->at));
    t.bytes = (size_t)(s->at - t.text);
    return t;
}

static int is(token t, const char *word)
{
    return t.bytes == strlen(word) && memcmp(t.text, word, t.bytes) == 0;
}

/* Up to the brace that closes `depth` blocks. */
static void skip_blocks(scanner *s, size_t depth)
{
    for (token t; depth > 0 && (t = next(s)).bytes > 0;)
        depth += is(t, "{") ? 1 : is(t, "}") ? (size_t)-1 : 0;
}

/* The brace that opens a block, after a name if there is one. */
static int opens(scanner *s)
{
    token t = next(s);
    if (!is(t, "{"))
        t = next(s);
    return is(t, "{");
}

static int number(scanner *s, double *out)
{
    const token t = next(s);
    return t.bytes > 0 && nkwi_decimal(t.text, t.bytes, out) == NULL;
}

/* ---- keys ---- */

/* The matrix keys of an Animation: their number, and where the first begins. */
typedef struct matrix_keys {
    char frame[256];
    scanner first;
    size_t count, blocks; /* blocks: how many AnimationKey of matrices there are */
} matrix_keys;

static int next_matrix(scanner *s, nkw_trs *out)
{
    double time, sixteen, value;
    nkw_mat4 m;
    if (!number(s, &time) || !number(s, &sixteen) || sixteen != 16.0)
        return 0;
    for (int i = 0; i < 16; i++) {
        if (!number(s, &value))
            return 0;
        m.m[i] = (float)((i % 4 == 2) != (i / 4 == 2) ? -value : value);
    }
    *out = nkw_trs_from_mat4(&m);
    return 1;
}

/* A track of the joint with as many keys as the file has matrices; NULL without one. */
static const nkw_track *track_of(const nkw_document_animation *a, int32_t joint, nkw_clip_target target, size_t count)
{
    for (size_t i = 0; i < a->track_count; i++)
        if (a->channels[i].joint == joint && a->tracks[i].target == target)
            return a->tracks[i].track.count == count ? &a->tracks[i].track : NULL;
    return NULL;
}

/* Whether a scale has these lengths: the key is that of the matrix. */
static int has_lengths(const float *lengths, nkw_vec3 scale)
{
    return fabsf(lengths[0] + scale.x) <= 1e-4f * lengths[0] && fabsf(lengths[1] - scale.y) <= 1e-4f * lengths[1] &&
           fabsf(lengths[2] - scale.z) <= 1e-4f * lengths[2];
}

/* The keys of one Animation. Returns 0 without memory for the warning. */
static int mirror_keys(nkwi_assimp *a, const nkw_document_animation *animation, const matrix_keys *keys)
{
    const int32_t node = nkwi_assimp_find(a, keys->frame);
    if (node == NKW_NO_JOINT || keys->blocks != 1)
        return 1;
    const int32_t joint = nkwi_assimp_joint(a, node);
    const nkw_track *turns = track_of(animation, joint, NKW_CLIP_ROTATION, keys->count);
    const nkw_track *scales = track_of(animation, joint, NKW_CLIP_SCALE, keys->count);
    scanner s = keys->first;
    size_t mirrored = 0;
    nkw_trs trs;
    for (size_t k = 0; turns && scales && k < keys->count && next_matrix(&s, &trs); k++) {
        float *turn = (float *)turns->values + 4 * k, *scale = (float *)scales->values + 3 * k;
        if (!(trs.scale.x < 0.0f) || !has_lengths(scale, trs.scale))
            continue;
        memcpy(turn, &trs.rotation, 4 * sizeof *turn);
        memcpy(scale, &trs.scale, 3 * sizeof *scale);
        mirrored++;
    }
    for (size_t k = 1; mirrored > 0 && k < keys->count; k++) { /* the sign follows the key before */
        float *q = (float *)turns->values + 4 * k;
        const float sign = q[0] * q[-4] + q[1] * q[-3] + q[2] * q[-2] + q[3] * q[-1] < 0.0f ? -1.0f : 1.0f;
        for (int i = 0; i < 4; i++)
            q[i] *= sign;
    }
    return mirrored == 0 ||
           nkwi_document_warn(a->document, a->error, "joint %.60s: %zu keys mirror: they have a negative scale x",
                              a->document->all.nodes[joint].name, mirrored);
}

/* ---- blocks ---- */

/* After the word AnimationKey. */
static int read_key(scanner *s, matrix_keys *keys)
{
    double kind, count;
    if (!opens(s) || !number(s, &kind) || !number(s, &count))
        return 0;
    if ((kind == 3.0 || kind == 4.0) && count >= 1.0 && count < 1e9) {
        keys->first = *s;
        keys->count = (size_t)count;
        keys->blocks++;
    }
    skip_blocks(s, 1);
    return 1;
}

/* After the word Animation: its block. */
static int read_animation(scanner *s, matrix_keys *keys)
{
    memset(keys, 0, sizeof *keys);
    if (!opens(s))
        return 0;
    for (token t; (t = next(s)).bytes > 0 && !is(t, "}");) {
        if (is(t, "AnimationKey")) {
            if (!read_key(s, keys))
                return 0;
            continue;
        }
        if (is(t, "{")) { /* {FRAME} */
            t = next(s);
            const size_t bytes = t.bytes < sizeof keys->frame ? t.bytes : 0;
            memcpy(keys->frame, t.text, bytes);
            keys->frame[bytes] = 0;
        } else if (!opens(s))
            return 0;
        skip_blocks(s, 1);
    }
    return 1;
}

/* The animation `*number` of the document is the next set that is not empty. */
static int read_set(nkwi_assimp *a, scanner *s, size_t *number)
{
    const nkw_document *d = &a->document->all;
    size_t found = 0;
    for (token t; (t = next(s)).bytes > 0 && !is(t, "}");) {
        matrix_keys keys;
        if (is(t, "{"))
            skip_blocks(s, 1);
        if (!is(t, "Animation"))
            continue;
        if (!read_animation(s, &keys))
            return 1;
        found++;
        if (*number < d->animation_count && !mirror_keys(a, &d->animations[*number], &keys))
            return 0;
    }
    *number += found > 0;
    return 1;
}

int nkwi_assimp_x_mirrors(nkwi_assimp *a, const nkw_import_memory *memory)
{
    const char *text = (const char *)memory->data;
    if (memory->bytes < 16 || memcmp(text, "xof ", 4) != 0 || memcmp(text + 8, "txt ", 4) != 0)
        return 1;
    scanner s = {text + 16, text + memory->bytes};
    size_t number_of_set = 0;
    for (token t; (t = next(&s)).bytes > 0;) {
        if (is(t, "{"))
            skip_blocks(&s, 1);
        else if (is(t, "AnimationSet") && (!opens(&s) || !read_set(a, &s, &number_of_set)))
            return a->error->code == NKW_IMPORT_OK;
    }
    return 1;
}
