/* SPDX-License-Identifier: MIT */
/*
 * The main of a program whose own main is compiled as `on_phase`, and whose functions align their stack to 4 bytes, as
 * 32-bit callers may: runs it at each of the four phases of 16 bytes.
 */
#undef main

#include <alloca.h>
#include <stdio.h>

int on_phase(int argc, char **argv);

/* Moves the stack by a word for each phase. */
static int run(int argc, char **argv, unsigned phase)
{
    volatile char *words = (volatile char *)alloca(4 * phase + 4);
    words[0] = 0;
    return on_phase(argc, argv) | words[0];
}

int main(int argc, char **argv)
{
    int failed = 0;
    for (unsigned phase = 0; phase < 4; phase++)
        failed |= run(argc, argv, phase);
    return failed;
}
