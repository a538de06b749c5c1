/* SPDX-License-Identifier: MIT */
#include "finding.h"

#include <string.h>

#include "json.h"

static const char *const severities[SEVERITIES] = {"note", "warning", "error"};

finding finding_of(severity level, const char *what)
{
    finding f = {level, what, NULL, NULL, -1, -1, -1, -1, 0.0f, 0.0, ""};
    return f;
}

/* file: clip 0 walk: joint arm.L rotation: key 3, 0.5 s: warning: not-unit: its length is 1.1 */
static void put_line(const findings *all, const finding *f)
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
    printf(": %s: %s: %s\n", severities[f->level], f->what, f->detail);
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

void findings_add(findings *all, const finding *f)
{
    if (all->hide_notes && f->level == SEVERITY_NOTE)
        return;
    all->counts[f->level]++;
    all->repeated = same_object(all, f) ? all->repeated + 1 : 0;
    all->last_what = f->what;
    all->last_object = f->object;
    all->last_clip = f->clip;
    all->last_number = f->number;
    if (all->repeated > all->most)
        return;
    finding shown = *f;
    if (all->repeated == all->most)
        snprintf(shown.detail, sizeof shown.detail, "and more of these are not printed");
    progress_end(&all->line);
    if (!all->list)
        put_line(all, &shown);
    else
        all->failed |= json_array_append_new(all->list, to_json(all, &shown)) != 0;
}
