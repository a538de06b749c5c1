# SPDX-License-Identifier: CC0-1.0
"""A minimal implementation in binary64, as an example of an adapter for run.py."""
import math


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def scale(a, s):
    return [x * s for x in a]


def add(a, b):
    return [x + y for x, y in zip(a, b)]


def length(a):
    return math.sqrt(dot(a, a))


def hermite(p0, v0, p1, v1, t):
    s = 1 - t
    return [(1 + 2 * t) * s * s * p0 + t * s * s * v0 + t * t * (3 - 2 * t) * p1 - t * t * s * v1]


def bezier(p0, p1, p2, p3, t):
    s = 1 - t
    return [s * s * s * p0 + 3 * s * s * t * p1 + 3 * s * t * t * p2 + t * t * t * p3]


def quat_mul(a, b):
    ax, ay, az, aw = a
    bx, by, bz, bw = b
    return [[
        aw * bx + ax * bw + ay * bz - az * by,
        aw * by - ax * bz + ay * bw + az * bx,
        aw * bz + ax * by - ay * bx + az * bw,
        aw * bw - ax * bx - ay * by - az * bz,
    ]]


def quat_rotate(q, v):
    conjugate = [-q[0], -q[1], -q[2], q[3]]
    return [quat_mul(quat_mul(q, [*v, 0.0])[0], conjugate)[0][:3]]


def nlerp(a, b, t):
    line = add(scale(a, 1 - t), scale(b, -t if dot(a, b) < 0 else t))
    return [scale(line, 1 / length(line))]


def slerp(a, b, t):
    c = scale(b, -1) if dot(a, b) < 0 else b
    # The angle from the chords: exact for small angles and near a half turn too.
    h = 2 * math.atan2(length(add(a, scale(c, -1))), length(add(a, c)))
    if h == 0:
        return [a]
    return [scale(add(scale(a, math.sin((1 - t) * h)), scale(c, math.sin(t * h))), 1 / math.sin(h))]
