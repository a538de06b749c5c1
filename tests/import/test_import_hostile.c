/* SPDX-License-Identifier: MIT */
/* Files that are broken, by accident or with intent: an error that names the place, and no more. */
#include "documents.h"
#include "views.h"

#define ASSET               "'asset':{'version':'2.0'},"
#define BUFFER              "'buffers':[{'uri':'data.bin','byteLength':64}],'bufferViews':[{'buffer':0,'byteLength':64}],"
#define FLOATS(count, type) "{'bufferView':0,'componentType':5126,'count':" #count ",'type':'" #type "'}"

/* ---- Structure ---- */

typedef struct broken {
    nkw_import_result code;
    const char *place, *text;
} broken;

static void refuse_all(const broken *list, size_t count)
{
    static const float data[16];
    for (size_t i = 0; i < count; i++)
        expect_refused(list[i].text, data, sizeof data, list[i].code, list[i].place);
}

#define REFUSE(list) refuse_all((list), sizeof(list) / sizeof *(list))

static void files_of_other_formats_are_unknown(void **state)
{
    (void)state;
    static const broken list[] = {
        {NKW_IMPORT_UNKNOWN, "", ""},
        {NKW_IMPORT_UNKNOWN, "", "to be or not\n"},
        {NKW_IMPORT_UNKNOWN, "", "[]"},
        {NKW_IMPORT_INVALID, "line 1, column 1", "{"},
        {NKW_IMPORT_INVALID, "line 2, column 5", "{\n 'a':\x80}"},
        {NKW_IMPORT_INVALID, "line 1, column 10", "{'a':1e999}"},
        {NKW_IMPORT_INVALID, "line 1, column 10", "{'a':1,'a':2}"},
        {NKW_IMPORT_INVALID, "/asset", "{}"},
        {NKW_IMPORT_INVALID, "/asset", "{'asset':[]}"},
        {NKW_IMPORT_INVALID, "/asset/version", "{'asset':{}}"},
        {NKW_IMPORT_UNSUPPORTED, "/asset/version", "{'asset':{'version':'1.0'}}"},
        {NKW_IMPORT_UNSUPPORTED, "/asset/version", "{'asset':{'version':'2.5','minVersion':'2.5'}}"},
        {NKW_IMPORT_INVALID, "/extensionsRequired/0", "{" ASSET "'extensionsRequired':[7]}"},
        {NKW_IMPORT_UNSUPPORTED, "/extensionsRequired/1",
         "{" ASSET "'extensionsRequired':['KHR_materials_unlit','KHR_draco_mesh_compression']}"},
    };
    REFUSE(list);
}

static void nodes_are_checked(void **state)
{
    (void)state;
    static const broken list[] = {
        {NKW_IMPORT_INVALID, "/nodes", "{" ASSET "'nodes':{}}"},
        {NKW_IMPORT_INVALID, "/nodes/1", "{" ASSET "'nodes':[{},3]}"},
        {NKW_IMPORT_INVALID, "/nodes/0/children", "{" ASSET "'nodes':[{'children':1}]}"},
        {NKW_IMPORT_INVALID, "/nodes/0/children/0", "{" ASSET "'nodes':[{'children':[1]}]}"},
        {NKW_IMPORT_INVALID, "/nodes/0/children/0", "{" ASSET "'nodes':[{'children':[-1]}]}"},
        {NKW_IMPORT_INVALID, "/nodes/0/children/0", "{" ASSET "'nodes':[{'children':[0.5]}]}"},
        {NKW_IMPORT_INVALID, "/nodes/0/children/0", "{" ASSET "'nodes':[{'children':[1e300]}]}"},
        {NKW_IMPORT_INVALID, "/nodes/0/children/0", "{" ASSET "'nodes':[{'children':['0']}]}"},
        {NKW_IMPORT_INVALID, "/nodes/0", "{" ASSET "'nodes':[{'children':[0]}]}"},
        {NKW_IMPORT_INVALID, "/nodes/1", "{" ASSET "'nodes':[{},{'children':[2]},{'children':[1]}]}"},
        {NKW_IMPORT_INVALID, "/nodes/1/children/0", "{" ASSET "'nodes':[{'children':[2]},{'children':[2]},{}]}"},
        {NKW_IMPORT_INVALID, "/nodes/0/children/1", "{" ASSET "'nodes':[{'children':[1,1]},{}]}"},
        {NKW_IMPORT_INVALID, "/nodes/0/translation", "{" ASSET "'nodes':[{'translation':[1,2]}]}"},
        {NKW_IMPORT_INVALID, "/nodes/0/scale/2", "{" ASSET "'nodes':[{'scale':[1,2,null]}]}"},
        {NKW_IMPORT_INVALID, "/nodes/0/rotation/3", "{" ASSET "'nodes':[{'rotation':[0,0,0,1e39]}]}"},
        {NKW_IMPORT_INVALID, "/nodes/0/matrix", "{" ASSET "'nodes':[{'matrix':[]}]}"},
        {NKW_IMPORT_INVALID, "/nodes/0/mesh", "{" ASSET "'nodes':[{'mesh':0}]}"},
        {NKW_IMPORT_INVALID, "/nodes/0/skin", "{" ASSET "'nodes':[{'skin':4294967296}]}"},
        {NKW_IMPORT_INVALID, "/skins/0/joints", "{" ASSET "'nodes':[{}],'skins':[{'joints':[]}]}"},
        {NKW_IMPORT_INVALID, "/skins/0/joints", "{" ASSET "'nodes':[{}],'skins':[{}]}"},
        {NKW_IMPORT_INVALID, "/skins/0/joints/1", "{" ASSET "'nodes':[{}],'skins':[{'joints':[0,1]}]}"},
        {NKW_IMPORT_INVALID, "/skins/0/inverseBindMatrices",
         "{" ASSET "'nodes':[{}],'skins':[{'joints':[0],'inverseBindMatrices':0}]}"},
        {NKW_IMPORT_INVALID, "/skins/0/inverseBindMatrices",
         "{" ASSET BUFFER "'accessors':[" FLOATS(1, MAT4) "],'nodes':[{}],"
                                                          "'skins':[{'joints':[0,0],'inverseBindMatrices':0}]}"},
        {NKW_IMPORT_INVALID, "/scenes/0/nodes/0", "{" ASSET "'nodes':[{}],'scenes':[{'nodes':[1]}]}"},
        {NKW_IMPORT_INVALID, "/scene", "{" ASSET "'nodes':[{}],'scene':0}"},
    };
    REFUSE(list);
}

