/* SPDX-License-Identifier: MIT */
/*
 * Real animated models, sampled track by track and as clips, composed node by node, against tables of independent
 * implementations (three.js, SciPy). The files are not in the repository: without the folder NKW_DATA_DIR every test is
 * skipped.
 */
#if !defined(_POSIX_C_SOURCE)
#define _POSIX_C_SOURCE 200809L /* glob */
#endif
#include <glob.h>
#include <math.h>
#include <stdlib.h>

#include "scene.h"
#include "support/expect.h"
#include "support/page.h"
#include "support/quantized.h"
#include "support/views.h"
#include "support/resample.h"

#define ANIMS 128

/* Translation and scale as they are, rotation with either sign. */
static void expect_local(nkw_trs got, const float *want, double bound)
{
    nkw_quat rotation = {want[3], want[4], want[5], want[6]};
    expect_floats_near(&got.translation.x, want, 3, bound);
    expect_rotation_near(got.rotation, rotation, bound);
    expect_floats_near(&got.scale.x, want + 7, 3, bound);
}

/* A scene with a clip of each of its animations; the last one is of none, the rest. */
typedef struct played {
    scene scene;
    float rest[NKW_POSE_FLOATS(SCENE_NODES)];
    nkw_clip_track tracks[ANIMS + 1][SCENE_TRACKS];
    nkw_clip_source source[ANIMS + 1];
    nkw_clip *clip[ANIMS + 1];
} played;

static void play(const char *path, int normalized, nkw_clip_format format, played *p)
{
    scene_read(path, &p->scene);
    if (normalized)
        scene_normalize_keys(&p->scene);
    scene_rest(&p->scene, p->rest);
    assert_in_range(p->scene.anims, 0, ANIMS);
    for (int i = 0; i <= p->scene.anims; i++)
        p->clip[i] = scene_clip(&p->scene, i, format, p->rest, p->tracks[i], &p->source[i]);
}

static void stop(played *p)
{
    for (int i = 0; i <= p->scene.anims; i++)
        free(p->clip[i]);
    scene_free(&p->scene);
}

static const nkw_clip *clip_of(const played *p, int anim)
{
    return p->clip[anim < 0 ? p->scene.anims : anim];
}

/* Samples a clip, and holds it to the bits of track by track. */
static void sample_both_ways(const played *p, int anim, float time, float *pose, float *floats)
{
    float want[NKW_POSE_FLOATS(SCENE_NODES)], want_floats[SCENE_FLOATS];
    size_t joints = (size_t)p->scene.nodes, stride = NKW_POSE_STRIDE(joints);
    scene_sample(&p->scene, anim, time, want, want_floats);
    nkw_clip_sample(clip_of(p, anim), time, NULL, pose_span(pose, nkw_clip_describe(clip_of(p, anim)).joint_count),
                    floats);
    for (size_t c = 0; c < 10; c++)
        expect_floats_bits(pose + c * stride, want + c * stride, joints);
    expect_floats_bits(floats, want_floats, p->scene.floats);
}

/* A scene at a time of an animation. */
typedef struct moment {
    float pose[NKW_POSE_FLOATS(SCENE_NODES)], floats[SCENE_FLOATS];
    nkw_mat4 models[SCENE_NODES], palette[SCENE_SKINS][SCENE_NODES];
    nkw_vec3 skinned[SCENE_SKINS][SCENE_VERTICES];
} moment;

/* From keys to skinned vertices. */
static void play_to(const played *p, int anim, float time, moment *m)
{
    const scene *s = &p->scene;
    sample_both_ways(p, anim, time, m->pose, m->floats);
    scene_models(s, m->pose, m->models);
    for (int k = 0; k < s->skins; k++)
        palette_from_models(m->models, (size_t)s->nodes, s->skin[k].joints, s->skin[k].inverse_bind, NULL,
                            s->skin[k].count, m->palette[k]);
    for (int k = 0; k < s->meshes; k++) {
        const scene_mesh *mesh = &s->mesh[k];
        nkw_skin skin = {mesh->count, 8, {mesh->joints, 0, NKW_SKIN_U16}, {mesh->weights, 0, NKW_SKIN_F32}};
        nkw_skin_palette palette = {{m->palette[mesh->skin], s->skin[mesh->skin].count, NKW_PALETTE_MAT4},
                                    {NULL, 0, NKW_PALETTE_NORMAL_MAT3},
                                    {0, 0, 0}};
        nkw_vertices_view in = {{mesh->positions, 0}, {NULL, 0}, {NULL, 0}, {NULL, 0}};
        nkw_vertices_span out = {{m->skinned[k], 0}, {NULL, 0}, {NULL, 0}, {NULL, 0}};
        nkw_skin_linear(&skin, &palette, in, out);
    }
}

