/* SPDX-License-Identifier: MIT */
#include "answers.h"

#include "fields.h"

#include <string.h>

#include <nakawari/mat.h>
#include <nakawari/quat.h>
#include <nakawari/scalar.h>

enum { VALUES = 17 };

/* What a column has. The 16 elements of the matrix, column by column, follow SLOT_MATRIX. */
enum {
    SLOT_TIME,
    SLOT_POSITION,
    SLOT_QUAT = SLOT_POSITION + 3,
    SLOT_ANGLES = SLOT_QUAT + 4,
    SLOT_MATRIX = SLOT_ANGLES + 3,
    NUMBERS = SLOT_MATRIX + 16, /* of slots that are numbers */
    SLOT_POSITION_METHOD = NUMBERS,
    SLOT_ORIENTATION_METHOD,
    SLOT_SCENE,
    SLOT_NONE
};

typedef struct reader {
    const answers_options *o;
    fields f;

    int has_header, slots[FIELDS_MOST];
    size_t column_count;
    unsigned long given; /* bit s: there is a column of slot s */
    answers_unit unit; /* that the header states */

    int method[COMPARE_PARTS]; /* that the program has printed */
    int is_open; /* below "Time:" */
    float values[VALUES];
    size_t value_count, value_line, usual_count;

    compare_row *rows;
    size_t capacity, count;
    const char *fault;
    size_t fault_line;
} reader;

static int fail(reader *r, size_t line, const char *what)
{
    if (!r->fault) {
        r->fault = what;
        r->fault_line = line;
    }
    return 0;
}

/* The fields of a text. */
static int cut(reader *r, char *text)
{
    return fields_split(&r->f, text) || fail(r, r->f.line, r->f.fault);
}

/* ---- methods ---- */

typedef struct alias {
    const char *name;
    int value;
} alias;

static int find_alias(const alias *list, const char *name)
{
    for (; list->name; list++)
        if (strcmp(list->name, name) == 0)
            return list->value;
    return -1;
}

/* The index in report_positions or report_orientations of the library's name or of the exercise's; -1 if it is none. */
static int find_method(compare_part part, const char *text)
{
    static const alias others[COMPARE_PARTS][4] = {{{"hermit", 1}, {NULL, 0}},
                                                   {{"slerp", 2}, {"quaternion", 2}, {NULL, 0}}};
    const report_method *list = part == COMPARE_POSITION ? report_positions : report_orientations;
    char name[FIELDS_NAME], known[FIELDS_NAME];
    fields_name(text, name);
    for (int i = 0; list[i].name; i++)
        if (strcmp(fields_name(list[i].name, known), name) == 0)
            return i;
    return find_alias(others[part], name);
}

/* ---- the header ---- */

static const alias names[] = {
    {"time", SLOT_TIME},
    {"sec", SLOT_TIME},
    {"second", SLOT_TIME},
    {"seconds", SLOT_TIME},
    {"x", SLOT_POSITION},
    {"y", SLOT_POSITION + 1},
    {"z", SLOT_POSITION + 2},
    {"px", SLOT_POSITION},
    {"py", SLOT_POSITION + 1},
    {"pz", SLOT_POSITION + 2},
    {"tx", SLOT_POSITION},
    {"ty", SLOT_POSITION + 1},
    {"tz", SLOT_POSITION + 2},
    {"posx", SLOT_POSITION},
    {"posy", SLOT_POSITION + 1},
    {"posz", SLOT_POSITION + 2},
    {"positionx", SLOT_POSITION},
    {"positiony", SLOT_POSITION + 1},
    {"positionz", SLOT_POSITION + 2},
    {"quatx", SLOT_QUAT},
    {"quaty", SLOT_QUAT + 1},
    {"quatz", SLOT_QUAT + 2},
    {"quatw", SLOT_QUAT + 3},
    {"qx", SLOT_QUAT},
    {"qy", SLOT_QUAT + 1},
    {"qz", SLOT_QUAT + 2},
    {"qw", SLOT_QUAT + 3},
    {"yaw", SLOT_ANGLES},
    {"pitch", SLOT_ANGLES + 1},
    {"roll", SLOT_ANGLES + 2},
    {"posmethod", SLOT_POSITION_METHOD},
    {"position", SLOT_POSITION_METHOD},
    {"orimethod", SLOT_ORIENTATION_METHOD},
    {"orientation", SLOT_ORIENTATION_METHOD},
    {"scene", SLOT_SCENE},
    {NULL, 0},
};