/* An accessor as the positions of a mesh. */
#define POSITIONS(buffers, views, accessor)                                                                            \
    "{" ASSET "'buffers':[" buffers "],'bufferViews':[" views "],'accessors':[" accessor "],"                          \
    "'meshes':[{'primitives':[{'attributes':{'POSITION':0}}]}],'nodes':[{'mesh':0}]}"
#define DATA "{'uri':'data.bin','byteLength':64}"
#define VIEW "{'buffer':0,'byteLength':64}"

static void accessors_are_checked(void **state)
{
    (void)state;
    static const broken list[] = {
        {NKW_IMPORT_INVALID, "/meshes/0/primitives/0/attributes/POSITION", POSITIONS(DATA, VIEW, "")},
        {NKW_IMPORT_INVALID, "/meshes/0/primitives/0/attributes/POSITION", POSITIONS(DATA, VIEW, FLOATS(1, VEC4))},
        {NKW_IMPORT_INVALID, "/accessors/0/type", POSITIONS(DATA, VIEW, FLOATS(1, MAT2))},
        {NKW_IMPORT_INVALID, "/accessors/0/count", POSITIONS(DATA, VIEW, FLOATS(0, VEC3))},
        {NKW_IMPORT_INVALID, "/accessors/0/count", POSITIONS(DATA, VIEW, FLOATS(-1, VEC3))},
        {NKW_IMPORT_INVALID, "/accessors/0/bufferView", POSITIONS(DATA, VIEW, FLOATS(6, VEC3))},
        {NKW_IMPORT_INVALID, "/accessors/0/bufferView", POSITIONS(DATA, VIEW, FLOATS(4294967296, VEC3))},
        {NKW_IMPORT_INVALID, "/accessors/0/bufferView", POSITIONS(DATA, VIEW, FLOATS(9007199254740992, VEC3))},
        {NKW_IMPORT_INVALID, "/accessors/0/bufferView", POSITIONS(DATA, "", FLOATS(1, VEC3))},
        {NKW_IMPORT_INVALID, "/accessors/0/componentType",
         POSITIONS(DATA, VIEW, "{'bufferView':0,'componentType':5124,'count':1,'type':'VEC3'}")},
        {NKW_IMPORT_INVALID, "/accessors/0/bufferView",
         POSITIONS(DATA, VIEW, "{'bufferView':0,'byteOffset':56,'componentType':5126,'count':1,'type':'VEC3'}")},
        {NKW_IMPORT_INVALID, "/accessors/0/bufferView",
         POSITIONS(DATA, VIEW,
                   "{'bufferView':0,'byteOffset':9007199254740992,'componentType':5126,'count':1,'type':'VEC3'}")},
        {NKW_IMPORT_TOO_LARGE, "/accessors/0",
         POSITIONS(DATA, VIEW, "{'componentType':5126,'count':4294967295,'type':'VEC3'}")},
        {NKW_IMPORT_TOO_LARGE, "/accessors/0",
         POSITIONS(DATA, VIEW, "{'componentType':5126,'count':9007199254740992,'type':'VEC3'}")},
        {NKW_IMPORT_INVALID, "/bufferViews/0", POSITIONS(DATA, "{'buffer':0,'byteLength':65}", FLOATS(1, VEC3))},
        {NKW_IMPORT_INVALID, "/bufferViews/0",
         POSITIONS(DATA, "{'buffer':0,'byteOffset':1,'byteLength':64}", FLOATS(1, VEC3))},
        {NKW_IMPORT_INVALID, "/bufferViews/0",
         POSITIONS(DATA, "{'buffer':0,'byteStride':8,'byteLength':64}", FLOATS(1, VEC3))},
        {NKW_IMPORT_INVALID, "/accessors/0/bufferView",
         POSITIONS(DATA, "{'buffer':0,'byteStride':9007199254740992,'byteLength':64}", FLOATS(2, VEC3))},
        {NKW_IMPORT_INVALID, "/bufferViews/0/buffer", POSITIONS(DATA, "{'buffer':1,'byteLength':64}", FLOATS(1, VEC3))},
        {NKW_IMPORT_INVALID, "/bufferViews/0/byteLength", POSITIONS(DATA, "{'buffer':0}", FLOATS(1, VEC3))},
        {NKW_IMPORT_INVALID, "/accessors/0/sparse/count",
         POSITIONS(DATA, VIEW,
                   "{'componentType':5126,'count':1,'type':'VEC3','sparse':{'count':2,'indices':"
                   "{'bufferView':0,'componentType':5121},'values':{'bufferView':0}}}")},
        {NKW_IMPORT_INVALID, "/accessors/0",
         POSITIONS(DATA, VIEW,
                   "{'componentType':5126,'count':9,'type':'VEC3','sparse':{'count':2,'indices':"
                   "{'bufferView':0,'componentType':5121},'values':{'bufferView':0}}}")},
        {NKW_IMPORT_INVALID, "/accessors/0/sparse/indices",
         POSITIONS(DATA, VIEW,
                   "{'componentType':5126,'count':9,'type':'VEC3','sparse':{'count':1,'indices':"
                   "{'bufferView':0,'componentType':5126},'values':{'bufferView':0}}}")},
        {NKW_IMPORT_INVALID, "/accessors/0/sparse/values/bufferView",
         POSITIONS(DATA, VIEW,
                   "{'componentType':5126,'count':9,'type':'VEC3','sparse':{'count':9,'indices':"
                   "{'bufferView':0,'componentType':5121},'values':{'bufferView':0}}}")},
    };
    REFUSE(list);
}

