/* SPDX-License-Identifier: MIT */
/* Collada: the input as it is, and edits of a text. Every channel is read, every node is transformed at some times. */
#include <stdlib.h>
#include <string.h>

#include "fuzz.h"
#include "import/collada.h"

enum { FILE_MOST = 8192, EDITS_MOST = 8 };

/* ' for ". */
static const char text[] =
    "<COLLADA version='1.4.1'><library_animations><animation id='a'><animation id='b'>"
    "<source id='i'><float_array id='ia' count='3'> 0 1 2</float_array><technique_common><accessor source='#ia' count='3' "
    "stride='1' offset='0'/></technique_common></source><source id='o'><float_array id='oa' count='3'>0 400 -3e1"
    "</float_array><technique_common><accessor source='#oa' count='3'/></technique_common></source><source id='k'>"
    "<Name_array count='3'>BEZIER HERMITE TCB</Name_array></source><source id='t'><float_array id='ta' count='6'>0.5 1 "
    "1.5 5 2 -1</float_array><technique_common><accessor source='#ta' count='3' stride='2'/></technique_common></source>"
    "<source id='m'><float_array id='ma' count='48'>1 0 0 1 0 1 0 2 0 0 1 3 0 0 0 1 0 0 0 1 0 0 0 2 0 0 0 3 0 0 0 1 -1 0 "
    "0 1 0 1 0 2 0 0 1 3 0 0 0 1</float_array><technique_common><accessor source='#ma' count='3' stride='16'/>"
    "</technique_common></source><sampler id='s'><input semantic='INPUT' source='#i'/><input semantic='OUTPUT' "
    "source='#o'/><input semantic='INTERPOLATION' source='#k'/><input semantic='IN_TANGENT' source='#t'/><input "
    "semantic='OUT_TANGENT' source='#t'/><input semantic='TENSION' source='#i'/></sampler><sampler id='r'><input "
    "semantic='INPUT' source='#i'/><input semantic='OUTPUT' source='#m'/></sampler><channel source='#s' "
    "target='n/r.ANGLE'/><channel source='#s' target='n/t(1)'/><channel source='#s' target='n/m(3)(2)'/>"
    "</animation><channel source='#r' target='p/m'/></animation></library_animations><library_visual_scenes>"
    "<visual_scene id='v'><node id='n'><translate sid='t'>1 2 3</translate><rotate sid='r'>0 0 1 30</rotate>"
    "<scale sid='z'>1 2 3</scale><lookat>5 0 0 0 0 0 0 1 0</lookat><matrix sid='m'>1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1"
    "</matrix><skew>1 2 3 4 5 6 7</skew><node id='p'><matrix sid='m'>1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1</matrix></node>"
    "</node></visual_scene></library_visual_scenes><scene><instance_visual_scene url='#v'/></scene></COLLADA>";

static const char *const words[] = {"0",    "-1",  "1e38", "nan",     "4294967295", "'",      "<",      "/>",   "#o",
                                    "#m",   "#k",  "STEP", "LINEAR",  "BEZIER",     "(3)(3)", "(9999)", ".X",   "&lt;",
                                    "&#1;", "n/t", "a",    "<node>", "<!--",       "'16'",   "'0'",    "sid='"};

static size_t replace(fuzz *f, char *data, size_t length)
{
    const char *word = words[fuzz_upto(f, sizeof words / sizeof *words - 1)];
    const size_t at = fuzz_upto(f, length), size = strlen(word);
    size_t cut = fuzz_upto(f, 8);
    cut = cut < length - at ? cut : length - at;
    if (length - cut + size > FILE_MOST)
        return length;
    memmove(data + at + size, data + at + cut, length - at - cut);
    memcpy(data + at, word, size);
    return length - cut + size;
}

static void link_channels(nkwi_collada *c)
{
    for (size_t i = 0; i < c->channel_count; i++) {
        nkwi_collada_channel *one = &c->channels[i];
        if (!one->curve)
            continue;
        FUZZ_CHECK(one->first + one->curve->width <= nkwi_collada_width(c->elements[one->element].kind));
        one->next = c->elements[one->element].channel;
        c->elements[one->element].channel = i;
    }
}

static void read_file(const char *data, size_t length)
{
    nkwi_memory memory = {NULL, 0, (size_t)1 << 24, 0};
    nkwi_collada c;
    if (nkwi_collada_begin(&c, &memory, data, length)) {
        const xmlNode *top = xmlDocGetRootElement(c.xml);
        link_channels(&c);
        for (const xmlNode *t = top; t; t = nkwi_collada_walk(top, t)) {
            size_t count;
            if (!nkwi_collada_is(t, "node"))
                continue;
            const nkwi_collada_element *list = nkwi_collada_elements_of(&c, t, &count);
            for (size_t i = 0; i < count; i++)
                for (int part = 0; part < 3; part++)
                    nkwi_collada_affects(list, count, i, part);
            for (float time = -0.5f; time < 3.0f; time += 0.25f) {
                nkw_mat4 matrix;
                nkwi_collada_transform(&c, list, count, time, &matrix);
            }
        }
    } else
        FUZZ_CHECK(c.fault != NULL);
    nkwi_collada_end(&c);
    nkwi_give(&memory);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    fuzz f = fuzz_begin(data, size);
    char *file = (char *)fuzz_block(&f, FILE_MOST);
    size_t length = sizeof text - 1;
    if (fuzz_byte(&f) % 8 == 0) {
        length = size < FILE_MOST ? size : FILE_MOST;
        if (length > 0)
            memcpy(file, data, length);
    } else {
        for (size_t i = 0; i < length; i++)
            file[i] = (char)(text[i] == '\'' ? '"' : text[i]);
        for (size_t i = fuzz_upto(&f, EDITS_MOST); i > 0; i--)
            length = replace(&f, file, length);
    }
    read_file(file, length);
    return fuzz_end(&f);
}
