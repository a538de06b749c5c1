
/** The play head of a range at the running time (nkw_playback_head_f64). */
export function playbackHeadF64(out, range, time) {
  const data = new DataView(x.memory.buffer, p + 64, 48), f = (at, value) => data.setFloat64(at, number(value), true);
  const { start, duration, closing = 0, before = 0, after = 0, beforeCycles = 0, afterCycles = 0 } = range;
  [start, duration, closing].forEach((value, i) => f(8 * i, value));
  [before, after].forEach((value, i) => data.setInt32(24 + 4 * i, number(value), true));
  [beforeCycles, afterCycles].forEach((value, i) => f(32 + 8 * i, value));
  x.nkw_playback_head_f64(p, p + 64, number(time));
  const head = new Float64Array(f32.buffer, p, 3);
  return Object.assign(out, { time: head[0], cycle: head[1], closing: head[2] });
}
