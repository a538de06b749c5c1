/* SPDX-License-Identifier: MIT */
/* The arrays of a motion of a rotation, for tests. */
#ifndef NAKAWARI_TESTS_MOTION_SPAN_H
#define NAKAWARI_TESTS_MOTION_SPAN_H

#include <nakawari/types.h>

static inline nkw_motion_span quat_motion_span(nkw_quat_motion *m)
{
    nkw_motion_span span = {&m->value.x, &m->velocity.x, &m->acceleration.x};
    return span;
}

#endif
