/* SPDX-License-Identifier: MIT */
/*
 * Keys of angles that turn by half a turn or more. As quaternions two keys only have the shorter arc between them: yaw
 * 0 -> 270 would turn backwards, 270 -> 630 not at all.
 */
#include <math.h>
#include <string.h>

#include <nakawari/euler.h>
#include <nakawari/scalar.h>
#include <nakawari/vec.h>

#include "keys.h"

/* Half a turn, except for the rounding of angles; and the most that a part between two keys turns by. */
#define HALF_TURN    3.1415896f
#define QUARTER_TURN 1.5707964f
/* The most keys between two rows: 16,384 turns. */
#define PARTS_MOST 65536.0f

void nkwi_entry_turn(nkwi_entry *e, nkw_vec3 angles)
{
    const nkw_quat q = nkw_quat_from_euler(angles, NKW_EULER_YXZ);
    memcpy(e->numbers + nkwi_keys_first[NKW_CLIP_ROTATION], &q, sizeof q);
    e->angles = angles;
    e->has_angles = 1;
}

/* The parts of equal length between two rows: 1, if nothing is added. More than PARTS_MOST: too many. */
static float parts_between(const nkwi_row *a, const nkwi_row *b)
{
    if (!a->has_angles || !b->has_angles)
        return 1.0f;
    const nkw_vec3 d = nkw_vec3_sub(b->angles, a->angles);
    const float most = nkw_max(nkw_abs(d.x), nkw_max(nkw_abs(d.y), nkw_abs(d.z)));
    return most >= HALF_TURN ? ceilf(most / QUARTER_TURN) : 1.0f;
}

static int has_rotation(const nkwi_row *r)
{
    return (int)(r->has >> NKW_CLIP_ROTATION & 1);
}

int nkwi_keys_check_turns(nkwi_keys *k, size_t from, size_t to)
{
    const nkwi_row *last = NULL;
    for (size_t i = from; i < to; i++) {
        const nkwi_row *row = &k->rows[i];
        if (!has_rotation(row))
            continue;
        k->line = row->line;
        if (last && !(parts_between(last, row) <= PARTS_MOST))
            return nkwi_keys_fail(k, "yaw", NKW_IMPORT_TOO_LARGE, "more than 16384 turns from the row before");
        last = row;
    }
    return 1;
}

/* The key at the part t of the line between two rows. */
static void put_between(const nkwi_row *a, const nkwi_row *b, float t, float *time, float *value)
{
    const nkw_quat q = nkw_quat_from_euler(nkw_vec3_lerp(a->angles, b->angles, t), NKW_EULER_YXZ);
    *time = nkw_lerp(a->time, b->time, t);
    memcpy(value, &q, sizeof q);
}

size_t nkwi_keys_turns(const nkwi_keys *k, size_t from, size_t to, float *times, float *values)
{
    const nkwi_row *last = NULL;
    size_t count = 0;
    for (size_t i = from; i < to; i++) {
        const nkwi_row *row = &k->rows[i];
        if (!has_rotation(row))
            continue;
        const float parts = last ? parts_between(last, row) : 1.0f;
        for (float p = 1.0f; p < parts; p += 1.0f, count++)
            if (times)
                put_between(last, row, p / parts, times + count, values + 4 * count);
        if (times) {
            times[count] = row->time;
            memcpy(values + 4 * count, k->numbers + row->numbers + nkwi_keys_first[NKW_CLIP_ROTATION],
                   4 * sizeof *values);
        }
        count++;
        last = row;
    }
    return count;
}
