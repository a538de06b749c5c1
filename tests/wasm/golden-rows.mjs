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

function dialects(N, i, o, round) {
  const n = some(i), { s } = i, keys = [], blender = [], slopes = fcurveKeys(N, i, 4, k => ({
    inSlope: s[k], outSlope: s[k + 1], inWeight: abs(s[k + 2]), outWeight: abs(s[k + 3]), weighted: (k + n) % 4 }));
  N.fcurveFromSlopeKeys(slopes, 4, n % 3, keys);
  N.blenderKeysFromFcurve(keys, 4, blender);
  put(o, 0, blender[1].left, blender[1].center, blender[1].right, keys[1].in);
  N.slopeKeysFromFcurve(keys, 4, (n + 1) % 3, slopes);
  put(o, 8, slopes[1].inSlope, slopes[1].outSlope, slopes[1].inWeight, slopes[1].outWeight);
  if (round % 16 === 0 && n % 6 === 1)
    tracksOfFcurves(N, o, keys, N.lerp(i.keys[0][0], i.keys[3][0], i.t));
  N.fcurveFromCss(s, keys);
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
  (N, i, h) => N.rotationFromSlerp({}, i.q[0], i.q[1], h, i.path, Math.trunc(i.s[0])),
  (N, i, h) => N.rotationFromHermite({}, i.q[0], i.v[0], i.q[1], i.v[1], h),
  (N, i) => N.rotationFromCatmullRom({}, i.q, i.times),
  (N, i) => N.rotationFromTcb({}, i.q, i.times, [i.t, ...i.s.slice(0, 4), i.t]),
  (N, i, h) => N.rotationFromSquad({}, i.q, h),
  (N, i, h) => N.rotationFromBspline({}, i.q, h),
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
  using(turns(N, i, { interpolation: N[modes[mode]] }), track => 
    track.sampleMotion(i.s[0], o, o.subarray(4), o.subarray(7)));

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
    N.playbackPassed({ times: i.s.slice(0, 4), duration: 10, from: i.s[4], to: F(i.s[4] + 25), includesFrom: 0n }, null, 64, number);
    put(o, 0, number);
  } catch {
    o[0] = 0;
  }
}

function passedFar(N, i, o) {
  const keys = [0], number = [], from = 1e6 * i.s[0];
  N.playbackPassed({ times: i.times, duration: 4.7, from, to: from + 9 * i.s[1], includesFrom: 0n }, keys, 64, number);
  put(o, 0, number, number[0] ? keys[0] : 0);
}

function timecode(N, i, o) {
  const ntsc = { numerator: 30000n, denominator: 1001n }, fbx = { numerator: 46186158000n, denominator: 1n };
  const round = i.s[1] > 0 ? N.ROUND_DOWN : N.ROUND_UP, [ticks, frames, frame, seconds, label] = [[], [], [], [], {}];
  N.ticksFromSeconds(1e4 * i.s[0], fbx, round, ticks);
  N.ticksConvert(ticks[0], fbx, ntsc, round, frames);
  N.ticksToSeconds(frames[0], ntsc, seconds);
  put(o, 0, twoFloats(Number(ticks[0])), Number(frames[0]), twoFloats(seconds[0]));
  N.timecodeFromFrame(frames[0] < 0n ? -frames[0] : frames[0], 30, 1, label);
  N.timecodeToFrame(label, 30, 1, frame);
  put(o, 5, label.minutes, label.seconds, label.frames, Number(frame[0]));
}

const place = (i, k) => [...i.v[k], ...i.q[k], 1, 1, 1];
const cycle = i => ({ first: place(i, 0), last: place(i, 1) });

const limitOf = (axis, side, a, b, low = -Math.PI, high = Math.PI) =>
  [0, 0, 0, 1, ...axis, ...side, a, b, low, high];

function rootSplit(N, i, o) {
  const { motion, rest } = N.rootSplit({}, { up: i.v[3], parts: N.ROOT_PLANE | N.ROOT_YAW }, place(i, 0));
  put(o, 0, motion.slice(0, 7), rest.slice(0, 7));
}

const find = f => (N, i, o) => {
  const { index, t } = f(N, i);
  put(o, 0, index, t);
};

