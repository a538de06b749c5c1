/* SPDX-License-Identifier: MIT */
/* Keys in CSV and in JSON: columns, clips, nodes; and what is refused. */
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
    const nkw_import_memory memory = {text, strlen(text), "keys.csv", NULL, NULL, NULL};
    nkw_document *d;
    nkw_import_error error;
    nkw_clip *clip;
    float pose[NKW_POSE_FLOATS(3)];
    assert_int_equal(nkw_document_open_memory(&memory, &d, &error), NKW_IMPORT_OK);
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
        cmocka_unit_test(broken_rows_are_refused),
    };
    return cmocka_run_group_tests_name("import_keys", tests, NULL, NULL);
}
