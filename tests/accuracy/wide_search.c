/* SPDX-License-Identifier: MIT */
/* The driver of the accuracy programs: samples, and a search for the worst one. */
#include "wide.h"

#if WIDE_AVAILABLE

#include <math.h>
#include <string.h>

typedef struct wide_worst {
    double worst;
    double squares;
    uint64_t count;
    float witness[WIDE_ARGUMENTS];
} wide_worst;

/* What a sampler draws while a case is climbed. */
#define TAPE 4096
static uint64_t numbers[TAPE];
static random_tape tape;
static int is_climbing, is_searching;

static double error_of(const wide_case *c, const float *x)
{
    double error = c->error(x);
    return error == error ? error : HUGE_VAL;
}

static random_source source_on_tape(random_source r)
{
    tape.next = numbers;
    tape.end = numbers + TAPE;
    r.tape = &tape;
    r.fine = 1;
    return r;
}

/* The sample that the tape says, or what is drawn for the seed x from it. */
static double error_on_tape(const wide_case *c, int by_seed, float *x)
{
    if (!by_seed) {
        random_source r = source_on_tape(random_from(0));
        c->sample(&r, x);
    }
    return error_of(c, x);
}

/* Half a number of the tape, from -2^62 to 2^62: 0 is the middle of the range that is drawn from it. */
static int64_t about_middle(uint64_t number)
{
    return (int64_t)(number >> 1) - (INT64_C(1) << 62);
}

static uint64_t from_middle(int64_t k)
{
    return (uint64_t)(k + (INT64_C(1) << 62)) << 1;
}

/* The component by whole powers of two: nearer to the middle of its range, or away from it as far as the range goes. */
static uint64_t by_exponents(random_source *r, uint64_t number)
{
    int64_t k = about_middle(number), factor = INT64_C(1) << random_bits(r) % 40;
    if (random_bits(r) % 4 == 0 && k < (INT64_C(1) << 60) && k > -(INT64_C(1) << 60))
        return from_middle(k * 4);
    return from_middle(k / factor);
}

/*
 * A number of the tape by 1 to 2^20 last places of the float that is made of it, wherever those bits are taken from;
 * with fewer bits; with one of the highest bits the other way round; another one; by whole exponents; or equal or
 * opposite to another number, as far as their ranges are alike.
 */
static uint64_t changed(random_source *r, uint64_t number, size_t used)
{
    uint64_t kind = random_bits(r) % 11, place = random_bits(r) % 44;
    uint64_t step = (1 + random_bits(r) % (UINT64_C(1) << random_bits(r) % 21)) << place;
    switch (kind) {
    case 5:
        return number & ~UINT64_C(0) << (place + 18);
    case 6:
        return number ^ UINT64_C(1) << (63 - place / 2);
    case 7:
        return random_bits(r);
    case 8:
        return by_exponents(r, number);
    case 9:
        return numbers[random_bits(r) % used];
    case 10:
        return ~numbers[random_bits(r) % used];
    default:
        return kind % 2 ? number + step : number - step;
    }
}

/* So many changes without gain end a climb; it begins from the worst of so many samples. */
#define PATIENCE 3000
#define STARTS   300

/* The tape of a sample: x is its seed, or is drawn with the seed `start`. */
static void fill_tape(int by_seed, uint64_t start, const float *x)
{
    random_source r = by_seed ? wide_source(x) : random_from(start);
    for (int i = 0; i < TAPE; i++)
        numbers[i] = random_bits(&r);
}

/* The seed of the worst of the next samples; for cases that draw from one, x is that. */
static uint64_t find_start(const wide_case *c, int by_seed, uint64_t first, uint64_t count, float *x)
{
    double worst = -1.0;
    uint64_t start = first;
    for (uint64_t i = first; i < first + count; i++) {
        float sample[WIDE_ARGUMENTS];
        random_source r = random_from(i);
        r.fine = 1;
        c->sample(&r, sample);
        double error = error_of(c, sample);
        if (error <= worst)
            continue;
        worst = error;
        start = i;
        memcpy(x, sample, by_seed ? 2 * sizeof *x : 0);
    }
    return start;
}

static void note_worst(const wide_case *c, double worst, const float *x, wide_worst *w)
{
    if (worst <= w->worst)
        return;
    w->worst = worst;
    memcpy(w->witness, x, (size_t)c->arguments * sizeof *x);
}

