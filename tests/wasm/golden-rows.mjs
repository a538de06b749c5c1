// SPDX-License-Identifier: MIT
// The rows of kernels.h whose results come from a function of golden.c, handles.h, edits.h or motion.h, with the
// functions of the package.
const F = Math.fround, { abs } = Math;

const put = (o, at, ...parts) => parts.flat(3).forEach((x, k) => { o[at + k] = x; });
const some = i => i.order + 6 * i.path;
const xOf = key => key[1];

const handles = ({ s }) => {
  return [...s.slice(0, 6), F(s[0] + abs(s[7])), s[6]];
};
const handleTime = (N, c, t) => N.lerp(c[0], c[6], t);

// Keys of a curve of `count` keys; `of` changes key k.
const fcurveKeys = (N, { keys, s }, count, of = () => ({})) => Array.from({ length: count }, (_, k) => ({
  time: keys[k][0], value: xOf(keys[k]), in: [-abs(s[k]), s[k + 1]], out: [abs(s[k + 1]), s[k + 2]],
  kind: N.FCURVE_BEZIER, ease: N.EASE_LINEAR, ...of(k) }));

function using(object, f) {
  try {
    return f(object);
  } finally {
    object.dispose();
  }
}

function sampleFcurve(N, i, o) {
  const n = some(i), { s, keys } = i;
  const curve = { before: n % 5, after: (n + 2) % 5, beforeCycles: n % 3, afterCycles: n % 2, policy: n % 4,
    keys: fcurveKeys(N, i, 5, k => ({ kind: (k + n) % 5, ease: (7 * k + n) % (N.EASE_CSS_STEP_END + 1) })) };
  using(new N.FCurve(curve), c => {
    const times = [N.lerp(keys[0][0], keys[4][0], i.t), keys[2][0], s[0], 64 * s[1], -(2 ** 20) * abs(s[2])];
    times.forEach((time, k) => put(o, 3 * k, c.sample(time, [])));
  });
}

function insertKey(N, i, o) {
  using(new N.FCurve({ keys: fcurveKeys(N, i, 3), policy: some(i) % 4 }), curve => {
    let made;
    try {
      made = curve.insert(N.lerp(i.keys[0][0], i.keys[2][0], i.t));
    } catch {
      return;
    }
    const { index, keys } = made;
    put(o, 0, keys[index - 1].out, keys[index].in, keys[index].out, keys[index + 1].in, keys[index].value);
  });
}

function autoHandles(N, i, o) {
  const n = some(i), keys = fcurveKeys(N, i, 4, () => ({ in: [-0.25, 0.5], out: [0.25, 0.125] }));
  N.fcurveAutoHandles(keys, 4, keys.map((_, k) => ({ in: (n + k) % 5, out: (Math.floor(n / 2) + 2 * k) % 5 })));
  put(o, 0, keys.map(key => [key.in, key.out]));
}

function dialects(N, i, o) {
  const n = some(i), { s } = i, keys = [], blender = [], slopes = fcurveKeys(N, i, 4, k => ({
    inSlope: s[k], outSlope: s[k + 1], inWeight: abs(s[k + 2]), outWeight: abs(s[k + 3]), weighted: (k + n) % 4 }));
  N.fcurveKeysFromSlopes(slopes, 4, n % 3, keys);
  N.blenderFromFcurveKeys(keys, 4, blender);
  put(o, 0, blender[1].left, blender[1].center, blender[1].right, keys[1].in);
  N.slopesFromFcurveKeys(keys, 4, (n + 1) % 3, slopes);
  put(o, 8, slopes[1].inSlope, slopes[1].outSlope, slopes[1].inWeight, slopes[1].outWeight);
  if (n === 7)
    tracksOfFcurves(N, o, keys, N.lerp(i.keys[0][0], i.keys[3][0], i.t));
  N.fcurveKeysFromCss(s, keys);
  put(o, 13, keys[0].out[1], keys[1].in[0]);
}

function tracksOfFcurves(N, o, keys, time) {
  using(new N.FCurve({ keys, policy: N.HANDLE_KEEP_RATIO }), curve => {
    const difference = [], at = [];
    using(N.trackFromFcurves([curve], 1, 0.25, difference), track => {
      put(o, 0, difference, track.count, track.sample(time, at));
    });
    using(N.trackFromEulerFcurves([curve, curve, curve], N.EULER_YXZ, 0.25, difference), track => {
      put(o, 3, difference, track.sample(time, []));
    });
  });
}