// Springs and transitions, as in motion.h.
const spring = (N, i) => N.springFromFrequency([], F(4 * i.t + 0.125), abs(i.s[5]));
const motion = (i, k) => i.s.slice(k, k + 2);
const vec3Motion = (i, k) => [...i.v[k], ...i.v[k + 1]];
const quatMotion = (i, k) => [...i.q[k], ...i.v[k]];
const timed = (N, i, state, point) => [...spring(N, i), abs(i.s[4]), ...state, ...point];
const inertia = i => ({ duration: abs(i.s[4]) });
const deadBlend = (N, i) => ({ kind: N.OFFSET_DEAD_BLEND, duration: abs(i.s[5]), halfLife: abs(i.s[4]) });

const motionRows = {
  spring_constants: (N, i, o) => {
    const [time, ratio] = [F(i.t + 2 ** -6), abs(i.s[0])], a = N.springFromHalfLife([], time, ratio);
    put(o, 0, a, N.springFromFrequency([], time, ratio), N.springDescribe([], a));
  },
  spring_step: (N, i, o) => N.springStep(o, spring(N, i), motion(i, 0), motion(i, 2), i.t),
  quat_spring_step: (N, i, o) => N.quatSpringStep(o, spring(N, i), quatMotion(i, 0), quatMotion(i, 1), i.t),
  spring_timed_step: (N, i, o) => {
    const x = timed(N, i, motion(i, 0), motion(i, 2));
    N.springTimedStep(x, i.s[6], i.t);
    put(o, 0, x.slice(3), x[2]);
  },
  quat_spring_timed_step: (N, i, o) => {
    const x = timed(N, i, quatMotion(i, 0), quatMotion(i, 1));
    N.quatSpringTimedStep(x, i.q[3], i.t);
    put(o, 0, x.slice(3));
  },
  damper_step: (N, i, o) => put(o, 0, N.damperStep(i.s[0], i.s[1], abs(i.s[2]), i.t),
    N.quatDamperStep([], i.q[0], i.q[1], abs(i.s[2]), i.t)),
  offset: (N, i, o) => {
    const x = inertia(i);
    N.offsetBegin(x, motion(i, 0), motion(i, 2));
    put(o, 0, x.c, x.end, N.offsetEvaluate([], x, motion(i, 2), i.t));
  },
  vec3_offset: (N, i, o) => {
    const to = vec3Motion(i, 2), x = inertia(i);
    N.vec3OffsetBegin(x, vec3Motion(i, 0), to);
    put(o, 0, x.c, x.end, N.vec3OffsetEvaluate([], x, to, i.t));
  },
  quat_offset: (N, i, o) => {
    const to = quatMotion(i, 1), x = inertia(i);
    N.quatOffsetBegin(x, quatMotion(i, 0), to);
    put(o, 0, x.c, N.quatOffsetEvaluate([], x, to, i.t));
  },
  offset_dead_blend: (N, i, o) => {
    const x = deadBlend(N, i), way = F(F(i.s[2] - i.s[0]) / i.s[1]);
    N.offsetBegin(x, motion(i, 0), motion(i, 2));
    put(o, 0, N.offsetEvaluate([], x, motion(i, 2), i.t), i.s[1] ? N.clamp(0.5 * way, 0.125, 2) : 2);
  },
  quat_offset_dead_blend: (N, i, o) => {
    const x = deadBlend(N, i), to = quatMotion(i, 1);
    N.quatOffsetBegin(x, quatMotion(i, 0), to);
    x.difference = i.q[3];
    put(o, 0, N.quatOffsetEvaluate([], x, to, i.t), x.difference);
  },
  body_motion_between: (N, i, o) => N.bodyMotionBetween(o, [...vec3Motion(i, 0), ...quatMotion(i, 0)],
    [...vec3Motion(i, 2), ...quatMotion(i, 1)], abs(i.s[0]), i.t),
};

// A cubic of numbers, as the x of one of vectors.
const cubic = c => c.flatMap(x => [x, 0, 0]), xs = c => [0, 3, 6, 9].map(k => c[k]);
const converted = (from, to) => (N, i, o) =>
  put(o, 0, xs(N.vec3CubicConvert([], cubic(i.cubic), N['CUBIC_' + from], N['CUBIC_' + to])));
