/* SPDX-License-Identifier: MIT */
/* A clip track by track: what its samples are held against. */
#ifndef NAKAWARI_TESTS_TRACKS_H
#define NAKAWARI_TESTS_TRACKS_H

#include <nakawari/nakawari.h>
#include "views.h"

/* Samples the track at a time into its components of a pose, or into the floats of the clip. */
static inline void track_sample_to(const nkw_clip_track *t, float time, size_t joints, float *pose, float *floats)
{
    if (t->target == NKW_CLIP_FLOATS) {
        nkw_track_sample(&t->track, time, NULL, floats + t->index);
        return;
    }
    nkw_trs trs = nkw_pose_get(pose_view(pose, joints), t->index);
    nkw_track_sample(&t->track, time, NULL, t->target == NKW_CLIP_TRANSLATION ? &trs.translation.x
                     : t->target == NKW_CLIP_ROTATION  ? &trs.rotation.x
                                                       : &trs.scale.x);
    nkw_pose_set(pose_span(pose, joints), t->index, &trs);
}

#endif