const rotations = [
  (N, i, h) => N.rotationSlerp({}, i.q[0], i.q[1], i.path, Math.trunc(i.s[0]), h),
  (N, i, h) => N.rotationHermite({}, i.q[0], i.v[0], i.q[1], i.v[1], h),
  (N, i) => N.rotationCatmullRom({}, i.q, i.times),
  (N, i) => N.rotationTcb({}, i.q, i.times, [i.t, ...i.s.slice(0, 4), i.t]),
  (N, i, h) => N.rotationSquad({}, i.q, h),
  (N, i, h) => N.rotationBspline({}, i.q, h),
];
const rotate = kind => (N, i, o) => put(o, 0, N.rotationEvaluate([], rotations[kind](N, i, F(i.t + 0.25)), i.t));

function turns(N, i, { kind = N.TRACK_ROTATION, interpolation = N.INTERPOLATION_LINEAR, count = 3 } = {}) {
  const length = interpolation === N.INTERPOLATION_CUBICSPLINE ? 9 : count;
  return new N.Track({ times: i.times.slice(0, count), width: 4, kind, interpolation,
    values: Array.from({ length }, (_, k) => i.q[k % 4]).flat() });
}
const modes = { linear: 'INTERPOLATION_LINEAR', cubic: 'INTERPOLATION_CUBICSPLINE', step: 'INTERPOLATION_STEP' };

const sampled = (kind, mode) => (N, i, o) =>
  using(turns(N, i, { kind: N[kind], interpolation: N[modes[mode]] }), track => track.sample(i.s[0], o));
const turned = mode => (N, i, o) =>
  using(turns(N, i, { interpolation: N[modes[mode]] }), track => N.trackSampleRotation(track, i.s[0], o));

const edits = {
  trim: (N, track, s) => N.trackTrim(track, N.min(s[0], s[1]), N.max(s[0], s[1])),
  retime: (N, track, s) => N.trackRetime(track, s[0], s[1]),
  join: (N, track) => N.trackJoin(track, track),
  close: (N, track) => N.trackClose(track, 0.5),
};
const edited = (edit, mode) => (N, i, o) => using(turns(N, i, { interpolation: N[modes[mode]] }), track => {
  let made;
  try {
    made = edits[edit](N, track, i.s);
  } catch {
    return;
  }
  using(made, () => {
    const { times, values } = made, size = mode === 'cubic' ? 12 : 4;
    put(o, 0, made.count, times.at(-1), [...values].slice(size * (made.count - 1)));
  });
});

function align(N, i, o) {
  using(turns(N, i, { count: 4 }), track => {
    const values = new Float32Array(16), negated = [];
    N.trackAlign(track, values, negated);
    put(o, 0, [...values].slice(8, 15), negated);
  });
}

function fit(N, i, o) {
  const at = Array.from({ length: 16 }, (_, k) => k), difference = [];
  using(new N.Track({ times: at.map(k => 0.25 * k), values: at.map(k => i.s[(3 * k) % 8]) }), track =>
    using(N.trackFit(track, F(F(0.1) * i.t), difference), made => put(o, 0, difference, made.count,
      [...made.values, 0, 0, 0].slice(0, 6), [...made.values].slice(-3))));
}

const reduced = (kind, mode, tolerance) => (N, i, o, round) => {
  if (round % 16 !== 0)
    return;
  const parts = mode === 'cubic' ? 3 : 1, at = Array.from({ length: 9 }, (_, k) => k / 8), difference = [];
  const values = at.flatMap(t => Array(parts).fill(
    N.quatSlerp([], i.q[0], N.quatSlerp([], i.q[1], i.q[2], t), t)).flat());
  const source = { times: at.map(t => N.lerp(i.times[0], i.times[3], t)), values, width: 4, kind: N[kind],
    interpolation: N[modes[mode]] };
  using(new N.Track(source), track => using(N.trackReduce(track, F(tolerance), difference), made =>
    put(o, 0, made.count, difference, made.count > 1 ? made.times[1] : 0)));
};

const twoFloats = x => [F(x), (x - F(x)) * 2 ** 24];

function headF64(N, i, o) {
  const range = { start: i.s[0], duration: i.t + 0.1, closing: 0.3 * abs(i.s[1]), before: N.PLAYBACK_LOOP,
    after: N.PLAYBACK_PING_PONG, beforeCycles: 0, afterCycles: 50 };
  const head = N.playbackHeadF64({}, range, 1e3 * i.s[2]);
  put(o, 0, twoFloats(head.time), twoFloats(head.cycle), twoFloats(head.closing));
}

// The keys may be in any order; the number is 0 for those that are refused.
function passed(N, i, o) {
  const number = [];
  try {
    N.playbackPassed({ times: i.s.slice(0, 4), duration: 10, from: i.s[4], to: F(i.s[4] + 25) }, null, number, 0);
    put(o, 0, number);
  } catch {
    o[0] = 0;
  }
}

