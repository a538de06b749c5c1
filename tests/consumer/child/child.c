/* SPDX-License-Identifier: MIT */
float engine_half(float from, float to);

int main(void)
{
    return !(engine_half(2.0f, 4.0f) > 2.99f && engine_half(2.0f, 4.0f) < 3.01f);
}
