/* SPDX-License-Identifier: MIT */
/**
 * @file
 * Easing: functions that map the progress of a transition, 0 to 1, to the progress of its value. They ease in (begin
 * slowly), ease out (end slowly) or both.
 *
 * Penner's thirty and the functions of CSS. Multiply by the change of the value:
 *
 *     value = start + (end - start) ease(t),      t = elapsed / duration
 *
 * All is computed in binary64 and rounded once. Each function returns value, first and second derivative by t; divide
 * `velocity` by the duration and `acceleration` by its square. The value is exactly 0 at t = 0 and exactly 1 at t = 1,
 * except those of steps and linear() that CSS defines otherwise.
 */
#ifndef NAKAWARI_EASE_H
#define NAKAWARI_EASE_H

#include <stdint.h>

#include "curve.h"

#ifdef __cplusplus
extern "C" {
#endif

/**
 * The functions without parameters. `in` of Penner's ten families, with x = t:
 *
 *     SINE     1 - cos(pi x/2)
 *     QUAD, CUBIC, QUART, QUINT     x^2, x^3, x^4, x^5
 *     EXPO     2^(10 (x - 1)); 0 at x = 0, where it jumps by 2^-10
 *     CIRC     1 - sqrt(1 - x^2)
 *     BACK     x^2 ((c + 1) x - c),    c = 1.70158; for IN_OUT c = 1.70158 * 1.525
 *     ELASTIC  -2^(10 (x - 1)) sin((x - 1 - d/4) 2 pi/d),    d = 0.3; for IN_OUT d = 0.45; 0 at x = 0, where it jumps
 *     BOUNCE   1 - b(1 - x),   b(x) = 7.5625 (x - m)^2 + k in the parabola of x:
 *
 *                  x <         1/2.75      2/2.75      2.5/2.75     1
 *                  m           0           1.5/2.75    2.25/2.75    2.625/2.75
 *                  k           0           0.75        0.9375       0.984375
 *
 *     OUT      1 - in(1 - t)
 *     IN_OUT   in(2t)/2 for t < 1/2, otherwise 1 - in(2 - 2t)/2
 *
 * The keywords of CSS:
 *
 *     LINEAR           t
 *     CSS              cubic-bezier(0.25, 0.1, 0.25, 1)    `ease`
 *     CSS_IN           cubic-bezier(0.42, 0, 1, 1)         `ease-in`
 *     CSS_OUT          cubic-bezier(0, 0, 0.58, 1)         `ease-out`
 *     CSS_IN_OUT       cubic-bezier(0.42, 0, 0.58, 1)      `ease-in-out`
 *     CSS_STEP_START   steps(1, jump-start)                `step-start`
 *     CSS_STEP_END     steps(1, jump-end)                  `step-end`
 *
 * Any other number is read as NKW_EASE_LINEAR.
 */
typedef enum nkw_ease_kind {
    NKW_EASE_LINEAR,
    NKW_EASE_SINE_IN,
    NKW_EASE_SINE_OUT,
    NKW_EASE_SINE_IN_OUT,
    NKW_EASE_QUAD_IN,
    NKW_EASE_QUAD_OUT,
    NKW_EASE_QUAD_IN_OUT,
    NKW_EASE_CUBIC_IN,
    NKW_EASE_CUBIC_OUT,
    NKW_EASE_CUBIC_IN_OUT,
    NKW_EASE_QUART_IN,
    NKW_EASE_QUART_OUT,
    NKW_EASE_QUART_IN_OUT,
    NKW_EASE_QUINT_IN,
    NKW_EASE_QUINT_OUT,
    NKW_EASE_QUINT_IN_OUT,
    NKW_EASE_EXPO_IN,
    NKW_EASE_EXPO_OUT,
    NKW_EASE_EXPO_IN_OUT,
    NKW_EASE_CIRC_IN,
    NKW_EASE_CIRC_OUT,
    NKW_EASE_CIRC_IN_OUT,
    NKW_EASE_BACK_IN,
    NKW_EASE_BACK_OUT,
    NKW_EASE_BACK_IN_OUT,
    NKW_EASE_ELASTIC_IN,
    NKW_EASE_ELASTIC_OUT,
    NKW_EASE_ELASTIC_IN_OUT,
    NKW_EASE_BOUNCE_IN,
    NKW_EASE_BOUNCE_OUT,
    NKW_EASE_BOUNCE_IN_OUT,
    NKW_EASE_CSS,
    NKW_EASE_CSS_IN,
    NKW_EASE_CSS_OUT,
    NKW_EASE_CSS_IN_OUT,
    NKW_EASE_CSS_STEP_START,
    NKW_EASE_CSS_STEP_END,
    NKW_EASE_COUNT,
    NKW_EASE_KIND_MAX_ENUM = 0x7fffffff
} nkw_ease_kind;

/** The position of the jumps of steps(): at the start or at the end of each step, at neither or both ends of 0..1. */
typedef enum nkw_ease_jump {
    NKW_EASE_JUMP_START, /**< 1/n, 2/n ... 1 */
    NKW_EASE_JUMP_END, /**< 0, 1/n ... (n - 1)/n; and any other number */
    NKW_EASE_JUMP_NONE, /**< 0, 1/(n - 1) ... 1 */
    NKW_EASE_JUMP_BOTH, /**< 1/(n + 1), 2/(n + 1) ... n/(n + 1) */
    NKW_EASE_JUMP_MAX_ENUM = 0x7fffffff
} nkw_ease_jump;

/**
 * The easing function of a kind at t.
 *
 * t        outside 0..1: Penner's functions return their end, 0 or 1, with derivatives 0; those of CSS as
 *          nkw_easing_evaluate and, for LINEAR, t itself. NaN returns NaN
 * Returns  at a corner (BOUNCE, the middle of QUINT_IN_OUT ...) the derivatives to its right; at 0 and 1 those within
 *          0..1; infinity where CIRC is vertical
 *
 * Error  1.1 u of the larger of 1 and the result, for each of the three.
 * Source Penner, Programming Macromedia Flash MX, chapter 7, 2002; CSS Easing Functions Level 2, W3C, 2024.
 */
NKW_API nkw_motion nkw_ease_evaluate(nkw_ease_kind kind, float t);
/** What an nkw_easing is. Any other number is read as NKW_EASING_CUBIC_BEZIER. */
typedef enum nkw_easing_kind {
    NKW_EASING_CUBIC_BEZIER, /**< cubic-bezier(curve[0], curve[1], curve[2], curve[3]) */
    NKW_EASING_STEPS, /**< steps(count, jump) */
    NKW_EASING_LINEAR, /**< linear() of the points (inputs[i], outputs[i]), i < count */
    NKW_EASING_KIND_MAX_ENUM = 0x7fffffff
} nkw_easing_kind;

/** An easing function of CSS with its numbers. The fields of other kinds are not read. */
typedef struct nkw_easing {
    nkw_easing_kind kind;
    float curve[4]; /**< x1, y1, x2, y2 */
    nkw_ease_jump jump;
    size_t count; /**< of steps, or of points */
    const float *inputs; /**< ascending; nkw_easing_complete computes those that CSS lets an author omit */
    const float *outputs;
} nkw_easing;
NKW_SIZE(nkw_easing, 48, 36);

/**
 * An easing function of CSS at t: value, first and second derivative by t.
 *
 * CUBIC_BEZIER is nkw_handle_sample of the segment from (0, 0) to (1, 1) with control points (x1, y1) and (x2, y2). x1
 * and x2 are 0..1 in CSS; otherwise the curve can run back, and its first value counts, as in handle.h. For t outside
 * 0..1 the curve continues along its tangent there, `acceleration` 0; where the tangent is vertical, it holds the end.
 * Returns NaN if x1 or x2 is not finite.
 *
 * STEPS, with n = count and m = n, n, n - 1, n + 1 jumps:
 *
 *     floor(t n)/m for END and NONE,    (floor(t n) + 1)/m for START and BOTH,    derivatives 0
 *
 * At the time of a jump the value is that after it, as without the before flag of CSS. t in 0..1 returns 0..1; outside,
 * the steps continue. The count is at least 1, for NONE 2; a smaller count is read as that.
 *
 * LINEAR has straight lines between its points. At an input that several points have, the last of them counts, and
 * `velocity` is the slope to its right. Outside, the first and the last line continue; if the first or last two points
 * have one input, the value there is that of the first or last. No points return 0, one point returns its output. Any
 * inputs are answered.
 *
 * Returns  NaN for a NaN t
 *
 * Error  1.1 u of the largest of 1, |y1| and |y2|, for CUBIC_BEZIER, t in 0..1 and the value, relative to the exact
 *        curve at some time within 2^-48 of t, or of the largest handle, if that is longer than 1; 1.0 u of the result,
 *        for STEPS, if t count < 2^24; 1.1 u of the larger of the result and the two outputs, for the value of LINEAR.
 * Source CSS Easing Functions Level 2, W3C, 2024, sections 2.1 to 2.3.
 */
NKW_API nkw_motion nkw_easing_evaluate(const nkw_easing *easing, float t);

/**
 * Completes the inputs of linear(), where omitted ones are NaN: the first becomes 0, the last 1, an input that is less
 * than one before it becomes the largest of those, and omitted ones between are spaced evenly. In place.
 */
NKW_API void nkw_easing_complete(float *inputs, size_t count);

#ifdef __cplusplus
}
#endif

#endif