/* One climb of at most `steps` changes, one number at a time; the worst goes to w. Returns their number. */
static uint64_t climb(const wide_case *c, int by_seed, random_source *r, uint64_t steps, float *x, wide_worst *w)
{
    uint64_t step = 0, idle = 0;
    is_climbing = 1;
    double worst = error_on_tape(c, by_seed, x);
    float at_worst[WIDE_ARGUMENTS];
    memcpy(at_worst, x, sizeof at_worst);
    for (; step < steps && idle < PATIENCE; step++, idle++) {
        size_t used = (size_t)(tape.next - numbers), at = (size_t)(random_bits(r) % used);
        uint64_t old = numbers[at];
        numbers[at] = changed(r, old, used);
        double error = error_on_tape(c, by_seed, x);
        idle = error > worst ? 0 : idle;
        if (error >= worst) {
            worst = error;
            memcpy(at_worst, x, (size_t)c->arguments * sizeof *x);
        } else {
            numbers[at] = old;
        }
    }
    is_climbing = 0;
    note_worst(c, worst, at_worst, w);
    memcpy(x, at_worst, sizeof at_worst);
    return step;
}

/* ---- The same for the components of unit quaternions; a number of the tape changes all four of them ---- */

/* Where x has four numbers that may be those of an exactly unit quaternion, each rounded: within 2^-24 of unit. */
static int find_units(const float *x, int arguments, int at[WIDE_ARGUMENTS])
{
    int count = 0;
    for (int i = 0; i + 4 <= arguments; i++) {
        double n2 = 0.0;
        for (int k = 0; k < 4; k++)
            n2 += (double)x[i + k] * (double)x[i + k];
        if (fabs(n2 - 1.0) <= 0x1p-23) {
            at[count++] = i;
            i += 3;
        }
    }
    return count;
}

/* One component by some last places, or by a power of two. */
static void change_component(random_source *r, float *x)
{
    int32_t bits, step = (int32_t)(1 + random_bits(r) % (UINT64_C(1) << random_bits(r) % 21));
    if (random_bits(r) % 8 == 0) {
        *x = ldexpf(*x, (int)(random_bits(r) % 31) - 25);
        return;
    }
    memcpy(&bits, x, sizeof bits);
    bits += random_bits(r) >> 63 ? step : -step;
    memcpy(x, &bits, sizeof bits);
}

/* One component is changed, another so that the length stays 1. Returns 0 where that is not possible. */
static int change_unit(random_source *r, float *q)
{
    size_t i = (size_t)(random_bits(r) % 4), j = (i + 1 + (size_t)(random_bits(r) % 3)) % 4;
    double rest = 1.0;
    change_component(r, &q[i]);
    q[i] = random_bits(r) % 64 ? q[i] : -q[i];
    for (size_t k = 0; k < 4; k++)
        rest -= k == j ? 0.0 : (double)q[k] * (double)q[k];
    q[j] = (float)(q[j] < 0.0f ? -sqrt(rest) : sqrt(rest));
    double n2 = 1.0 - rest + (double)q[j] * (double)q[j];
    return rest > 0.0 && fabs(n2 - 1.0) <= 0x1p-24;
}

/* The unit quaternion that argument i is of, or -1. */
static int unit_of(int i, const int at[WIDE_ARGUMENTS], int units)
{
    for (int k = 0; k < units; k++)
        if (i >= at[k] && i < at[k] + 4)
            return at[k];
    return -1;
}

/* By 1 to 256 last places: in its region still. */
static void change_little(random_source *r, float *x)
{
    int32_t bits, step = (int32_t)(1 + random_bits(r) % (UINT64_C(1) << random_bits(r) % 9));
    float changed;
    memcpy(&bits, x, sizeof bits);
    bits += random_bits(r) >> 63 ? step : -step;
    memcpy(&changed, &bits, sizeof changed);
    int is_within = fabsf(changed) <= 1.0f || fabsf(*x) > 1.0f;
    *x = is_within && changed - changed == 0.0f ? changed : *x;
}

static uint64_t climb_units(const wide_case *c, random_source *r, uint64_t steps, const float *start, wide_worst *w)
{
    float x[WIDE_ARGUMENTS], next[WIDE_ARGUMENTS];
    int at[WIDE_ARGUMENTS], units = find_units(start, c->arguments, at);
    uint64_t step = 0, idle = 0;
    memcpy(x, start, sizeof x);
    double worst = error_of(c, x);
    for (; units > 0 && step < steps && idle < PATIENCE; step++, idle++) {
        memcpy(next, x, sizeof x);
        int i = (int)(random_bits(r) % (uint64_t)c->arguments), unit = unit_of(i, at, units);
        if (unit < 0)
            change_little(r, next + i);
        else if (!change_unit(r, next + unit))
            continue;
        double error = error_of(c, next);
        idle = error > worst ? 0 : idle;
        if (error < worst)
            continue;
        worst = error;
        memcpy(x, next, sizeof x);
    }
    note_worst(c, worst, x, w);
    return step;
}

