/* SPDX-License-Identifier: MIT */
/** @file What the kinds of `nakawari plot` share. */
#ifndef PLOT_H
#define PLOT_H

#include <nakawari/euler.h>

#include "chart.h"
#include "moment.h"

/** What is drawn: the channels of one target, of all; or of rotations, or of joints, something else. */
typedef enum plot_what { PLOT_ALL = -1, PLOT_PATH = 4, PLOT_EULER = 5 } plot_what;

typedef struct plot_request {
    char *clip, *joints, *what, *output, *order;
    int target; /**< one of nkw_clip_target or plot_what */
    nkw_euler_order euler;
    long most;
    int watch;
} plot_request;

enum { PLOT_TOP = 70, PLOT_ROW = 210, PLOT_PANEL_WIDTH = 470, PLOT_PANEL_HEIGHT = 130 };

/** Whether the list of joints has a name as it is, commas included. */
int plot_lists(const plot_request *r, const char *name);
/** Whether the list of joints has the name or the number of a joint; every one if there is no list. */
int plot_names(const plot_request *r, const nkw_document *document, size_t joint);

/** The two panels of a row at a y of the page. */
svg_box plot_panel(float y, int right);

/** A row of the page: the Euler angles of a channel, and of its keys interpolated; the angle between. */
int plot_euler(page *p, const plot_request *r, const nkw_clip_track *track, svg_axis time, float y);

/** The size of a page with paths. */
svg_point plot_path_size(void);
/** The paths of joints, from above, the front, the side and the camera. Returns 0 without memory. */
int plot_path(page *p, const plot_request *r, moment *m);

#endif