static void buffers_are_checked(void **state)
{
    (void)state;
    static const broken list[] = {
        {NKW_IMPORT_INVALID, "/buffers/0/byteLength", POSITIONS("{'uri':'data.bin'}", VIEW, FLOATS(1, VEC3))},
        {NKW_IMPORT_INVALID, "/buffers/0/byteLength",
         POSITIONS("{'uri':'data.bin','byteLength':0}", VIEW, FLOATS(1, VEC3))},
        {NKW_IMPORT_INVALID, "/buffers/0/uri",
         POSITIONS("{'uri':'data.bin','byteLength':4294967296}", VIEW, FLOATS(1, VEC3))},
        {NKW_IMPORT_INVALID, "/buffers/0/uri",
         POSITIONS("{'uri':'data:;base64,AAAA','byteLength':4294967296}", VIEW, FLOATS(1, VEC3))},
        {NKW_IMPORT_INVALID, "/buffers/0/uri",
         POSITIONS("{'uri':'data:;base64,AAAA','byteLength':4}", VIEW, FLOATS(1, VEC3))},
        {NKW_IMPORT_INVALID, "/buffers/0/uri",
         POSITIONS("{'uri':'data:;base64,A','byteLength':1}", VIEW, FLOATS(1, VEC3))},
        {NKW_IMPORT_INVALID, "/buffers/0/uri",
         POSITIONS("{'uri':'data:;base64,A!AA','byteLength':1}", VIEW, FLOATS(1, VEC3))},
        {NKW_IMPORT_INVALID, "/buffers/0/uri",
         POSITIONS("{'uri':'data:;base64','byteLength':1}", VIEW, FLOATS(1, VEC3))},
        {NKW_IMPORT_INVALID, "/buffers/0/uri", POSITIONS("{'uri':'data:,%0','byteLength':1}", VIEW, FLOATS(1, VEC3))},
        {NKW_IMPORT_INVALID, "/buffers/0", POSITIONS("{'byteLength':64}", VIEW, FLOATS(1, VEC3))},
        {NKW_IMPORT_INVALID, "/buffers/0/uri", POSITIONS("{'uri':7,'byteLength':64}", VIEW, FLOATS(1, VEC3))},
        {NKW_IMPORT_INVALID, "/buffers/0/uri",
         POSITIONS("{'uri':'data.bin\\u0000x','byteLength':64}", VIEW, FLOATS(1, VEC3))},
    };
    REFUSE(list);
}

