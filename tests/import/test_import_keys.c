/* SPDX-License-Identifier: MIT */
/* Keys in CSV and in JSON: columns, clips, nodes; and what is refused. */
#include <math.h>

#include <nakawari/euler.h>

#include "documents.h"
#include "views.h"

static void expect_document(const nkw_document *d)
{
    assert_string_equal(d->format, "CSV keys");
    assert_int_equal(d->skeleton.joint_count, 3);
    assert_string_equal(d->nodes[0].name, "root");
    assert_string_equal(d->nodes[1].name, "arm, left");
    assert_string_equal(d->nodes[2].name, "hand \"l\"");
    assert_int_equal(d->skeleton.parents[1], 0);
    assert_int_equal(d->skeleton.parents[2], 1);
    assert_int_equal(d->animation_count, 2);
    assert_string_equal(d->animations[0].name, "walk");
    assert_string_equal(d->animations[1].name, "wave");
    assert_int_equal(d->animations[0].track_count, 2);
    const nkw_clip_track *t = d->animations[0].tracks;
    const float times[] = {0, 2}, values[] = {0, 1, 2, 4, 5, 6};
    assert_int_equal(t[0].target, NKW_CLIP_TRANSLATION);
    assert_int_equal(t[0].index, 0);
    assert_int_equal(t[0].track.count, 2);
    expect_floats_bits(t[0].track.times, times, 2);
    expect_floats_bits(t[0].track.values, values, 6);
    assert_int_equal(t[1].target, NKW_CLIP_ROTATION);
    assert_int_equal(t[1].index, 1);
    assert_int_equal(t[1].track.interpolation, NKW_INTERPOLATION_STEP);
    assert_int_equal(d->animations[1].channels[0].joint, 2);
    expect_near(nkw_pose_get(d->rest, 0).translation.y, 1, 0);
    expect_near(nkw_pose_get(d->rest, 2).scale.x, 1, 0);
}

static void columns_become_tracks(void **state)
{
    (void)state;
    const char *const text = "# own keys\r\n"
                             "name,time,clip,parent,interpolation,tx,ty,tz,yaw,pitch,roll\r\n"
                             "root,0,walk,,,0,1,2,,,\r\n"
                             "\"arm, left\",0,walk,root,STEP,,,,90,0,0\r\n"
                             "\"arm, left\",1e0,walk,,STEP,,,,0,45,0\r\n"
                             "\r\n"
                             "root,2,walk,,,4,5,6,,,\r\n"
                             "\"hand \"\"l\"\"\",0,wave,\"arm, left\",,7,8,9,0,0,90";
    char *kept = quoted(text);
    const nkw_import_memory memory = {text, strlen(text), "keys.csv", NULL, NULL, NULL, 0, 0};
    nkw_document *d;
    nkw_import_error error;
    nkw_clip *clip;
    float pose[NKW_POSE_FLOATS(3)];
    assert_int_equal(nkw_document_from_memory(&memory, &d, &error), NKW_IMPORT_OK);
    assert_string_equal(kept, text); /* it is not changed */
    expect_document(d);
    assert_int_equal(nkw_document_validate(d, NULL), NKW_IMPORT_OK);
    assert_int_equal(nkw_document_clip(d, 0, NKW_CLIP_FLOAT32, &clip, NULL), NKW_IMPORT_OK);
    assert_int_equal(nkw_clip_sample(clip, 0.5f, NULL, pose_span(pose, 3), NULL), NKW_OK);
    const nkw_vec3 quarter = {0, nkw_radians_from_degrees(90.0f), 0};
    expect_quat_bits(nkw_pose_get(pose_view(pose, 3), 1).rotation, nkw_quat_from_euler(quarter, NKW_EULER_YXZ));
    expect_near(nkw_pose_get(pose_view(pose, 3), 0).translation.x, 1, 0);
    nkw_import_free(clip);
    nkw_document_close(d);
    free(kept);
}

#define POSITION "name,time,tx,ty,tz\n"

/* A table in memory. */
static nkw_document *table(const char *text)
{
    const nkw_import_memory memory = {text, strlen(text), "keys.csv", NULL, NULL, NULL, 0, 0};
    nkw_document *d;
    nkw_import_error error;
    if (nkw_document_from_memory(&memory, &d, &error) != NKW_IMPORT_OK)
        print_error("%s:%s: %s\n", error.file, error.place, error.reason);
    assert_non_null(d);
    assert_int_equal(nkw_document_validate(d, NULL), NKW_IMPORT_OK);
    return d;
}

