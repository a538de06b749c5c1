/* SPDX-License-Identifier: MIT */
#if !defined(_POSIX_C_SOURCE)
#define _POSIX_C_SOURCE 200809L /* popen */
#endif
#include "scene.h"

#include <stdlib.h>

#include "clips.h"
#include "tracks.h"
#include "views.h"

void scene_read_floats(FILE *file, float *out, size_t n)
{
    for (size_t i = 0; i < n; i++)
        assert_int_equal(fscanf(file, "%f", &out[i]), 1);
}

static void read_node(FILE *file, scene *s)
{
    int index, parent;
    char kind;
    float v[16];
    assert_int_equal(fscanf(file, "%d %d %*d %c", &index, &parent, &kind), 3);
    assert_in_range(index, 0, SCENE_NODES - 1);
    scene_node *n = &s->node[index];
    s->nodes = index >= s->nodes ? index + 1 : s->nodes;
    n->parent = parent;
    n->is_matrix = kind == 'M';
    scene_read_floats(file, v, n->is_matrix ? 16 : 10);
    if (n->is_matrix)
        memcpy(&n->matrix, v, sizeof n->matrix);
    else
        memcpy(&n->rest, v, sizeof n->rest);
}

static nkw_clip_target target_of(const char *path)
{
    static const char *const paths[4] = {"translation", "rotation", "scale", "weights"};
    int target = 0;
    while (target < 4 && strcmp(path, paths[target]) != 0)
        target++;
    assert_in_range(target, 0, 3);
    return (nkw_clip_target)target;
}

static nkw_interpolation interpolation_of(const char *mode)
{
    return strcmp(mode, "LINEAR") == 0 ? NKW_INTERPOLATION_LINEAR
           : strcmp(mode, "STEP") == 0 ? NKW_INTERPOLATION_STEP
                                       : NKW_INTERPOLATION_CUBICSPLINE;
}

/* Where the node's morph weights stand among those of the scene; all animations of a node move as many. */
static uint32_t weights_of(scene *s, scene_node *n, size_t width)
{
    if (n->weight_count == 0) {
        n->weights = s->floats;
        n->weight_count = width;
        s->floats += width;
    }
    assert_int_equal(n->weight_count, width);
    assert_true(s->floats <= SCENE_FLOATS);
    return (uint32_t)n->weights;
}

static void read_channel(FILE *file, scene *s, int anim)
{
    char path[16], mode[16];
    int node;
    assert_true(s->channels < SCENE_CHANNELS);
    scene_channel *c = &s->channel[s->channels++];
    nkw_track *t = &c->track.track;
    assert_int_equal(fscanf(file, "%d %15s %15s %zu %zu", &node, path, mode, &t->count, &t->width), 5);
    assert_in_range(node, 0, s->nodes - 1);
    c->anim = anim;
    c->track.target = target_of(path);
    c->track.index = c->track.target == NKW_CLIP_FLOATS ? weights_of(s, &s->node[node], t->width) : (uint32_t)node;
    t->kind = c->track.target == NKW_CLIP_ROTATION ? NKW_TRACK_ROTATION : NKW_TRACK_FLOATS;
    t->interpolation = interpolation_of(mode);
    size_t count = nkw_track_value_count(t);
    t->times = c->times = (float *)malloc(t->count * sizeof(float));
    t->values = c->values = (float *)malloc(count * sizeof(float));
    assert_true(c->times && c->values);
    scene_read_floats(file, c->times, t->count);
    scene_read_floats(file, c->values, count);
    assert_int_equal(nkw_track_validate(t, NULL), NKW_OK);
}

static void read_skin(FILE *file, scene *s)
{
    int index, node;
    char word[16];
    scene_skin *skin = &s->skin[s->skins];
    assert_true(s->skins++ < SCENE_SKINS);
    assert_int_equal(fscanf(file, "%d %zu", &index, &skin->count), 2);
    assert_in_range(skin->count, 1, SCENE_NODES);
    for (size_t k = 0; k < skin->count; k++) {
        assert_int_equal(fscanf(file, "%15s %d", word, &node), 2);
        assert_string_equal(word, "joint");
        assert_in_range(node, 0, s->nodes - 1);
        skin->joints[k] = node;
        scene_read_floats(file, skin->inverse_bind[k].m, 16);
    }
}

static void read_vertex(FILE *file, scene_mesh *m, size_t v)
{
    char word[16];
    int influences;
    assert_int_equal(fscanf(file, "%15s %d", word, &m->index[v]), 2);
    assert_string_equal(word, "vertex");
    scene_read_floats(file, &m->positions[v].x, 3);
    assert_int_equal(fscanf(file, "%d", &influences), 1);
    assert_in_range(influences, 0, 8);
    for (int i = 0; i < influences; i++)
        assert_int_equal(fscanf(file, "%hu %f", &m->joints[v][i], &m->weights[v][i]), 2);
}

static void read_mesh(FILE *file, scene *s)
{
    scene_mesh *m = &s->mesh[s->meshes];
    assert_true(s->meshes++ < SCENE_SKINS);
    assert_int_equal(fscanf(file, "%d %d %zu", &m->node, &m->skin, &m->count), 3);
    assert_in_range(m->count, 0, SCENE_VERTICES);
    for (size_t v = 0; v < m->count; v++)
        read_vertex(file, m, v);
}

