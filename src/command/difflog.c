/* SPDX-License-Identifier: MIT */
#include "difflog.h"

#include <inttypes.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "command.h"
#include "fields.h"
#include "json.h"

enum { NAME = 64, NUMBER = 32 };

/* A line of numbers. */
typedef struct part {
    int is_joint;
    size_t index; /* of the joint, or of the first float */
    size_t first, count; /* of the numbers of the frame */
    char name[NAME];
} part;

typedef struct frame {
    char number[NUMBER];
    uint64_t hash;
    part *parts;
    float *numbers;
    size_t part_count, number_count, float_count;
} frame;

typedef struct log {
    const char *path;
    unsigned char *data;
    fields text;
    int has_line; /* text.text is a line that is not used yet */
    frame now;
} log_file;

int difflog_is(const char *path)
{
    char begin[6] = "";
    FILE *f = strcmp(path, "-") == 0 ? NULL : fopen(path, "rb");
    const int is = f && fread(begin, 1, sizeof begin, f) == sizeof begin && memcmp(begin, "frame ", 6) == 0;
    if (f)
        fclose(f);
    return is;
}

/* ---- Reading ---- */

static int complain(const log_file *l, const char *what)
{
    output_text(stderr, l->path);
    fprintf(stderr, ":line %zu: %s\n", l->text.line, what);
    return 0;
}

static int next_line(log_file *l)
{
    if (!l->has_line)
        l->has_line = fields_next(&l->text);
    return l->has_line;
}

/* Room for one element more: at powers of 2. */
static void *grown(void *list, size_t count, size_t size)
{
    return count & (count - 1) ? list : realloc(list, (count ? 2 * count : 1) * size);
}

static int add_number(frame *f, float x)
{
    float *numbers = (float *)grown(f->numbers, f->number_count, sizeof *numbers);
    if (!numbers)
        return 0;
    f->numbers = numbers;
    f->numbers[f->number_count++] = x;
    return 1;
}

/* Reads at most `most` numbers of a part; returns what follows, NULL without memory. */
static char *read_numbers(frame *f, part *p, char *text, size_t most)
{
    while (p->count < most) {
        char *end;
        const float x = strtof(text, &end);
        if (end == text)
            break;
        if (!add_number(f, x))
            return NULL;
        p->count++;
        text = end;
    }
    return fields_start(text);
}

static int read_part(log_file *l, char *text)
{
    frame *f = &l->now;
    part *parts = (part *)grown(f->parts, f->part_count, sizeof *parts);
    if (!parts)
        return complain(l, "no memory");
    f->parts = parts;
    part *p = &f->parts[f->part_count++];
    memset(p, 0, sizeof *p);
    p->is_joint = strncmp(text, "joint ", 6) == 0;
    p->first = f->number_count;
    char *end = text + (p->is_joint ? 6 : 7);
    p->index = p->is_joint ? (size_t)strtoull(end, &end, 10) : f->float_count;
    end = read_numbers(f, p, end, p->is_joint ? 10 : SIZE_MAX);
    if (!end)
        return complain(l, "no memory");
    if (p->is_joint ? p->count != 10 : *end != '\0' || p->count == 0)
        return complain(l, p->is_joint ? "a joint has an index and ten numbers" : "no number");
    snprintf(p->name, sizeof p->name, "%s", p->is_joint ? end : "");
    f->float_count += p->is_joint ? 0 : p->count;
    return 1;
}