/* No name of a file leads out of the folder. */
static void paths_stay_in_the_folder(void **state)
{
    (void)state;
    static const char *const uris[] = {
        "none.bin",  "../data.bin", "a/../../data.bin", "/data.bin",  "%2e%2e/data.bin", "..%2Fdata.bin", "a/..", "",
        ".",         "./",          "file:x",           "http://a/b", "C:/data.bin",     "a\\\\..\\\\b",  "%00",  "%4",
        "data.bin/", "\\u001b[2J"};
    for (size_t i = 0; i < sizeof uris / sizeof *uris; i++) {
        char text[512];
        snprintf(text, sizeof text, POSITIONS("{'uri':'%s','byteLength':64}", VIEW, FLOATS(1, VEC3)), uris[i]);
        expect_refused(text, "", 64, NKW_IMPORT_UNREADABLE, "/buffers/0/uri");
    }
    nkw_document *document;
    nkw_import_error error;
    char *json = quoted(POSITIONS(DATA, VIEW, FLOATS(1, VEC3)));
    const nkw_import_memory memory = {json, strlen(json), NULL, NULL, NULL, NULL, 0, 0};
    assert_int_equal(nkw_document_from_memory(&memory, &document, &error), NKW_IMPORT_UNREADABLE);
    const nkw_import_memory nowhere = {json, strlen(json), NULL, "/no/such/folder", NULL, NULL, 0, 0};
    assert_int_equal(nkw_document_from_memory(&nowhere, &document, NULL), NKW_IMPORT_UNREADABLE);
    free(json);
    assert_int_equal(nkw_document_open("/no/such/file", &document, &error), NKW_IMPORT_UNREADABLE);
    assert_string_equal(error.file, "/no/such/file");
    assert_null(document);
}

/* Texts of a file do not control the terminal, and a long name does not overflow. */
static void messages_are_tame(void **state)
{
    (void)state;
    char text[3000], name[2000];
    nkw_document *document;
    nkw_import_error error;
    memset(name, 'x', sizeof name);
    name[sizeof name - 1] = 0;
    memcpy(name, "\\u001b\\u007f", 12);
    snprintf(text, sizeof text, POSITIONS("{'uri':'%s','byteLength':64}", VIEW, FLOATS(1, VEC3)), name);
    assert_int_equal(open_text(text, "", 0, &document, &error), NKW_IMPORT_UNREADABLE);
    assert_int_equal(error.reason[0], '?');
    assert_int_equal(error.reason[1], '?');
    memset(name, 'y', sizeof name - 1);
    memcpy(name + sizeof name - 7, "/z.bvh", 6);
    assert_int_equal(nkw_document_open(name, &document, &error), NKW_IMPORT_UNREADABLE);
    assert_int_equal(strlen(error.file), sizeof error.file - 1);
    assert_string_equal(error.file + strlen(error.file) - 6, "/z.bvh");
}

#define MESH(primitive)                                                                                                \
    "{" ASSET BUFFER "'accessors':[" FLOATS(2, VEC3) "," FLOATS(1, VEC3) "," FLOATS(                                   \
        2, VEC4) ","                                                                                                   \
                 "{'bufferView':0,'componentType':5121,'count':2,'type':'VEC4'},"                                      \
                 "{'bufferView':0,'componentType':5125,'count':3,'type':'SCALAR'},"                                    \
                 "{'bufferView':0,'componentType':5122,'count':2,'type':'VEC4'}],"                                     \
                 "'meshes':[{'primitives':[" primitive "]}],'nodes':[{'mesh':0}]}"
#define PRIMITIVE "/meshes/0/primitives/0"

