/* SPDX-License-Identifier: MIT */
/* nakawari exercise --check: programs of students, right and wrong, and every form of their numbers. */
#if !defined(_POSIX_C_SOURCE)
#define _POSIX_C_SOURCE 200809L
#endif
#include "program.h"
#include "student.h"

#include <math.h>
#include <stdlib.h>

#define CHECK "exercise '" NKW_FIGURES "/../examples/scenes.json' --clip scene1 --check "
#define PI    3.14159265358979323846

/* A row of a file, and what is printed before all rows. */
typedef struct form {
    const char *head, *end;
    void (*row)(FILE *f, double time, student_pose *pose);
} form;

static void put(FILE *f, char separator, const double *v, int n)
{
    for (int i = 0; i < n; i++)
        fprintf(f, "%c%.6f", separator, v[i]);
}

/* By columns, or, with `rows`, by rows. */
static void put_matrix(FILE *f, char separator, student_pose *pose, int rows)
{
    double m[16] = {0};
    m[15] = 1.0;
    for (int r = 0; r < 3; r++) {
        for (int c = 0; c < 3; c++)
            m[rows ? 4 * r + c : 4 * c + r] = pose->o[r][c];
        m[rows ? 4 * r + 3 : 12 + r] = pose->p[r];
    }
    put(f, separator, m, 16);
}

static void plain_row(FILE *f, double time, student_pose *pose)
{
    fprintf(f, "%g", time);
    put_matrix(f, ' ', pose, 0);
}

static void row_of_rows(FILE *f, double time, student_pose *pose)
{
    fprintf(f, "%g", time);
    put_matrix(f, ' ', pose, 1);
}

static void position_row(FILE *f, double time, student_pose *pose)
{
    fprintf(f, "%g", time);
    put(f, ',', pose->p, 3);
}

static const form plain = {"", "\n", plain_row}, by_rows = {"", "\n", row_of_rows},
                  positions = {"", "\n", position_row};

static void write_file(const char *path, const student *s, const form *to)
{
    FILE *f = fopen(path, "wb");
    assert_non_null(f);
    fputs(to->head, f);
    for (int i = 0; i <= 60; i++) {
        student_pose pose = student_sample(s, i / 10.0);
        if (s->slip == SLIP_NOISE && i % 3 == 0)
            pose.p[i / 3 % 3] += 0.05;
        to->row(f, i / 10.0, &pose);
        fputs(to->end, f);
    }
    assert_int_equal(fclose(f), 0);
}

static void says(const student *s, const form *to, int code, const char *text, const char *options)
{
    char arguments[512];
    write_file("mine.csv", s, to);
    snprintf(arguments, sizeof arguments, CHECK "mine.csv %s", options);
    program_says(code, text, arguments);
}

/* ---- right programs ---- */

static void right_programs_of_every_method_agree(void **state)
{
    (void)state;
    static const char *const p[] = {"linear", "hermite", "bezier", "bspline"}, *const q[] = {"none", "euler", "quat"};
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 3; j++) {
            const student s = {(student_position)i, (student_orientation)j, SLIP_NONE};
            char options[64], text[128];
            snprintf(text, sizeof text,
                     "position, %s (the most likely method): 61 rows agree\norientation, %s (the most "
                     "likely method): 61 rows agree\n",
                     p[i], q[j]);
            says(&s, &plain, 0, text, "");
            snprintf(options, sizeof options, "-p %s -q %s", p[i], q[j]);
            snprintf(text, sizeof text, "position, %s: 61 rows agree\norientation, %s: 61 rows agree\n", p[i], q[j]);
            says(&s, &plain, 0, text, options);
        }
}

/* Signs of quaternions alternate; a column that means nothing; another order of columns; CRLF. */
static void quaternion_row(FILE *f, double time, student_pose *pose)
{
    double q[4];
    student_quaternion(pose->o, q);
    const double sign = (int)(10.0 * time + 0.5) % 2 ? -1.0 : 1.0;
    fprintf(f, "%.6f,%d,%.6f,%.6f,%.6f,%.2f,%.6f,%.6f,%.6f", sign * q[3], 7, sign * q[0], sign * q[1], sign * q[2],
            time, pose->p[2], pose->p[1], pose->p[0]);
}

static void put_angles(FILE *f, double time, student_pose *pose, double unit)
{
    double a[3];
    student_angles(pose->o, a);
    fprintf(f, "%g;%.6f;%.6f;%.6f;%.6f;%.6f;%.6f", time, pose->p[0], pose->p[1], pose->p[2], unit * a[1], unit * a[0],
            unit * a[2]);
}

static void degrees_row(FILE *f, double time, student_pose *pose)
{
    put_angles(f, time, pose, 180 / PI);
}

static void radians_row(FILE *f, double time, student_pose *pose)
{
    put_angles(f, time, pose, 1.0);
}