/* The next frame and its parts. Returns 1, 0 at the end, -1 for a fault, which is reported. */
static int read_frame(log_file *l)
{
    frame *f = &l->now;
    f->part_count = f->number_count = f->float_count = 0;
    if (!next_line(l))
        return l->text.fault ? complain(l, l->text.fault) - 1 : 0;
    if (sscanf(l->text.text, "frame %31s %16" SCNx64, f->number, &f->hash) != 2)
        return complain(l, "no frame: frame NUMBER HASH") - 1;
    l->has_line = 0;
    while (next_line(l) && strncmp(l->text.text, "frame ", 6) != 0) {
        char *text = fields_start(l->text.text);
        if (strncmp(text, "joint ", 6) == 0 || strncmp(text, "floats ", 7) == 0) {
            if (!read_part(l, text))
                return -1;
        } else if (*text != '\0' && *text != '#')
            return complain(l, "neither frame, joint nor floats") - 1;
        l->has_line = 0;
    }
    return l->text.fault ? complain(l, l->text.fault) - 1 : 1;
}

static int open_log(log_file *l, const char *path)
{
    size_t bytes;
    memset(l, 0, sizeof *l);
    l->path = path;
    l->data = input_read(path, &bytes);
    l->text.at = (const char *)l->data;
    l->text.end = l->data ? l->text.at + bytes : NULL;
    return l->data != NULL;
}

static void close_log(log_file *l)
{
    free(l->data);
    free(l->now.parts);
    free(l->now.numbers);
}

/* ---- Comparing ---- */

/* What differs in a frame. */
typedef struct difference {
    size_t count; /* of numbers */
    const part *part; /* of the first; NULL: none */
    size_t number; /* of the part */
    float a, b;
} difference;

/* Steps from float to float; 0 and -0 are one apart. */
static int64_t place_of(float x)
{
    int32_t bits;
    memcpy(&bits, &x, sizeof bits);
    return bits < 0 ? (int64_t)INT32_MIN - 1 - bits : bits;
}

static int is_equal(float a, float b, float tolerance)
{
    if (a != a || b != b)
        return a != a && b != b;
    return tolerance > 0.0f ? a == b || fabs((double)a - (double)b) <= (double)tolerance : place_of(a) == place_of(b);
}

static int is_comparable(const frame *a, const frame *b)
{
    int is = a->part_count > 0 && a->part_count == b->part_count;
    for (size_t i = 0; is && i < a->part_count; i++)
        is = a->parts[i].is_joint == b->parts[i].is_joint && a->parts[i].index == b->parts[i].index &&
             a->parts[i].count == b->parts[i].count;
    return is;
}

static difference compare_numbers(const frame *a, const frame *b, float tolerance)
{
    difference d = {0, NULL, 0, 0.0f, 0.0f};
    for (size_t i = 0; i < a->part_count; i++)
        for (size_t k = 0; k < a->parts[i].count; k++) {
            const float x = a->numbers[a->parts[i].first + k], y = b->numbers[b->parts[i].first + k];
            if (is_equal(x, y, tolerance))
                continue;
            if (d.count++ == 0)
                d.part = &a->parts[i], d.number = k, d.a = x, d.b = y;
        }
    return d;
}

static const char *component_of(const difference *d)
{
    static const char *const names[10] = {"translation.x", "translation.y", "translation.z", "rotation.x", "rotation.y",
                                          "rotation.z",    "rotation.w",    "scale.x",       "scale.y",    "scale.z"};
    return d->part->is_joint ? names[d->number] : "float";
}

static size_t index_of(const difference *d)
{
    return d->part->index + (d->part->is_joint ? 0 : d->number);
}

/* ---- Output ---- */

typedef struct outcome {
    size_t same; /* frames before the first that differs, or all */
    const char *kind; /* NULL: the logs are the same */
    int has_numbers; /* both logs have them in that frame */
    difference d;
} outcome;

