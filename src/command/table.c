/* SPDX-License-Identifier: MIT */
#include "table.h"

#include <stdint.h>

#include "bytes.h"
#include "json.h"

void table_begin(table *t, const char *file)
{
    if (t->format == TABLE_CSV)
        fprintf(t->file, "clip,time,index,name,%s%s\n", t->has_targets ? "target," : "", t->columns);
    if (t->format == TABLE_JSON) {
        fputs("{\"file\": ", t->file);
        t->failed |= !json_put(t->file, json_text(file));
        fprintf(t->file, ",\n \"what\": \"%s\",\n \"columns\": \"%s\",\n \"rows\": [", t->what, t->columns);
    }
}

void table_end(table *t)
{
    if (t->format == TABLE_JSON)
        fputs("\n]}\n", t->file);
}

void table_clip(table *t, long clip, size_t time_count)
{
    t->clip = clip;
    if (t->format != TABLE_RAW)
        return;
    fputs("nkwsampl", t->file);
    bytes_put_u32(t->file, 1);
    bytes_put_u32(t->file, (uint32_t)t->kind);
    bytes_put_u32(t->file, (uint32_t)clip);
    bytes_put_u32(t->file, (uint32_t)time_count);
    bytes_put_u32(t->file, (uint32_t)t->rows_per_time);
    bytes_put_u32(t->file, (uint32_t)t->width);
}

void table_time(table *t, float time)
{
    t->time = time;
    if (t->format == TABLE_RAW)
        bytes_put_f32(t->file, time);
}

static void csv_row(table *t, size_t index, const char *name, const float *numbers)
{
    fprintf(t->file, "%ld,", t->clip);
    output_number(t->file, t->time);
    fprintf(t->file, ",%zu,", index);
    output_field(t->file, name);
    if (t->has_targets) {
        fputc(',', t->file);
        output_field(t->file, t->target);
    }
    for (size_t i = 0; i < t->width; i++) {
        fputc(',', t->file);
        output_number(t->file, numbers[i]);
    }
    fputc('\n', t->file);
}

static void json_row(table *t, size_t index, const char *name, const float *numbers)
{
    json_t *values = json_array();
    for (size_t i = 0; i < t->width; i++)
        json_array_append_new(values, json_number(numbers[i]));
    json_t *row = json_pack("{s:I, s:o, s:I, s:o, s:o}", "clip", (json_int_t)t->clip, "time", json_number(t->time),
                            "index", (json_int_t)index, "name", json_text(name), "values", values);
    if (t->has_targets)
        json_object_set_new(row, "target", json_text(t->target));
    fputs(t->row_count ? ",\n  " : "\n  ", t->file);
    t->failed |= !json_put(t->file, row);
}

void table_row(table *t, size_t index, const char *name, const float *numbers)
{
    if (t->format == TABLE_CSV)
        csv_row(t, index, name, numbers);
    else if (t->format == TABLE_JSON)
        json_row(t, index, name, numbers);
    else
        for (size_t i = 0; i < t->width; i++)
            bytes_put_f32(t->file, numbers[i]);
    t->row_count++;
}
