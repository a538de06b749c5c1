/* SPDX-License-Identifier: MIT */
/* Nkw_ease_point before its rounding, and the keywords of CSS. */
#ifndef NAKAWARI_EASE_POINT_H
#define NAKAWARI_EASE_POINT_H

#include <nakawari/ease.h>

#include "handle_solve.h"

/* The control points x1, y1, x2, y2 of a keyword of CSS; NULL for other kinds. */
const float *nkwi_ease_css(nkw_ease_kind kind);
handle_point nkwi_ease_point(nkw_ease_kind kind, double t);

#endif
