/* SPDX-License-Identifier: MIT */
/* nakawari convert: any file that is read, as glTF; or as OBJ at one time. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <nakawari/scalar.h>
#include <nakawari/vec.h>

#include "check.h"
#include "inplace.h"
#include "mend.h"
#include "moment.h"
#include "objfile.h"
#include "progress.h"
#include "reframe.h"
#include "space.h"

static const options_text text = {
    "[OPTION...] FILE -o OUT",
    "Writes FILE, of any format that is read, as glTF 2.0: skeleton, skins, meshes with morph targets, clips.\n"
    "Keys are those of the file, unless --rate resamples them or --tolerance reduces them; then the keys, their\n"
    "bytes and the largest distance to the original are printed for each clip.\n\n"
    "-o OUT.obj writes the triangles at one time as OBJ, and their materials as OUT.mtl: at --time seconds of\n"
    "--clip, or in the rest pose. OBJ has no clips and no skins, and texture coordinates of set 0 only.\n\n"
    "--axes A:B converts from the axes of A to those of B: a tool (gltf, maya, vrm, godot, usd-y, usd-z,\n"
    "blender, max, unity, directx, unreal, unreal-mesh), a view space (opengl-camera, opencv-camera), or the axes\n"
    "that point right, up and forward, such as x,z,-y. --up z:y is --axes blender:gltf, --up y:z the reverse.\n"
    "--scale multiplies lengths; --size L does so that the largest side of the model in its rest pose is L, and\n"
    "prints its sides. --in-place removes the motion of the root joint, about the up axis of A or y, so that the\n"
    "character stays in its place.\n\n"
    "--v up counts the texture coordinate v from the lower edge of a picture, 1 - v, in all sets, for programs\n"
    "that expect it; a glTF file whose v is upwards is mended by it.\n\n"
    "--normals D makes the normals that are missing: edges sharper than D degrees stay hard, 180 is smooth.\n"
    "--tangents makes missing tangents, --fix-facing turns triangles to face the same way, --apply-transforms\n"
    "multiplies vertices by the transforms of their nodes, except animated ones and joints. What was made is\n"
    "printed.\n\n"
    "--repair mends what nakawari check names: keys, weights, joints of vertices, inverse bind matrices; it prints\n"
    "each change, and what remains.\n\n"
    "Of a glTF file everything else is kept, unless an option changes its meshes: then only what is read is\n"
    "written: no cameras, lights, extensions; of textures only base colours.\n",
    "  nakawari convert keys.csv -o keys.glb\n"
    "  nakawari convert fox.glb --rate 30 --tolerance 0.1 -o fox30.glb\n"
    "  nakawari convert zup.glb --up z:y --scale 0.01 -o yup.glb\n"
    "  nakawari convert walk.bvh --rate 30 --in-place plane,yaw -o walk.glb\n"
    "  nakawari convert --repair broken.glb -o mended.glb\n"
    "  nakawari convert fox.glb --clip Run --time 0.4 -o fox.obj\n"
    "  nakawari convert fox.glb --axes gltf:unity --form embedded -o - | less\n",
    1, 0};

typedef struct request {
    char *clip, *time, *output, *form, *axes, *up, *v, *in_place, *root, *unit;
    float rate, tolerance, scale, size, seconds; /* size -1: that of the file; seconds: of time */
    int reframes, embeds, repairs, keeps_axes; /* keeps_axes: --axes keep */
    float metres; /* of a unit that is written; 0: that of the file is kept */
    nkw_axes_map map;
    nkw_root_rule rule; /* of --in-place */
    nkw_document_preparation preparation;
} request;

static int change_clip(model *m, size_t animation, const request *r, const extent *e, FILE *report)
{
    model_change change;
    const float tolerance = r->tolerance >= 0.0f ? r->tolerance : 1e-4f * e->size;
    if (r->rate > 0.0f && !model_resample(m, animation, r->rate))
        return 0;
    if (r->tolerance >= 0.0f && !model_reduce(m, animation, e, tolerance, 0))
        return 0;
    if (!model_measure(m, animation, e, tolerance, &change))
        return 0;
    model_report(report, m->original, animation, &change);
    return 1;
}

/* Of OBJ: one, or none for the rest pose. */
static int choose_moment(model *m, const request *r, input_clips *clips)
{
    if (!input_select(m->original, r->clip || r->time ? r->clip : "rest", clips))
        return 0;
    if (clips->count != 1)
        return output_complain(m->original, NULL, "choose one clip");
    m->is_obj = 1;
    m->clip = clips->first;
    m->time = r->seconds;
    clips->count = clips->first != INPUT_REST;
    return 1;
}