static void meshes_are_checked(void **state)
{
    (void)state;
    const uint32_t vertex[16] = {0, 1, 2};
    static const broken list[] = {
        {NKW_IMPORT_INVALID, "/meshes/0", "{" ASSET "'meshes':[1]}"},
        {NKW_IMPORT_INVALID, PRIMITIVE, MESH("1")},
        {NKW_IMPORT_INVALID, PRIMITIVE "/attributes", MESH("{}")},
        {NKW_IMPORT_INVALID, PRIMITIVE "/material", MESH("{'attributes':{},'material':0}")},
        {NKW_IMPORT_INVALID, PRIMITIVE "/mode", MESH("{'attributes':{'POSITION':0},'mode':7}")},
        {NKW_IMPORT_INVALID, PRIMITIVE "/attributes/NORMAL", MESH("{'attributes':{'POSITION':0,'NORMAL':1}}")},
        {NKW_IMPORT_INVALID, PRIMITIVE "/attributes/JOINTS_0",
         MESH("{'attributes':{'POSITION':0,'JOINTS_0':0,'WEIGHTS_0':2}}")},
        {NKW_IMPORT_INVALID, PRIMITIVE "/attributes/JOINTS_0",
         MESH("{'attributes':{'POSITION':0,'JOINTS_0':5,'WEIGHTS_0':2}}")},
        {NKW_IMPORT_INVALID, PRIMITIVE "/attributes/JOINTS_0",
         MESH("{'attributes':{'POSITION':1,'JOINTS_0':3,'WEIGHTS_0':2}}")},
        {NKW_IMPORT_INVALID, PRIMITIVE "/attributes/WEIGHTS_0", MESH("{'attributes':{'POSITION':0,'JOINTS_0':3}}")},
        {NKW_IMPORT_INVALID, PRIMITIVE "/attributes/WEIGHTS_0",
         MESH("{'attributes':{'POSITION':0,'JOINTS_0':3,'WEIGHTS_0':3}}")},
        {NKW_IMPORT_INVALID, PRIMITIVE "/indices", MESH("{'attributes':{'POSITION':0},'indices':0}")},
        {NKW_IMPORT_INVALID, PRIMITIVE "/indices", MESH("{'attributes':{'POSITION':0},'indices':4}")},
        {NKW_IMPORT_INVALID, PRIMITIVE "/targets", MESH("{'attributes':{'POSITION':0},'targets':{}}")},
        {NKW_IMPORT_INVALID, PRIMITIVE "/targets/0", MESH("{'attributes':{'POSITION':0},'targets':[0]}")},
        {NKW_IMPORT_INVALID, PRIMITIVE "/targets/0/POSITION",
         MESH("{'attributes':{'POSITION':0},'targets':[{'POSITION':1}]}")},
        {NKW_IMPORT_INVALID, "/meshes/0/primitives/1",
         MESH("{'attributes':{'POSITION':0},'targets':[{}]},{'attributes':{'POSITION':0}}")},
        {NKW_IMPORT_UNSUPPORTED, PRIMITIVE "/extensions/KHR_draco_mesh_compression",
         "{" ASSET "'accessors':[{'componentType':5126,'count':2,'type':'VEC3'}],'nodes':[{}],'meshes':[{'primitives':["
         "{'attributes':{'POSITION':0},'extensions':{'KHR_draco_mesh_compression':{}}}]}]}"},
        {NKW_IMPORT_INVALID, "/meshes/0/weights",
         "{" ASSET "'nodes':[{}],'meshes':[{'weights':[],'primitives':[{'attributes':{},'targets':[{}]}]}]}"},
        {NKW_IMPORT_INVALID, "/nodes/0/weights",
         "{" ASSET
         "'nodes':[{'mesh':0,'weights':[1,2]}],'meshes':[{'primitives':[{'attributes':{},'targets':[{}]}]}]}"},
    };
    for (size_t i = 0; i < sizeof list / sizeof *list; i++)
        expect_refused(list[i].text, vertex, sizeof vertex, list[i].code, list[i].place);
}

#define ANIMATION(sampler, channel)                                                                                    \
    "{" ASSET BUFFER "'accessors':[" FLOATS(2, SCALAR) "," FLOATS(2, VEC3) "," FLOATS(3, VEC3) "," FLOATS(             \
        2, VEC4) ","                                                                                                   \
                 "{'bufferView':0,'componentType':5121,'count':2,'type':'VEC3'}],"                                     \
                 "'nodes':[{},{}],'animations':[{'samplers':[" sampler "],'channels':[" channel "]}]}"
#define MOVES "{'sampler':0,'target':{'node':1,'path':'translation'}}"

static void animations_are_checked(void **state)
{
    (void)state;
    static const broken list[] = {
        {NKW_IMPORT_INVALID, "/animations/0/channels/0", ANIMATION("", "[]")},
        {NKW_IMPORT_INVALID, "/animations/0/channels/0/target", ANIMATION("", "{'sampler':0}")},
        {NKW_IMPORT_INVALID, "/animations/0/channels/0/sampler", ANIMATION("", MOVES)},
        {NKW_IMPORT_INVALID, "/animations/0/channels/0/target/node",
         ANIMATION("{}", "{'sampler':0,'target':{'node':2,'path':'scale'}}")},
        {NKW_IMPORT_INVALID, "/animations/0/channels/0/target/path",
         ANIMATION("{}", "{'sampler':0,'target':{'node':0,'path':'colour'}}")},
        {NKW_IMPORT_INVALID, "/animations/0/samplers/0", ANIMATION("7", MOVES)},
        {NKW_IMPORT_INVALID, "/animations/0/samplers/0/input", ANIMATION("{}", MOVES)},
        {NKW_IMPORT_INVALID, "/animations/0/samplers/0/input", ANIMATION("{'input':9,'output':1}", MOVES)},
        {NKW_IMPORT_INVALID, "/animations/0/samplers/0/input", ANIMATION("{'input':1,'output':1}", MOVES)},
        {NKW_IMPORT_INVALID, "/animations/0/samplers/0/output", ANIMATION("{'input':0,'output':3}", MOVES)},
        {NKW_IMPORT_INVALID, "/animations/0/samplers/0/output", ANIMATION("{'input':0,'output':2}", MOVES)},
        {NKW_IMPORT_INVALID, "/animations/0/samplers/0/output", ANIMATION("{'input':0,'output':4}", MOVES)},
        {NKW_IMPORT_INVALID, "/animations/0/samplers/0/output",
         ANIMATION("{'input':0,'output':1,'interpolation':'CUBICSPLINE'}", MOVES)},
        {NKW_IMPORT_INVALID, "/animations/0/samplers/0/interpolation",
         ANIMATION("{'input':0,'output':1,'interpolation':'BEZIER'}", MOVES)},
    };
    REFUSE(list);
}

