/* SPDX-License-Identifier: MIT */
#include "student.h"

#include <math.h>
#include <string.h>

#define PI 3.14159265358979323846

typedef double matrix[3][3];

static void turn(matrix m, int axis, double angle)
{
    const int a = (axis + 1) % 3, b = (axis + 2) % 3;
    memset(m, 0, sizeof(matrix));
    m[axis][axis] = 1.0;
    m[a][a] = m[b][b] = cos(angle);
    m[a][b] = -sin(angle);
    m[b][a] = sin(angle);
}

/* a = a b */
static void multiply(matrix a, matrix b)
{
    matrix m;
    for (int r = 0; r < 3; r++)
        for (int c = 0; c < 3; c++)
            m[r][c] = a[r][0] * b[0][c] + a[r][1] * b[1][c] + a[r][2] * b[2][c];
    memcpy(a, m, sizeof m);
}

static void yaw_pitch_roll(matrix o, double yaw, double pitch, double roll)
{
    matrix m;
    turn(o, 1, yaw);
    turn(m, 0, pitch);
    multiply(o, m);
    turn(m, 2, roll);
    multiply(o, m);
}

enum { KEYS = 7 };

/* SetupScene( 1 ): position, yaw, pitch and roll in parts of pi. */
static const double scene1[KEYS][6] = {
    {-1.0, 0.5, -1.5, 0.6, 0.0, 0.0},         {0.0, 1.0, 0.0, 1.2, 1.0 / 3.0, 0.25},
    {-2.0, 0.5, 1.0, 1.0, -1.0 / 6.0, 0.0},   {0.0, 0.4, 1.5, 1.2, 0.0, 0.0},
    {1.0, 0.35, 1.75, -0.4, 1.0 / 12.0, 0.0}, {1.5, 0.6, 0.0, 0.0, 0.0, 0.0},
    {1.0, 1.0, -1.0, 1.0 / 3.0, 0.0, 0.0},
};

static void key_orientation(int k, matrix o)
{
    yaw_pitch_roll(o, PI * scene1[k][3], PI * scene1[k][4], PI * scene1[k][5]);
}

/* ---- positions ---- */

static void hermite(const student *s, int k, double t, double p[3])
{
    double a = 2 * t * t * t - 3 * t * t + 1, b = -2 * t * t * t + 3 * t * t, c = t * t * t - 2 * t * t + t;
    double d = s->slip == SLIP_PLUS ? t * t * t + t * t : t * t * t - t * t;
    const double sign = s->slip == SLIP_TANGENT ? 1.0 : -1.0;
    matrix o0, o1;
    key_orientation(k, o0);
    key_orientation(k + 1, o1);
    if (s->slip == SLIP_EXCHANGED) {
        const double swap = b;
        b = c;
        c = swap;
    }
    for (int i = 0; i < 3; i++)
        p[i] = a * scene1[k][i] + b * scene1[k + 1][i] + c * sign * o0[i][2] + d * sign * o1[i][2];
}

static void bezier(const student *s, int k, double t, double time, double p[3])
{
    const int first = k / 3 * 3;
    double u = (time - first) / 3.0;
    if (s->slip == SLIP_T_FOR_S || (s->slip == SLIP_T_LATER && first > 0))
        u = t;
    const double r = s->slip == SLIP_MINUS_ONE ? u - 1 : 1 - u;
    for (int i = 0; i < 3; i++)
        p[i] = r * r * r * scene1[first][i] + 3 * r * r * u * scene1[first + 1][i] +
               3 * r * u * u * scene1[first + 2][i] + u * u * u * scene1[first + 3][i];
}

static void bspline(const student *s, int k, double t, double p[3])
{
    const int k0 = k > 0 ? k - 1 : k, k3 = k + 2 == KEYS ? k + 1 : k + 2;
    const double sixth = s->slip == SLIP_INTEGER ? 1 / 6 : 1 / 6.0, half = s->slip == SLIP_INTEGER ? 1 / 2 : 0.5;
    const double thirds = s->slip == SLIP_INTEGER ? 2 / 3 : 2 / 3.0, t2 = t * t, t3 = t2 * t;
    for (int i = 0; i < 3; i++)
        p[i] = (-sixth * t3 + half * t2 - half * t + sixth) * scene1[k0][i] + (half * t3 - t2 + thirds) * scene1[k][i] +
               (-half * t3 + half * t2 + half * t + sixth) * scene1[k + 1][i] + sixth * t3 * scene1[k3][i];
}

/* ---- orientations ---- */

void student_angles(double o[3][3], double angles[3])
{
    const double yaw = atan2(o[0][2], o[2][2]);
    const double pitch = atan2(-o[1][2], sqrt(o[0][2] * o[0][2] + o[2][2] * o[2][2]));
    angles[0] = yaw;
    angles[1] = pitch;
    angles[2] = atan2(cos(pitch) * (sin(yaw) * o[2][1] - cos(yaw) * o[0][1]), o[1][1]);
}

