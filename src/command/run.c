/* SPDX-License-Identifier: MIT */
#include "command.h"

int command_work(const char *path, const command_steps *steps, void *request)
{
    nkw_document *d = input_open(path);
    const int done = d && steps->work(d, request);
    input_close(d);
    return done ? COMMAND_FINE : COMMAND_FINDINGS;
}

int command_run(const options_text *text, const struct poptOption *table, int argc, const char **argv,
                const command_steps *steps, void *request)
{
    options o;
    int code;
    if (!options_read(&o, text, table, argc, argv))
        code = o.code;
    else if ((code = steps->check(&o, request)) == COMMAND_FINE)
        code = command_work(o.files[0], steps, request);
    options_close(&o);
    return code;
}