static int is_digit(char c)
{
    return c >= '0' && c <= '9';
}

/* The digits of m0, m15, m01, r22, mat33: their number; -1 if the name is no element of a matrix. */
static int element_digits(const char *name, int *value)
{
    static const char *const heads[] = {"m", "r", "o", "mat", "rot", "ori"};
    for (size_t i = 0; i < sizeof heads / sizeof *heads; i++) {
        const size_t n = strlen(heads[i]);
        if (strncmp(name, heads[i], n) != 0 || !is_digit(name[n]))
            continue;
        const char *digits = name + n;
        *value = digits[0] - '0';
        if (digits[1] == '\0')
            return 1;
        *value = 10 * *value + digits[1] - '0';
        return is_digit(digits[1]) && digits[2] == '\0' ? 2 : -1;
    }
    return -1;
}

/* How the elements are named: by one index from 0; by row and column, from 0 or from 1. */
typedef struct elements {
    size_t count;
    int by_place, base;
} elements;

static elements survey(const reader *r)
{
    elements e = {0, 0, 1};
    int most = 0;
    for (size_t i = 0; i < r->f.count; i++) {
        char name[FIELDS_NAME];
        int value, digits = element_digits(fields_name(r->f.field[i], name), &value);
        if (digits < 0)
            continue;
        e.count++;
        most = value > most ? value : most;
        if (digits == 2 && value < 10) {
            e.by_place = 1;
            e.base = 0;
        }
    }
    e.by_place |= most > 15;
    return e;
}

static int element_slot(const reader *r, const elements *e, int digits, int value)
{
    const int side = e->count == 9 ? 3 : 4;
    if (e->by_place && digits != 2)
        return SLOT_NONE;
    int row = e->by_place ? value / 10 - e->base : value % side,
        column = e->by_place ? value % 10 - e->base : value / side;
    if (!e->by_place && r->o->by_rows) {
        const int swap = row;
        row = column;
        column = swap;
    }
    const int element = 4 * column + row;
    return row < 0 || column < 0 || row >= side || column >= side ? SLOT_NONE : SLOT_MATRIX + element;
}

/* A name of an angle may end with its unit: yaw_deg, yaw (rad). */
static void cut_unit(reader *r, char *name)
{
    static const alias units[] = {{"degrees", ANSWERS_DEGREES}, {"degree", ANSWERS_DEGREES}, {"deg", ANSWERS_DEGREES},
                                  {"radians", ANSWERS_RADIANS}, {"radian", ANSWERS_RADIANS}, {"rad", ANSWERS_RADIANS}};
    const size_t length = strlen(name);
    for (size_t i = 0; i < sizeof units / sizeof *units; i++) {
        const size_t n = strlen(units[i].name);
        if (length <= n || strcmp(name + length - n, units[i].name) != 0)
            continue;
        name[length - n] = '\0';
        r->unit = (answers_unit)units[i].value;
        return;
    }
}

/* "time [s]" and "x (m)" as "time" and "x". */
static const char *without_unit(const char *text, char out[FIELDS_NAME])
{
    char cut[FIELDS_NAME];
    const size_t n = strcspn(text, "([");
    if (n >= sizeof cut)
        return fields_name(text, out);
    memcpy(cut, text, n);
    cut[n] = '\0';
    return fields_name(cut, out);
}

static int slot_of(reader *r, const elements *e, const char *text)
{
    char name[FIELDS_NAME];
    int value;
    const int digits = element_digits(fields_name(text, name), &value);
    if (digits > 0)
        return element_slot(r, e, digits, value);
    cut_unit(r, name);
    value = find_alias(names, name);
    if (value < 0)
        value = find_alias(names, without_unit(text, name));
    return value < 0 ? SLOT_NONE : value;
}

static unsigned long bits(int first, int count)
{
    return ((1ul << count) - 1) << first;
}

/* Elements 0 1 2, 4 5 6, 8 9 10. */
static unsigned long rotation_bits(void)
{
    return bits(SLOT_MATRIX, 3) | bits(SLOT_MATRIX + 4, 3) | bits(SLOT_MATRIX + 8, 3);
}

