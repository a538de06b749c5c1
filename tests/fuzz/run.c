/* SPDX-License-Identifier: MIT */
/*
 * fuzz_STEM [--runs=N] [--seed=S] [FILE ...]: a harness without libFuzzer. Runs over the files, or over N inputs of 0
 * to 400 bytes that are the same everywhere.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "fuzz.h"

enum { MOST = 400, FILE_MOST = 1 << 20 };

static int run_file(const char *path)
{
    static uint8_t data[FILE_MOST];
    FILE *file = fopen(path, "rb");
    if (!file) {
        fprintf(stderr, "cannot read %s\n", path);
        return 1;
    }
    size_t size = fread(data, 1, FILE_MOST, file);
    fclose(file);
    LLVMFuzzerTestOneInput(data, size);
    return 0;
}

/* The input in memory of its very size; most bytes are small, as counts and choices are. */
static void run_random(uint64_t seed)
{
    random_source r = random_from(seed);
    size_t size = (size_t)(random_bits(&r) % (MOST + 1));
    uint8_t *data = malloc(size + 1);
    if (!data)
        abort();
    for (size_t i = 0; i < size; i++)
        data[i] = (uint8_t)(random_bits(&r) >> (random_bits(&r) % 4 ? 56 : 60));
    LLVMFuzzerTestOneInput(data, size);
    free(data);
}

int main(int argc, char **argv)
{
    unsigned long runs = 1000, seed = 1;
    int files = 0, failed = 0;
    for (int i = 1; i < argc; i++) {
        if (strncmp(argv[i], "--runs=", 7) == 0)
            runs = strtoul(argv[i] + 7, NULL, 10);
        else if (strncmp(argv[i], "--seed=", 7) == 0)
            seed = strtoul(argv[i] + 7, NULL, 10);
        else
            files++, failed |= run_file(argv[i]);
    }
    for (unsigned long i = 0; !files && i < runs; i++)
        run_random((uint64_t)seed << 32 | i);
    printf("%lu inputs\n", files ? (unsigned long)files : runs);
    return failed;
}