/* ---- Values ---- */

/* Two keys whose times and values are data[0..1] and data[2..7]. */
static const char keys_text[] =
    "{" ASSET "'buffers':[{'uri':'data.bin','byteLength':32}],'bufferViews':[{'buffer':0,'byteLength':8},"
    "{'buffer':0,'byteOffset':8,'byteLength':24}],'accessors':[" FLOATS(
        2, SCALAR) ","
                   "{'bufferView':1,'componentType':5126,'count':2,'type':'VEC3'}],'nodes':[{},{}],'animations':[{'"
                   "samplers':["
                   "{'input':0,'output':1}],'channels':[" MOVES
                   "]},{'samplers':[{'input':0,'output':1}],'channels':[" MOVES "," MOVES "]}]}";

static void expect_clip_refused(const float *data, size_t animation, nkw_result result, const char *place,
                                const char *reason)
{
    nkw_document *d = opened(keys_text, data, 32);
    nkw_clip *clip;
    nkw_import_error error;
    assert_int_equal(nkw_document_clip(d, animation, NKW_CLIP_FLOAT32, &clip, &error), NKW_IMPORT_REFUSED);
    assert_null(clip);
    assert_int_equal(error.result, result);
    assert_string_equal(error.place, place);
    assert_int_equal(strncmp(error.reason, reason, strlen(reason)), 0);
    assert_int_equal(nkw_document_validate(d, NULL), NKW_IMPORT_REFUSED);
    nkw_document_close(d);
}

static void keys_are_refused_by_clips(void **state)
{
    (void)state;
    float infinite = float_of(0x7f800000), none = float_of(0x7fc00000);
    const float nan_time[8] = {0, none}, infinite_value[8] = {0, 1, 0, 0, 0, infinite}, descending[8] = {1, 0.5f};
    const float good[8] = {0, 1};
    expect_clip_refused(nan_time, 0, NKW_NOT_FINITE, "/animations/0/channels/0", "key 1: ");
    expect_clip_refused(infinite_value, 0, NKW_NOT_FINITE, "/animations/0/channels/0", "key 1: ");
    expect_clip_refused(descending, 0, NKW_NOT_ASCENDING, "/animations/0/channels/0", "key 1: ");
    expect_clip_refused(good, 1, NKW_REPEATED, "/animations/1/channels/1", "two tracks");
}

static void skins_are_refused_by_validation(void **state)
{
    (void)state;
    static const char text[] =
        "{" ASSET "'buffers':[{'uri':'data.bin','byteLength':96}],'bufferViews':[{'buffer':0,'byteLength':96}],"
        "'accessors':[" FLOATS(
            1, VEC3) ",{'bufferView':0,'byteOffset':12,'componentType':5121,'count':1,'type':'VEC4'},"
                     "{'bufferView':0,'byteOffset':16,'componentType':5126,'count':1,'type':'VEC4'},"
                     "{'bufferView':0,'byteOffset':32,'componentType':5126,'count':1,'type':'MAT4'}],"
                     "'meshes':[{'primitives':[{'attributes':{'POSITION':0,'JOINTS_0':1,'WEIGHTS_0':2}}]}],"
                     "'skins':[{'joints':[1],'inverseBindMatrices':3}],'nodes':[{'mesh':0,'skin':0},{}]}";
    struct {
        float position[3];
        unsigned char joints[4];
        float weights[4], matrix[16];
    } data = {{0, 0, 0}, {0, 0, 0, 9}, {1, 0, 0, 0}, {0}};
    static const char *const places[] = {"", "/meshes/0/primitives/0", "/meshes/0/primitives/0",
                                         "/meshes/0/primitives/0", "/skins/0"};
    static const nkw_result results[] = {NKW_OK, NKW_OUT_OF_RANGE, NKW_BAD_WEIGHTS, NKW_NOT_FINITE, NKW_NOT_FINITE};
    for (int i = 0; i < 5; i++) {
        nkw_import_error error;
        data.weights[3] = i == 1 ? 0.5f : i == 2 ? -0.5f : i == 3 ? float_of(0x7fc00000) : 0.0f;
        data.matrix[5] = i == 4 ? float_of(0x7fc00000) : 1.0f;
        nkw_document *d = opened(text, &data, sizeof data);
        assert_int_equal(nkw_document_validate(d, &error), i ? NKW_IMPORT_REFUSED : NKW_IMPORT_OK);
        assert_int_equal(error.result, results[i]);
        assert_string_equal(error.place, places[i]);
        nkw_document_close(d);
    }
}

/* ---- Size ---- */

/* A text that grows. */
typedef struct growing {
    char *text;
    size_t length, room;
} growing;