static void tangents_are_those_of_cubicspline(void **state)
{
    (void)state;
    nkw_document *d = table("name,time,interpolation,tx,ty,tz,in_tx,in_ty,in_tz,out_tx,out_ty,out_tz,qx,qy,qz,qw,"
                            "out_qx,out_qy,out_qz,out_qw\n"
                            "a,0,CUBICSPLINE,1,2,3,,,,4,5,6,0,0,0,1,0.25,0,0,0\n"
                            "a,2,CUBICSPLINE,7,8,9,-1,-2,-3,,,,0,1,0,0,,,,\n"
                            "b,0,,1,2,3,,,,,,,,,,,,,,\n");
    const float values[] = {0, 0, 0, 1, 2, 3, 4, 5, 6, -1, -2, -3, 7, 8, 9, 0, 0, 0};
    const float turns[] = {0, 0, 0, 0, 0, 0, 0, 1, 0.25f, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0};
    const nkw_clip_track *t = d->animations[0].tracks;
    assert_int_equal(d->animations[0].track_count, 3);
    assert_int_equal(t[0].track.interpolation, NKW_INTERPOLATION_CUBICSPLINE);
    assert_int_equal(t[1].track.kind, NKW_TRACK_ROTATION);
    assert_int_equal(t[2].track.interpolation, NKW_INTERPOLATION_LINEAR);
    expect_floats_bits(t[0].track.values, values, 18);
    expect_floats_bits(t[1].track.values, turns, 24);
    assert_int_equal(d->animations[0].channels[1].bytes, (2 + 24) * sizeof(float));
    nkw_document_close(d);
    d = table("name,time,interpolation,weight\na,0,CUBICSPLINE,1\na,1,CUBICSPLINE,2\n"); /* without columns: zeros */
    const float flat[] = {0, 1, 0, 0, 2, 0};
    expect_floats_bits(d->animations[0].tracks[0].track.values, flat, 6);
    nkw_document_close(d);
}

static void rows_of_one_time_are_the_weights_of_a_node(void **state)
{
    (void)state;
    nkw_document *d = table("clip,time,index,name,target,weight,in_weight,out_weight,interpolation,tx,ty,tz\n"
                            "0,0,0,face,puff,0.25,,,,1,2,3\n0,0,1,face,puff,0.5,,,,,,\n0,0,2,tail,,1,,,,,,\n"
                            "0,1,0,face,puff,0.75,,,,,,\n0,1,1,face,puff,1,,,,,,\n"
                            "1,0,0,face,puff,1,2,3,CUBICSPLINE,,,\n1,0,0,face,puff,4,5,6,CUBICSPLINE,,,\n");
    const float face[] = {0.25f, 0.5f, 0.75f, 1}, rest[] = {0.25f, 0.5f, 1}, cubic[] = {2, 5, 1, 4, 3, 6};
    const nkw_clip_track *t = d->animations[0].tracks;
    assert_int_equal(d->float_count, 3);
    expect_floats_bits(d->rest_floats, rest, 3);
    assert_int_equal(d->nodes[0].float_count, 2);
    assert_int_equal(d->nodes[1].float_first, 2);
    assert_int_equal(d->meshes[d->nodes[0].mesh].primitive_count, 0);
    assert_string_equal(d->meshes[d->nodes[0].mesh].target_names[1], "target_1");
    assert_int_equal(d->animations[0].track_count, 3);
    assert_int_equal(t[1].target, NKW_CLIP_FLOATS);
    assert_int_equal(t[1].track.width, 2);
    assert_int_equal(t[1].track.count, 2);
    expect_floats_bits(t[1].track.values, face, 4);
    assert_int_equal(t[2].index, 2);
    expect_floats_bits(d->animations[1].tracks[0].track.values, cubic, 6);
    nkw_clip *clip;
    float pose[NKW_POSE_FLOATS(2)], floats[3];
    assert_int_equal(nkw_document_clip(d, 0, NKW_CLIP_FLOAT32, &clip, NULL), NKW_IMPORT_OK);
    assert_int_equal(nkw_clip_sample(clip, 0.5f, NULL, pose_span(pose, 2), floats), NKW_OK);
    expect_near(floats[0], 0.5, 0);
    expect_near(floats[2], 1, 0);
    nkw_import_free(clip);
    nkw_document_close(d);
}

