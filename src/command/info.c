/* SPDX-License-Identifier: MIT */
/* nakawari info: what a file contains. */
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <nakawari/box.h>
#include <nakawari/segment.h>
#include <nakawari/vec.h>

#include "json.h"
#include "moment.h"
#include "progress.h"
#include "size.h"
#include "space.h"

static const options_text text = {
    "[OPTION...] FILE",
    "Prints what FILE contains (- reads the standard input): counts, a table of its clips, and a table of the\n"
    "channels of each clip: the joint, what is animated, the interpolation, the number of keys, the first and the\n"
    "last key time, how the keys are spaced, and the bytes in the file, in a clip of float keys and in a clip of\n"
    "16-bit keys. In the file, key times that channels of a clip share count once for the clip.\n",
    "  nakawari info fox.glb\n"
    "  nakawari info --clips --reduced fox.glb\n"
    "  nakawari info --json fox.glb | jq '.clips[].name'\n",
    1, 0};

typedef struct request {
    int json, clips_only, reduced, opened;
    float tolerance;
    extent extent; /* for reduced */
} request;

static const char *const targets[] = {"translation", "rotation", "scale", "weights"};
static const char *const modes[] = {"LINEAR", "STEP", "CUBICSPLINE"};

/* ---- counts ---- */

typedef struct totals {
    size_t vertices, triangles, primitives, targets;
} totals;

static totals count_meshes(const nkw_document *d)
{
    totals t = {0, 0, 0, 0};
    for (size_t m = 0; m < d->mesh_count; m++)
        for (size_t p = 0; p < d->meshes[m].primitive_count; p++) {
            const nkw_document_primitive *primitive = &d->meshes[m].primitives[p];
            t.primitives++;
            t.vertices += primitive->vertex_count;
            t.targets += primitive->target_count;
            t.triangles += primitive->topology == NKW_DOCUMENT_TRIANGLES ? primitive->index_count / 3 : 0;
        }
    return t;
}

/*
 * Of an animation: all keys, their bytes in the file (times that channels share once), the animated joints, the first
 * and the last key time.
 */
typedef struct clip_totals {
    size_t keys, bytes, joints;
    float start, end;
} clip_totals;

static size_t count_joints(const nkw_document *d, const nkw_document_animation *a)
{
    size_t count = 0;
    unsigned char *seen = calloc(d->skeleton.joint_count, 1);
    for (size_t i = 0; seen && i < a->track_count; i++) {
        unsigned char *one = &seen[a->channels[i].joint];
        count += !*one;
        *one = 1;
    }
    free(seen);
    return count;
}

/* Whether a channel before this one has the same accessor of times; formats without accessors have 0 for both. */
static int shares_accessor(const nkw_document_animation *a, size_t channel)
{
    const nkw_document_channel *c = a->channels;
    for (size_t i = 0; i < channel; i++)
        if (c[i].input == c[channel].input && c[i].input != c[i].output)
            return 1;
    return 0;
}

static clip_totals count_clip(const nkw_document *d, size_t animation)
{
    const nkw_document_animation *a = &d->animations[animation];
    clip_totals t = {0, 0, count_joints(d, a), 0.0f, 0.0f};
    for (size_t i = 0; i < a->track_count; i++) {
        const nkw_track *track = &a->tracks[i].track;
        t.keys += track->count;
        t.bytes += a->channels[i].bytes - (shares_accessor(a, i) ? track->count * sizeof *track->times : 0);
        if (!track->count)
            continue;
        float first = track->times[0], last = track->times[track->count - 1];
        t.start = i == 0 || first < t.start ? first : t.start;
        t.end = i == 0 || last > t.end ? last : t.end;
    }
    return t;
}

/* The rate of keys that deviate from even times by less than half a segment; 0 of others. */
static float even_rate(const nkw_track *track)
{
    const size_t last = track->count - 1;
    const double rate = (double)last / ((double)track->times[last] - (double)track->times[0]);
    int even = rate > 0.0 && isfinite(rate);
    for (size_t k = 0; even && k <= last; k++)
        even = fabs(((double)track->times[k] - (double)track->times[0]) * rate - (double)k) < 0.5;
    return even ? (float)rate : 0.0f;
}

/* The rate of the keys, exact or nearly, or 0; *exact receives which. */
static float key_rate(const nkw_track *track, int *exact)
{
    nkw_timeline timeline;
    *exact = nkw_timeline_from_times(track->times, track->count, &timeline) == NKW_OK;
    return *exact ? timeline.rate : track->count > 1 ? even_rate(track) : 0.0f;
}