static int has(const reader *r, unsigned long all)
{
    return (r->given & all) == all;
}

static int check_header(reader *r)
{
    if (!has(r, bits(SLOT_TIME, 1)))
        return fail(r, r->f.line, "no column is named time");
    const unsigned long position = r->given & bits(SLOT_POSITION, 3), quat = r->given & bits(SLOT_QUAT, 4),
                        angles = r->given & bits(SLOT_ANGLES, 3), matrix = r->given & bits(SLOT_MATRIX, 16);
    if ((position && !has(r, bits(SLOT_POSITION, 3))) || (quat && !has(r, bits(SLOT_QUAT, 4))) ||
        (angles && !has(r, bits(SLOT_ANGLES, 3))) ||
        (matrix && matrix != rotation_bits() && matrix != bits(SLOT_MATRIX, 16)))
        return fail(r, r->f.line, "a column of the position or of the orientation is missing");
    if (!position && !quat && !angles && !matrix)
        return fail(r, r->f.line, "no columns are named as a position or an orientation");
    if ((quat != 0) + (angles != 0) + (matrix != 0) > 1 || (position && matrix == bits(SLOT_MATRIX, 16)))
        return fail(r, r->f.line, "the position or the orientation is there twice");
    return 1;
}

static int read_header(reader *r)
{
    const elements e = survey(r);
    int t = -1;
    char name[FIELDS_NAME];
    r->has_header = 1;
    r->column_count = r->f.count;
    r->given = 0;
    for (size_t i = 0; i < r->f.count; i++) {
        const int slot = slot_of(r, &e, r->f.field[i]);
        if (slot != SLOT_NONE && (r->given & bits(slot, 1)))
            return fail(r, r->f.line, "two columns have the same name");
        r->slots[i] = slot;
        r->given |= slot != SLOT_NONE ? bits(slot, 1) : 0;
        t = strcmp(fields_name(r->f.field[i], name), "t") == 0 ? (int)i : t;
    }
    if (t >= 0 && !has(r, bits(SLOT_TIME, 1))) {
        r->slots[t] = SLOT_TIME;
        r->given |= bits(SLOT_TIME, 1);
    }
    return check_header(r);
}

/* ---- rows ---- */

static compare_row *new_row(reader *r, size_t line)
{
    if (r->count == r->capacity) {
        fail(r, line, "too many rows");
        return NULL;
    }
    compare_row *row = &r->rows[r->count++];
    const compare_row nothing = {0};
    *row = nothing;
    row->line = line;
    row->method[0] = r->method[0];
    row->method[1] = r->method[1];
    row->m = nkw_mat4_identity();
    return row;
}

static int set_quaternion(reader *r, compare_row *row, const float *v)
{
    nkw_quat q = {v[0], v[1], v[2], v[3]};
    nkw_mat3 rotation = nkw_mat3_from_quat(nkw_quat_normalize(q));
    row->form = COMPARE_QUATERNION;
    row->m = nkw_mat4_from_mat3(&rotation, nkw_mat4_translation(&row->m));
    return (q.x != 0.0f || q.y != 0.0f || q.z != 0.0f || q.w != 0.0f) || fail(r, row->line, "a quaternion is zero");
}

static void set_angles(compare_row *row, const float *v)
{
    row->form = COMPARE_ANGLES;
    memcpy(row->angles, v, 3 * sizeof *v);
}

static void set_position(compare_row *row, const float *v)
{
    row->has_position = 1;
    memcpy(row->m.m + 12, v, 3 * sizeof *v);
}

/* The slots that `given` names. */
static int set_row(reader *r, compare_row *row, const float slots[NUMBERS])
{
    row->time = slots[SLOT_TIME];
    if (has(r, bits(SLOT_MATRIX, 16))) {
        row->whole = row->has_position = 1;
        row->form = COMPARE_MATRIX;
        memcpy(row->m.m, slots + SLOT_MATRIX, 16 * sizeof *slots);
    } else if (has(r, rotation_bits())) {
        row->form = COMPARE_MATRIX;
        for (int c = 0; c < 3; c++)
            memcpy(row->m.m + 4 * c, slots + SLOT_MATRIX + 4 * c, 3 * sizeof *slots);
    }
    if (has(r, bits(SLOT_POSITION, 3)))
        set_position(row, slots + SLOT_POSITION);
    if (has(r, bits(SLOT_ANGLES, 3)))
        set_angles(row, slots + SLOT_ANGLES);
    return !has(r, bits(SLOT_QUAT, 4)) || set_quaternion(r, row, slots + SLOT_QUAT);
}