static void members_that_are_lists_of_keys_are_scenes(void **state)
{
    (void)state;
    nkw_document *d = opened("{'scene1':[{'time':0,'pos':[1,2,3],'quat_xyzw':[0,1,0,0]},"
                             "{'time':1,'pos':[4,5,6],'euler_yxz_yaw_pitch_roll':[0.5,0.25,0.125]},"
                             "{'time':2,'pos':[4,5,6],'ori_rows':[0,-1,0,1,0,0,0,0,1]}],"
                             "'scene2':[{'time':3,'pos':[1,2,3]}]}",
                             NULL, 0);
    const nkw_vec3 angles = {0.25f, 0.5f, 0.125f};
    const nkw_clip_track *t = d->animations[0].tracks;
    const nkw_quat *q = (const nkw_quat *)(const void *)t[1].track.values;
    assert_string_equal(d->nodes[0].name, "model");
    assert_string_equal(d->animations[1].name, "scene2");
    assert_int_equal(d->animation_count, 2);
    assert_int_equal(t[0].track.count, 3);
    expect_near(q[0].y, 1, 0);
    expect_quat_bits(q[1], nkw_quat_from_euler(angles, NKW_EULER_YXZ));
    expect_near(q[2].z, sqrt(0.5), 1e-7); /* the quarter turn about z takes x to y: the first column is 0 1 0 */
    expect_near(q[2].w, sqrt(0.5), 1e-7);
    assert_int_equal(d->animations[1].track_count, 1);
    nkw_document_close(d);
    expect_refused("{'a':[{'time':0,'pos':[1,2,3]},{'time':1,'pos':[1,2]}]}", NULL, 0, NKW_IMPORT_INVALID, "/a/1/pos");
    expect_refused("{'a':[{'time':0,'pos':[1,2,3]},{'pos':[1,2,3]}]}", NULL, 0, NKW_IMPORT_INVALID, "/a/1/time");
    expect_refused("{'a':[{'time':0,'pos':[1,2,3]}],'b':[7]}", NULL, 0, NKW_IMPORT_INVALID, "/b/0");
}

/* The yaw of a rotation about y, in degrees, nearest to `near`. */
static double yaw_of(const nkw_track *t, float time, double near)
{
    nkw_quat q;
    nkw_track_sample(t, time, NULL, &q.x);
    double yaw = 2.0 * atan2((double)q.y, (double)q.w) * 57.29577951308232;
    return yaw + 360.0 * floor((near - yaw) / 360.0 + 0.5);
}

/* yaw 0 -> 270 -> 630 -> 630 -> -90: at each time that of the line between the angles. */
static void angles_keep_their_turns(void **state)
{
    (void)state;
    static const char *const texts[] = {
        "name,time,yaw,pitch,roll\nbox,0,0,0,0\nbox,1,270,0,0\nbox,2,630,0,0\nbox,3,630,0,0\nbox,4,-90,0,0\n",
        "{'a':[{'time':0,'pos':[0,0,0],'euler_yxz_yaw_pitch_roll':[0,0,0]},"
        "{'time':1,'pos':[0,0,0],'euler_yxz_yaw_pitch_roll':[4.71238898,0,0]},"
        "{'time':2,'pos':[0,0,0],'euler_yxz_yaw_pitch_roll':[10.99557429,0,0]},"
        "{'time':3,'pos':[0,0,0],'euler_yxz_yaw_pitch_roll':[10.99557429,0,0]},"
        "{'time':4,'pos':[0,0,0],'euler_yxz_yaw_pitch_roll':[-1.57079633,0,0]}]}"};
    static const double keys[5] = {0, 270, 630, 630, -90};
    for (int i = 0; i < 2; i++) {
        nkw_document *d = opened(texts[i], NULL, 0);
        const nkw_document_animation *a = d->animations;
        const size_t track = a->track_count - 1;
        assert_int_equal(a->channels[track].added, 2 + 3 + 7);
        assert_int_equal(a->tracks[track].track.count, 5 + 12);
        assert_int_equal(nkw_track_validate(&a->tracks[track].track, NULL), NKW_OK);
        for (int k = 0; k <= 400; k++) {
            const int s = k < 400 ? k / 100 : 3;
            const double t = k / 100.0, want = keys[s] + (keys[s + 1] - keys[s]) * (t - s);
            expect_near(yaw_of(&a->tracks[track].track, (float)t, want), want, 2e-4);
        }
        nkw_document_close(d);
    }
    /* Steps jump, and less than half a turn stays the shorter arc of two keys. */
    nkw_document *d = opened("name,time,interpolation,yaw,pitch,roll\nbox,0,STEP,0,0,0\nbox,1,STEP,270,0,0\n"
                             "arm,0,LINEAR,0,10,0\narm,1,LINEAR,170,20,30\n",
                             NULL, 0);
    for (size_t i = 0; i < 2; i++)
        assert_true(d->animations->tracks[i].track.count == 2 && d->animations->channels[i].added == 0);
    nkw_document_close(d);
    expect_refused("name,time,yaw,pitch,roll\nbox,0,0,0,0\nbox,1,1e9,0,0\n", NULL, 0, NKW_IMPORT_TOO_LARGE,
                   "line 3, column yaw");
}