function throughKeys(N, i) {
  const c = new Float32Array(4);
  N.cubicFromCatmullRom(i.s.slice(0, 4), i.times, c);
  return N.cubicEvaluate([], c, i.t, N.CUBIC_HERMITE);
}
const eased = kind => (N, i, o) => {
  const steps = kind === 'STEPS', easing = {
    kind: N['EASING_' + kind], curve: [abs(i.s[0]), i.s[1], abs(i.s[2]), i.s[3]], jump: i.path,
    count: steps ? 1 + i.order : 4, inputs: steps ? null : i.times, outputs: steps ? null : i.s,
  };
  const all = N.easingEvaluate([], easing, kind === 'CUBIC_BEZIER' ? i.t : i.s[steps ? 0 : 5]);
  put(o, 0, steps ? all.slice(0, 1) : all);
};
const withCubic = (from, to) => (N, i, o) => N.vec3CubicConvert(o, i.v.flat(), N['CUBIC_' + from], N['CUBIC_' + to]);

function handlePoints(N, i, o) {
  const c = handles(i), time = handleTime(N, c, i.t), limited = N.handleLimit([], c, N.HANDLE_KEEP_RATIO);
  put(o, 0, N.handleSample([], c, time), N.handleSample([], limited, time), N.handleParameter(c, time),
    N.handleRunsBack(c));
}

function resampled(mode) {
  return (N, i, o) => using(turns(N, i, { interpolation: N[modes[mode]] }), track => {
    const [rate, count, difference] = [[], [0], []];
    let made;
    try {
      made = N.trackResampleWithin(track, 2, rate);
    } catch {
      rate[0] = 0;
    }
    try {
      using(N.trackResample(track, 17), made => count[0] = made.count);
    } catch {
      count[0] = 0;
    }
    put(o, 0, rate, count, 0, i.q[0]);
    if (made)
      using(made, () => {
        N.trackDifference(track, made, difference);
        const at = 4 * Math.floor(made.count / 2);
        put(o, 2, difference, [...made.values].slice(at, at + 4));
      });
  });
}

function reducedClip(N, i, o, round) {
  if (round % 16 !== 0)
    return;
  const times = Array.from({ length: 9 }, (_, k) => k);
  const tracks = [0, 1].map(n => ({ target: N.CLIP_ROTATION, index: n, track: new N.Track({ times, width: 4,
    kind: N.TRACK_ROTATION, values: times.flatMap(k =>
      N.quatSlerp([], i.q[n], N.quatSlerp([], i.q[1 + n], i.q[2 + n], k / 8), k / 8)) }) }));
  const result = {}, reduction = { parents: [-1, 0], tolerance: 0.25, distance: 1 };
  const made = N.clipSourceReduce({ jointCount: 2, tracks }, reduction, result);
  put(o, 0, result.keyCount, result.distance);
  [...tracks, ...made.tracks].forEach(t => t.track.dispose());
}

function traced(position, orientation) {
  return (N, i, o) => using(new N.Keyframes(i.keys.flat()), keys => {
    const t = keys.trace(i.s[0], { position: N[position], orientation: N[orientation] });
    const padded = a => [...a, 0, 0, 0, 0].slice(0, 4);
    put(o, 0, padded(t.weight), t.control[1] ?? [0, 0, 0], t.orientation[1], t.angles[0], t.halfAngle,
      t.orientationWeight[1]);
  });
}

// Inputs that random ones never come near.
function nearlySingular({ n, t, order }) {
  const m = [...n], part = t < 0.5 ? 2 ** -14 : 2 ** -19;
  for (let k = 0; k < 4; k++) {
    m[4 + k] = F(m[k] + F(part * m[4 + k]));
    m[12 + k] = order % 2 ? F(m[8 + k] + F(part * m[12 + k])) : m[12 + k];
  }
  return m;
}

function sheared(N, i) {
  const m = [...i.m];
  for (let k = 0; k < 3; k++) {
    m[4 + k] = i.path === N.PATH_LONG ? 0 : F(m[k] + F(2 ** -6 * m[4 + k]));
    m[8 + k] = i.order < 2 ? 0 : m[8 + k];
  }
  return m;
}

function someAxes(N, { order, s }) {
  const [x, y, z] = [N.AXIS_X, N.AXIS_Y, N.AXIS_Z];
  const named = [[x, y, z], [x, z, y], [y, x, z], [y, z, x], [z, x, y], [z, y, x]][order];
  const [a, b, c] = named.map((axis, k) => s[k] < 0 ? -axis : axis);
  return { x: a, y: b, z: c };
}

const opposite = (N, i) => N.vec3AddScaled([], N.vec3Negate([], i.v[0]), i.v[1], 2 ** -12);