/* format: of at most one number. */
static void append(growing *g, const char *format, int number)
{
    if (g->room - g->length < 256) {
        g->room += g->room + 4096;
        g->text = (char *)realloc(g->text, g->room);
        assert_non_null(g->text);
    }
    g->length += (size_t)snprintf(g->text + g->length, 256, format, number);
}

static void nesting_is_bounded(void **state)
{
    (void)state;
    growing g = {NULL, 0, 0};
    append(&g, "{" ASSET "'nodes':", 0);
    for (int i = 0; i < 1000000; i++)
        append(&g, i % 2 ? "[" : "{'a':", i);
    nkw_document *document;
    nkw_import_error error;
    assert_int_equal(open_text(g.text, NULL, 0, &document, &error), NKW_IMPORT_INVALID);
    free(g.text);
}

/* A chain of 65,536 nodes, all of them joints of a skin: every index that JOINTS_0 can hold. */
static void joints_may_be_65536(void **state)
{
    (void)state;
    enum { COUNT = 65536 };
    growing g = {NULL, 0, 0};
    append(&g, "{" ASSET "'nodes':[{}", 0);
    for (int i = 1; i < COUNT; i++)
        append(&g, ",{'children':[%d]}", i - 1);
    append(&g, "],'skins':[{'joints':[0", 0);
    for (int i = 1; i < COUNT; i++)
        append(&g, ",%d", i);
    append(&g, "]}]}", 0);
    nkw_document *d = opened(g.text, NULL, 0);
    free(g.text);
    assert_int_equal(d->skeleton.joint_count, COUNT);
    assert_int_equal(d->skins[0].joint_count, COUNT);
    assert_int_equal(d->skins[0].joints[0], COUNT - 1);
    assert_int_equal(nkw_document_validate(d, NULL), NKW_IMPORT_OK);
    nkw_document_close(d);
}

/* Ten thousand accessors that are the same 100 KB: no file needs so much more than it has. */
static void memory_is_bounded(void **state)
{
    (void)state;
    enum { COUNT = 10000, BYTES = 100000 };
    growing g = {NULL, 0, 0};
    append(&g, "{" ASSET "'buffers':[{'uri':'data.bin','byteLength':%d}],", BYTES);
    append(&g, "'bufferViews':[{'buffer':0,'byteLength':%d}],'nodes':[{}],'accessors':[", BYTES);
    for (int i = 0; i < COUNT; i++) {
        append(&g, i > 0 ? "," : "", 0);
        append(&g, "{'bufferView':0,'componentType':5121,'count':%d,'type':'VEC3'}", BYTES / 3);
    }
    append(&g, "],'meshes':[{'primitives':[", 0);
    for (int i = 0; i < COUNT; i++)
        append(&g, i ? ",{'attributes':{'POSITION':%d}}" : "{'attributes':{'POSITION':%d}}", i);
    append(&g, "]}]}", 0);
    unsigned char *data = (unsigned char *)calloc(BYTES, 1);
    assert_non_null(data);
    nkw_document *document;
    nkw_import_error error;
    assert_int_equal(open_text(g.text, data, BYTES, &document, &error), NKW_IMPORT_TOO_LARGE);
    free(data);
    free(g.text);
}

/* ---- Bytes ---- */

static const char glb_text[] =
    "{" ASSET "'buffers':[{'byteLength':44}],'bufferViews':[{'buffer':0,'byteLength':44}],"
    "'accessors':[" FLOATS(2, SCALAR) "," FLOATS(
        3, VEC3) ","
                 "{'bufferView':0,'byteOffset':8,'componentType':5126,'count':2,'type':'VEC3'}],"
                 "'nodes':[{'mesh':0},{}],'meshes':[{'primitives':[{'attributes':{'POSITION':1}}]}],"
                 "'animations':[{'samplers':[{'input':0,'output':2}],'channels':[" MOVES "]}]}   ";

/* A GLB of one triangle that moves; returns its size. */
static size_t glb(unsigned char *out)
{
    char *json = quoted(glb_text);
    uint32_t length = (uint32_t)strlen(json) / 4 * 4, bin = 44, all = 12 + 8 + length + 8 + bin;
    const float keys[11] = {0, 1, 1, 2, 3, 4, 5, 6};
    const uint32_t head[5] = {0x46546c67, 2, all, length, 0x4e4f534a}, chunk[2] = {bin, 0x004e4942};
    memcpy(out, head, sizeof head);
    memcpy(out + 20, json, length);
    memcpy(out + 20 + length, chunk, sizeof chunk);
    memcpy(out + 28 + length, keys, sizeof keys);
    free(json);
    return all;
}