/* The scenes of the exercise, where they are at hand: the quaternions, the angles and the matrices are the same. */
static void the_keys_of_the_exercise_are_read(void **state)
{
    (void)state;
    nkw_document *d;
    nkw_import_error error;
    nkw_import_result result = nkw_document_open(NKW_DATA_DIR "/coursework/keys.json", &d, &error);
    if (result == NKW_IMPORT_UNREADABLE)
        skip();
    assert_int_equal(result, NKW_IMPORT_OK);
    assert_int_equal(d->animation_count, 2);
    assert_string_equal(d->animations[0].name, "scene1");
    assert_int_equal(d->animations[0].tracks[0].track.count, 7);
    assert_int_equal(d->animations[1].tracks[1].track.count, 2);
    assert_int_equal(nkw_document_validate(d, NULL), NKW_IMPORT_OK);
    nkw_document_close(d);
}

static void broken_rows_are_refused(void **state)
{
    (void)state;
    static const struct {
        nkw_import_result code;
        const char *place, *text;
    } list[] = {
        {NKW_IMPORT_UNKNOWN, "", "name,tx,ty,tz\n"},
        {NKW_IMPORT_INVALID, "line 1, column colour", "name,time,colour\n"},
        {NKW_IMPORT_INVALID, "line 1, column time", "name,time,time\n"},
        {NKW_IMPORT_INVALID, "line 1, column ty", "name,time,tx,tz\n"},
        {NKW_IMPORT_INVALID, "line 1, column yaw", "name,time,qx,qy,qz,qw,yaw,pitch,roll\n"},
        {NKW_IMPORT_INVALID, "line 1", "name,time\n"},
        {NKW_IMPORT_INVALID, "line 2, column name", POSITION ",0,1,2,3\n"},
        {NKW_IMPORT_INVALID, "line 3, column time", POSITION "a,0,1,2,3\na,x,1,2,3\n"},
        {NKW_IMPORT_INVALID, "line 2, column time", POSITION "a,1e39,1,2,3\n"},
        {NKW_IMPORT_INVALID, "line 2, column tz", POSITION "a,0,1,2,[3]\n"},
        {NKW_IMPORT_INVALID, "line 2, column tx", POSITION "a,0,1,2\n"},
        {NKW_IMPORT_INVALID, "line 2", POSITION "a,0,1,2,3,4\n"},
        {NKW_IMPORT_INVALID, "line 2, column interpolation", "name,time,interpolation\na,0,BEZIER\n"},
        {NKW_IMPORT_INVALID, "line 3, column interpolation", "name,time,interpolation\na,0,STEP\na,1,LINEAR\n"},
        {NKW_IMPORT_INVALID, "line 1, column in_tx", "name,time,in_tx,in_ty,in_tz\n"},
        {NKW_IMPORT_INVALID, "line 1, column out_qy", "name,time,qx,qy,qz,qw,out_qx,out_qz,out_qw\n"},
        {NKW_IMPORT_INVALID, "line 2, column in_weight", "name,time,weight,in_weight\na,0,1,1\n"},
        {NKW_IMPORT_INVALID, "line 2, column out_weight",
         "name,time,interpolation,weight,out_weight\na,0,CUBICSPLINE,,1\n"},
        {NKW_IMPORT_INVALID, "line 5, column weight", "name,time,weight\na,0,1\na,0,1\na,1,1\na,2,1\na,2,1\n"},
        {NKW_IMPORT_INVALID, "line 4, column weight", "name,time,weight\na,0,1\na,0,1\na,1,1\n"},
        {NKW_IMPORT_INVALID, "", "name,time,parent\na,0,b\n"},
        {NKW_IMPORT_INVALID, "/nodes/0", "name,time,parent\na,0,b\nb,0,a\n"},
    };
    for (size_t i = 0; i < sizeof list / sizeof *list; i++)
        expect_refused(list[i].text, NULL, 0, list[i].code, list[i].place);
}