static void euler(const student *s, int k, double t, matrix o)
{
    matrix o0, o1;
    double a0[3], a1[3], a[3];
    key_orientation(k, o0);
    key_orientation(k + 1, o1);
    student_angles(o0, a0);
    student_angles(o1, a1);
    if (s->slip != SLIP_UNWRAP && a0[0] < a1[0] - PI)
        a0[0] += 2 * PI;
    else if (s->slip != SLIP_UNWRAP && a0[0] > a1[0] + PI)
        a0[0] -= 2 * PI;
    for (int i = 0; i < 3; i++)
        a[i] = ((a1[i] - a0[i]) * t + a0[i]) * (s->slip == SLIP_DEGREES ? 180 / PI : 1.0);
    yaw_pitch_roll(o, a[0], a[1], a[2]);
    if (s->slip != SLIP_ORDER)
        return;
    matrix m;
    turn(o, 2, a[2]);
    turn(m, 0, a[1]);
    multiply(o, m);
    turn(m, 1, a[0]);
    multiply(o, m);
}

/* vecmath: w from the trace if that is not negative, else the component of the largest diagonal element is positive. */
void student_quaternion(double o[3][3], double q[4])
{
    const double trace = o[0][0] + o[1][1] + o[2][2];
    if (trace >= 0.0) {
        const double w = sqrt(trace + 1.0), r = 0.5 / w;
        q[3] = 0.5 * w;
        for (int i = 0; i < 3; i++)
            q[i] = (o[(i + 2) % 3][(i + 1) % 3] - o[(i + 1) % 3][(i + 2) % 3]) * r;
        return;
    }
    int i = o[1][1] > o[0][0] ? 1 : 0;
    i = o[2][2] > o[i][i] ? 2 : i;
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    const double x = sqrt(o[i][i] - o[j][j] - o[k][k] + 1.0), r = 0.5 / x;
    q[i] = 0.5 * x;
    q[j] = (o[i][j] + o[j][i]) * r;
    q[k] = (o[i][k] + o[k][i]) * r;
    q[3] = (o[k][j] - o[j][k]) * r;
}

/* vecmath: of a quaternion of any length. */
static void matrix_of(const double q[4], matrix o)
{
    const double s = 2.0 / (q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        o[i][i] = 1.0 - s * (q[j] * q[j] + q[k] * q[k]);
        o[i][j] = s * (q[i] * q[j] - q[3] * q[k]);
        o[j][i] = s * (q[i] * q[j] + q[3] * q[k]);
    }
}

static void slerp(const student *s, int k, double t, matrix o)
{
    matrix o0, o1;
    double q0[4], q1[4], q[4], dot = 0.0;
    key_orientation(k, o0);
    key_orientation(k + 1, o1);
    student_quaternion(o0, q0);
    student_quaternion(o1, q1);
    for (int i = 0; i < 4; i++)
        dot += q0[i] * q1[i];
    for (int i = 0; i < 4 && dot < 0 && s->slip != SLIP_NO_BLANK_B; i++)
        q1[i] = i == 3 && s->slip == SLIP_CONJUGATE ? q1[i] : -q1[i];
    dot = q0[0] * q1[0] + q0[1] * q1[1] + q0[2] * q1[2] + q0[3] * q1[3];
    const double theta = acos(dot) * (s->slip == SLIP_THETA ? 180 / PI : 1.0);
    const double w0 = s->slip == SLIP_BRACKET ? sin(1 - t) * theta : sin((1 - t) * theta);
    for (int i = 0; i < 4; i++)
        q[i] = (w0 * q0[i] + sin(t * theta) * q1[i]) / sin(theta);
    matrix_of(q, o);
}

/* ---- all ---- */

student_pose student_sample(const student *s, double time)
{
    student_pose pose;
    int k = 0;
    while (k < KEYS - 2 && (s->slip == SLIP_HALF_OPEN ? time >= k + 1 : time > k + 1))
        k++;
    const double t = time < 0 ? 0.0 : time > KEYS - 1 ? 1.0 : time - k;
    if (s->position == STUDENT_LINEAR)
        for (int i = 0; i < 3; i++)
            pose.p[i] = (1 - t) * scene1[k][i] + t * scene1[k + 1][i];
    else if (s->position == STUDENT_HERMITE)
        hermite(s, k, t, pose.p);
    else if (s->position == STUDENT_BEZIER)
        bezier(s, k, t, time, pose.p);
    else
        bspline(s, k, t, pose.p);
    if (s->orientation == STUDENT_NONE)
        key_orientation(k, pose.o);
    else if (s->orientation == STUDENT_EULER)
        euler(s, k, t, pose.o);
    else
        slerp(s, k, t, pose.o);
    return pose;
}