/* Parents may come after their children: the skeleton has an order of its own. */
static void make_skeleton(scene *s)
{
    int32_t parents[SCENE_NODES];
    for (int i = 0; i < s->nodes; i++)
        parents[i] = s->node[i].parent;
    assert_int_equal(
        nkw_skeleton_from_parents(parents, (size_t)s->nodes, s->joint_of_node, s->node_of_joint, s->parents, NULL),
        NKW_OK);
    for (int k = 0; k < s->skins; k++)
        for (size_t j = 0; j < s->skin[k].count; j++)
            s->skin[k].joints[j] = s->joint_of_node[s->skin[k].joints[j]];
}

int scene_folder_is_there(void)
{
    FILE *there = fopen(NKW_DATA_DIR "/README.md", "r");
    if (there)
        fclose(there);
    else
        printf("skipped: no models in %s (-DNKW_DATA_DIR=FOLDER; docs/README.md explains)\n", NKW_DATA_DIR);
    return there != NULL;
}

void scene_normalize_keys(scene *s)
{
    for (int i = 0; i < s->channels; i++) {
        nkw_track *t = &s->channel[i].track.track;
        t->kind = t->kind == NKW_TRACK_ROTATION ? NKW_TRACK_ROTATION_NORMALIZED : t->kind;
    }
}

void scene_read(const char *path, scene *s)
{
    char word[256];
    int anim = -1;
    memset(s, 0, sizeof *s);
    FILE *file = table_open(path);
    while (fscanf(file, "%255s", word) == 1) {
        if (strcmp(word, "node") == 0)
            read_node(file, s);
        else if (strcmp(word, "anims") == 0)
            assert_int_equal(fscanf(file, "%d", &s->anims), 1);
        else if (strcmp(word, "anim") == 0)
            assert_int_equal(fscanf(file, "%d %*d", &anim), 1);
        else if (strcmp(word, "channel") == 0)
            read_channel(file, s, anim);
        else if (strcmp(word, "skin") == 0)
            read_skin(file, s);
        else if (strcmp(word, "skinmesh") == 0)
            read_mesh(file, s);
    }
    table_close(file);
    assert_true(s->nodes > 0);
    make_skeleton(s);
}

void scene_free(scene *s)
{
    for (int i = 0; i < s->channels; i++) {
        free(s->channel[i].times);
        free(s->channel[i].values);
    }
}

void scene_rest(const scene *s, float *pose)
{
    size_t joints = (size_t)s->nodes;
    nkw_pose_identity(pose_span(pose, joints));
    for (size_t j = 0; j < joints; j++) {
        const scene_node *n = &s->node[j];
        nkw_trs trs = n->is_matrix ? nkw_trs_from_mat4(&n->matrix) : n->rest;
        nkw_pose_set(pose_span(pose, joints), j, &trs);
    }
}

void scene_sample(const scene *s, int anim, float time, float *pose, float *floats)
{
    size_t joints = (size_t)s->nodes;
    scene_rest(s, pose);
    memset(floats, 0, s->floats * sizeof *floats);
    for (int i = 0; i < s->channels; i++)
        if (s->channel[i].anim == anim)
            track_sample_to(&s->channel[i].track, time, joints, pose, floats);
}

nkw_clip *scene_clip(const scene *s, int anim, nkw_clip_format format, const float *rest, nkw_clip_track *tracks,
                     nkw_clip_source *source)
{
    size_t bytes, count = 0;
    for (int i = 0; i < s->channels; i++)
        if (s->channel[i].anim == anim) {
            assert_true(count < SCENE_TRACKS);
            tracks[count++] = s->channel[i].track;
        }
    nkw_clip_source from = {tracks, count, (size_t)s->nodes, s->floats, {rest, (size_t)s->nodes}, NULL, format, NULL};
    *source = from;
    return clip_build(source, &bytes);
}

void scene_models(const scene *s, const float *pose, nkw_mat4 *models)
{
    const nkw_skeleton skeleton = {s->parents, (size_t)s->nodes};
    for (int j = 0; j < s->nodes; j++) {
        int32_t node = s->node_of_joint[j];
        nkw_trs t = nkw_pose_get(pose_view(pose, (size_t)s->nodes), (size_t)node);
        models[j] = s->node[node].is_matrix ? s->node[node].matrix : nkw_mat4_from_trs(&t);
    }
    nkw_skeleton_models_from_locals(&skeleton, models, NULL, NULL, models);
}

FILE *table_open(const char *path)
{
    char command[1024];
    snprintf(command, sizeof command, "gzip -dcf '%s'*", path);
    FILE *file = popen(command, "r");
    assert_non_null(file);
    return file;
}

void table_close(FILE *file)
{
    pclose(file);
}

int table_read(FILE *file, table_row *r)
{
    char line[16384], *at = line;
    int used = 0;
    if (!fgets(line, sizeof line, file))
        return 0;
    r->count = 0;
    if (sscanf(line, "%7[^,],%d,%f,%d,%d%n", r->tag, &r->anim, &r->time, &r->a, &r->b, &used) != 5)
        return r->tag[0] = '#', 1;
    for (at += used; r->count < SCENE_FLOATS && sscanf(at, ",%f%n", &r->values[r->count], &used) == 1; at += used)
        r->count++;
    return 1;
}

double table_bound(const char *path, int off_unit)
{
    double largest = off_unit ? 100.0 : 1.0;
    table_row r;
    FILE *file = table_open(path);
    while (table_read(file, &r))
        for (int i = 0; i < r.count; i++)
            largest = fabs((double)r.values[i]) > largest ? fabs((double)r.values[i]) : largest;
    table_close(file);
    return 5e-6 * largest;
}