static void commas_row(FILE *f, double time, student_pose *pose)
{
    char text[32];
    const double v[4] = {time, pose->p[0], pose->p[1], pose->p[2]};
    for (int i = 0; i < 4; i++) {
        snprintf(text, sizeof text, "%.5f", v[i]);
        *strchr(text, '.') = ',';
        fprintf(f, "%s%s", i ? ";" : "", text);
    }
}

static void named_row(FILE *f, double time, student_pose *pose)
{
    fprintf(f, "Hermit, %g", time);
    for (int r = 0; r < 3; r++)
        for (int c = 0; c < 3; c++)
            fprintf(f, ", %.6f", pose->o[r][c]);
    fputs(", Quat", f);
}

/* sprintf( message, "Time: %2.2f", animation_time ), and the 16 numbers of mat in four lines. */
static void printed_row(FILE *f, double time, student_pose *pose)
{
    fprintf(f, "Time: %2.2f\n", time);
    for (int c = 0; c < 4; c++) {
        for (int r = 0; r < 4; r++)
            fprintf(f, "%10.6f ", r == 3 ? c == 3 : c == 3 ? pose->p[r] : pose->o[r][c]);
        fputc('\n', f);
    }
}

static void right_programs_agree_in_every_form(void **state)
{
    (void)state;
    const student quat = {STUDENT_HERMITE, STUDENT_QUAT, SLIP_NONE}, euler = {STUDENT_BEZIER, STUDENT_EULER, SLIP_NONE};
    const form quaternions = {"\xef\xbb\xbfqw,keys,quat.x,quat.y,quat.z,Time,z,Position Y,x\r\n", "\r\n",
                              quaternion_row},
               degrees = {"time;x;y;z;pitch (deg);yaw (deg);roll (deg)\n", "\n", degrees_row},
               unstated = {"Time;Pos_X;Pos_Y;Pos_Z;Pitch;Yaw;Roll\n", "\n", degrees_row},
               units = {"time [s];x (m);y (m);z (m);pitch;yaw;roll\n", "\n", degrees_row},
               radians = {"# mine\n\ntime;px;py;pz;pitch;yaw;roll\n", "\n\n", radians_row},
               commas = {"", "\n", commas_row},
               named = {"pos_method, time, m00, m01, m02, m10, m11, m12, m20, m21, m22, ori_method\n", "\n", named_row},
               from_1 = {"pos_method,\"time\",m11,m12,m13,m21,m22,m23,m31,m32,m33,ori_method\n", "\n", named_row},
               printed = {"Animation Mode\nPosition: Hermit, Orientation: Quat\n", "", printed_row};
    says(&quat, &quaternions, 0, "61 rows agree\norientation, quat (the most likely method): 61 rows agree", "");
    says(&euler, &degrees, 0, "angles in degrees\nposition, bezier", "");
    says(&euler, &unstated, 0, "angles in degrees\nposition, bezier", "");
    says(&euler, &units, 0, "angles in degrees\nposition, bezier", "");
    says(&euler, &radians, 0, "0.001\nposition, bezier (the most likely method): 61 rows agree\norientation, euler",
         "");
    says(&quat, &commas, 0, "position, hermite (the most likely method): 61 rows agree", "");
    says(&quat, &named, 0, "orientation, quat: 61 rows agree", "");
    says(&quat, &from_1, 0, "orientation, quat: 61 rows agree", "");
    says(&quat, &printed, 0, "position, hermite: 61 rows agree\norientation, quat: 61 rows agree", "");
    says(&quat, &by_rows, 0, "61 rows agree\norientation, quat (the most likely method): 61", "--matrix rows");
    program_says(0, "position, hermite", CHECK "- < mine.csv --matrix rows");
}

/* The table that a program of its own computed: all rows of scene 1 by the rule of the exercise. */
static void the_expected_table_agrees(void **state)
{
    (void)state;
    program_says(0, "213 rows agree",
                 "--version > /dev/null; grep -v clamped '" NKW_FIGURES
                 "/../../tests/data/coursework_expected.csv' > expected.csv; '" NKW_PROGRAM "' " CHECK "expected.csv");
    program_says(1, "orientation, none: 11 of 71 rows differ, from 1 s", CHECK "expected.csv --rule library");
}

/* for ( float t=0.0f; ...; t+=0.1f ): of the sums 10, 20 ... some are before the key and some after, and "%.6f" hides it. */
static void a_sum_of_steps_explains_the_rows_at_keys(void **state)
{
    (void)state;
    const student s = {STUDENT_LINEAR, STUDENT_NONE, SLIP_NONE};
    FILE *f = fopen("mine.csv", "wb");
    assert_non_null(f);
    float t = 0.0f;
    for (int i = 0; i <= 60; i++, t += 0.1f) {
        student_pose pose = student_sample(&s, (double)t);
        fprintf(f, "%.1f", i / 10.0);
        put_matrix(f, ' ', &pose, 0);
        fputc('\n', f);
    }
    assert_int_equal(fclose(f), 0);
    program_says(1, "61 rows agree\norientation, none: ", CHECK "mine.csv -q none");
    program_says(1, "or the time is slightly after the key, in 1.7\n", CHECK "mine.csv -q none");
}