function passedF64(N, i, o) {
  const keys = [0], number = [], from = 1e6 * i.s[0];
  N.playbackPassedF64({ times: i.times, duration: 4.7, from, to: from + 9 * i.s[1] }, keys, number, 1);
  put(o, 0, number, keys);
}

function timecode(N, i, o) {
  const ntsc = { numerator: 30000n, denominator: 1001n }, fbx = { numerator: 46186158000n, denominator: 1n };
  const round = i.s[1] > 0 ? N.ROUND_DOWN : N.ROUND_UP, [ticks, frames, frame, label] = [[], [], [], {}];
  N.ticksFromSeconds(1e4 * i.s[0], fbx, round, ticks);
  N.ticksConvert(ticks[0], fbx, ntsc, round, frames);
  put(o, 0, twoFloats(Number(ticks[0])), Number(frames[0]), twoFloats(N.secondsFromTicks(frames[0], ntsc)));
  N.timecodeFromFrame(frames[0] < 0n ? -frames[0] : frames[0], 30, 1, label);
  N.frameFromTimecode(label, 30, 1, frame);
  put(o, 5, label.minutes, label.seconds, label.frames, Number(frame[0]));
}

const place = (i, k) => [...i.v[k], ...i.q[k], 1, 1, 1];
const cycle = i => ({ first: place(i, 0), last: place(i, 1) });

function rootExtract(N, i, o) {
  const root = place(i, 0);
  const motion = N.rootExtract([], root, { up: i.v[3], parts: N.ROOT_PLANE | N.ROOT_YAW });
  put(o, 0, motion.slice(0, 7), N.rootRemove([], root, motion).slice(0, 7));
}

const find = f => (N, i, o) => {
  const { index, t } = f(N, i);
  put(o, 0, index, t);
};

export const rowsOfFunctions = {
  handle_split: (N, i, o) => {
    const c = handles(i), [left, right] = [[], []];
    N.handleSplit(c, handleTime(N, c, i.t), left, right);
    put(o, 0, left, right);
  },
  fcurve_sample: sampleFcurve,
  fcurve_insert: insertKey,
  fcurve_auto_handles: autoHandles,
  dialect: dialects,
  rotation_slerp: rotate(0), rotation_hermite: rotate(1), rotation_catmull_rom: rotate(2), rotation_tcb: rotate(3),
  rotation_squad: rotate(4), rotation_bspline: rotate(5),
  segment_find: find((N, i) => N.segmentFind({}, i.times, 4, i.s[0])),
  segment_find_from: find((N, i) => N.segmentFindHint({}, i.times, 4, i.s[0], 1)),
  segment_find_uniform: find((N, i) => N.segmentFindUniform({}, i.s[1], 30, 100, i.s[0])),
  track_floats: sampled('TRACK_FLOATS', 'linear'),
  track_cubic: sampled('TRACK_ROTATION', 'cubic'),
  track_slerp: sampled('TRACK_ROTATION_NORMALIZED', 'linear'),
  track_turn_slerp: turned('linear'), track_turn_cubic: turned('cubic'),
  track_align: align,
  track_trim_linear: edited('trim', 'linear'), track_trim_cubic: edited('trim', 'cubic'),
  track_retime_cubic: edited('retime', 'cubic'), track_retime_step: edited('retime', 'step'),
  track_join_linear: edited('join', 'linear'),
  track_close_linear: edited('close', 'linear'), track_close_cubic: edited('close', 'cubic'),
  track_reduce_floats: reduced('TRACK_FLOATS', 'linear', 0.1),
  track_reduce_cubic: reduced('TRACK_FLOATS', 'cubic', 0.5),
  track_reduce_turns: reduced('TRACK_ROTATION_NORMALIZED', 'linear', 0.1),
  track_fit: fit,
  playback_head_f64: headF64, playback_passed: passed, playback_passed_f64: passedF64,
  timecode,
  root_extract: rootExtract,
  root_delta: (N, i, o) =>
    put(o, 0, N.rootDelta([], cycle(i), place(i, 2), place(i, 3), Math.trunc(F(100 * i.t))).slice(0, 7)),
  root_place: (N, i, o) =>
    put(o, 0, N.rootPlace([], place(i, 2), cycle(i), place(i, 3), -Math.trunc(F(1000 * i.t))).slice(0, 7)),
  root_blend: (N, i, o) => put(o, 0, N.rootBlend([], [0, 1, 2].flatMap(k => place(i, k)), i.s, 3).slice(0, 7)),
};