/* The clips to be converted: one, if it is chosen, otherwise all. */
static int choose_clips(model *m, const request *r, input_clips *clips)
{
    if (objfile_is(r->output))
        return choose_moment(m, r, clips);
    const input_clips all = {0, m->original->animation_count}, none = {0, 0};
    *clips = all;
    if (r->clip && !input_select(m->original, r->clip, clips))
        return 0;
    if (clips->first == INPUT_REST)
        *clips = none;
    return 1;
}

static int stay_in_place(model *m, const request *r, input_clips clips)
{
    int fine = 1;
    for (size_t i = 0; fine && r->in_place && i < clips.count; i++)
        fine = inplace_clip(m, clips.first + i, r->root, &r->rule);
    return fine;
}

static int change_clips(model *m, const request *r, input_clips clips, const extent *e, FILE *report)
{
    int fine = 1;
    if (r->rate == 0.0f && r->tolerance < 0.0f)
        return 1;
    model_report_head(report, m->original);
    progress p = progress_begin("converting clip", clips.count, report);
    for (size_t i = 0; fine && i < clips.count; i++) {
        progress_at(&p, i);
        fine = change_clip(m, clips.first + i, r, e, report);
    }
    progress_end(&p);
    return fine;
}

/* The box of the vertices at rest, or of the joints if there are none. */
static int find_size(const model *m, const extent *e, nkw_vec3 *size)
{
    const nkw_box joints = {e->low, e->high};
    nkw_box box;
    if (!moment_rest_box(m->original, &box))
        return 0;
    if (!(box.low.x <= box.high.x))
        box = joints;
    *size = nkw_vec3_sub(box.high, box.low);
    const float most = nkw_max(size->x, nkw_max(size->y, size->z));
    return (most > 0.0f && most < 1e30f) || output_complain(m->original, NULL, "has no size");
}

/* The factor of --scale, or that of --size: its largest side becomes r->size. The sides are printed. */
static int find_scale(const model *m, const request *r, const extent *e, FILE *report, float *scale)
{
    nkw_vec3 size;
    *scale = r->scale;
    if (r->size == -1.0f)
        return 1;
    if (!find_size(m, e, &size))
        return 0;
    const nkw_vec3 turned = nkw_axes_convert_vec3(r->map, size);
    *scale = (float)((double)r->size / (double)nkw_max(size.x, nkw_max(size.y, size.z)));
    fprintf(report, "size %.6g x %.6g x %.6g, was %.6g x %.6g x %.6g\n", fabs((double)(*scale * turned.x)),
            fabs((double)(*scale * turned.y)), fabs((double)(*scale * turned.z)), (double)size.x, (double)size.y,
            (double)size.z);
    return 1;
}

/* The axes and the unit of the file become those of glTF, unless options say otherwise. Says so in a line. */
static request with_space(const model *m, const request *given, FILE *report)
{
    const nkw_document *d = m->original;
    const nkw_axes gltf = NKW_AXES_GLTF, axes = d->space.axes;
    request r = *given;
    const int turns = !r.axes && !r.up && !r.keeps_axes && space_has_axes(d) &&
                      (axes.right != gltf.right || axes.up != gltf.up || axes.forward != gltf.forward);
    const int scales =
        r.scale == 1.0f && r.size == -1.0f && r.metres > 0.0f && d->space.metres > 0.0f && d->space.metres != r.metres;
    if (space_has_axes(d) && !r.axes && !r.up)
        r.rule.up = space_up(d);
    if (turns)
        r.map = nkw_axes_map_from_axes(axes, gltf);
    if (scales)
        r.scale = (float)((double)d->space.metres / (double)r.metres);
    r.reframes = r.reframes || turns || scales;
    if (!turns && !scales)
        return r;
    space_print(report, d);
    if (turns)
        fputs(": turned to up y, forward z, right -x", report);
    if (scales)
        fprintf(report, "%s multiplied by %.6g to %.6g m", turns ? "; lengths" : ": lengths", (double)r.scale,
                (double)r.metres);
    fputc('\n', report);
    return r;
}

/* Says how near the CUBICSPLINE keys of clips are to the curves of the file. */
static void note_curves(const nkw_document *d, input_clips clips)
{
    size_t tracks = 0, added = 0;
    double angle = 0.0, number = 0.0;
    for (size_t c = clips.first; c < clips.first + clips.count; c++)
        for (size_t i = 0; i < d->animations[c].track_count; i++) {
            const nkw_document_channel *channel = &d->animations[c].channels[i];
            double *most = d->animations[c].tracks[i].target == NKW_CLIP_ROTATION ? &angle : &number;
            *most = fmax(*most, (double)channel->difference);
            tracks += channel->difference > 0.0f;
            added += channel->difference > 0.0f ? channel->added : 0;
        }
    if (tracks == 0)
        return;
    output_text(stderr, d->file);
    fprintf(stderr, ": note: curves of %zu track%s became CUBICSPLINE, with %zu more key%s: within %.2g degrees",
            tracks, tracks > 1 ? "s" : "", added, added == 1 ? "" : "s", angle * 57.29577951308232);
    fprintf(stderr, ", other numbers within %.2g\n", number);
}

