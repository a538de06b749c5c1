/* SPDX-License-Identifier: MIT */
/* A program whose calls the linker is told: -Wl,--undefined=FUNCTION. */
int main(void)
{
    return 0;
}
