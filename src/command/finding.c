/* SPDX-License-Identifier: MIT */
#include "finding.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "json.h"

static const char *const severities[SEVERITIES] = {"note", "warning", "error"};

finding finding_of(severity level, const char *what)
{
    finding f = {level, what, NULL, NULL, -1, -1, -1, -1, 0.0f, 0.0, ""};
    return f;
}

static const char *const kinds[] = {"absent-image",
                                    "added-keys",
                                    "animated-matrix",
                                    "as-read",
                                    "bad-weight",
                                    "constant",
                                    "duplicate-time",
                                    "empty-scene",
                                    "equal-names",
                                    "half-turn",
                                    "joint-out-of-range",
                                    "joint-outside-scene",
                                    "long-way",
                                    "negative-time",
                                    "non-positive-scale",
                                    "not-affine",
                                    "not-finite",
                                    "not-unit",
                                    "open-loop",
                                    "outlier-time",
                                    "over-half-turn",
                                    "overshoot",
                                    "refused",
                                    "root-drift",
                                    "rounded-unit",
                                    "scaled-matrix",
                                    "short-segment",
                                    "sign-flip",
                                    "singular-matrix",
                                    "sliding-foot",
                                    "spare-keys",
                                    "spike",
                                    "transposed-matrix",
                                    "unread-channel",
                                    "unsorted-time",
                                    "unused-joint-out-of-range",
                                    "velocity-seam",
                                    "weights-sum",
                                    "wrong-bounds",
                                    "wrong-skeleton"};

int finding_is_kind(const char *what, size_t length)
{
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++)
        if (strlen(kinds[i]) == length && memcmp(kinds[i], what, length) == 0)
            return 1;
    return 0;
}

/* How bad a finding is among those of its kind. */
static double badness(const finding *f)
{
    const int is_one = strcmp(f->what, "not-unit") == 0 || strcmp(f->what, "weights-sum") == 0;
    const double off = fabs(is_one ? f->amount - 1.0 : f->amount);
    return isnan(off) ? (double)INFINITY : off;
}

/* file: clip 0 walk: joint arm.L rotation: key 3, 0.5 s: warning: not-unit: its length is 1.1 (the worst of 3) */
static void put_line(const findings *all, const finding *f, size_t count)
{
    output_text(stdout, all->document->file);
    if (f->clip >= 0) {
        printf(": clip %ld ", f->clip);
        output_text(stdout, input_clip_name(all->document, (size_t)f->clip));
    }
    if (f->joint) {
        printf(": %s ", f->clip >= 0 ? "joint" : f->object);
        output_text(stdout, f->joint);
        if (f->clip >= 0 && f->object)
            printf(" %s", f->object);
    }
    if (f->key >= 0)
        printf(": key %ld, %.9g s", f->key, (double)f->time);
    if (f->vertex >= 0)
        printf(": vertex %ld", f->vertex);
    printf(": %s: %s: %s", severities[f->level], f->what, f->detail);
    if (count > 1)
        printf(" (the worst of %zu)", count);
    putchar('\n');
}

static json_t *number_or_null(long number)
{
    return number >= 0 ? json_integer(number) : json_null();
}

static json_t *to_json(const findings *all, const finding *f)
{
    return json_pack("{s:o, s:s, s:s, s:o, s:o, s:o, s:o, s:o, s:o, s:o, s:o, s:o}", "file",
                     json_text(all->document->file), "severity", severities[f->level], "what", f->what, "clip",
                     number_or_null(f->clip), "object", f->object ? json_text(f->object) : json_null(), "name",
                     f->joint ? json_text(f->joint) : json_null(), "number", number_or_null(f->number), "key",
                     number_or_null(f->key), "time", f->key >= 0 ? json_number((double)f->time) : json_null(), "vertex",
                     number_or_null(f->vertex), "amount", json_number(f->amount), "detail", json_text(f->detail));
}

static int same_object(const findings *all, const finding *f)
{
    return all->last_what && strcmp(all->last_what, f->what) == 0 && all->last_object == f->object &&
           all->last_clip == f->clip && all->last_number == f->number;
}

/* Whether a kind is among those that are asked for. */
static int is_asked(const findings *all, const char *what)
{
    const size_t length = strlen(what);
    for (const char *word = all->only; word;) {
        if (strncmp(word, what, length) == 0 && (word[length] == ',' || word[length] == 0))
            return 1;
        word = strchr(word, ',');
        word = word ? word + 1 : NULL;
    }
    return !all->only;
}

/* Counts the finding, and keeps it if it is the worst of its kind. */
static void sum_up(findings *all, const finding *f)
{
    size_t i = 0;
    while (i < all->kind_count && (all->kinds[i].worst.level != f->level || strcmp(all->kinds[i].worst.what, f->what)))
        i++;
    if (i == FINDING_KINDS)
        return;
    finding_kind *kind = &all->kinds[i];
    if (i == all->kind_count || badness(f) > badness(&kind->worst))
        kind->worst = *f;
    all->kind_count += i == all->kind_count;
    kind->count++;
}

static int by_severity(const void *a, const void *b)
{
    const finding_kind *x = a, *y = b;
    if (x->worst.level != y->worst.level)
        return x->worst.level > y->worst.level ? -1 : 1;
    return x->count != y->count ? (x->count > y->count ? -1 : 1) : strcmp(x->worst.what, y->worst.what);
}

void findings_end(findings *all)
{
    qsort(all->kinds, all->kind_count, sizeof *all->kinds, by_severity);
    for (size_t i = 0; all->sums_up && i < all->kind_count; i++)
        put_line(all, &all->kinds[i].worst, all->kinds[i].count);
}

json_t *findings_kinds(const findings *all)
{
    json_t *list = json_array();
    for (size_t i = 0; i < all->kind_count; i++)
        json_array_append_new(list, json_pack("{s:s, s:s, s:I}", "what", all->kinds[i].worst.what, "severity",
                                              severities[all->kinds[i].worst.level], "count",
                                              (json_int_t)all->kinds[i].count));
    return list;
}

void findings_add(findings *all, const finding *f)
{
    if ((all->hide_notes && f->level == SEVERITY_NOTE) || !is_asked(all, f->what))
        return;
    sum_up(all, f);
    all->counts[f->level]++;
    all->repeated = same_object(all, f) ? all->repeated + 1 : 0;
    all->last_what = f->what;
    all->last_object = f->object;
    all->last_clip = f->clip;
    all->last_number = f->number;
    if (all->sums_up || all->repeated > all->most)
        return;
    finding shown = *f;
    if (all->repeated == all->most)
        snprintf(shown.detail, sizeof shown.detail, "and more of these are not printed");
    progress_end(&all->line);
    if (!all->list)
        put_line(all, &shown, 1);
    else
        all->failed |= json_array_append_new(all->list, to_json(all, &shown)) != 0;
}