function atThePole(N, i) {
  const half = 0x16a09e6 * 2 ** -25, pole = N.quatMul([], [0, 0, F(0.6), F(0.8)], [0, half, 0, half]);
  pole[0] = F(pole[0] + F(2 ** -20 * i.t));
  return N.quatNormalize([], pole);
}

const normalized = Format => (N, i, o) => {
  const out = new Format(8);
  N.skinNormalizeWeights(Float32Array.from(i.s, abs), out, 4, 2);
  put(o, 0, [...out]);
};

const otherRows = {
  skin_normalize_floats: normalized(Float32Array), skin_normalize_u16: normalized(Uint16Array),
  sincos: (N, i, o) => {
    const [s, c] = [[], []];
    N.sincos(i.s[0], s, c);
    put(o, 0, s, c);
  },
  euler_filter: (N, i, o) => {
    const angles = new Float32Array(12);
    N.eulerFilter(i.v.flat(), 4, i.order, angles);
    put(o, 0, [...angles.slice(9)]);
  },
  cubic_convert_hermite_bezier: converted('HERMITE', 'BEZIER'),
  cubic_convert_bezier_hermite: converted('BEZIER', 'HERMITE'),
  cubic_convert_bspline_bezier: converted('BSPLINE', 'BEZIER'),
  bezier_split: (N, i, o) => {
    const [left, right] = [[], []];
    N.vec3BezierSplit(cubic(i.cubic), i.t, left, right);
    put(o, 0, xs(left), xs(right));
  },
  vec3_cubic_convert_hermite_bezier: withCubic('HERMITE', 'BEZIER'),
  vec3_cubic_convert_bezier_hermite: withCubic('BEZIER', 'HERMITE'),
  vec3_cubic_convert_bspline_bezier: withCubic('BSPLINE', 'BEZIER'),
  vec3_bezier_split: (N, i, o) => {
    const [left, right] = [[], []];
    N.vec3BezierSplit(i.v.flat(), i.t, left, right);
    put(o, 0, right, left.slice(6, 9));
  },
  quintic_evaluate: (N, i, o) => N.quinticEvaluate(o, i.s.slice(0, 3), i.s.slice(3, 6), i.t),
  handle_sample: handlePoints,
  handle_limit: (N, i, o) => ['RATIO', 'START'].map(name => N['HANDLE_KEEP_' + name]).concat(N.HANDLE_CONTAIN)
    .forEach((policy, k) => put(o, 4 * k, N.handleLimit([], handles(i), policy).slice(2, 6))),
  vec3_cubic_sum: (N, i, o) =>
    N.vec3CubicSum(o, i.v.flat().slice(0, 12), N.cubicWeights([], N.CUBIC_BEZIER, 0, i.t)),
  vec3_catmull_rom_timed: (N, i, o) => {
    const c = N.vec3CubicFromCatmullRom([], i.v.flat().slice(0, 12), i.times);
    N.vec3Hermite(o, ...[0, 3, 6, 9].map(k => c.slice(k, k + 3)), i.t);
  },
  catmull_rom_timed: (N, i, o) => put(o, 0, throughKeys(N, i).slice(0, 1)),
  catmull_rom_timed_motion: (N, i, o) => put(o, 0, throughKeys(N, i)),
  easing_cubic_bezier: eased('CUBIC_BEZIER'), easing_steps: eased('STEPS'), easing_linear: eased('LINEAR'),
  rotation_from_squad_control: (N, i, o) => put(o, 0, N.rotationFromSquad({}, i.q.flat().slice(0, 16), 1).control.flat().slice(4, 8)),
  ease_evaluate: (N, i, o) => [0, 1, 2, 3].forEach(k =>
    put(o, 3 * k, N.easeEvaluate([], (10 * k + some(i)) % (N.EASE_CSS_STEP_END + 1), i.t))),
  timeline_from_times: (N, i, o) => {
    const line = { start: i.s[0], rate: N.lerp(1, 61, i.t), count: 32 }, found = {};
    N.timelineFromTimes(Array.from({ length: 32 }, (_, k) => N.timelineTime(line, k)), 32, found);
    put(o, 0, found.rate);
  },
  track_resample_linear: resampled('linear'), track_resample_cubic: resampled('cubic'),
  clip_source_reduce: reducedClip,
  playback_offset: (N, i, o) => put(o, 0, N.playbackOffset(i.s[0], i.s[1], i.s[2], 77),
    N.quatPlaybackOffset([], i.q[0], i.q[1], i.q[2], 1e5 * i.s[0])),
  keyframes_trace_slerp: traced('POSITION_CATMULL_ROM', 'ORIENTATION_SLERP'),
  keyframes_trace_euler: traced('POSITION_BSPLINE', 'ORIENTATION_EULER_UNWRAPPED'),
  keyframes_trace_step: traced('POSITION_BEZIER', 'ORIENTATION_STEP'),
  mat4_inverse_cancelling: (N, i, o) => N.mat4Inverse(o, nearlySingular(i)),
  mat3_inverse_cancelling: (N, i, o) => N.mat3Inverse(o, N.mat3FromMat4([], nearlySingular(i))),
  mat3_orthonormalize_sheared: (N, i, o) => N.mat3Orthonormalize(o, N.mat3FromMat4([], sheared(N, i))),
  trs_from_mat4_of_trs: (N, i, o) => N.trsFromMat4(o, N.mat4FromTrs([], i.trs)),
  trs_from_mat4_sheared: (N, i, o) => N.trsFromMat4(o, sheared(N, i)),
  quat_from_vectors_opposite: (N, i, o) => N.quatFromVectors(o, i.v[0], opposite(N, i)),
  vec3_angle_opposite: (N, i, o) => put(o, 0, N.vec3Angle(i.v[0], opposite(N, i))),
  quat_from_euler_proper: (N, i, o) => N.quatFromEuler(o, i.v[0], i.order + 6),
  euler_from_quat_proper: (N, i, o) => N.eulerFromQuat(o, i.q[0], i.order + 6),
  euler_from_quat_pole: (N, i, o) => N.eulerFromQuat(o, atThePole(N, i), i.order),
  axes_convert_trs: (N, i, o) => N.axesConvertTrs(o, someAxes(N, i), i.trs),
  axes_convert_mat4: (N, i, o) => N.axesConvertMat4(o, someAxes(N, i), i.n),
  limit_cone: (N, i, o) => N.limitApply(o, limitOf(i.v[0], [0, 0, 0], i.t, i.t), i.q[0]),
  limit_ellipse: (N, i, o) => N.limitApply(o, limitOf(i.v[0], i.v[1], i.t, 0.25), i.q[0]),
  limit_twist: (N, i, o) => N.limitApply(o, limitOf(i.v[0], [0, 0, 0], Math.PI, Math.PI, -i.t, i.s[0]), i.q[0]),
  limit_apply: (N, i, o) => N.limitApply(o, [...i.q[1], ...i.v[1], ...i.v[2], i.t, abs(i.s[0]), -abs(i.s[1]),
    abs(i.s[2])], i.q[0]),
};