static int read_named_row(reader *r)
{
    float slots[NUMBERS] = {0.0f};
    int method[COMPARE_PARTS] = {r->method[0], r->method[1]};
    if (r->f.count != r->column_count)
        return fail(r, r->f.line, "the line has not as many fields as there are names of columns");
    for (size_t i = 0; i < r->f.count; i++) {
        const int slot = r->slots[i];
        if (slot < NUMBERS && !fields_number(r->f.field[i], &slots[slot]))
            return fail(r, r->f.line, "a number was expected");
        if (slot == SLOT_SCENE && r->o->scene && strcmp(r->f.field[i], r->o->scene) != 0)
            return 1;
        const int part = slot - SLOT_POSITION_METHOD;
        if (slot != SLOT_POSITION_METHOD && slot != SLOT_ORIENTATION_METHOD)
            continue;
        method[part] = find_method((compare_part)part, r->f.field[i]);
        if (method[part] < 0)
            return fail(r, r->f.line, "no method has this name");
    }
    compare_row *row = new_row(r, r->f.line);
    if (!row)
        return 0;
    row->method[0] = method[0];
    row->method[1] = method[1];
    return set_row(r, row, slots);
}

/* ---- rows without names ---- */

/* The slots of `count` numbers after the time. */
static int set_layout(reader *r)
{
    static const struct {
        size_t count;
        int position, quat, angles, matrix;
    } layouts[] = {{3, 1, 0, 0, 0}, {4, 0, 1, 0, 0},  {6, 1, 0, 1, 0},  {7, 1, 1, 0, 0},
                   {9, 0, 0, 0, 9}, {12, 1, 0, 0, 9}, {16, 0, 0, 0, 16}};
    for (size_t i = 0; i < sizeof layouts / sizeof *layouts; i++) {
        if (layouts[i].count + 1 != r->value_count)
            continue;
        r->given = bits(SLOT_TIME, 1) | (layouts[i].position ? bits(SLOT_POSITION, 3) : 0) |
                   (layouts[i].quat ? bits(SLOT_QUAT, 4) : 0) | (layouts[i].angles ? bits(SLOT_ANGLES, 3) : 0) |
                   (layouts[i].matrix == 9 ? rotation_bits()
                    : layouts[i].matrix    ? bits(SLOT_MATRIX, 16)
                                           : 0);
        return 1;
    }
    return fail(r, r->value_line, "not 3, 4, 6, 7, 9, 12 or 16 numbers after the time");
}

/* The values in the order of their slots; of matrices written by rows, in the order of rows. */
static int finish_row(reader *r)
{
    float slots[NUMBERS] = {0.0f};
    const float *v = r->values;
    if (r->usual_count > 0 && r->value_count != r->usual_count)
        return fail(r, r->value_line, "not as many numbers as at the first time");
    r->usual_count = r->value_count;
    if (!set_layout(r))
        return 0;
    for (int s = 0; s < SLOT_MATRIX; s++)
        slots[s] = has(r, bits(s, 1)) ? *v++ : 0.0f;
    const int side = has(r, bits(SLOT_MATRIX, 16)) ? 4 : 3;
    for (int i = 0; i < side && has(r, rotation_bits()); i++)
        for (int j = 0; j < side; j++)
            slots[SLOT_MATRIX + (r->o->by_rows ? 4 * j + i : 4 * i + j)] = *v++;
    compare_row *row = new_row(r, r->value_line);
    return row && set_row(r, row, slots);
}

static int add_values(reader *r)
{
    for (size_t i = 0; i < r->f.count; i++) {
        if (r->value_count == VALUES)
            return fail(r, r->f.line, "more than 16 numbers after the time");
        if (!fields_number(r->f.field[i], &r->values[r->value_count]))
            return fail(r, r->f.line, "a number was expected");
        r->value_count++;
    }
    return 1;
}

/* ---- what the exercise's program prints ---- */

static int close_time(reader *r)
{
    const int open = r->is_open;
    r->is_open = 0;
    return !open || finish_row(r);
}

