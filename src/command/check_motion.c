/* SPDX-License-Identifier: MIT */
/* A clip as a whole: whether its end meets its start, and feet that slide. */
#include <ctype.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <nakawari/mat.h>
#include <nakawari/vec.h>

#include "check.h"
#include "distance.h"
#include "moment.h"
#include "space.h"

static finding finding_of_joint(const check *c, size_t animation, size_t joint, const char *what)
{
    finding f = finding_of(SEVERITY_NOTE, what);
    f.clip = (long)animation;
    f.joint = c->document->nodes[joint].name;
    f.number = (long)c->document->nodes[joint].number;
    return f;
}

static nkw_vec3 place_of(const nkw_mat4 *m)
{
    const nkw_vec3 p = {m->m[12], m->m[13], m->m[14]};
    return p;
}

/* ---- the ends ---- */

/* The largest distance that remains if the joints that move by `step` had not. */
static double remaining(const check *c, const nkw_mat4 *first, const nkw_mat4 *last, nkw_vec3 step)
{
    double worst = 0.0;
    for (size_t j = 0; j < c->document->skeleton.joint_count; j++) {
        nkw_mat4 back = last[j];
        back.m[12] -= step.x, back.m[13] -= step.y, back.m[14] -= step.z;
        worst = fmax(worst, fmin(matrix_distance(&first[j], &last[j], c->extent.reach[j]),
                                 matrix_distance(&first[j], &back, c->extent.reach[j])));
    }
    return worst;
}

/*
 * The joint with the largest distance, of those that rounding alone distinguishes the first: parents are first. Returns
 * whether the clip closes, but for a step of its root.
 */
static int compare_ends(check *c, size_t animation, const nkw_mat4 *first, const nkw_mat4 *last)
{
    double worst = 0.0;
    size_t at = 0;
    for (size_t j = 0; j < c->document->skeleton.joint_count; j++) {
        double distance = matrix_distance(&first[j], &last[j], c->extent.reach[j]);
        if (distance > worst * (1.0 + 1e-5)) {
            worst = distance;
            at = j;
        }
    }
    if (worst <= (double)c->tolerance)
        return 1;
    const nkw_vec3 step = nkw_vec3_sub(place_of(&last[at]), place_of(&first[at]));
    const double left = remaining(c, first, last, step);
    const int drifts = left <= fmax((double)c->tolerance, 0.05 * worst);
    finding f = finding_of_joint(c, animation, at, drifts ? "root-drift" : "open-loop");
    f.amount = worst;
    if (drifts)
        snprintf(f.detail, sizeof f.detail, "it moves by %.6g %.6g %.6g from start to end; the rest closes within %.2g",
                 (double)step.x, (double)step.y, (double)step.z, left);
    else
        snprintf(f.detail, sizeof f.detail, "the end of the clip is %.6g from its start, %.3g of the model's size",
                 worst, worst / (double)c->extent.size);
    findings_add(&c->found, &f);
    return drifts;
}

/* ---- the way between ---- */

/* Points at equal times: POINTS of each joint, in model space. */
enum { POINTS = 3, STEPS_LEAST = 16, STEPS_MOST = 1024 };

typedef struct course {
    const check *c;
    moment *m;
    size_t animation, joints, steps;
    double step; /* seconds */
    nkw_vec3 up; /* unit, of the file */
    nkw_vec3 *now, *before, *earlier; /* POINTS of each joint */
    nkw_vec3 *head; /* those of the first step, and of the start */
    double *jumps; /* of each joint: the largest change of a step */
    struct foot {
        double low, high, slide, path;
    } * feet;
} course;

/* The origin of a joint, and two points at its reach. */
static void place_points(course *w, nkw_vec3 *points)
{
    for (size_t j = 0; j < w->joints; j++) {
        const float reach = w->c->extent.reach[j];
        const nkw_vec3 x = {reach, 0.0f, 0.0f}, y = {0.0f, reach, 0.0f};
        points[POINTS * j] = place_of(&w->m->models[j]);
        points[POINTS * j + 1] = nkw_mat4_transform_point(&w->m->models[j], x);
        points[POINTS * j + 2] = nkw_mat4_transform_point(&w->m->models[j], y);
    }
}

