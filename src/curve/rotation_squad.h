/* SPDX-License-Identifier: MIT */
/* Quaternions with their first two derivatives by t. */
#ifndef NAKAWARI_ROTATION_SQUAD_H
#define NAKAWARI_ROTATION_SQUAD_H

#include "lane/strict.h"

#include <nakawari/rotation.h>

#include "lane/quat.h"

typedef struct rotation_jet {
    lane_f64_quat q, d, dd;
} rotation_jet;

/* slerp(slerp(c0, c3, t), slerp(c1, c2, t), 2 t (1 - t)), along the arcs as given. */
rotation_jet nkwi_rotation_squad_at(const lane_f64_quat c[4], double t);

#endif