static void put_lines(const outcome *o, const log_file *a, const log_file *b)
{
    printf("%zu %s\n", COUNT(o->same, "frame is the same", "frames are the same"));
    if (!o->kind)
        return;
    if (strcmp(o->kind, "end") == 0) {
        output_text(stdout, *a->now.number ? b->path : a->path);
        printf(" has no frame %s\n", *a->now.number ? a->now.number : b->now.number);
    } else if (strcmp(o->kind, "number") == 0)
        printf("then frame %s and frame %s\n", a->now.number, b->now.number);
    else if (o->d.part) {
        printf("frame %s: ", a->now.number);
        if (o->d.part->is_joint) {
            printf("joint %zu ", o->d.part->index);
            output_text(stdout, o->d.part->name);
            printf("%s%s", *o->d.part->name ? " " : "", component_of(&o->d));
        } else
            printf("float %zu", index_of(&o->d));
        printf(": %.9g and %.9g, %" PRId64 " ulp; %zu %s\n", (double)o->d.a, (double)o->d.b,
               place_of(o->d.b) - place_of(o->d.a), COUNT(o->d.count, "number differs", "numbers differ"));
    } else
        printf("frame %s: %016" PRIx64 " and %016" PRIx64 "%s\n", a->now.number, a->now.hash, b->now.hash,
               o->has_numbers ? "; the numbers are the same" : "; log the joints of this frame");
}

static int put_json(const outcome *o, const log_file *a, const log_file *b)
{
    json_t *all = json_pack("{s:o, s:o, s:I, s:b}", "a", json_text(a->path), "b", json_text(b->path), "frames",
                            (json_int_t)o->same, "same", !o->kind);
    if (o->kind) {
        json_object_set_new(all, "differs", json_string(o->kind));
        json_object_set_new(all, "frame_a", json_text(a->now.number));
        json_object_set_new(all, "frame_b", json_text(b->now.number));
    }
    if (o->d.part) {
        json_object_set_new(all, o->d.part->is_joint ? "joint" : "float", json_integer((json_int_t)index_of(&o->d)));
        json_object_set_new(all, "name", json_text(o->d.part->name));
        json_object_set_new(all, "component", json_string(component_of(&o->d)));
        json_object_set_new(all, "value_a", json_number((double)o->d.a));
        json_object_set_new(all, "value_b", json_number((double)o->d.b));
        json_object_set_new(all, "numbers", json_integer((json_int_t)o->d.count));
    }
    return json_put_lines(stdout, all);
}

/* ---- The command ---- */

/* Whether the frames are the same; otherwise `o` says what differs. */
static int compare_frames(const frame *a, const frame *b, float tolerance, outcome *o)
{
    if (strcmp(a->number, b->number) != 0) {
        o->kind = "number";
        return 0;
    }
    if (a->hash == b->hash)
        return 1;
    o->has_numbers = is_comparable(a, b);
    if (o->has_numbers)
        o->d = compare_numbers(a, b, tolerance);
    if (o->has_numbers && tolerance > 0.0f && o->d.count == 0)
        return 1;
    o->kind = o->d.part ? "component" : "fingerprint";
    return 0;
}

/* Returns 0 for a fault, which is reported. */
static int compare_logs(log_file *a, log_file *b, float tolerance, outcome *o)
{
    for (;; o->same++) {
        const int x = read_frame(a), y = x < 0 ? -1 : read_frame(b);
        if (x < 0 || y < 0)
            return 0;
        if (x != y) {
            o->kind = "end";
            *(x ? b : a)->now.number = '\0';
        }
        if (x != y || !x || !compare_frames(&a->now, &b->now, tolerance, o))
            return 1;
    }
}

int difflog_run(const difflog_request *r)
{
    static log_file a, b; /* a line is 4 KB */
    outcome o;
    memset(&o, 0, sizeof o);
    memset(&b, 0, sizeof b);
    int fine = open_log(&a, r->a) && open_log(&b, r->b) && compare_logs(&a, &b, r->tolerance, &o);
    if (fine && r->json)
        fine = put_json(&o, &a, &b);
    else if (fine)
        put_lines(&o, &a, &b);
    close_log(&a);
    close_log(&b);
    fine = output_close(stdout, NULL) && fine;
    return fine && !o.kind ? COMMAND_FINE : COMMAND_FINDINGS;
}
