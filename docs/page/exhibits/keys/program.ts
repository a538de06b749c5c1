// SPDX-License-Identifier: MIT
// The C program of a state: value, velocity and acceleration of every method, and the tangents of the chosen one.
import { list, literal, program } from '../../kit/code';
import { splines, type State } from './curves';

const setup = (s: State) => `
enum { COUNT = ${s.times.length} };
static const char *const names[] = {${splines.map(m => `"${m}"`).join(', ')}};
static const float times[COUNT] = ${list(s.times)};
static const float values[COUNT] = ${list(s.values)};
static const float own[COUNT] = ${list(s.tangents)};
const float time = ${literal(s.time)};
nkw_tcb tcb[COUNT];
for (int k = 0; k < COUNT; k++)
    tcb[k] = (nkw_tcb){${[s.tension, s.continuity, s.bias].map(literal).join(', ')}};
float p[3];

/* The segment of the time, for curves by their parameter. */
const nkw_segment found = nkw_segment_find(times, COUNT, time);
const size_t k = found.index < COUNT - 1 ? found.index : COUNT - 2;
const float t = found.index < COUNT - 1 ? found.t : 1.0f, h = times[k + 1] - times[k];`;

const simple = ['STEP', 'LINEAR'].map(name => `
const nkw_track ${name.toLowerCase()} = {times, values, COUNT, 1, NKW_TRACK_FLOATS, NKW_INTERPOLATION_${name}, NULL};
nkw_track_sample_derivatives(&${name.toLowerCase()}, time, p, p + 1, p + 2);
show_floats("${name.toLowerCase()}", 3, p);`).join('');

const byTime = (name: string) => `
float triples[3 * COUNT];
for (int i = 0; i < COUNT; i++) {
    triples[3 * i] = before[i];
    triples[3 * i + 1] = values[i];
    triples[3 * i + 2] = after[i];
}
const nkw_track track = {times, triples, COUNT, 1, NKW_TRACK_FLOATS, NKW_INTERPOLATION_CUBICSPLINE, NULL};
nkw_track_sample_derivatives(&track, time, p, p + 1, p + 2);
show_floats(${name}, 3, p);`;

const point = (name: string) => `
show(${name}, 0, (double)point.value);
show(${name}, 1, (double)point.first / (double)h);
show(${name}, 2, (double)point.second / ((double)h * (double)h));`;

const bySegment = (name: string) => `
/* The tangents are read as tangents per segment. */
const float control[4] = {values[k], after[k], values[k + 1], before[k + 1]};
const nkw_curve_point point = nkw_cubic_point(NKW_CUBIC_HERMITE, control, t);${point(name)}`;

const chosen = (s: State) => `
if (m == ${splines.indexOf(s.method as typeof splines[number])}) {
    show_floats("before", COUNT, before);
    show_floats("after", COUNT, after);
}`;

const inLoop = (s: State) => (s.scale === 'second' ? byTime : bySegment)('name') +
  (s.method === 'own' || splines.includes(s.method as never) ? chosen(s) : '');

const cubics = (s: State) => `
for (int m = -1; m < ${splines.length}; m++) {
    const char *const name = m < 0 ? "own" : names[m];
    float before[COUNT], after[COUNT];
    for (int i = 0; i < COUNT; i++)
        before[i] = after[i] = own[i];
    const nkw_spline spline = {times, values, COUNT, 1, 1, (nkw_spline_method)(m < 0 ? 0 : m),
                               NKW_SPLINE_ENDS_FREE, ${literal(s.tension)}, tcb, NULL};
    double work[NKW_SPLINE_WORK(COUNT)];
    const nkw_tangent_span tangents = {before, after, 1};
    if (m >= 0 && nkw_spline_tangents(&spline, tangents, NULL, work, NKW_SPLINE_WORK(COUNT)) != NKW_OK)
        return 1;${inLoop(s).replace(/\n(?=.)/g, '\n    ')}
}`;

const bspline = `
float control[4];
for (size_t i = 0; i < 4; i++) {
    const size_t key = k + i < 1 ? 0 : k + i - 1;
    control[i] = values[key < COUNT ? key : COUNT - 1];
}
const nkw_curve_point point = nkw_cubic_point(NKW_CUBIC_BSPLINE, control, t);${point('"bspline"')}`;

export const code = (s: State) => program([setup(s), simple, cubics(s), bspline].join('\n'));