/* How the keys are spaced: "24/s", "about 24/s" or "uneven"; "-" for one key. */
static const char *spacing(const nkw_track *track, char out[48])
{
    int exact;
    const float rate = key_rate(track, &exact);
    if (track->count < 2)
        return "-";
    if (rate == 0.0f)
        return "uneven";
    snprintf(out, 48, exact ? "%.6g/s" : "about %.6g/s", (double)rate);
    return out;
}

/* ---- text ---- */

/* A text in a column of at least `width` characters of UTF-8. */
static void put_column(const char *name, int width)
{
    int characters = 0;
    output_text(stdout, name);
    for (const char *c = name; *c; c++)
        characters += ((unsigned char)*c & 0xc0) != 0x80;
    printf("%*s", characters < width ? width - characters + 2 : 2, "");
}

static int widest_name(const nkw_document *d)
{
    size_t widest = 5;
    for (size_t i = 0; i < d->skeleton.joint_count; i++) {
        size_t length = strlen(d->nodes[i].name);
        widest = length > widest && length <= 32 ? length : widest;
    }
    return (int)widest;
}

static void put_box(const nkw_document *d)
{
    nkw_box box;
    if (!moment_rest_box(d, &box) || !(box.low.x <= box.high.x))
        return;
    const nkw_vec3 size = nkw_vec3_sub(box.high, box.low);
    printf("  size %.6g x %.6g x %.6g, from %.6g %.6g %.6g to %.6g %.6g %.6g\n", (double)size.x, (double)size.y,
           (double)size.z, (double)box.low.x, (double)box.low.y, (double)box.low.z, (double)box.high.x,
           (double)box.high.y, (double)box.high.z);
    if (d->space.metres > 0.0f && d->space.metres != 1.0f)
        printf("  in metres %.6g x %.6g x %.6g\n", (double)(d->space.metres * size.x),
               (double)(d->space.metres * size.y), (double)(d->space.metres * size.z));
}

/* Of glTF they are always the same. */
static void put_space(const nkw_document *d)
{
    if (strcmp(d->format, "glTF 2.0") == 0 || (!space_has_axes(d) && !(d->space.metres > 0.0f)))
        return;
    fputs("  ", stdout);
    space_print(stdout, d);
    putchar('\n');
}

static json_t *json_space(const nkw_document *d)
{
    json_t *space = json_object();
    if (space_has_axes(d)) {
        json_object_set_new(space, "right", json_string(space_axis(d->space.axes.right)));
        json_object_set_new(space, "up", json_string(space_axis(d->space.axes.up)));
        json_object_set_new(space, "forward", json_string(space_axis(d->space.axes.forward)));
    }
    if (d->space.metres > 0.0f)
        json_object_set_new(space, "metres", json_real((double)d->space.metres));
    return space;
}

static void put_file(const nkw_document *d)
{
    totals t = count_meshes(d);
    output_text(stdout, d->file);
    printf(": %s, %zu bytes", d->format, d->bytes);
    if (d->generator[0]) {
        fputs(", by ", stdout);
        output_text(stdout, d->generator);
    }
    printf("\n  %zu %s, %zu %s, %zu %s, %zu %s, %zu %s, %zu morph %s\n",
           COUNT(d->skeleton.joint_count, "node", "nodes"), COUNT(d->skin_count, "skin", "skins"),
           COUNT(d->mesh_count, "mesh", "meshes"), COUNT(d->material_count, "material", "materials"),
           COUNT(d->animation_count, "clip", "clips"), COUNT(d->float_count, "weight", "weights"));
    printf("  %zu %s: %zu %s, %zu %s, %zu morph %s\n", COUNT(t.primitives, "primitive", "primitives"),
           COUNT(t.vertices, "vertex", "vertices"), COUNT(t.triangles, "triangle", "triangles"),
           COUNT(t.targets, "target", "targets"));
    put_space(d);
    put_box(d);
    for (size_t i = 0; i < d->skin_count; i++) {
        printf("  skin %zu ", i);
        output_text(stdout, d->skins[i].name);
        printf(": %zu %s\n", COUNT(d->skins[i].joint_count, "joint", "joints"));
    }
}

static void put_bytes(size_t bytes)
{
    if (bytes == SIZE_MAX)
        printf("  %9s", "refused");
    else
        printf("  %9zu", bytes);
}