/* "Time: 1.25", numbers may follow. */
static int read_time(reader *r, char *text)
{
    if (!close_time(r))
        return 0;
    r->is_open = 1;
    r->value_count = 0;
    r->value_line = r->f.line;
    if (!cut(r, text) || !add_values(r))
        return 0;
    return r->value_count > 0 || fail(r, r->f.line, "a number was expected");
}

/* "Position: Hermit, Orientation: Quat" */
static int read_methods(reader *r, char *text)
{
    char *orientation = strchr(text, ',');
    if (!close_time(r))
        return 0;
    if (orientation) {
        *orientation++ = '\0';
        orientation = fields_start(orientation);
        if (strncmp(orientation, "Orientation:", 12) != 0)
            return fail(r, r->f.line, "Orientation: was expected");
        r->method[1] = find_method(COMPARE_ORIENTATION, orientation + 12);
    }
    r->method[0] = find_method(COMPARE_POSITION, text);
    return (r->method[0] >= 0 && (!orientation || r->method[1] >= 0)) || fail(r, r->f.line, "no method has this name");
}

/* Whether no field begins as a number does. */
static int are_names(const reader *r)
{
    for (size_t i = 0; i < r->f.count; i++)
        if (r->f.field[i][0] && strchr("0123456789+-.,", r->f.field[i][0]))
            return 0;
    return 1;
}

static int read_fields(reader *r)
{
    if (!cut(r, r->f.text))
        return 0;
    if (r->is_open)
        return add_values(r);
    if (r->has_header)
        return read_named_row(r);
    if (r->count == 0 && are_names(r))
        return read_header(r);
    r->value_count = 0;
    r->value_line = r->f.line;
    return add_values(r) && finish_row(r);
}

static int read_line(reader *r)
{
    char *text = r->f.text;
    if (r->f.line == 1 && strncmp(text, "\xef\xbb\xbf", 3) == 0)
        memset(text, ' ', 3);
    text = fields_start(text);
    if (*text == '\0' || *text == '#' || strcmp(text, "Animation Mode") == 0 || strcmp(text, "Layout Mode") == 0)
        return 1;
    if (strncmp(text, "Time:", 5) == 0)
        return read_time(r, text + 5);
    if (strncmp(text, "Position:", 9) == 0)
        return read_methods(r, text + 9);
    return read_fields(r);
}

/* ---- all ---- */

/* Angles become radians, and matrices. */
static void settle_angles(reader *r)
{
    answers_unit unit = r->unit != ANSWERS_ANY_UNIT ? r->unit : r->o->unit;
    for (size_t i = 0; i < r->count && unit == ANSWERS_ANY_UNIT; i++)
        for (int k = 0; k < 3; k++)
            if (nkw_abs(r->rows[i].angles[k]) > 10.0f)
                unit = ANSWERS_DEGREES;
    for (size_t i = 0; i < r->count; i++) {
        compare_row *row = &r->rows[i];
        if (row->form != COMPARE_ANGLES)
            continue;
        row->degrees = unit == ANSWERS_DEGREES;
        for (int k = 0; k < 3 && row->degrees; k++)
            row->angles[k] = nkw_radians_from_degrees(row->angles[k]);
        nkw_mat3 rotation = compare_rotation(row->angles);
        row->m = nkw_mat4_from_mat3(&rotation, nkw_mat4_translation(&row->m));
    }
}

size_t answers_most(const char *text, size_t bytes)
{
    size_t lines = 1;
    for (size_t i = 0; i < bytes; i++)
        lines += text[i] == '\n' || text[i] == '\r';
    return lines;
}

int answers_read(const char *text, size_t bytes, const answers_options *o, compare_row *rows, size_t capacity,
                 size_t *count, answers_fault *fault)
{
    reader r = {0};
    r.o = o;
    r.f.at = text;
    r.f.end = text + bytes;
    r.method[0] = r.method[1] = COMPARE_UNSTATED;
    r.rows = rows;
    r.capacity = capacity;
    int fine = 1;
    while (fine && fields_next(&r.f))
        fine = read_line(&r);
    if (r.f.fault)
        fail(&r, r.f.line, r.f.fault);
    if (!r.fault && close_time(&r) && r.count == 0)
        fail(&r, 0, "has no rows");
    settle_angles(&r);
    *count = r.count;
    fault->line = r.fault_line;
    fault->what = r.fault;
    return !r.fault;
}