/* The position of the skinned vertex `index` of the node's mesh in the array of skinned vertices. */
static const nkw_vec3 *vertex_of(const scene *s, const moment *m, int node, int index)
{
    for (int k = 0; k < s->meshes; k++)
        for (size_t v = 0; s->mesh[k].node == node && v < s->mesh[k].count; v++)
            if (s->mesh[k].index[v] == index)
                return &m->skinned[k][v];
    fail();
    return NULL;
}

/* Compares a row of the table; returns whether it is compared. */
static int compare_row(const played *p, const moment *m, const table_row *r, double bound)
{
    const scene *s = &p->scene;
    switch (r->tag[0]) {
    case 'L':
        expect_local(nkw_pose_get(pose_view(m->pose, (size_t)s->nodes), (size_t)r->a), r->values, bound);
        return 1;
    case 'W':
        expect_floats_near(m->models[s->joint_of_node[r->a]].m, r->values, 16, bound);
        return 1;
    case 'M':
        assert_int_equal(r->count, s->node[r->a].weight_count);
        expect_floats_near(m->floats + s->node[r->a].weights, r->values, s->node[r->a].weight_count, bound);
        return 1;
    case 'J':
        expect_floats_near(m->palette[r->a][r->b].m, r->values, 16, bound);
        return 1;
    case 'V':
        expect_floats_near(&vertex_of(s, m, r->a, r->b)->x, r->values, 3, bound);
        return 1;
    default:
        return 0;
    }
}

/* Compares all rows: local values, morph weights, world and skinning matrices, skinned vertices. Returns the count. */
static int compare_scene(const char *model, const char *table, int normalized, double bound)
{
    static played p;
    static moment m;
    table_row r;
    int rows = 0, compared = 0, anim = -2;
    float time = 0.0f;
    play(model, normalized, NKW_CLIP_FLOAT32, &p);
    FILE *file = table_open(table);
    for (; table_read(file, &r); rows++) {
        if (r.tag[0] != '#' && (r.anim != anim || r.time != time))
            play_to(&p, anim = r.anim, time = r.time, &m);
        compared += compare_row(&p, &m, &r, bound);
    }
    table_close(file);
    stop(&p);
    assert_int_equal(rows, compared + 1); /* the header */
    return compared;
}

/*
 * Every table of the folder: NAME.expected.csv with keys as stored, NAME.keynorm.expected.csv, for files whose keys are
 * off unit, with keys normalised first.
 */
static void scenes_are_met(void **state)
{
    (void)state;
    const char *const folder = NKW_DATA_DIR "/expected/", *const end = ".expected.csv";
    glob_t found, other;
    int compared = 0;
    assert_int_equal(glob(NKW_DATA_DIR "/expected/*.expected.csv*", 0, NULL, &found), 0);
    for (size_t i = 0; i < found.gl_pathc; i++) {
        char name[64], model[512], table[512], normal[512];
        assert_int_equal(sscanf(found.gl_pathv[i] + strlen(folder), "%63[^.]", name), 1);
        const char *rest = found.gl_pathv[i] + strlen(folder) + strlen(name);
        int normalized = strncmp(rest, ".keynorm.", 9) == 0;
        if (!normalized && strncmp(rest, end, strlen(end)) != 0)
            continue; /* a table of another kind: test_motion */
        snprintf(model, sizeof model, "%s/scenes/%s.scene.txt", NKW_DATA_DIR, name);
        snprintf(table, sizeof table, "%s%s%s%s", folder, name, normalized ? ".keynorm" : "", end);
        snprintf(normal, sizeof normal, "%s%s.keynorm%s*", folder, name, end);
        int off_unit = !normalized && glob(normal, 0, NULL, &other) == 0;
        if (off_unit)
            globfree(&other);
        int rows = compare_scene(model, table, normalized, table_bound(table, off_unit));
        printf("%s%s: %d rows\n", name, normalized ? ", keys normalised" : "", rows);
        compared += rows;
    }
    globfree(&found);
    assert_true(compared > 0);
}

/* Calls `check` with every scene of the folder and returns their number. */
static size_t each_scene(nkw_clip_format format, int normalized, void (*check)(const played *p))
{
    static played p;
    glob_t found;
    assert_int_equal(glob(NKW_DATA_DIR "/scenes/*.scene.txt*", 0, NULL, &found), 0);
    size_t count = found.gl_pathc;
    for (size_t i = 0; i < count; i++) {
        play(found.gl_pathv[i], normalized, format, &p);
        check(&p);
        stop(&p);
    }
    globfree(&found);
    return count;
}

