/* SPDX-License-Identifier: MIT */
/* FBX: the input as it is, and edits of a text and of a binary file. Every object is read, every stack is baked. */
#include <stdlib.h>
#include <string.h>

#include "fuzz.h"
#include "import/fbx_bake.h"

enum { FILE_MOST = 8192, EDITS_MOST = 8 };

/* ' for ". */
static const char text[] =
    "; FBX 7.4.0\nFBXHeaderExtension: {\nFBXVersion: 7400\nOtherFlags: {\nTCDefinition: 127\n}\n}\nDefinitions: {\n"
    "ObjectType: 'Model' {\nPropertyTemplate: 'FbxNode' {\nProperties70: {\nP: 'InheritType', 'enum', '', "
    "'',0\n}\n}\n}\n}\n"
    "Objects: {\nModel: 1, 'Model::a', 'Null' {\nProperties70: {\nP: 'Lcl Scaling', 'Vector3D', '', 'A',1,2,.5\n}\n}\n"
    "AnimationStack: 2, 'AnimStack::s', '' {\nProperties70: {\nP: 'LocalStop', 'KTime', 'Time', '',138558474000\n}\n}\n"
    "AnimationLayer: 3, 'AnimLayer::l', '' {\n}\nAnimationLayer: 4, 'AnimLayer::m', '' {\nProperties70: {\nP: "
    "'Weight', "
    "'Number', '', 'A',50\nP: 'BlendMode', 'enum', '', '',2\n}\n}\nAnimationCurveNode: 5, 'AnimCurveNode::R', '' {\n}\n"
    "AnimationCurveNode: 6, 'AnimCurveNode::R', '' {\nProperties70: {\nP: 'd|X', 'Number', '', 'A',90\n}\n}\n"
    "AnimationCurve: 7, 'AnimCurve::', '' {\nKeyTime: *3 {\na: 0,46186158000,92372316000\n}\nKeyValueFloat: *3 {\n"
    "a: 0,400,-30.5\n}\nKeyAttrFlags: *2 {\na: 50332680,8456\n}\nKeyAttrDataFloat: *8 {\na: "
    "1065353216,0,218434821,0,0,0,"
    "0,0\n}\nKeyAttrRefCount: *2 {\na: 1,2\n}\nPost-Extrapolation: {\nType: R\nRepetition: -1\n}\n}\n}\n"
    "Connections: {\nC: 'OO',1,0\nC: 'OO',3,2\nC: 'OO',4,2\nC: 'OO',5,3\nC: 'OO',6,4\nC: 'OP',5,1, 'Lcl Rotation'\n"
    "C: 'OP',6,1, 'Lcl Rotation'\nC: 'OP',7,5, 'd|X'\n}\n";

static const char *const words[] = {
    "0",    "1",        "-1",  "*4",   "{",     "}", ",", "'", "4294967295", "9223372036854775807",
    "1e38", "258",      "520", "1032", "17152", "A", "M", "K", "a:",         "\n",
    ":",    "Model: 0", "2,"};

/* A node of the binary form with one value after its name; ended when what is below it is written. */
typedef struct binary {
    uint8_t *data;
    size_t bytes, wide;
} binary;

static void put(binary *b, uint64_t number, size_t size)
{
    for (size_t i = 0; i < size && b->bytes < FILE_MOST; i++)
        b->data[b->bytes++] = (uint8_t)(number >> (8 * i));
}

static size_t open_node(binary *b, const char *name, uint64_t id)
{
    const size_t start = b->bytes, length = strlen(name);
    put(b, 0, b->wide);
    put(b, 1, b->wide);
    put(b, 9, b->wide);
    put(b, length, 1);
    for (size_t i = 0; i < length; i++)
        put(b, (uint8_t)name[i], 1);
    put(b, 'L', 1);
    put(b, id, 8);
    return start;
}

static void close_node(binary *b, size_t start, int has_children)
{
    for (size_t i = 0; has_children && i <= 3 * b->wide; i++)
        put(b, 0, 1);
    for (size_t i = 0; i < b->wide && start + i < FILE_MOST; i++)
        b->data[start + i] = (uint8_t)((uint64_t)b->bytes >> (8 * i));
}