/* ---- wrong programs ---- */

static void every_mistake_is_named(void **state)
{
    (void)state;
    static const struct {
        student s;
        const char *text;
    } wrong[] = {
        {{STUDENT_BEZIER, STUDENT_QUAT, SLIP_MINUS_ONE},
         "what you get if (t - 1) is used as printed in (8) and (10)\n"},
        {{STUDENT_BEZIER, STUDENT_QUAT, SLIP_T_FOR_S},
         "rows 0.1 to 5.9 are what you get if t is used in place of s in (7)\n"},
        {{STUDENT_BEZIER, STUDENT_QUAT, SLIP_T_LATER},
         "rows 3.1 to 5.9 are what you get if t is used in place of s in (7)\n"},
        {{STUDENT_HERMITE, STUDENT_EULER, SLIP_PLUS}, "what you get if h1 has a plus, t^3 + t^2, in (6)\n"},
        {{STUDENT_HERMITE, STUDENT_EULER, SLIP_TANGENT}, "what you get if the tangents are not negated in (2)\n"},
        {{STUDENT_HERMITE, STUDENT_EULER, SLIP_EXCHANGED}, "what you get if blanks B and C are exchanged in 2.1\n"},
        {{STUDENT_BSPLINE, STUDENT_EULER, SLIP_INTEGER}, "are divided as integers, and are 0, in (13) to (16)\n"},
        {{STUDENT_LINEAR, STUDENT_QUAT, SLIP_CONJUGATE}, "q1 is conjugated, not negated, in blank B of 2.4\n"},
        {{STUDENT_LINEAR, STUDENT_QUAT, SLIP_NO_BLANK_B}, "what you get if q1 is never negated in blank B of 2.4\n"},
        {{STUDENT_LINEAR, STUDENT_QUAT, SLIP_BRACKET}, "what you get if sin(1 - t) theta is used as printed in (17)\n"},
        {{STUDENT_LINEAR, STUDENT_QUAT, SLIP_THETA}, "what you get if theta is in degrees in (17)\n"},
        {{STUDENT_LINEAR, STUDENT_EULER, SLIP_UNWRAP}, "what you get if yaw is not unwrapped in 1.9\n"},
        {{STUDENT_LINEAR, STUDENT_EULER, SLIP_DEGREES},
         "what you get if sine and cosine take the angles in degrees in 1.9\n"},
        {{STUDENT_LINEAR, STUDENT_EULER, SLIP_ORDER},
         "what you get if the rotations are multiplied as Rz Rx Ry in 1.9\n"},
        {{STUDENT_LINEAR, STUDENT_NONE, SLIP_HALF_OPEN},
         "rows 1 to 5 are what you get if the rule is the other one of --rule"},
    };
    static const char *const p[] = {"linear", "hermite", "bezier", "bspline"}, *const q[] = {"none", "euler", "quat"};
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        char options[64];
        snprintf(options, sizeof options, "-p %s -q %s", p[wrong[i].s.position], q[wrong[i].s.orientation]);
        says(&wrong[i].s, &plain, 1, wrong[i].text, options);
        says(&wrong[i].s, &plain, 1, wrong[i].text, "");
        char *said = program_run(NULL, CHECK "mine.csv %s || true", options);
        assert_int_equal(lines_with(said, "differ"), 1);
        assert_int_equal(lines_with(said, "what you get"), 1);
        free(said);
    }
}

static void mistakes_of_the_form_are_named(void **state)
{
    (void)state;
    const student right = {STUDENT_HERMITE, STUDENT_EULER, SLIP_NONE};
    const form degrees = {"time;x;y;z;pitch;yaw_rad;roll\n", "\n", degrees_row};
    says(&right, &degrees, 1, "orientation, euler: 60 of 61 rows differ", "-q euler");
    says(&right, &degrees, 1, "what you get if the angles are in degrees: --angles degrees\n", "");
    says(&right, &by_rows, 1, "the matrices are transposed: glMultMatrixf", "");
    says(&right, &by_rows, 1,
         "(the most likely method): 61 rows agree\norientation, euler (the most likely method): 61", "");
    says(&right, &plain, 1, "those of the method euler\n", "-q quat");
    says(&right, &plain, 1, "those of the method hermite\n", "-p linear");
}