/* How much the step b..c differs from the step a..b. */
static double change_of(const nkw_vec3 *a, const nkw_vec3 *b, const nkw_vec3 *c)
{
    double most = 0.0;
    for (int i = 0; i < POINTS; i++)
        most = fmax(most, (double)nkw_vec3_length(nkw_vec3_sub(nkw_vec3_sub(c[i], b[i]), nkw_vec3_sub(b[i], a[i]))));
    return most;
}

static void take_step(course *w, size_t k)
{
    const nkw_clip_description d = nkw_clip_describe(w->m->clip);
    nkw_vec3 *oldest = w->earlier;
    w->earlier = w->before;
    w->before = w->now;
    w->now = oldest;
    moment_at(w->m, k == w->steps ? d.end : (float)((double)d.start + (double)k * w->step));
    place_points(w, w->now);
    if (k < 2)
        memcpy(w->head + k * POINTS * w->joints, w->now, POINTS * w->joints * sizeof *w->now);
    for (size_t j = 0; k >= 2 && j < w->joints; j++)
        w->jumps[j] =
            fmax(w->jumps[j], change_of(w->earlier + POINTS * j, w->before + POINTS * j, w->now + POINTS * j));
}

/* The step after the last one is the first one: a change three times as large as any other. */
static void check_seam(check *c, const course *w)
{
    double worst = 0.0;
    size_t at = 0;
    for (size_t j = 0; j < w->joints; j++) {
        const nkw_vec3 *start = w->head + POINTS * j, *first = start + POINTS * w->joints;
        nkw_vec3 next[POINTS];
        for (int i = 0; i < POINTS; i++)
            next[i] = nkw_vec3_add(w->now[POINTS * j + (size_t)i], nkw_vec3_sub(first[i], start[i]));
        const double jump = change_of(w->before + POINTS * j, w->now + POINTS * j, next);
        if (jump > 3.0 * w->jumps[j] + (double)c->tolerance && jump > worst * (1.0 + 1e-5)) {
            worst = jump;
            at = j;
        }
    }
    if (worst == 0.0)
        return;
    finding f = finding_of_joint(c, w->animation, at, "velocity-seam");
    f.amount = worst / w->step;
    snprintf(f.detail, sizeof f.detail, "from the end to the start its velocity changes by %.3g in a second", f.amount);
    findings_add(&c->found, &f);
}

/* ---- feet ---- */

static int is_foot(const char *name)
{
    static const char *const words[] = {"foot", "toe", "ankle"};
    for (; *name; name++)
        for (size_t i = 0; i < sizeof words / sizeof *words; i++) {
            size_t n = 0;
            while (words[i][n] && tolower((unsigned char)name[n]) == words[i][n])
                n++;
            if (!words[i][n])
                return 1;
        }
    return 0;
}

/* up: an axis or its negative. */
static double height_of(const course *w, nkw_vec3 p)
{
    return (double)p.x * (double)w->up.x + (double)p.y * (double)w->up.y + (double)p.z * (double)w->up.z;
}

static double along_ground(const course *w, nkw_vec3 a, nkw_vec3 b)
{
    const double x = (double)b.x - (double)a.x, y = (double)b.y - (double)a.y, z = (double)b.z - (double)a.z;
    const double rise = height_of(w, b) - height_of(w, a);
    return sqrt(fmax(x * x + y * y + z * z - rise * rise, 0.0));
}

/* A joint is on the ground in the lowest tenth of its heights. */
static void follow_feet(course *w, size_t k)
{
    for (size_t j = 0; k > 0 && j < w->joints; j++) {
        struct foot *foot = &w->feet[j];
        const double limit = foot->low + 0.1 * (foot->high - foot->low) + 0.002 * (double)w->c->extent.size;
        const nkw_vec3 from = w->before[POINTS * j], to = w->now[POINTS * j];
        const double way = along_ground(w, from, to);
        foot->path += way;
        foot->slide += fmax(height_of(w, from), height_of(w, to)) <= limit ? way : 0.0;
    }
}

