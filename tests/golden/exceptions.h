/* SPDX-License-Identifier: MIT */
/*
 * golden --exceptions: the exceptions that the functions raise (IEEE 754, 7), by the processor's flags; a trap would
 * stop the program where a flag is set here. docs/determinism.md states what is promised.
 *
 *     any finite numbers              no division by zero
 *     of the size of ordinary data    nor an invalid operation, nor an overflow: also of zeros, of keys that are equal
 *                                     or at one time, and of matrices without an inverse
 */
static void draw_degenerate(input *i, unsigned kind)
{
    const nkw_vec3 none = {0.0f, 0.0f, 0.0f};
    if (kind & 1)
        i->trs.scale.x = 0.0f;
    if (kind & 2)
        i->trs.scale.y = i->trs.scale.z = 0.0f;
    if (kind == 3) {
        memset(&i->m, 0, sizeof i->m), memset(&i->n, 0, sizeof i->n), memset(&i->r, 0, sizeof i->r);
    }
    for (unsigned k = 1; k < 5 && kind == 4; k++) {
        i->keys[k].position = i->keys[0].position;
        i->keys[k].orientation = i->keys[0].orientation;
        i->v[k % 4] = i->v[0];
        i->q[k % 4] = i->q[0];
    }
    for (unsigned k = 0; k < 4 && kind == 5; k++)
        i->v[k] = none;
    if (kind == 6) {
        memset(i->s, 0, sizeof i->s), memset(i->x, 0, sizeof i->x), memset(i->cubic, 0, sizeof i->cubic);
    }
    if (kind == 7)
        memset(i->q, 0, sizeof i->q);
    for (unsigned k = 1; k < 5 && kind == 8; k++)
        i->times[k % 4] = i->keys[k].time = i->times[0] = i->keys[0].time;
}

/* Every kernel on `rounds` inputs; of any bits, or ordinary ones. Returns the number that raise one of `refused`. */
static int raise_kernels(int any, int refused)
{
    static int raised[KERNELS];
    int failed = 0;
    random_source r = random_from(any ? 98 : 99);
    memset(raised, 0, sizeof raised);
    for (unsigned round = 0; round < ROUNDS; round++) {
        input i;
        draw(&r, &i);
        i.is_seldom = round % 16 == 0;
        for (int k = 0; k < 8 && !any; k++)
            i.x[k] = random_scaled(&r, -20, 20);
        draw_degenerate(&i, round % 16);
        for (size_t k = 0; k < KERNELS; k++) {
            float o[16] = {0};
            clear_exceptions();
            kernels[k].run(&i, o);
            raised[k] |= raised_exceptions(refused) & ~defined_exceptions(kernels[k].name);
        }
    }
    for (size_t k = 0; k < KERNELS; k++)
        failed += report_exceptions("golden", kernels[k].name, any ? "finite" : "ordinary", raised[k]);
    return failed;
}

static int raise_data(void)
{
    int failed = 0;
    for (size_t k = 0; k < sizeof data / sizeof data[0]; k++) {
        clear_exceptions();
        data[k].hash();
        failed += report_exceptions("golden", data[k].name, "ordinary",
                                    raised_exceptions(EXCEPTIONS & ~defined_exceptions(data[k].name + 5)));
    }
    return failed;
}

static int test_exceptions(void)
{
    if (!EXCEPTIONS) {
        printf("golden: exceptions skipped, this system has no flags for them\n");
        return 77;
    }
    int failed = raise_kernels(1, EXCEPTION_DIVISION) + raise_kernels(0, EXCEPTIONS) + raise_data();
    printf("golden: exceptions of %zu functions, %d raise some\n", LINES, failed);
    return failed > 0;
}