/* R for R^T with the position in its place. */
static void inverse_row(FILE *f, double time, student_pose *pose)
{
    student_pose turned = *pose;
    for (int r = 0; r < 3; r++)
        for (int c = 0; c < 3; c++)
            turned.o[r][c] = pose->o[c][r];
    plain_row(f, time, &turned);
}

static void a_transposed_rotation_is_named(void **state)
{
    (void)state;
    const form inverse = {"", "\n", inverse_row};
    for (int j = 0; j < 3; j++) {
        const student s = {STUDENT_LINEAR, (student_orientation)j, SLIP_NONE};
        says(&s, &inverse, 1, "what you get if the matrix is transposed in 1.7\n", "");
    }
}

static void what_no_mistake_reproduces_is_not_named(void **state)
{
    (void)state;
    const student noise = {STUDENT_BSPLINE, STUDENT_QUAT, SLIP_NOISE};
    says(&noise, &plain, 1, "position, bspline: 21 of 61 rows differ, from 0 s (line 1) on, by 0.05 at most",
         "-p bspline");
    says(&noise, &plain, 1, "\n  no known mistake reproduces all of them\n", "");
    says(&noise, &plain, 0, "61 rows agree", "--tolerance 0.051");
    const student two = {STUDENT_HERMITE, STUDENT_QUAT, SLIP_TANGENT};
    write_file("mine.csv", &two, &positions);
    program_says(1, "no known mistake reproduces all of them; 53 of them are what you get if the tangents are not",
                 "--version > /dev/null; sed '12s/.*/1.1,9,9,9/' mine.csv > two.csv; '" NKW_PROGRAM "' " CHECK
                 "two.csv -p hermite");
}

/* ---- lines that cannot be read ---- */

static void refuses(const char *text, const char *why)
{
    FILE *f = fopen("bad.csv", "wb");
    assert_non_null(f);
    fputs(text, f);
    assert_int_equal(fclose(f), 0);
    char all[160];
    snprintf(all, sizeof all, "bad.csv:%s", why);
    program_says(2, all, CHECK "bad.csv");
}

static void unreadable_lines_are_named(void **state)
{
    (void)state;
    refuses("0 1 2 3\n1 2 3 x\n", "2: a number was expected");
    refuses("0 1 2 3\n\n# no\n1 2 3\n", "4: not as many numbers as at the first time");
    refuses("0 1 2\n", "1: not 3, 4, 6, 7, 9, 12 or 16 numbers");
    refuses("0 1 2 1e99\n", "1: a number was expected");
    refuses("0 1 nan 3\n", "1: a number was expected");
    refuses("x,y,z,1\n", "1: a number was expected");
    refuses("step,x,y,z\n", "1: no column is named time");
    refuses("time,x,y\n0,1,2\n", "1: a column of the position or of the orientation is missing");
    refuses("time,a,b\n0,1,2\n", "1: no columns are named as a position");
    refuses("time,x,y,z,x\n0,1,2,3,4\n", "1: two columns have the same name");
    refuses("time,yaw,pitch,roll,qx,qy,qz,qw\n", "1: the position or the orientation is there twice");
    refuses("time,x,y,z\n0,1,2,3\r\n1,2,3\r\n", "3: the line has not as many fields");
    refuses("time,x,y,z\n0,1,,3\n", "2: a number was expected");
    refuses("time,x,y,z,pos_method\n0,1,2,3,spline\n", "2: no method has this name");
    refuses("time,qx,qy,qz,qw\n0,0,0,0,0\n", "2: a quaternion is zero");
    refuses("Position: Hermit\nTime: 0\n1 2\n3\nTime: 1\n1 2 3 4\n", "5: not as many numbers as at the first time");
    refuses("Position: Cubic, Orientation: Quat\n", "1: no method has this name");
    refuses("Time:\n1 2 3\n", "1: a number was expected");
    refuses("\n\n", " has no rows");
    program_says(2, "no_such.csv", CHECK "no_such.csv");
    program_says(2, "not radians or degrees", CHECK "bad.csv --angles turns");
    program_says(2, "not columns or rows", CHECK "bad.csv --matrix sideways");
    program_says(2, "not in 0..1000000", CHECK "bad.csv --tolerance -1");
    program_says(2, "only with --check", "exercise x --angles degrees");
    program_says(2, "not with --check", CHECK "bad.csv --trace 1");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(right_programs_of_every_method_agree),
        cmocka_unit_test(right_programs_agree_in_every_form),
        cmocka_unit_test(the_expected_table_agrees),
        cmocka_unit_test(a_sum_of_steps_explains_the_rows_at_keys),
        cmocka_unit_test(every_mistake_is_named),
        cmocka_unit_test(mistakes_of_the_form_are_named),
        cmocka_unit_test(a_transposed_rotation_is_named),
        cmocka_unit_test(what_no_mistake_reproduces_is_not_named),
        cmocka_unit_test(unreadable_lines_are_named),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
