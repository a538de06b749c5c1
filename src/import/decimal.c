/* SPDX-License-Identifier: MIT */
#include "decimal.h"

#include <jansson.h>
#include <math.h>
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

/*
 * The double nearest to it. Up to 15 digits and 10^22 are exact, so one division or product rounds once; others are
 * read as JSON, whose numbers do not depend on the locale.
 */
static double value_of(const decimal *d)
{
    static const double powers[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
                                    1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
    double number = 0.0;
    if (d->digits <= 15 && d->exponent >= -22 && d->exponent <= 22) {
        for (size_t i = 0; i < d->digits; i++)
            number = 10.0 * number + (d->text[i] - '0');
        number = d->exponent < 0 ? number / powers[-d->exponent] : number * powers[d->exponent];
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
