/* SPDX-License-Identifier: MIT */
/*
 * Scenes: JSON whose members are lists of keys, as those of the exercise. Each member is a clip of one node, "model".
 * A key has "time", "pos", and its orientation as "quat_xyzw", "euler_yxz_yaw_pitch_roll" or "ori_rows".
 */
#include <string.h>

#include <nakawari/euler.h>
#include <nakawari/mat.h>
#include <nakawari/quat.h>

#include "keys.h"

/* An object of lists, and the first list begins with a key. */
int nkwi_scenes_are(const nkwi_value *root)
{
    const json_t *first = NULL;
    const char *name;
    json_t *list;
    json_object_foreach((json_t *)root->json, name, list)
    {
        if (!json_is_array(list))
            return 0;
        first = first ? first : json_array_get(list, 0);
    }
    return json_object_get(first, "time") != NULL && json_object_get(first, "pos") != NULL;
}

/* The first of the three that is there. */
static int read_orientation(nkwi_keys *k, const nkwi_value *key, nkwi_entry *e)
{
    const nkw_quat identity = {0.0f, 0.0f, 0.0f, 1.0f};
    nkw_quat q = identity;
    float numbers[9];
    e->has |= 2u;
    if (nkwi_member(key, "quat_xyzw").json) {
        if (!nkwi_floats(k->error, key, "quat_xyzw", &q.x, 4))
            return 0;
    } else if (nkwi_member(key, "euler_yxz_yaw_pitch_roll").json) {
        if (!nkwi_floats(k->error, key, "euler_yxz_yaw_pitch_roll", numbers, 3))
            return 0;
        const nkw_vec3 angles = {numbers[1], numbers[0], numbers[2]};
        nkwi_entry_turn(e, angles);
        return 1;
    } else if (nkwi_member(key, "ori_rows").json) {
        if (!nkwi_floats(k->error, key, "ori_rows", numbers, 9))
            return 0;
        const nkw_mat3 rows = {{numbers[0], numbers[3], numbers[6], numbers[1], numbers[4], numbers[7], numbers[2],
                                numbers[5], numbers[8]}};
        q = nkw_quat_from_mat3(&rows);
    } else
        e->has &= ~2u;
    memcpy(e->numbers + nkwi_keys_first[NKW_CLIP_ROTATION], &q, sizeof q);
    return 1;
}

static int read_key(nkwi_keys *k, const nkwi_value *key, const char *clip)
{
    static const float one[3] = {1.0f, 1.0f, 1.0f};
    nkwi_entry e;
    nkwi_value time = nkwi_member(key, "time"), at = nkwi_member(key, "pos");
    memset(&e, 0, sizeof e);
    e.name = "model";
    e.clip = clip;
    e.has = at.json ? 1u : 0u;
    memcpy(e.numbers + nkwi_keys_first[NKW_CLIP_SCALE], one, sizeof one);
    e.time = (float)json_number_value(time.json);
    if (!nkwi_is_object(k->error, key))
        return 0;
    if (!json_is_number(time.json) || !(e.time - e.time == 0.0f))
        return nkwi_fail(k->error, &time.place, NKW_IMPORT_INVALID, "is no finite number");
    return nkwi_floats(k->error, key, "pos", e.numbers, 3) && read_orientation(k, key, &e) && nkwi_keys_add(k, &e);
}

int nkwi_scenes_read(nkwi_keys *k, const nkwi_value *root)
{
    const char *name;
    json_t *list;
    k->stride = NKWI_VALUES;
    k->is_json = 1;
    json_object_foreach((json_t *)root->json, name, list)
    {
        nkwi_value scene = nkwi_member(root, name);
        for (size_t i = 0; i < nkwi_length(&scene); i++) {
            nkwi_value key = nkwi_element(&scene, i);
            k->line++;
            if (!read_key(k, &key, name))
                return 0;
        }
    }
    return 1;
}
