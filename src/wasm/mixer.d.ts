/** The clips that a mixer plays at the same time. */
export const MIXER_SLOTS: 16;
/** A clip of a set, and what belongs to it. What is left out is none or 0. */
export interface MixerClip {
  clip: Clip;
  /** What an added slot is relative to; none: the start of the clip. */
  reference?: Pose | null;
  /** Instants, and intervals of a duration, in seconds. */
  events?: { time: number; duration?: number }[];
  /** For MIXER_SYNC_MARKERS. */
  markers?: FloatArray;
  /** The part that is played; both 0: the whole clip. */
  start?: number;
  end?: number;
}
export interface MixerSetSource {
  clips: MixerClip[];
  /** null is the whole body. */
  masks?: (Mask | null)[];
  rest: Pose;
  restFloats?: FloatArray | null;
  root?: number;
  up?: FloatArray;
  /** Of ROOT_X and the others; 0: the root stays in the pose. */
  rootParts?: number;
}
/** What mixers play (mixer.h). The objects in it stay alive as long as it; masks may be changed between two frames. */
export class MixerSet extends Owner {
  constructor(source: MixerSetSource);
  readonly clips: Clip[];
  readonly jointCount: number;
  readonly floatCount: number;
}
/** How a clip is played (nkw_mixer_options). What is left out is 0. */
export interface MixerPlay {
  clip?: number;
  mask?: number;
  layer?: number;
  group?: number;
  mode?: Playback;
  blend?: MixerBlend;
  sync?: MixerSync;
  transition?: MixerTransition;
  fade?: number;
  time?: number;
}
export interface MixerEvent {
  slot: number;
  clip: number;
  event: number;
  kind: MixerEventKind;
  weight: number;
  /** Seconds since the beginning of the step. */
  moment: number;
}
export interface MixerFrame {
  events: MixerEvent[];
  /** Also of those that did not fit. */
  eventCount: number;
  /** Of the root: translation x y z, rotation x y z w, scale x y z. */
  motion: number[];
}
/** Plays the clips of a set: fades, layers, clips in step, events, root motion; the state of one character (mixer.h). */
export class Mixer extends Owner {
  /** `events`: how many of a frame are kept, 64 by default. */
  constructor(set: MixerSet, options?: { events?: number });
  /** Begins to play a clip of the set; returns its slot. */
  play(options: MixerPlay): number;
  /** Fades a slot out. */
  stop(slot: number, fade?: number): void;
  setWeight(slot: number, weight: number): void;
  setSpeed(slot: number, speed: number): void;
  /** What plays in a slot; null if it is free. */
  slot(slot: number): { clip: number; time: number; weight: number; speed: number } | null;
  /** The next frame: its pose and floats. */
  advance(seconds: number, pose: Pose, floats?: FloatArray | null): MixerFrame;
  /** The state, as bytes for restore(): of this machine's byte order, for sets of the same clips. */
  save(): Uint8Array;
  /** Takes a state that was saved. What is not one is refused, and changes nothing. */
  restore(state: Uint8Array): void;
}
