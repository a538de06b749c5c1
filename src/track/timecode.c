/* SPDX-License-Identifier: MIT */
#include "lane/strict.h"

#include <nakawari/timecode.h>

#include "lane/f64.h"

/* A number of 128 bits. */
typedef struct wide {
    uint64_t high, low;
} wide;

static wide product(uint64_t a, uint64_t b)
{
    uint64_t al = a & 0xFFFFFFFFu, ah = a >> 32, bl = b & 0xFFFFFFFFu, bh = b >> 32;
    uint64_t low = al * bl, middle = ah * bl + (low >> 32), other = al * bh + (middle & 0xFFFFFFFFu);
    wide w = {ah * bh + (middle >> 32) + (other >> 32), (other << 32) | (low & 0xFFFFFFFFu)};
    return w;
}

/* n / d for n < 2^127 and 0 < d < 2^63, by long division. */
static wide quotient(wide n, uint64_t d, uint64_t *remainder)
{
    wide q = {n.high / d, 0};
    uint64_t r = n.high % d;
    for (int i = 63; i >= 0; i--) {
        r = (r << 1) | ((n.low >> i) & 1u);
        q.low = (q.low << 1) | (r >= d ? 1u : 0u);
        r -= r >= d ? d : 0;
    }
    *remainder = r;
    return q;
}

static int is_rate(nkw_rate r)
{
    return r.numerator > 0 && r.numerator <= INT64_C(1) << 40 && r.denominator > 0 && r.denominator <= INT64_C(1) << 22;
}

static uint64_t magnitude(int64_t x)
{
    return x < 0 ? 0 - (uint64_t)x : (uint64_t)x;
}

/*
 * Stores +-(q + f), 0 <= f < 1, rounded: `half` is -1, 0 or 1 as f is below, at or above 1/2, and `some` says that it
 * is not 0. NKW_OUT_OF_RANGE beyond 63 bits.
 */
static nkw_result rounded(wide q, int half, int some, int negative, nkw_round round, int64_t *out)
{
    int nearest = negative ? half > 0 : half >= 0;
    int up = round == NKW_ROUND_DOWN ? negative && some : round == NKW_ROUND_UP ? !negative && some : nearest;
    uint64_t n = q.low + (uint64_t)(up ? 1 : 0);
    if (q.high != 0 || n < q.low || n > (uint64_t)INT64_MAX)
        return NKW_OUT_OF_RANGE;
    *out = negative ? -(int64_t)n : (int64_t)n;
    return NKW_OK;
}

static int compare_to_half(uint64_t remainder, uint64_t d)
{
    return remainder > d - remainder ? 1 : remainder == d - remainder ? 0 : -1;
}

nkw_result nkw_ticks_convert(int64_t count, nkw_rate from, nkw_rate to, nkw_round round, int64_t *out)
{
    *out = 0;
    if (!is_rate(from) || !is_rate(to))
        return NKW_NO_RATE;
    uint64_t remainder, d = (uint64_t)from.numerator * (uint64_t)to.denominator;
    wide n = product(magnitude(count), (uint64_t)to.numerator * (uint64_t)from.denominator);
    wide q = quotient(n, d, &remainder);
    return rounded(q, compare_to_half(remainder, d), remainder != 0, count < 0, round, out);
}

/* The position of the highest bit of x, not 0. */
static int highest_bit(uint64_t x)
{
    int n = 0;
    for (int step = 32; step > 0; step /= 2)
        if (x >> step) {
            x >>= step;
            n += step;
        }
    return n;
}

/* q + f to the nearest double, q in 2^63 .. 2^125 and f in 0..1, not 0 if `some`; times 2^exponent. */
static double double_of(wide q, int some, int exponent)
{
    int drop = (q.high ? 64 + highest_bit(q.high) : highest_bit(q.low)) - 61;
    uint64_t lost = q.low & ((UINT64_C(1) << drop) - 1);
    uint64_t top = (q.low >> drop) | (q.high << (64 - drop));
    /* Of 62 bits, rounded once; bit 0 says that something was lost. */
    double x = (double)(int64_t)(top | (some || lost ? 1u : 0u));
    return x * lane_double((uint64_t)(1023 + exponent + drop) << 52);
}

nkw_result nkw_ticks_to_seconds(int64_t count, nkw_rate rate, double *seconds)
{
    uint64_t remainder;
    *seconds = 0.0;
    if (!is_rate(rate))
        return NKW_NO_RATE;
    if (count == 0)
        return NKW_OK;
    /* count denominator < 2^86; the shift makes the quotient longer than a double. */
    wide n = product(magnitude(count), (uint64_t)rate.denominator);
    int bits = n.high ? 64 + highest_bit(n.high) : highest_bit(n.low), shift = 124 - bits;
    wide s = {shift >= 64 ? n.low << (shift - 64) : (n.high << shift) | (shift ? n.low >> (64 - shift) : 0),
              shift >= 64 ? 0 : n.low << shift};
    wide q = quotient(s, (uint64_t)rate.numerator, &remainder);
    const double size = double_of(q, remainder != 0, -shift);
    *seconds = count < 0 ? -size : size;
    return NKW_OK;
}

