/* SPDX-License-Identifier: MIT */
/* Numbers of students: texts of every form with edits, and whatever bytes come. */
#include <string.h>

#include "command/answers.h"
#include "fuzz.h"

enum { TEXT_MOST = 1024, EDITS_MOST = 5 };

static const char *const texts[] = {
    "time,x,y,z,qx,qy,qz,qw\n0,1,2,3,0,0,0,1\r\n0.1,-1,.5,2e-1,0,1,0,-1\n",
    "Pos_Method;time;m00;m01;m02;m10;m11;m12;m20;m21;m22;ori_method\nHermit;0,5;1;0;0;0;1;0;0;0;1;Quat\n",
    "# mine\n0 1 0 0 0 0 1 0 0 0 0 1 0 1 2 3 1\n2\t1 0 0 0 0 1 0 0 0 0 1 0 1 2 3 1\n",
    "Layout Mode\nPosition: Bezier, Orientation: Euler\nTime: 1\n1 0 0\n0 1 0\n0 0 1\nTime: 2 1 0 0 0 1 0 0 0 1\n",
    "scene,n,t,yaw_deg,pitch,roll,r\nscene1,7,0,10,20,-30,1\nscene2,7,x,\"10\",2,-3,1\nscene1,7,1,400,20,-30,1\n",
    "0 1 2 3 10 20 30\n6 1 0 -1 40 50 60\n"};

static const char *const words[] = {"\n",    "\r\n", ",",   ";",   "\t", " ",    "Time:", "Position:", "nan", "1e39",
                                    "1e-50", "-",    "m15", "m33", "t",  "time", "quat",  "3.5",       "\"",  "#"};

/* Cuts up to seven bytes at a place and inserts a word or a byte there. */
static size_t edit(fuzz *f, char *text, size_t length)
{
    const size_t at = fuzz_upto(f, length), most = length - at;
    size_t cut = fuzz_upto(f, 7);
    const char byte = (char)fuzz_byte(f);
    const char *word = words[fuzz_upto(f, sizeof words / sizeof *words - 1)];
    const int is_byte = fuzz_byte(f) % 4 == 0;
    const size_t more = is_byte ? 1 : strlen(word);
    cut = cut > most ? most : cut;
    if (length - cut + more > TEXT_MOST)
        return length;
    memmove(text + at + more, text + at + cut, most - cut);
    memcpy(text + at, is_byte ? &byte : word, more);
    return length - cut + more;
}

static int is_method(int method, const report_method *list)
{
    int count = 0;
    while (list[count].name)
        count++;
    return method >= COMPARE_UNSTATED && method < count;
}

static void check_rows(const compare_row *rows, size_t count, size_t lines)
{
    FUZZ_CHECK(count > 0);
    for (size_t i = 0; i < count; i++) {
        const compare_row *r = &rows[i];
        FUZZ_CHECK(r->line >= 1 && r->line <= lines && (i == 0 || r->line > rows[i - 1].line));
        FUZZ_CHECK(fuzz_finite(&r->time, 1) && fuzz_finite(r->m.m, 16) && fuzz_finite(r->angles, 3));
        FUZZ_CHECK(r->has_position || r->form != COMPARE_NONE);
        FUZZ_CHECK(is_method(r->method[0], report_positions) && is_method(r->method[1], report_orientations));
    }
}

static void check_result(const compare_row *rows, size_t count, const compare_result *result, int agrees)
{
    size_t has[COMPARE_PARTS] = {0, 0}, found[COMPARE_PARTS] = {0, 0}, differing = 0;
    for (size_t i = 0; i < count; i++) {
        has[COMPARE_POSITION] += rows[i].has_position != 0;
        has[COMPARE_ORIENTATION] += rows[i].form != COMPARE_NONE;
    }
    FUZZ_CHECK(result->count <= COMPARE_FINDINGS);
    for (size_t i = 0; i < result->count; i++) {
        const compare_finding *f = &result->findings[i];
        found[f->part] += f->rows;
        differing += f->differing;
        FUZZ_CHECK(f->differing <= f->rows && f->cause_count <= COMPARE_CAUSES && f->first <= f->last);
        FUZZ_CHECK(f->cause_count == 0 || f->nearest.reproduced < f->differing);
        for (size_t k = 0; k < f->cause_count; k++)
            FUZZ_CHECK(f->causes[k].reproduced == f->differing && f->causes[k].agreeing <= f->rows);
    }
    FUZZ_CHECK(found[0] == has[0] && found[1] == has[1]);
    FUZZ_CHECK(agrees == (differing == 0 && !result->is_transposed));
}

static void read_text(fuzz *f, const char *text, size_t length)
{
    const size_t most = answers_most(text, length);
    compare_row *rows = fuzz_block(f, most * sizeof *rows);
    char *copy = fuzz_block(f, length);
    const answers_options read = {fuzz_byte(f) % 2 ? "scene1" : NULL, (answers_unit)(fuzz_byte(f) % 3),
                                  fuzz_byte(f) % 2};
    const compare_options compare = {{(int)fuzz_upto(f, 6) - 1, (int)fuzz_upto(f, 5) - 1}, 1e-3f};
    answers_fault fault;
    compare_result result;
    scene s;
    size_t count;
    memcpy(copy, text, length);
    if (!answers_read(copy, length, &read, rows, most, &count, &fault)) {
        FUZZ_CHECK(fault.what && fault.line <= most);
        return;
    }
    FUZZ_CHECK(scene_build(1 + fuzz_byte(f) % 2, 0, &s));
    check_rows(rows, count, most);
    const int agrees = compare_rows(&s, &compare, rows, count, &result);
    check_result(rows, count, &result, agrees);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    char text[TEXT_MOST];
    fuzz f = fuzz_begin(data, size);
    const size_t kind = fuzz_upto(&f, sizeof texts / sizeof *texts);
    size_t length;
    if (kind == sizeof texts / sizeof *texts) {
        length = size > TEXT_MOST ? TEXT_MOST : size;
        memcpy(text, data, length);
    } else {
        length = strlen(texts[kind]);
        memcpy(text, texts[kind], length);
        for (size_t n = fuzz_upto(&f, EDITS_MOST); n > 0; n--)
            length = edit(&f, text, length);
    }
    read_text(&f, text, length);
    return fuzz_end(&f);
}