static void note_heights(course *w, size_t k)
{
    for (size_t j = 0; j < w->joints; j++) {
        struct foot *foot = &w->feet[j];
        const double height = height_of(w, w->now[POINTS * j]);
        foot->low = k ? fmin(foot->low, height) : height;
        foot->high = k ? fmax(foot->high, height) : height;
    }
}

/* Of a clip that travels: in place every foot slides. */
static void check_feet(check *c, course *w)
{
    double travel = 0.0;
    for (size_t j = 0; j < w->joints; j++)
        travel = fmax(travel, along_ground(w, w->head[POINTS * j], w->now[POINTS * j]));
    if (travel < 0.2 * (double)c->extent.size)
        return;
    for (size_t k = 0; k <= w->steps; k++) {
        take_step(w, k);
        follow_feet(w, k);
    }
    for (size_t j = 0; j < w->joints; j++) {
        const struct foot *foot = &w->feet[j];
        if (!is_foot(c->document->nodes[j].name) || foot->slide < 0.3 * foot->path ||
            foot->slide < 0.05 * (double)c->extent.size)
            continue;
        finding f = finding_of_joint(c, w->animation, j, "sliding-foot");
        f.amount = foot->slide;
        snprintf(f.detail, sizeof f.detail, "on the ground it slides by %.3g of the %.3g that it moves", foot->slide,
                 foot->path);
        findings_add(&c->found, &f);
    }
}

/* ---- the clip ---- */

static int begin_course(course *w, check *c, moment *m, size_t animation)
{
    const nkw_clip_description d = nkw_clip_describe(m->clip);
    const double length = (double)d.end - (double)d.start;
    const size_t joints = c->document->skeleton.joint_count;
    memset(w, 0, sizeof *w);
    w->c = c;
    w->m = m;
    w->animation = animation;
    w->joints = joints;
    w->up = space_up(c->document);
    w->steps = (size_t)fmin(fmax(60.0 * length, (double)STEPS_LEAST), (double)STEPS_MOST);
    w->step = length / (double)w->steps;
    w->now = calloc(POINTS * joints, sizeof *w->now);
    w->before = calloc(POINTS * joints, sizeof *w->now);
    w->earlier = calloc(POINTS * joints, sizeof *w->now);
    w->head = calloc(2 * POINTS * joints, sizeof *w->now);
    w->jumps = calloc(joints, sizeof *w->jumps);
    w->feet = calloc(joints, sizeof *w->feet);
    return w->now && w->before && w->earlier && w->head && w->jumps && w->feet;
}

static void end_course(course *w)
{
    free(w->now);
    free(w->before);
    free(w->earlier);
    free(w->head);
    free(w->jumps);
    free(w->feet);
}

static void follow_clip(check *c, moment *m, size_t animation, int closes)
{
    course w;
    if (begin_course(&w, c, m, animation)) {
        for (size_t k = 0; k <= w.steps; k++) {
            take_step(&w, k);
            note_heights(&w, k);
        }
        if (closes)
            check_seam(c, &w);
        check_feet(c, &w);
    } else
        c->found.failed = 1;
    end_course(&w);
}

void check_motion(check *c, size_t animation)
{
    const size_t joints = c->document->skeleton.joint_count;
    moment m;
    nkw_mat4 *first = calloc(joints, sizeof *first);
    if (moment_open(&m, c->document, animation) && first) {
        const nkw_clip_description d = nkw_clip_describe(m.clip);
        moment_at(&m, d.start);
        memcpy(first, m.models, joints * sizeof *first);
        moment_at(&m, d.end);
        const int closes = compare_ends(c, animation, first, m.models);
        if (d.end > d.start)
            follow_clip(c, &m, animation, closes);
    } else
        c->found.failed = 1;
    moment_close(&m);
    free(first);
}