static void put_clips(const nkw_document *d, const request *r)
{
    int width = 4;
    for (size_t i = 0; i < d->animation_count; i++) {
        int length = (int)strlen(d->animations[i].name);
        width = length > width && length <= 32 ? length : width;
    }
    printf("\nclip  ");
    put_column("name", width);
    printf("channels  joints     keys      start        end       file       clip    compact%s\n",
           r->reduced ? "    reduced" : "");
    progress p = progress_begin("measuring clip", d->animation_count, stdout);
    for (size_t i = 0; i < d->animation_count; i++) {
        progress_at(&p, i);
        clip_totals t = count_clip(d, i);
        clip_size size = size_of_clip(d, i);
        printf("%4zu  ", i);
        put_column(d->animations[i].name, width);
        printf("%8zu  %6zu  %7zu  %9.6g  %9.6g", d->animations[i].track_count, t.joints, t.keys, (double)t.start,
               (double)t.end);
        put_bytes(t.bytes);
        put_bytes(size.clip);
        put_bytes(size.compact);
        if (r->reduced)
            put_bytes(size_of_reduced(d, i, &r->extent, r->tolerance));
        putchar('\n');
    }
    progress_end(&p);
}

static void put_channels(const nkw_document *d, size_t animation)
{
    const nkw_document_animation *a = &d->animations[animation];
    int width = widest_name(d);
    char even[48];
    printf("\nclip %zu ", animation);
    output_text(stdout, a->name);
    printf("\nchannel  ");
    put_column("joint", width);
    printf("target       mode            keys      start        end  %-12s       file       clip    compact\n",
           "keys at");
    for (size_t i = 0; i < a->track_count; i++) {
        const nkw_track *track = &a->tracks[i].track;
        clip_size size = size_of_channel(d, animation, i);
        float first = track->count ? track->times[0] : 0.0f,
              last = track->count ? track->times[track->count - 1] : 0.0f;
        printf("%7zu  ", a->channels[i].number);
        put_column(d->nodes[a->channels[i].joint].name, width);
        printf("%-11s  %-11s  %7zu  %9.6g  %9.6g  %-12s", targets[a->tracks[i].target], modes[track->interpolation],
               track->count, (double)first, (double)last, spacing(track, even));
        put_bytes(a->channels[i].bytes);
        put_bytes(size.clip);
        put_bytes(size.compact);
        putchar('\n');
    }
    for (size_t i = 0; i < a->unread_count; i++) {
        printf("%7zu  ", a->unread[i].number);
        output_text(stdout, a->unread[i].reason);
        putchar('\n');
    }
}

static void put_text(const nkw_document *d, const request *r)
{
    put_file(d);
    if (d->animation_count)
        put_clips(d, r);
    for (size_t i = 0; !r->clips_only && i < d->animation_count; i++)
        put_channels(d, i);
}

/* ---- JSON ---- */

static json_t *json_vec3(nkw_vec3 v)
{
    return json_pack("[o, o, o]", json_number((double)v.x), json_number((double)v.y), json_number((double)v.z));
}

static json_t *json_box(const nkw_document *d)
{
    nkw_box box;
    if (!moment_rest_box(d, &box) || !(box.low.x <= box.high.x))
        return json_null();
    return json_pack("{s:o, s:o}", "low", json_vec3(box.low), "high", json_vec3(box.high));
}

static json_t *json_bytes(size_t bytes)
{
    return bytes == SIZE_MAX ? json_null() : json_integer((json_int_t)bytes);
}

static json_t *json_channel(const nkw_document *d, size_t animation, size_t i)
{
    const nkw_document_animation *a = &d->animations[animation];
    const nkw_track *track = &a->tracks[i].track;
    clip_size size = size_of_channel(d, animation, i);
    int exact;
    const float rate = key_rate(track, &exact);
    const int even = rate > 0.0f;
    return json_pack("{s:I, s:I, s:o, s:s, s:s, s:I, s:o, s:o, s:s, s:o, s:o, s:o, s:o}", "channel",
                     (json_int_t)a->channels[i].number, "node", (json_int_t)d->nodes[a->channels[i].joint].number,
                     "joint", json_text(d->nodes[a->channels[i].joint].name), "target", targets[a->tracks[i].target],
                     "mode", modes[track->interpolation], "keys", (json_int_t)track->count, "start",
                     track->count ? json_number((double)track->times[0]) : json_null(), "end",
                     track->count ? json_number((double)track->times[track->count - 1]) : json_null(), "spacing",
                     exact  ? "uniform"
                     : even ? "even"
                            : "uneven",
                     "rate", even ? json_number((double)rate) : json_null(), "file_bytes",
                     json_bytes(a->channels[i].bytes), "clip_bytes", json_bytes(size.clip), "compact_bytes",
                     json_bytes(size.compact));
}

