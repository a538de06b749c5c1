/* SPDX-License-Identifier: MIT */
#include "space.h"

#include <string.h>

int space_unit(const char *text, float *metres)
{
    static const struct {
        const char *name;
        float metres;
    } units[] = {{"keep", 0.0f},  {"m", 1.0f},     {"cm", 0.01f},   {"mm", 0.001f},
                 {"km", 1000.0f}, {"in", 0.0254f}, {"ft", 0.3048f}, {"yd", 0.9144f}};
    for (size_t i = 0; i < sizeof units / sizeof *units; i++)
        if (strcmp(text, units[i].name) == 0) {
            *metres = units[i].metres;
            return 1;
        }
    return 0;
}

int space_has_axes(const nkw_document *d)
{
    return nkw_axes_map_is_valid(nkw_axes_map_from_axes(d->space.axes, d->space.axes));
}

nkw_vec3 space_up(const nkw_document *d)
{
    const nkw_axes gltf = NKW_AXES_GLTF;
    const nkw_vec3 y = {0.0f, 1.0f, 0.0f};
    return space_has_axes(d) ? nkw_axes_convert_vec3(nkw_axes_map_from_axes(gltf, d->space.axes), y) : y;
}

const char *space_axis(nkw_axis axis)
{
    static const char *const names[] = {"-z", "-y", "-x", "", "x", "y", "z"};
    return axis >= NKW_AXIS_NEGATIVE_Z && axis <= NKW_AXIS_Z ? names[axis + 3] : "";
}

int space_print(FILE *out, const nkw_document *d)
{
    const int has_axes = space_has_axes(d), has_unit = d->space.metres > 0.0f;
    const nkw_axes axes = d->space.axes;
    if (has_axes)
        fprintf(out, "axes up %s, forward %s, right %s", space_axis(axes.up), space_axis(axes.forward),
                space_axis(axes.right));
    if (has_unit)
        fprintf(out, "%sa unit is %.6g m", has_axes ? "; " : "", (double)d->space.metres);
    return has_axes || has_unit;
}