export const rowsOfFunctions = {
  ...motionRows, ...otherRows,
  handle_split: (N, i, o) => {
    const c = handles(i), [left, right] = [[], []];
    N.handleSplit(c, handleTime(N, c, i.t), left, right);
    put(o, 0, left, right);
  },
  fcurve_sample: sampleFcurve,
  fcurve_insert: insertKey,
  fcurve_auto_handles: autoHandles,
  dialect: dialects,
  rotation_from_slerp: rotate(0), rotation_from_hermite: rotate(1), rotation_from_catmull_rom: rotate(2), rotation_from_tcb: rotate(3),
  rotation_from_squad: rotate(4), rotation_from_bspline: rotate(5),
  segment_find: find((N, i) => N.segmentFind({}, i.times, 4, i.s[0])),
  segment_find_from: find((N, i) => N.segmentFindHint({}, i.times, 4, i.s[0], 1)),
  timeline_find: find((N, i) => N.timelineFind({}, { start: i.s[1], rate: 30, count: 100 }, i.s[0])),
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
  playback_head_f64: headF64, playback_passed: passed, playback_passed_far: passedFar,
  timecode,
  root_split: rootSplit,
  root_delta: (N, i, o) =>
    put(o, 0, N.rootDelta([], cycle(i), place(i, 2), place(i, 3), Math.trunc(F(100 * i.t))).slice(0, 7)),
  root_place: (N, i, o) =>
    put(o, 0, N.rootPlace([], cycle(i), place(i, 2), place(i, 3), -Math.trunc(F(1000 * i.t))).slice(0, 7)),
  root_blend: (N, i, o) => put(o, 0, N.rootBlend([], [0, 1, 2].flatMap(k => place(i, k)), i.s, 3).slice(0, 7)),
};