static json_t *json_clip(const nkw_document *d, size_t animation, const request *r)
{
    const nkw_document_animation *a = &d->animations[animation];
    clip_totals t = count_clip(d, animation);
    clip_size size = size_of_clip(d, animation);
    json_t *clip = json_pack("{s:I, s:o, s:I, s:I, s:I, s:o, s:o, s:o, s:o, s:o}", "clip", (json_int_t)animation,
                             "name", json_text(a->name), "channel_count", (json_int_t)a->track_count, "joints",
                             (json_int_t)t.joints, "keys", (json_int_t)t.keys, "start", json_number((double)t.start),
                             "end", json_number((double)t.end), "file_bytes", json_bytes(t.bytes), "clip_bytes",
                             json_bytes(size.clip), "compact_bytes", json_bytes(size.compact));
    if (r->reduced)
        json_object_set_new(clip, "reduced_bytes", json_bytes(size_of_reduced(d, animation, &r->extent, r->tolerance)));
    json_t *channels = r->clips_only ? NULL : json_array();
    for (size_t i = 0; channels && i < a->track_count; i++)
        json_array_append_new(channels, json_channel(d, animation, i));
    if (channels)
        json_object_set_new(clip, "channels", channels);
    json_t *unread = a->unread_count ? json_array() : NULL;
    for (size_t i = 0; unread && i < a->unread_count; i++)
        json_array_append_new(unread, json_pack("{s:I, s:o}", "channel", (json_int_t)a->unread[i].number, "reason",
                                                json_text(a->unread[i].reason)));
    if (unread)
        json_object_set_new(clip, "unread", unread);
    return clip;
}

static int put_json(const nkw_document *d, const request *r)
{
    totals t = count_meshes(d);
    json_t *clips = json_array(), *skins = json_array();
    progress p = progress_begin("measuring clip", d->animation_count, NULL);
    for (size_t i = 0; i < d->animation_count; i++) {
        progress_at(&p, i);
        json_array_append_new(clips, json_clip(d, i, r));
    }
    progress_end(&p);
    for (size_t i = 0; i < d->skin_count; i++)
        json_array_append_new(skins, json_pack("{s:o, s:I}", "name", json_text(d->skins[i].name), "joints",
                                               (json_int_t)d->skins[i].joint_count));
    json_t *all =
        json_pack("{s:i, s:o, s:s, s:o, s:I, s:I, s:o, s:I, s:I, s:I, s:I, s:I, s:I, s:I, s:o}", "schema", JSON_SCHEMA,
                  "file", json_text(d->file), "format", d->format, "generator", json_text(d->generator), "bytes",
                  (json_int_t)d->bytes, "nodes", (json_int_t)d->skeleton.joint_count, "skins", skins, "meshes",
                  (json_int_t)d->mesh_count, "primitives", (json_int_t)t.primitives, "vertices", (json_int_t)t.vertices,
                  "triangles", (json_int_t)t.triangles, "morph_targets", (json_int_t)t.targets, "morph_weights",
                  (json_int_t)d->float_count, "materials", (json_int_t)d->material_count, "clips", clips);
    json_object_set_new(all, "box", json_box(d));
    json_object_set_new(all, "space", json_space(d));
    return json_put_lines(stdout, all);
}

/* ---- the command ---- */

static int run(const nkw_document *d, void *data)
{
    request *r = data;
    int fine = 1;
    r->opened = 1;
    if (r->reduced) {
        fine = extent_open(&r->extent, d);
        r->tolerance = r->tolerance >= 0.0f ? r->tolerance : 1e-4f * r->extent.size;
    }
    if (fine && r->json)
        fine = put_json(d, r);
    else if (fine)
        put_text(d, r);
    if (r->reduced)
        extent_free(&r->extent);
    return output_close(stdout, NULL) && fine;
}

static int check_request(const options *o, void *data)
{
    request *r = data;
    r->reduced |= r->tolerance != -1.0f;
    if (r->tolerance != -1.0f && !(r->tolerance >= 0.0f && r->tolerance < 1e30f))
        return options_misuse(o, "--tolerance", "not a distance");
    return COMMAND_FINE;
}

int command_info(int argc, const char **argv)
{
    request r;
    memset(&r, 0, sizeof r);
    r.tolerance = -1.0f;
    const struct poptOption known[] = {
        {"clips", 'c', POPT_ARG_NONE, &r.clips_only, 0, "print clips without their channels", NULL},
        {"reduced", 'r', POPT_ARG_NONE, &r.reduced, 0, "print the bytes of reduced clips too; a second for 100000 keys",
         NULL},
        {"tolerance", 't', POPT_ARG_FLOAT, &r.tolerance, 0,
         "distance in model space for --reduced (default: 1/10000 of the model's size)", "D"},
        {"json", 0, POPT_ARG_NONE, &r.json, 0, "print JSON", NULL},
        OPTIONS_END};
    static const command_steps steps = {check_request, run};
    input_set_holding(0);
    const int code = command_run(&text, known, argc, argv, &steps, &r);
    if (r.json && !r.opened && code == COMMAND_FINDINGS) {
        json_put_lines(stdout, json_unreadable());
        output_close(stdout, NULL);
    }
    return code;
}
