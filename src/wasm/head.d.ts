/** How a clip is repeated; what is left out is 0. */
export interface PlaybackRange {
  start: number;
  duration: number;
  closing?: number;
  before?: Playback;
  after?: Playback;
  beforeCycles?: number;
  afterCycles?: number;
}
export interface PlayHeadF64 {
  time: number;
  cycle: number;
  closing: number;
}
/** The play head of a range at the running time (nkw_playback_head_f64). */
export function playbackHeadF64<T extends object>(out: T, range: PlaybackRange, time: number): T & PlayHeadF64;