/* All changes, which count clips as the file does; then only the chosen ones remain in the document. */
static int change_model(model *m, const void *request_of, const extent *e, FILE *report)
{
    const request converted = with_space(m, request_of, report), *r = &converted;
    input_clips clips;
    float scale;
    m->embeds = r->embeds;
    if ((r->repairs && !mend_all(m)) || !choose_clips(m, r, &clips) || !change_clips(m, r, clips, e, report) ||
        !stay_in_place(m, r, clips))
        return 0;
    if (r->reframes && (!find_scale(m, r, e, report, &scale) || !reframe(m, r->map, scale)))
        return 0;
    if (m->is_obj)
        return 1;
    if (r->rate == 0.0f)
        note_curves(m->original, clips);
    m->document.animations = clips.count ? m->animations + clips.first : NULL;
    m->document.animation_count = clips.count;
    return 1;
}

/* Whether the text of a glTF file has what only writing all of it anew mends. */
static int needs_all(const model_source *s)
{
    return check_count(s->document, s->data, s->memory.bytes, "animated-matrix,wrong-bounds") > 0;
}

static int run(const model_source *source, void *of)
{
    const request *r = of;
    const int is_gltf = strcmp(source->document->format, "glTF 2.0") == 0,
              names = r->output && strcmp(r->output, "-") != 0;
    const int keeps = is_gltf && !r->reframes && !r->clip && !input_v_is_up() && !input_prepares() &&
                      !(r->repairs && needs_all(source));
    if (is_gltf && !keeps && !objfile_is(r->output))
        fputs("note: only what is read is written: no cameras, lights, extensions; of textures only base colours\n",
              stderr);
    const int fine = model_rewrite(source, keeps, r->form, r->output, change_model, r);
    if (fine && r->repairs && names)
        check_written(r->output);
    return fine;
}

/* "A:B" */
static int read_axes(const char *axes, nkw_axes *from, nkw_axes_map *map)
{
    char first[64];
    nkw_axes to;
    const char *colon = strchr(axes, ':');
    const size_t length = colon ? (size_t)(colon - axes) : sizeof first;
    if (length >= sizeof first)
        return 0;
    memcpy(first, axes, length);
    first[length] = 0;
    if (!reframe_axes(first, from) || !reframe_axes(colon + 1, &to))
        return 0;
    *map = nkw_axes_map_from_axes(*from, to);
    return 1;
}

static int check_axes(const options *o, request *r)
{
    static const char *const ups[] = {"z:y", "y:z"};
    const int up = r->up ? words_find(r->up, ups, 2) : -1;
    if (r->up && r->axes)
        return options_misuse(o, "--up", "not with --axes");
    if (r->up && up < 0)
        return options_misuse(o, r->up, "not z:y or y:z");
    static const nkw_vec3 y = {0.0f, 1.0f, 0.0f}, z = {0.0f, 0.0f, 1.0f};
    nkw_axes from = NKW_AXES_GLTF;
    r->keeps_axes = r->axes && strcmp(r->axes, "keep") == 0;
    if (r->keeps_axes) {
        free(r->axes);
        r->axes = NULL;
    }
    const char *axes = up == 0 ? "blender:gltf" : up == 1 ? "gltf:blender" : r->axes;
    r->map = NKW_AXES_MAP_IDENTITY;
    if (axes && !read_axes(axes, &from, &r->map))
        return options_misuse(o, axes, "not two tools or triples of axes: FROM:TO, and not keep");
    r->metres = 1.0f;
    if (r->unit && !space_unit(r->unit, &r->metres))
        return options_misuse(o, r->unit, "not m, cm, mm, km, in, ft, yd or keep");
    if (r->unit && (r->scale != 1.0f || r->size != -1.0f))
        return options_misuse(o, "--unit", "not with --scale and --size");
    r->reframes = axes || (r->metres != 1.0f && r->metres != 0.0f) || r->scale != 1.0f || r->size != -1.0f;
    r->rule.up = from.up == NKW_AXIS_Z || from.up == NKW_AXIS_NEGATIVE_Z ? z : y;
    if (r->in_place && !inplace_parts(r->in_place, &r->rule.parts))
        return options_misuse(o, r->in_place, "not plane, height, yaw or rotation, separated by commas");
    if (r->root && !r->in_place)
        return options_misuse(o, "--root", "only with --in-place");
    return COMMAND_FINE;
}

