// SPDX-License-Identifier: MIT
// The C program of a state: value, velocity and acceleration of every method, and the tangents of the chosen one.
import { list, literal, program } from '../../kit/code';
import { joint, keysOf, splines, type Keys, type State } from './curves';

const setup = (s: Keys) => `
enum { COUNT = ${s.times.length} };
static const char *const names[] = {${splines.map(m => `"${m}"`).join(', ')}};
static const char *const keys[] = {${s.times.map((_, k) => `"key${k}"`).join(', ')}};
static const float times[COUNT] = ${list(s.times)};
static const float values[COUNT] = ${list(s.values)};
static const float own[COUNT] = ${list(s.tangents)};
const float time = ${literal(s.time)};
nkw_tcb tcb[COUNT];
for (int i = 0; i < COUNT; i++)
    tcb[i] = (nkw_tcb){${[s.tension, s.continuity, s.bias].map(literal).join(', ')}};
float p[3];
const nkw_motion_span motion = {p, p + 1, p + 2};

/* The segment of the time, for curves by their parameter. */
const nkw_segment found = nkw_segment_find(times, COUNT, time);
const size_t k = found.index < COUNT - 1 ? found.index : COUNT - 2;
const float t = found.index < COUNT - 1 ? found.t : 1.0f, h = times[k + 1] - times[k];`;

/* The velocity of `track` before and after key j: the track up to this key, and the whole track. */
const ofTrack = (name: string, j: number) => `
nkw_track part = track;
part.count = ${j + 1};
nkw_track_sample_motion(&part, times[${j}], motion);
show("${name}", 0, (double)p[1]);
nkw_track_sample_motion(&track, times[${j}], motion);
show("${name}", 1, (double)p[1]);`;

const block = (lines: string) => `\n{${lines.replace(/\n(?=.)/g, '\n    ')}\n}`;

/** What is shown of the joint between two segments for every method. */
const durations = (j: number) => `
show("duration", 0, (double)(times[${j}] - times[${j - 1}]));
show("duration", 1, (double)(times[${j + 1}] - times[${j}]));`;

const simple = (s: Keys, j?: number) => ['step', 'linear'].map(name => block(`
const nkw_track track = {times, values, COUNT, 1, NKW_TRACK_FLOATS, NKW_INTERPOLATION_${name.toUpperCase()}, NULL};
nkw_track_sample_motion(&track, time, motion);
show_floats("${name}", 3, p);${s.method === name && j !== undefined ? ofTrack('velocity', j) : ''}`)).join('');

const point = `
show(name, 0, (double)point.value);
show(name, 1, (double)point.velocity / (double)h);
show(name, 2, (double)point.acceleration / ((double)h * (double)h));`;

const own = `
float triples[3 * COUNT];
for (int i = 0; i < COUNT; i++) {
    triples[3 * i] = before[i];
    triples[3 * i + 1] = values[i];
    triples[3 * i + 2] = after[i];
}
const nkw_track track = {times, triples, COUNT, 1, NKW_TRACK_FLOATS, NKW_INTERPOLATION_CUBICSPLINE, NULL};`;

const bySecond = `
nkw_track_sample_motion(&track, time, motion);
show_floats(name, 3, p);`;

const bySegment = `
/* The tangents are read as tangents per segment. */
const float control[4] = {values[k], after[k], values[k + 1], before[k + 1]};
const nkw_motion point = nkw_cubic_evaluate(control, t, NKW_CUBIC_HERMITE);${point}`;

const atJoint = (j: number) => `
show("tangent", 0, (double)before[${j}]);
show("tangent", 1, (double)after[${j}]);${ofTrack('second', j)}
const float ends[2][4] = {{values[${j - 1}], after[${j - 1}], values[${j}], before[${j}]},
                          {values[${j}], after[${j}], values[${j + 1}], before[${j + 1}]}};
for (int i = 0; i < 2; i++)
    show("segment", i, (double)nkw_cubic_evaluate(ends[i], i ? 0.0f : 1.0f, NKW_CUBIC_HERMITE).velocity /
                           (double)(times[${j} + i] - times[${j - 1} + i]));`;

const chosen = (s: Keys, j?: number) => `
if (m == ${splines.indexOf(s.method as typeof splines[number])})
    for (int i = 0; i < COUNT; i++)
        show_floats(keys[i], 4, (const float[]){times[i], values[i], before[i], after[i]});${j === undefined ? '' : `
if (m == ${splines.indexOf(s.method as typeof splines[number])})${block(atJoint(j)).trim().replace(/^/, ' ')}`}`;

const withTangents = (s: Keys) => s.method === 'own' || splines.includes(s.method as typeof splines[number]);

const cubics = (s: Keys, j?: number) => `
for (int m = -1; m < ${splines.length}; m++) {
    const char *const name = m < 0 ? "own" : names[m];
    float before[COUNT], after[COUNT];
    for (int i = 0; i < COUNT; i++)
        before[i] = after[i] = own[i];
    const nkw_spline spline = {times, values, COUNT, 1, 1, (nkw_spline_method)(m < 0 ? 0 : m),
                               NKW_SPLINE_ENDS_FREE, ${literal(s.tension)}, tcb, NULL};
    NKW_STACK_WORK(work, NKW_SPLINE_WORK(COUNT));
    const nkw_tangent_span tangents = {before, after, 1};
    if (m >= 0 && nkw_spline_tangents(&spline, tangents, NULL, work) != NKW_OK)
        return 1;${[own, s.scale === 'second' ? bySecond : bySegment, withTangents(s) ? chosen(s, j) : ''].join('')
          .replace(/\n(?=.)/g, '\n    ')}
}`;

const plainKeys = `
for (int i = 0; i < COUNT; i++)
    show_floats(keys[i], 2, (const float[]){times[i], values[i]});`;

const bspline = (s: Keys, j?: number) => `
const char *const name = "bspline";
float control[COUNT - 1][4];
for (int i = 0; i < COUNT - 1; i++)
    for (int c = 0; c < 4; c++) {
        const int key = i + c - 1 < 0 ? 0 : i + c - 1;
        control[i][c] = values[key < COUNT ? key : COUNT - 1];
    }
const nkw_motion point = nkw_cubic_evaluate(control[k], t, NKW_CUBIC_BSPLINE);${point}${
  s.method !== 'bspline' || j === undefined ? '' : `
for (int i = 0; i < 2; i++)
    show("velocity", i, (double)nkw_cubic_evaluate(control[${j - 1} + i], i ? 0.0f : 1.0f, NKW_CUBIC_BSPLINE).velocity /
                            (double)(times[${j} + i] - times[${j - 1} + i]));`}`;

export function code(state: State): string {
  const s = keysOf(state), j = joint(s);
  return program([setup(s), simple(s, j), cubics(s, j), bspline(s, j), withTangents(s) ? '' : plainKeys,
    j === undefined ? '' : durations(j)].join('\n'));
}