static wide_worst sampled(const wide_case *c, uint64_t count)
{
    wide_worst w;
    random_source r = random_from(1);
    memset(&w, 0, sizeof w);
    w.worst = -1.0;
    w.count = count;
    for (uint64_t i = 0; i < count; i++) {
        float x[WIDE_ARGUMENTS];
        c->sample(&r, x);
        double error = error_of(c, x);
        w.squares += error * error;
        if (error > w.worst) {
            w.worst = error;
            memcpy(w.witness, x, (size_t)c->arguments * sizeof *x);
        }
    }
    return w;
}

/* Climbs from start to start until `steps` errors have been computed. */
static void search(const wide_case *c, int by_seed, uint64_t steps, wide_worst *w)
{
    random_source r = random_from(2);
    uint64_t first = 1000;
    is_searching = 1;
    while (steps > 0 && w->worst < HUGE_VAL) {
        uint64_t starts = steps / 4 < STARTS ? steps / 4 + 1 : STARTS;
        float x[WIDE_ARGUMENTS] = {0};
        uint64_t start = find_start(c, by_seed, first, starts, x);
        first += starts;
        steps -= starts < steps ? starts : steps;
        fill_tape(by_seed, start, x);
        uint64_t used = climb(c, by_seed, &r, steps, x, w);
        steps -= used < steps ? used : steps;
        used = c->kind == WIDE_UNITS ? climb_units(c, &r, steps, x, w) : 0;
        steps -= used < steps ? used : steps;
    }
    is_searching = 0;
}

static void print_witness(FILE *file, const wide_case *c, const wide_worst *w, const char *end)
{
    for (int i = 0; i < c->arguments; i++)
        fprintf(file, i ? ", %a" : "%a", (double)w->witness[i]);
    fputs(end, file);
}

/* A row that the Error line does not speak of. */
static void note(const accuracy *a, const wide_case *c, const wide_worst *w)
{
    double rms = sqrt(w->squares / (double)w->count);
    printf("%-26s %-38s worst %.7g rms %.3g (noted) of %.0f\n", c->function, c->region, w->worst, rms,
           (double)w->count);
    if (a->out) {
        fprintf(a->out, "| `%s` | %s | %.7g | %.3g | noted | `", c->function, c->region, w->worst, rms);
        print_witness(a->out, c, w, "");
        fprintf(a->out, "` | %.0f |\n", (double)w->count);
    }
}

static void check(accuracy *a, const wide_case *c, const wide_worst *w)
{
    accuracy_worst row = accuracy_worst_begin(0);
    row.worst = w->worst;
    row.squares = w->squares;
    row.count = w->count;
    if ((size_t)c->arguments <= sizeof row.witness / sizeof row.witness[0]) {
        row.arguments = c->arguments;
        memcpy(row.witness, w->witness, (size_t)c->arguments * sizeof *w->witness);
    }
    accuracy_row(a, c->function, c->region, &row);
}

static void run(accuracy *a, const wide_case *cases, size_t size, uint64_t count, int by_seed, uint64_t steps)
{
    for (const wide_case *c = cases; c < cases + size; c++) {
        if (!accuracy_wants(a, c->function))
            continue;
        wide_worst w = sampled(c, 1 + (uint64_t)((double)count * a->effort));
        if (c->kind != WIDE_NOTED && w.worst > 0.0)
            search(c, by_seed, (uint64_t)((double)steps * a->effort), &w);
        if (c->kind != WIDE_NOTED)
            check(a, c, &w);
        else
            note(a, c, &w);
        fflush(stdout);
    }
}

void wide_run(accuracy *a, const wide_case *cases, size_t size, uint32_t count)
{
    run(a, cases, size, count, 0, 0);
}

void wide_search(accuracy *a, const wide_case *cases, size_t size, uint32_t count)
{
    run(a, cases, size, count, 0, count);
}

void wide_search_seeds(accuracy *a, const wide_case *cases, size_t size, uint32_t count)
{
    run(a, cases, size, count, 1, count);
}

/* ---- Seeds ---- */

void wide_seed(random_source *r, float *x)
{
    x[0] = (float)(random_bits(r) >> 44);
    x[1] = (float)(random_bits(r) >> 44);
}

random_source wide_source(const float *x)
{
    random_source r = random_from((uint64_t)x[0] << 20 | (uint64_t)x[1]);
    r.fine = is_searching;
    return is_climbing ? source_on_tape(r) : r;
}

#else

/* Not an empty file. */
extern const int wide_search_unavailable;
const int wide_search_unavailable = 1;

#endif
