/* SPDX-License-Identifier: MIT */
/* A file that is read, and played. */
#ifndef NAKAWARI_TESTS_MOMENT_H
#define NAKAWARI_TESTS_MOMENT_H

#include <stdlib.h>

#include <nakawari/pose.h>
#include <nakawari/quat.h>
#include <nakawari/scalar.h>

#include "documents.h"
#include "views.h"

enum { JOINTS = 64 };

/* A document at a time of its first animation; without animations at rest. */
typedef struct moment {
    nkw_document *d;
    nkw_clip *clip;
    float pose[NKW_POSE_FLOATS(JOINTS)];
    nkw_mat4 models[JOINTS], palette[JOINTS];
} moment;

static inline moment *open_file(const char *path)
{
    nkw_import_error error;
    moment *m = (moment *)calloc(1, sizeof *m);
    assert_non_null(m);
    if (nkw_document_open(path, &m->d, &error) != NKW_IMPORT_OK)
        print_error("%s:%s: %s\n", error.file, error.place, error.reason);
    assert_non_null(m->d);
    assert_int_equal(nkw_document_validate(m->d, &error), NKW_IMPORT_OK);
    assert_in_range(m->d->skeleton.joint_count, 1, JOINTS);
    assert_int_equal(nkw_document_clip(m->d, 0, NKW_CLIP_FLOAT32, &m->clip, &error), NKW_IMPORT_OK);
    return m;
}

static inline void close_file(moment *m)
{
    nkw_import_free(m->clip);
    nkw_document_close(m->d);
    free(m);
}

static inline void play(moment *m, float time)
{
    size_t joints = m->d->skeleton.joint_count;
    assert_int_equal(nkw_clip_sample(m->clip, time, NULL, pose_span(m->pose, joints), NULL), NKW_OK);
    assert_int_equal(nkw_document_models(m->d, pose_view(m->pose, joints), NULL, m->models), NKW_OK);
    if (m->d->skin_count > 0)
        assert_int_equal(nkw_document_palette(m->d, 0, m->models, m->palette), NKW_OK);
}

static inline size_t joint(const moment *m, const char *name)
{
    size_t j = 0;
    while (j < m->d->skeleton.joint_count && strcmp(m->d->nodes[j].name, name) != 0)
        j++;
    assert_in_range(j, 0, m->d->skeleton.joint_count - 1);
    return j;
}

static inline nkw_trs local(const moment *m, const char *name)
{
    return nkw_pose_get(pose_view(m->pose, m->d->skeleton.joint_count), joint(m, name));
}

static inline nkw_vec3 at(float x, float y, float z)
{
    const nkw_vec3 v = {x, y, z};
    return v;
}

/* Rotations about an axis, in degrees. */
static inline nkw_quat turn(char axis, float degrees)
{
    return nkw_quat_from_axis_angle(at(axis == 'x', axis == 'y', axis == 'z'), nkw_radians_from_degrees(degrees));
}

#endif
