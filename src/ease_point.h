/* SPDX-License-Identifier: MIT */
/* Floor 3: nkw_ease_point before its rounding. */
#ifndef NAKAWARI_EASE_POINT_H
#define NAKAWARI_EASE_POINT_H

#include <nakawari/ease.h>

#include "handle_solve.h"

handle_point nkwi_ease_point(nkw_ease_kind kind, double t);

#endif