static void rows_of_json_are_those_of_the_table(void **state)
{
    (void)state;
    nkw_document *d = opened("{'columns':'tx,ty,tz,qx,qy,qz,qw','rows':["
                             "{'name':'a','time':1,'clip':3,'values':[1,2,3,null,null,null,null]},"
                             "{'name':'b','time':0.5,'clip':'c','parent':'a','interpolation':'STEP','index':7,"
                             "'values':[1,2,3,0,0,1,0]}]}",
                             NULL, 0);
    assert_string_equal(d->format, "JSON keys");
    assert_int_equal(d->animation_count, 2);
    assert_string_equal(d->animations[0].name, "3");
    assert_string_equal(d->animations[1].name, "c");
    assert_int_equal(d->animations[0].track_count, 1);
    assert_int_equal(d->animations[1].track_count, 2);
    expect_near(d->animations[1].tracks[1].track.values[2], 1, 0);
    assert_int_equal(d->skeleton.parents[1], 0);
    nkw_document_close(d);

    static const struct {
        nkw_import_result code;
        const char *place, *text;
    } list[] = {
        {NKW_IMPORT_INVALID, "/rows", "{'columns':'tx,ty,tz','rows':{}}"},
        {NKW_IMPORT_INVALID, "/columns", "{'columns':'tx','rows':[]}"},
        {NKW_IMPORT_INVALID, "/columns", "{'columns':7,'rows':[]}"},
        {NKW_IMPORT_INVALID, "/columns", "{'columns':'name,tx,ty,tz','rows':[]}"},
        {NKW_IMPORT_INVALID, "/rows/0", "{'columns':'tx,ty,tz','rows':[]}"},
        {NKW_IMPORT_INVALID, "/rows/0/time", "{'columns':'tx,ty,tz','rows':[7]}"},
        {NKW_IMPORT_INVALID, "/rows/0/values", "{'columns':'tx,ty,tz','rows':[{'time':0}]}"},
        {NKW_IMPORT_INVALID, "/rows/0/name", "{'columns':'tx,ty,tz','rows':[{'time':0,'values':[1,2,3]}]}"},
        {NKW_IMPORT_INVALID, "/rows/0/values", "{'columns':'tx,ty,tz','rows':[{'time':0,'values':[1,2,1e39]}]}"},
        {NKW_IMPORT_INVALID, "/rows/0/tx", "{'columns':'tx,ty,tz','rows':[{'name':'a','time':0,'values':[1,2,null]}]}"},
    };
    for (size_t i = 0; i < sizeof list / sizeof *list; i++)
        expect_refused(list[i].text, NULL, 0, list[i].code, list[i].place);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(columns_become_tracks),
        cmocka_unit_test(rows_of_json_are_those_of_the_table),
        cmocka_unit_test(tangents_are_those_of_cubicspline),
        cmocka_unit_test(rows_of_one_time_are_the_weights_of_a_node),
        cmocka_unit_test(members_that_are_lists_of_keys_are_scenes),
        cmocka_unit_test(angles_keep_their_turns),
        cmocka_unit_test(the_keys_of_the_exercise_are_read),
        cmocka_unit_test(broken_rows_are_refused),
    };
    return cmocka_run_group_tests_name("import_keys", tests, NULL, NULL);
}
