/* SPDX-License-Identifier: MIT */
/* A program whose calls are options of the linker: -Wl,--undefined=FUNCTION. */
int main(void)
{
    return 0;
}
