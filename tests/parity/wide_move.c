/* SPDX-License-Identifier: MIT */
/* The aligned move of a wide register that GCC may write to the stack; wide_moves.cmake looks for what becomes of it. */
void wide_move(float *to);

void wide_move(float *to)
{
    __asm__ volatile("vmovaps %%ymm0, (%0)" : : "r"(to) : "memory");
}