static size_t write_binary(fuzz *f, uint8_t *data)
{
    static const char mark[] = "Kaydara FBX Binary  \0\x1a";
    const int is_wide = fuzz_byte(f) % 2;
    binary b = {data, 0, is_wide ? 8 : 4};
    for (size_t i = 0; i < sizeof mark; i++)
        put(&b, (uint8_t)mark[i], 1);
    put(&b, is_wide ? 7700 : 7400, 4);
    const size_t objects = open_node(&b, "Objects", 0), stack = open_node(&b, "AnimationStack", 2);
    close_node(&b, stack, 0);
    const size_t curve = open_node(&b, "AnimationCurve", 7);
    for (int k = 0; k < 2; k++) {
        const size_t array = open_node(&b, k ? "KeyTime" : "KeyValueFloat", 0);
        b.bytes -= 9; /* an array in place of the number */
        put(&b, k ? 'l' : 'f', 1);
        put(&b, 2, 4);
        put(&b, fuzz_byte(f) % 4 == 0, 4);
        put(&b, k ? 16 : 8, 4);
        put(&b, fuzz_bits(f), k ? 8 : 4);
        put(&b, fuzz_bits(f), k ? 8 : 4);
        for (size_t i = 0; i < b.wide; i++)
            b.data[array + 2 * b.wide + i] = (uint8_t)(i == 0 ? (k ? 29 : 21) : 0);
        close_node(&b, array, 0);
    }
    close_node(&b, curve, 1);
    close_node(&b, objects, 1);
    return b.bytes;
}

static size_t edit(fuzz *f, uint8_t *data, size_t length, int is_text)
{
    const size_t at = fuzz_upto(f, length - 1);
    if (!is_text || fuzz_byte(f) % 3 == 0) {
        data[at] = fuzz_byte(f);
        return fuzz_byte(f) % 16 == 0 ? at + 1 : length;
    }
    const char *word = words[fuzz_upto(f, sizeof words / sizeof *words - 1)];
    const size_t more = strlen(word), cut = fuzz_byte(f) % 6 > length - at ? length - at : fuzz_byte(f) % 3;
    if (cut > length - at || length + more > FILE_MOST)
        return length;
    memmove(data + at + more, data + at + cut, length - at - cut);
    memcpy(data + at, word, more);
    return length - cut + more;
}

static void sample(void *user, float time, float *out)
{
    const nkw_vec3 v = nkwi_fbx_sample((const nkwi_fbx_animated *)user, time);
    memcpy(out, &v, sizeof v);
}

/* Every channel as a track of three numbers, whose times ascend. */
static void bake(const nkwi_fbx_stack *stack)
{
    for (size_t i = 0; i < stack->channel_count && i < 8; i++) {
        nkwi_fbx_animated a = {stack, &stack->channels[i], 1, {0, 0, 0}, NKW_EULER_XYZ, "TRSN"[i % 4]};
        nkwi_fbx_times times = {NULL, 0, 0, 0, 0, stack->start, stack->stop, 0, 0};
        nkwi_fbx_baked baked;
        nkwi_fbx_add_times(&times, &a);
        nkwi_fbx_sort_times(&times);
        const nkwi_fbx_source source = {sample, &a, 3, 0, &times};
        FUZZ_CHECK(!times.failed && times.count > 0 && nkwi_fbx_bake(&source, &baked));
        for (size_t k = 1; k < baked.count; k++)
            FUZZ_CHECK(baked.times[k] > baked.times[k - 1]);
        nkwi_fbx_baked_free(&baked);
        free(times.list);
    }
}

static void read_file(const uint8_t *data, size_t bytes)
{
    nkwi_memory memory = {NULL, 0, (size_t)1 << 24, 0};
    nkwi_fbx file;
    if (!nkwi_fbx_begin(&file, &memory, data, bytes))
        FUZZ_CHECK(file.tree.fault != NULL);
    for (size_t i = 0; !file.tree.fault && i < file.object_count; i++) {
        nkwi_fbx_stack stack;
        nkwi_fbx_curve curve;
        char name[32];
        nkwi_fbx_name(&file, i, name, sizeof name);
        FUZZ_CHECK(strlen(name) < sizeof name);
        nkwi_fbx_model_of(&file, i);
        if (nkwi_fbx_is_kind(&file, i, "AnimationCurve"))
            nkwi_fbx_curve_read(&file, i, &curve);
        if (nkwi_fbx_is_kind(&file, i, "AnimationStack") && nkwi_fbx_stack_read(&file, i, &stack) &&
            stack.stop > stack.start && stack.stop < 1000.0f)
            bake(&stack);
    }
    nkwi_fbx_end(&file);
    nkwi_give(&memory);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    fuzz f = fuzz_begin(data, size);
    uint8_t *file = (uint8_t *)fuzz_block(&f, FILE_MOST);
    const unsigned char kind = fuzz_byte(&f) % 8;
    size_t bytes = 0;
    if (kind == 0)
        for (; bytes < size && bytes < FILE_MOST; bytes++)
            file[bytes] = data[bytes];
    else if (kind < 4)
        bytes = write_binary(&f, file);
    else
        for (; text[bytes]; bytes++)
            file[bytes] = (uint8_t)(text[bytes] == '\'' ? '"' : text[bytes]);
    for (size_t i = fuzz_upto(&f, EDITS_MOST); kind != 0 && bytes > 0 && i > 0; i--)
        bytes = edit(&f, file, bytes, kind >= 4);
    read_file(file, bytes);
    return fuzz_end(&f);
}
