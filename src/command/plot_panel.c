/* SPDX-License-Identifier: MIT */
/* What all kinds of plots share: the places of panels, and the joints that are drawn. */
#include <string.h>

#include "plot.h"

svg_box plot_panel(float y, int right)
{
    svg_box box = {60.0f, y + 44.0f, PLOT_PANEL_WIDTH, PLOT_PANEL_HEIGHT};
    box.x += right ? PLOT_PANEL_WIDTH + 70.0f : 0.0f;
    return box;
}

int plot_lists(const plot_request *r, const char *name)
{
    size_t length = strlen(name);
    for (const char *at = r->joints ? strstr(r->joints, name) : NULL; at && length; at = strstr(at + 1, name))
        if ((at == r->joints || at[-1] == ',') && (at[length] == ',' || at[length] == 0))
            return 1;
    return 0;
}

int plot_names(const plot_request *r, const nkw_document *d, size_t joint)
{
    if (!r->joints || plot_lists(r, d->nodes[joint].name))
        return 1;
    for (const char *at = r->joints; *at;) {
        const size_t length = strcspn(at, ",");
        if (input_is_joint(d, joint, at, length))
            return 1;
        at += length + (at[length] == ',');
    }
    return 0;
}
