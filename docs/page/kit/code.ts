// SPDX-License-Identifier: MIT
// C programs that print the numbers of an exhibit: one line for each, `name.index value`.

/** A float as a C literal that reads back as the same float. */
export function literal(x: number): string {
  if (!Number.isFinite(x))
    return Number.isNaN(x) ? '(0.0f / 0.0f)' : x > 0 ? '(1.0f / 0.0f)' : '(-1.0f / 0.0f)';
  const f = Math.fround(x);
  if (Object.is(f, -0))
    return '-0.0f';
  let text = String(f);
  for (let digits = 1; digits <= 9; digits++) {
    text = String(+f.toPrecision(digits));
    if (Math.fround(Number(text)) === f)
      break;
  }
  return `${/[.e]/.test(text) ? text : `${text}.0`}f`;
}

/** {1.0f, 2.0f} */
export const list = (values: ArrayLike<number>) => `{${Array.from(values, literal).join(', ')}}`;

/** The whole program. `body` uses show(name, index, value), and show_floats(name, count, floats). */
export function program(body: string): string {
  const lines = body.trim().split('\n').map(line => line ? `    ${line}` : '').join('\n');
  const floats = !body.includes('show_floats(') ? '' : `
static void show_floats(const char *name, int count, const float *values)
{
    for (int i = 0; i < count; i++)
        show(name, i, (double)values[i]);
}
`;
  return `/* cc -std=c99 program.c $(pkg-config --cflags --libs --static nakawari) */
#include <nakawari/nakawari.h>
#include <stdio.h>

static void show(const char *name, int index, double value)
{
    printf("%s.%d %.17g\\n", name, index, value);
}
${floats}
int main(void)
{
${lines}
    return 0;
}
`;
}
