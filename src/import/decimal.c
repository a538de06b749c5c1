/* SPDX-License-Identifier: MIT */
#include "decimal.h"

#include <jansson.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

enum { NUMBER_MOST = 64 };

static int is_digit(char c)
{
    return c >= '0' && c <= '9';
}

/* The digits of a decimal number, and the power of ten that they are of. */
typedef struct decimal {
    int is_negative, exponent;
    size_t digits; /* significant ones */
    char text[NUMBER_MOST]; /* of these */
} decimal;

static void take_digit(decimal *d, char c, int is_fraction)
{
    d->exponent -= is_fraction;
    if (d->digits > 0 || c != '0')
        d->text[d->digits++] = c;
}

/* Sign, digits, a point or comma, digits, exponent; one digit at least. Returns whether all of `text` is that. */
static int take_decimal(const char *text, size_t length, decimal *d)
{
    size_t i = 0, seen = 0;
    int exponent = 0, sign = 1;
    memset(d, 0, sizeof *d);
    d->is_negative = text[0] == '-';
    i += text[0] == '-' || text[0] == '+';
    for (; i < length && is_digit(text[i]); i++, seen++)
        take_digit(d, text[i], 0);
    if (i < length && (text[i] == '.' || text[i] == ','))
        for (i++; i < length && is_digit(text[i]); i++, seen++)
            take_digit(d, text[i], 1);
    if (seen > 0 && i + 1 < length && (text[i] == 'e' || text[i] == 'E')) {
        i++;
        sign = text[i] == '-' ? -1 : 1;
        i += text[i] == '-' || text[i] == '+';
        for (seen = 0; i < length && is_digit(text[i]); i++, seen++)
            exponent = exponent < 10000 ? 10 * exponent + (text[i] - '0') : exponent;
    }
    d->exponent += sign * exponent;
    return seen > 0 && i == length;
}

/* Those that a double has exactly. */
enum { POWER_MOST = 22 };
static const double powers[POWER_MOST + 1] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
                                              1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

/* number 10^exponent, rounded once. */
static double times_power(double number, int exponent)
{
    return exponent < 0 ? number / powers[-exponent] : number * powers[exponent];
}

/*
 * The double nearest to it. Up to 15 digits and 10^22 are exact, so one division or product rounds once; others are
 * read as JSON, whose numbers do not depend on the locale.
 */
static double value_of(const decimal *d)
{
    double number = 0.0;
    if (d->digits <= 15 && d->exponent >= -POWER_MOST && d->exponent <= POWER_MOST) {
        for (size_t i = 0; i < d->digits; i++)
            number = 10.0 * number + (d->text[i] - '0');
        number = times_power(number, d->exponent);
    } else if (d->digits > 0) {
        char text[NUMBER_MOST + 16];
        snprintf(text, sizeof text, "%.*se%d", (int)d->digits, d->text, d->exponent);
        json_t *json = json_loads(text, JSON_DECODE_ANY | JSON_DECODE_INT_AS_REAL, NULL);
        number = json ? json_number_value(json) : d->exponent > 0 ? HUGE_VAL : 0.0;
        json_decref(json);
    }
    return d->is_negative ? -number : number;
}

const char *nkwi_decimal(const char *text, size_t length, double *number)
{
    decimal d;
    if (length == 0 || length >= NUMBER_MOST || !take_decimal(text, length, &d))
        return "a number is expected";
    *number = value_of(&d);
    return fabs(*number) <= (double)3.4e38f ? NULL : "the number is not finite as a float";
}

/* ---- Writing ---- */

/*
 * The digits of a positive float, x = digits 10^exponent. Floats of six digits differ, so a number of at most six is
 * among those rounded to six; nine digits are always enough. 0 where no power of ten is exact: below 1e-14, from 1e22.
 */
static uint32_t shortest(float x, int *exponent)
{
    enum { LEAST = 6, MOST = 9 };
    int size = 0;
    while (size < POWER_MOST && (double)x >= powers[size])
        size++;
    while (size > MOST - POWER_MOST && size <= 0 && times_power((double)x, 1 - size) < 1.0)
        size--;
    for (int count = LEAST; (double)x < powers[POWER_MOST] && count <= MOST; count++) {
        const uint32_t digits = (uint32_t)(times_power((double)x, count - size) + 0.5);
        if ((float)times_power((double)digits, size - count) == x) {
            *exponent = size - count;
            return digits;
        }
    }
    return 0;
}

/* The same of very large and very small ones, from the text of the system: digits around any point, and an exponent. */
static uint32_t nine_digits(float x, int *exponent)
{
    char text[64];
    uint32_t digits = 0;
    const int length = snprintf(text, sizeof text, "%.8e", (double)x);
    int power = 0, at = 0;
    for (; at < length && text[at] != 'e'; at++)
        digits = is_digit(text[at]) ? 10 * digits + (uint32_t)(text[at] - '0') : digits;
    const int is_negative = at + 1 < length && text[at + 1] == '-';
    for (; at < length; at++)
        power = is_digit(text[at]) ? 10 * power + (text[at] - '0') : power;
    *exponent = (is_negative ? -power : power) - 8;
    return digits;
}

/* digits 10^exponent as 123, 1200, 1.23, 0.00123 or 123e-20. */
static size_t put_decimal(uint32_t digits, int exponent, char *out)
{
    char text[16];
    const int count = snprintf(text, sizeof text, "%lu", (unsigned long)digits), point = count + exponent;
    if (point > 9 || point < -4)
        return (size_t)snprintf(out, NKWI_DECIMAL_ROOM - 1, "%se%d", text, exponent);
    if (exponent >= 0)
        return (size_t)snprintf(out, NKWI_DECIMAL_ROOM - 1, "%s%.*s", text, exponent, "000000000");
    if (point > 0)
        return (size_t)snprintf(out, NKWI_DECIMAL_ROOM - 1, "%.*s.%s", point, text, text + point);
    return (size_t)snprintf(out, NKWI_DECIMAL_ROOM - 1, "0.%.*s%s", -point, "0000", text);
}

size_t nkwi_decimal_write(float number, char *out)
{
    const int is_negative = number < 0.0f;
    const float x = is_negative ? -number : number;
    int exponent = 0;
    if (!(x > 0.0f && x <= 3.402823466e38f)) {
        memcpy(out, "0", 2);
        return 1;
    }
    uint32_t digits = shortest(x, &exponent);
    if (digits == 0)
        digits = nine_digits(x, &exponent);
    for (; digits % 10 == 0; exponent++)
        digits /= 10;
    *out = '-';
    return (size_t)is_negative + put_decimal(digits, exponent, out + is_negative);
}