/* A finite double as m 2^exponent, m < 2^53. */
static uint64_t mantissa_of(double x, int *exponent)
{
    uint64_t bits = lane_bits64(x) & ~LANE_SIGN, field = bits >> 52, m = bits & ((UINT64_C(1) << 52) - 1);
    *exponent = (int)(field > 0 ? field : 1) - 1075;
    return field > 0 ? m | UINT64_C(1) << 52 : m;
}

/* The bits of q below bit `shift`, 1 to 127, compared with a half; `some` says that more follows. */
static int compare_bits_to_half(wide q, int shift, int some, int *any)
{
    uint64_t high = shift > 64 ? q.high & ((UINT64_C(1) << (shift - 64)) - 1) : 0;
    uint64_t low = shift < 64 ? q.low & ((UINT64_C(1) << shift) - 1) : q.low;
    wide half = {shift > 64 ? UINT64_C(1) << (shift - 65) : 0, shift <= 64 ? UINT64_C(1) << (shift - 1) : 0};
    *any = some || high || low;
    int above = high > half.high || (high == half.high && low > half.low);
    int equal = high == half.high && low == half.low;
    return above || (equal && some) ? 1 : equal ? 0 : -1;
}

/* q / 2^shift, rounded down, for a shift of 1 to 127. */
static wide shifted_right(wide q, int shift)
{
    wide r = {0, 0};
    if (shift >= 64)
        r.low = q.high >> (shift - 64);
    else {
        r.high = q.high >> shift;
        r.low = (q.low >> shift) | (q.high << (64 - shift));
    }
    return r;
}

/* q 2^shift, for a shift of 1 to 63. */
static wide shifted_left(wide q, int shift)
{
    wide r = {(q.high << shift) | (q.low >> (64 - shift)), q.low << shift};
    return r;
}

nkw_result nkw_ticks_from_seconds(double seconds, nkw_rate rate, nkw_round round, int64_t *out)
{
    int exponent, any, half;
    uint64_t remainder;
    *out = 0;
    if (!is_rate(rate))
        return NKW_NO_RATE;
    if (seconds - seconds != 0.0)
        return NKW_NOT_FINITE;
    wide n = product(mantissa_of(seconds, &exponent), (uint64_t)rate.numerator); /* below 2^93 */
    if (exponent > 33) /* the count is at least 2^52 2^34 / 2^22 */
        return NKW_OUT_OF_RANGE;
    wide q = quotient(exponent > 0 ? shifted_left(n, exponent) : n, (uint64_t)rate.denominator, &remainder);
    if (exponent >= 0) /* the seconds are whole */
        return rounded(q, compare_to_half(remainder, (uint64_t)rate.denominator), remainder != 0, seconds < 0.0, round,
                       out);
    int shift = -exponent < 127 ? -exponent : 127;
    half = compare_bits_to_half(q, shift, remainder != 0, &any);
    return rounded(shifted_right(q, shift), half, any, seconds < 0.0, round, out);
}

/* ---- Timecode ---- */

static int is_label_rate(int32_t per_second, int drop)
{
    return per_second > 0 && per_second <= 1000 && (!drop || per_second % 30 == 0);
}

/* Labels that a minute leaves out. */
static int64_t dropped_in(int32_t per_second, int drop)
{
    return drop ? per_second / 15 : 0;
}

nkw_result nkw_timecode_from_frame(int64_t frame, int32_t per_second, int drop, nkw_timecode *out)
{
    const nkw_timecode none = {0, 0, 0, 0};
    *out = none;
    if (!is_label_rate(per_second, drop))
        return NKW_NO_RATE;
    int64_t minute = 60 * (int64_t)per_second, dropped = dropped_in(per_second, drop), ten = 10 * minute - 9 * dropped;
    if (frame < 0 || frame / (6 * ten) > INT32_MAX)
        return NKW_OUT_OF_RANGE;
    int64_t remainder = frame % ten, minutes = 0;
    /* The first minute of ten is complete. */
    if (remainder >= minute)
        minutes = 1 + (remainder - minute) / (minute - dropped);
    int64_t label = remainder + minutes * dropped, tens = frame / ten;
    out->hours = (int32_t)(tens / 6);
    out->minutes = (int32_t)(tens % 6 * 10 + label / minute);
    out->seconds = (int32_t)(label % minute / per_second);
    out->frames = (int32_t)(label % per_second);
    return NKW_OK;
}

nkw_result nkw_timecode_to_frame(nkw_timecode t, int32_t per_second, int drop, int64_t *out)
{
    *out = 0;
    if (!is_label_rate(per_second, drop))
        return NKW_NO_RATE;
    if (t.hours < 0 || t.minutes < 0 || t.minutes > 59 || t.seconds < 0 || t.seconds > 59 || t.frames < 0 ||
        t.frames >= per_second)
        return NKW_OUT_OF_RANGE;
    int64_t dropped = dropped_in(per_second, drop);
    if (t.minutes % 10 != 0 && t.seconds == 0 && t.frames < dropped)
        return NKW_OUT_OF_RANGE;
    int64_t minutes = 60 * (int64_t)t.hours + t.minutes;
    *out = (minutes * 60 + t.seconds) * per_second + t.frames - dropped * (minutes - minutes / 10);
    return NKW_OK;
}