/* At the keys of every channel, and at the quarters between two. */
static void expect_bits_of_tracks(const played *p)
{
    float pose[NKW_POSE_FLOATS(SCENE_NODES)], floats[SCENE_FLOATS];
    for (int i = 0; i < p->scene.channels; i++) {
        const nkw_track *t = &p->scene.channel[i].track.track;
        for (size_t k = 0; k < t->count; k++)
            for (int quarter = 0; quarter < 4; quarter++) {
                float next = t->times[k + 1 < t->count ? k + 1 : k];
                float time = nkw_lerp(t->times[k], next, 0.25f * (float)quarter);
                sample_both_ways(p, p->scene.channel[i].anim, time, pose, floats);
            }
    }
}

static void clips_of_all_scenes_give_the_bits_of_their_tracks(void **state)
{
    (void)state;
    assert_true(each_scene(NKW_CLIP_FLOAT32, 0, expect_bits_of_tracks) > 0);
}

/* Half a step of the largest range that a number of the target has in a clip; u of the largest number besides. */
static double compact_bound(const nkw_clip_source *s, nkw_clip_target target)
{
    double bound = 0.0;
    for (size_t i = 0; i < s->track_count; i++) {
        const nkw_track *t = &s->tracks[i].track;
        size_t n = s->tracks[i].target == target ? t->count * t->width : 0;
        for (size_t c = 0; c < t->width && n > 0; c++) {
            float low = t->values[c], high = low;
            for (size_t v = c; v < n && t->interpolation != NKW_INTERPOLATION_CUBICSPLINE; v += t->width) {
                low = nkw_min(low, t->values[v]);
                high = nkw_max(high, t->values[v]);
            }
            double largest = (double)nkw_max(nkw_abs(low), nkw_abs(high));
            double error = 0.51 / 65535.0 * ((double)high - (double)low) + 3.0 * 0x1p-24 * largest;
            bound = error > bound ? error : bound;
        }
    }
    return bound;
}

static void expect_compact_bound(const played *p)
{
    NKW_STACK_WORK(work, NKW_CLIP_DIFFERENCE_WORK(SCENE_NODES, SCENE_FLOATS));
    for (int i = 0; i < p->scene.anims; i++) {
        const nkw_clip_source *s = &p->source[i];
        nkw_clip_error error;
        assert_int_equal(nkw_clip_difference(p->clip[i], s, &error, work), NKW_OK);
        assert_true((double)error.translation <= compact_bound(s, NKW_CLIP_TRANSLATION));
        assert_true((double)error.scale <= compact_bound(s, NKW_CLIP_SCALE));
        assert_true((double)error.floats <= compact_bound(s, NKW_CLIP_FLOATS));
        assert_true(error.rotation <= 1.75e-4f);
    }
}

static void compact_clips_of_all_scenes_are_within_their_bound(void **state)
{
    (void)state;
    assert_true(each_scene(NKW_CLIP_UNORM16, 1, expect_compact_bound) > 0);
}

static void the_fox_has_the_bytes_of_the_page(void **state)
{
    static played whole, compact;
    NKW_STACK_WORK(work, NKW_CLIP_DIFFERENCE_WORK(SCENE_NODES, SCENE_FLOATS));
    (void)state;
    play(NKW_DATA_DIR "/scenes/Fox.scene.txt", 0, NKW_CLIP_FLOAT32, &whole);
    play(NKW_DATA_DIR "/scenes/Fox.scene.txt", 0, NKW_CLIP_UNORM16, &compact);
    for (int i = 0; i < whole.scene.anims; i++) {
        const nkw_clip_source *s = &whole.source[i];
        size_t keys = 0, floats = s->tracks[0].track.count;
        nkw_clip_error error;
        for (size_t t = 0; t < s->track_count; t++) {
            keys += s->tracks[t].track.count;
            floats += s->tracks[t].track.count * s->tracks[t].track.width;
        }
        assert_int_equal(s->track_count, 21);
        assert_int_equal(nkw_clip_difference(compact.clip[i], s, &error, work), NKW_OK);
        expect_page("subjects/clip/clip.md", "| %d | %lu | %lu | %lu | %lu | %.2e | %.2e |", i, (unsigned long)keys,
                    (unsigned long)(floats * sizeof(float)), (unsigned long)nkw_clip_describe(whole.clip[i]).bytes,
                    (unsigned long)nkw_clip_describe(compact.clip[i]).bytes, (double)error.rotation,
                    (double)error.translation);
    }
    stop(&whole);
    stop(&compact);
}

/* ---- vertices in fewer bits, for docs/joints.md ---- */

static nkw_box box_of(const scene_mesh *mesh)
{
    nkw_box box = NKW_BOX_EMPTY;
    for (size_t v = 0; v < mesh->count; v++) {
        nkw_box point = {mesh->positions[v], mesh->positions[v]};
        box = nkw_box_union(&box, &point);
    }
    return box;
}