static int check_request(const options *o, void *of)
{
    request *r = of;
    if (!(r->tolerance == -1.0f || (r->tolerance >= 0.0f && r->tolerance < 1e30f)))
        return options_misuse(o, "--tolerance", "not a distance");
    if (!(r->rate >= 0.0f && r->rate <= 1e6f))
        return options_misuse(o, "--rate", "not in 0..1000000");
    if (!(r->scale > 0.0f && r->scale < 1e30f))
        return options_misuse(o, "--scale", "not a positive number");
    if (!(r->size == -1.0f || (r->size > 0.0f && r->size < 1e30f)))
        return options_misuse(o, "--size", "not a positive number");
    if (r->size != -1.0f && r->scale != 1.0f)
        return options_misuse(o, "--size", "not with --scale");
    const int is_obj = objfile_is(r->output);
    if (is_obj && (r->embeds || r->repairs))
        return options_misuse(o, r->embeds ? "--embed" : "--repair", "not with -o FILE.obj");
    if (r->repairs)
        input_set_holding(0);
    if (!r->form && !is_obj && output_is_foreign(r->output))
        return options_misuse(o, r->output, "only glTF and OBJ are written: .glb, .gltf or .obj");
    if (r->form && is_obj)
        return options_misuse(o, "--form", "not with -o FILE.obj");
    if (r->time && !is_obj)
        return options_misuse(o, "--time", "only with -o FILE.obj");
    if (r->time && !options_number(r->time, &r->seconds))
        return options_misuse(o, r->time, "not a number of seconds");
    if (model_form(r->form, r->output) < 0)
        return options_misuse(o, r->form, "not glb, gltf or embedded");
    if (!input_set_v(r->v))
        return options_misuse(o, r->v, "not down or up");
    if (!input_set_preparation(&r->preparation))
        return options_misuse(o, "--normals", "not an angle of 0 degrees or more");
    return check_axes(o, r);
}

int command_convert(int argc, const char **argv)
{
    request r = {.tolerance = -1.0f,
                 .scale = 1.0f,
                 .size = -1.0f,
                 .metres = 1.0f,
                 .map = NKW_AXES_MAP_IDENTITY,
                 .rule = {{0.0f, 1.0f, 0.0f}, 0},
                 .preparation = {0, 0, 0, 0, -1.0f}};
    const struct poptOption known[] = {
        {"clip", 'c', POPT_ARG_STRING, &r.clip, 0, "number or name of one clip, or rest (default: all)", "N"},
        {"time", 0, POPT_ARG_STRING, &r.time, 0, "of OBJ: seconds in the clip (default: 0)", "T"},
        {"rate", 'r', POPT_ARG_FLOAT, &r.rate, 0, "resample at R keys per second", "R"},
        {"tolerance", 't', POPT_ARG_FLOAT, &r.tolerance, 0, "reduce keys to a distance in model space", "D"},
        {"axes", 'a', POPT_ARG_STRING, &r.axes, 0,
         "convert axes, such as blender:gltf or x,z,-y:-x,y,z; keep: those of the file", "A:B"},
        {"up", 'u', POPT_ARG_STRING, &r.up, 0, "z:y from Z-up to Y-up, y:z from Y-up to Z-up", "A:B"},
        INPUT_V(&r.v),
        INPUT_PREPARATION(&r.preparation),
        {"unit", 0, POPT_ARG_STRING, &r.unit, 0,
         "length of a unit: m, cm, mm, km, in, ft, yd, or keep (default: m, where the file states its own)", "U"},
        {"scale", 's', POPT_ARG_FLOAT, &r.scale, 0, "multiply lengths: 0.01 from centimetres to metres", "F"},
        {"size", 0, POPT_ARG_FLOAT, &r.size, 0, "scale to this length of the largest side in the rest pose", "L"},
        {"in-place", 'i', POPT_ARG_STRING, &r.in_place, 0,
         "remove root motion: plane, height, yaw, rotation, separated by commas", "PARTS"},
        {"root", 0, POPT_ARG_STRING, &r.root, 0,
         "name or number of the joint of --in-place (default: the first with an animated translation)", "NAME"},
        {"form", 'f', POPT_ARG_STRING, &r.form, 0,
         "glb, gltf (with FILE.bin) or embedded (default: by the name of the output)", "FORM"},
        {"embed", 0, POPT_ARG_NONE, &r.embeds, 0, "outer pictures become part of the file", NULL},
        {"repair", 0, POPT_ARG_NONE, &r.repairs, 0, "mend what check names: keys, weights, matrices", NULL},
        {"output", 'o', POPT_ARG_STRING, &r.output, 0, "write to FILE, not to the standard output", "FILE"},
        INPUT_STRICT,
        OPTIONS_END};
    static const model_steps steps = {check_request, run};
    const int code = model_run(&text, known, argc, argv, &steps, &r);
    free(r.clip);
    free(r.time);
    free(r.output);
    free(r.form);
    free(r.axes);
    free(r.unit);
    free(r.up);
    free(r.v);
    free(r.in_place);
    free(r.root);
    return code;
}