/* Opens, and uses what can be opened. The bytes are in memory of exactly their size. */
static nkw_import_result use_bytes(const unsigned char *bytes, size_t size)
{
    unsigned char *copy = (unsigned char *)malloc(size + 1);
    assert_non_null(copy);
    memcpy(copy, bytes, size);
    const nkw_import_memory memory = {copy, size, "bytes", NULL, NULL, NULL, 0, 0};
    nkw_document *d;
    nkw_clip *clip;
    nkw_import_result result = nkw_document_from_memory(&memory, &d, NULL);
    free(copy);
    if (d && nkw_document_validate(d, NULL) == NKW_IMPORT_OK)
        for (size_t i = 0; i < d->animation_count; i++) {
            assert_int_equal(nkw_document_clip(d, i, NKW_CLIP_FLOAT32, &clip, NULL), NKW_IMPORT_OK);
            nkw_import_free(clip);
        }
    nkw_document_close(d);
    return result;
}

static void cut_files_are_refused(void **state)
{
    (void)state;
    unsigned char bytes[2048];
    size_t size = glb(bytes);
    assert_true(size < sizeof bytes);
    assert_int_equal(use_bytes(bytes, size), NKW_IMPORT_OK);
    for (size_t i = 0; i < size; i++)
        assert_int_not_equal(use_bytes(bytes, i), NKW_IMPORT_OK);
    /* The text alone. */
    size_t length = bytes[12] + 256u * bytes[13], end = 20 + length;
    while (bytes[end - 1] == ' ')
        end--;
    for (size_t i = 20; i < end; i++)
        assert_int_not_equal(use_bytes(bytes + 20, i - 20), NKW_IMPORT_OK);
}

static void changed_bytes_do_no_harm(void **state)
{
    (void)state;
    static const unsigned char values[] = {0x00, 0xff, 0x7f, '9', '-', '}', '"'};
    unsigned char bytes[2048];
    size_t size = glb(bytes);
    for (size_t i = 0; i < size; i++) {
        unsigned char kept = bytes[i];
        for (size_t k = 0; k < sizeof values; k++) {
            bytes[i] = values[k];
            use_bytes(bytes, size);
        }
        bytes[i] = kept;
    }
}

static void headers_are_checked(void **state)
{
    (void)state;
    static const struct {
        size_t at;
        unsigned char value;
        nkw_import_result code;
        const char *place;
    } list[] = {{4, 1, NKW_IMPORT_UNSUPPORTED, "byte 4"},
                {11, 0xff, NKW_IMPORT_INVALID, "byte 8"},
                {16, 'j', NKW_IMPORT_INVALID, "byte 16"},
                {15, 0xff, NKW_IMPORT_INVALID, "byte 12"},
                {20, 'x', NKW_IMPORT_INVALID, "byte 21"}};
    for (size_t i = 0; i < sizeof list / sizeof *list; i++) {
        unsigned char bytes[2048];
        size_t size = glb(bytes);
        nkw_document *document;
        nkw_import_error error;
        bytes[list[i].at] = list[i].value;
        const nkw_import_memory memory = {bytes, size, "bytes", NULL, NULL, NULL, 0, 0};
        assert_int_equal(nkw_document_from_memory(&memory, &document, &error), list[i].code);
        assert_string_equal(error.place, list[i].place);
    }
}

/* The second chunk ends with the file: one byte more, and it is refused where it begins. */
static void the_second_chunk_ends_within_the_file(void **state)
{
    (void)state;
    unsigned char bytes[2048];
    const size_t size = glb(bytes), at = size - 44 - 8;
    assert_int_equal(use_bytes(bytes, size), NKW_IMPORT_OK);
    const uint32_t lengths[5] = {45, 44 + (uint32_t)at, 2 * (uint32_t)size, 0x7fffffff, 0xffffffff};
    for (size_t i = 0; i < 5; i++) {
        char place[32];
        nkw_document *document;
        nkw_import_error error;
        memcpy(bytes + at, &lengths[i], 4);
        const nkw_import_memory memory = {bytes, size, "bytes", NULL, NULL, NULL, 0, 0};
        snprintf(place, sizeof place, "byte %zu", at);
        assert_int_equal(nkw_document_from_memory(&memory, &document, &error), NKW_IMPORT_INVALID);
        assert_string_equal(error.place, place);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(files_of_other_formats_are_unknown),
        cmocka_unit_test(nodes_are_checked),
        cmocka_unit_test(accessors_are_checked),
        cmocka_unit_test(buffers_are_checked),
        cmocka_unit_test(paths_stay_in_the_folder),
        cmocka_unit_test(messages_are_tame),
        cmocka_unit_test(meshes_are_checked),
        cmocka_unit_test(animations_are_checked),
        cmocka_unit_test(keys_are_refused_by_clips),
        cmocka_unit_test(skins_are_refused_by_validation),
        cmocka_unit_test(nesting_is_bounded),
        cmocka_unit_test(joints_may_be_65536),
        cmocka_unit_test(memory_is_bounded),
        cmocka_unit_test(cut_files_are_refused),
        cmocka_unit_test(changed_bytes_do_no_harm),
        cmocka_unit_test(headers_are_checked),
        cmocka_unit_test(the_second_chunk_ends_within_the_file),
    };
    return cmocka_run_group_tests_name("import_hostile", tests, NULL, NULL);
}