static double longest_side(nkw_box box)
{
    nkw_vec3 side = nkw_vec3_sub(box.high, box.low);
    return (double)nkw_max(side.x, nkw_max(side.y, side.z));
}

static void round_positions(scene_mesh *mesh, int bits)
{
    nkw_box box = box_of(mesh);
    for (size_t v = 0; v < mesh->count; v++)
        mesh->positions[v] = quantized_position(mesh->positions[v], &box, bits);
}

static void round_weights(scene_mesh *mesh, int bits)
{
    static uint8_t bytes[SCENE_VERTICES][8];
    static uint16_t words[SCENE_VERTICES][8];
    nkw_skin_view weights = {mesh->weights, 0, NKW_SKIN_F32};
    nkw_skin_span in_bytes = {bytes, 0, NKW_SKIN_U8}, in_words = {words, 0, NKW_SKIN_U16};
    assert_int_equal(nkw_skin_normalize_weights(weights, 8, mesh->count, bits == 8 ? in_bytes : in_words), NKW_OK);
    for (size_t v = 0; v < mesh->count; v++)
        for (int i = 0; i < 8; i++)
            mesh->weights[v][i] = bits == 8 ? (float)bytes[v][i] / 255.0f : (float)words[v][i] / 65535.0f;
}

/* The largest distance of a vertex in all clips, in millimetres at a longest side of 2 m. */
static double worst_of_the_fox(void (*round_mesh)(scene_mesh *mesh, int bits), int bits)
{
    enum { TIMES = 41 };
    static played exact, rounded;
    static moment a, b;
    double most = 0.0;
    play(NKW_DATA_DIR "/scenes/Fox.scene.txt", 0, NKW_CLIP_FLOAT32, &exact);
    play(NKW_DATA_DIR "/scenes/Fox.scene.txt", 0, NKW_CLIP_FLOAT32, &rounded);
    scene_mesh *mesh = &rounded.scene.mesh[0];
    const double scale = 2000.0 / longest_side(box_of(mesh));
    round_mesh(mesh, bits);
    for (int i = 0; i < exact.scene.anims * TIMES; i++) {
        const int anim = i / TIMES;
        float time = nkw_clip_describe(exact.clip[anim]).end * (float)(i % TIMES) / (float)(TIMES - 1);
        play_to(&exact, anim, time, &a);
        play_to(&rounded, anim, time, &b);
        for (size_t v = 0; v < mesh->count; v++)
            most = fmax(most, scale * quantized_distance(a.skinned[0][v], b.skinned[0][v]));
    }
    stop(&exact);
    stop(&rounded);
    return most;
}

static void the_fox_has_the_errors_of_the_page(void **state)
{
    (void)state;
    expect_page("joints.md", "| positions within the box of the fox | %.3f mm | %.1f mm |",
                worst_of_the_fox(round_positions, 16), worst_of_the_fox(round_positions, 8));
    expect_page("joints.md", "| weights of the fox | %.4f mm | %.1f mm |", worst_of_the_fox(round_weights, 16),
                worst_of_the_fox(round_weights, 8));
}

/* A track baked at its own mean rate or below, within a tolerance, has no more keys and is within it. */
static void expect_resampled(const played *p)
{
    for (int i = 0; i < p->scene.channels; i++) {
        const nkw_track *t = &p->scene.channel[i].track.track;
        nkw_track baked;
        NKW_STACK_WORK(work, NKW_TRACK_WORK(SCENE_FLOATS));
        float *times = (float *)malloc(t->count * sizeof(float));
        float *values = (float *)malloc(t->count * t->width * sizeof(float));
        assert_true(times && values);
        float rate = resample_within(t, 1e-3f, times, values, work, &baked);
        assert_true(baked.count <= t->count && (rate > 0.0f) == (baked.count > 0));
        assert_true(rate == 0.0f || track_difference(t, &baked, work) <= 1e-3f);
        assert_true(baked.count < 2 || uniform_rate(times, baked.count) > 0.0f);
        free(times);
        free(values);
    }
}

static void tracks_of_all_scenes_resample_within_a_tolerance(void **state)
{
    (void)state;
    assert_true(each_scene(NKW_CLIP_FLOAT32, 0, expect_resampled) > 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(scenes_are_met),
        cmocka_unit_test(clips_of_all_scenes_give_the_bits_of_their_tracks),
        cmocka_unit_test(compact_clips_of_all_scenes_are_within_their_bound),
        cmocka_unit_test(the_fox_has_the_bytes_of_the_page),
        cmocka_unit_test(the_fox_has_the_errors_of_the_page),
        cmocka_unit_test(tracks_of_all_scenes_resample_within_a_tolerance),
    };
    if (!scene_folder_is_there())
        return 77;
    return cmocka_run_group_tests_name("scene", tests, NULL, NULL);
}
