
/** The clips that a mixer plays at the same time. */
export const MIXER_SLOTS = 16;

const SLOT_BYTES = 232, STATE_BYTES = 3752, SLOT = { time: 0, weight: 160, speed: 164, playing: 168, clip: 172 };
const markRows = list => list.flatMap(({ time, duration = 0 }) => [time, duration]);

/**
 * What mixers play (mixer.h): { clips: [{ clip, reference, events, markers, start, end }], masks, rest, restFloats, root,
 * up, rootParts }. The objects in it stay alive as long as it; a mask may be changed between two frames.
 */
export class MixerSet extends Owner {
  constructor({ clips, masks = [], rest, restFloats = null, root = 0, up = [0, 1, 0], rootParts = 0 }) {
    super();
    try {
      this._kept = [clips.map(c => [c.clip, c.reference]), masks, rest];
      this.clips = clips.map(c => c.clip);
      this.jointCount = expect(Pose, rest).jointCount;
      this.floatCount = clips[0]?.clip.floatCount ?? 0;
      need('restFloats', restFloats?.length ?? this.floatCount, this.floatCount);
      const list = store(this, clips.flatMap(c => this.#clipWords(c)), Uint32Array);
      const views = store(this, masks.flatMap(m => [addressOf(Mask, m), m?.jointCount ?? this.jointCount]), Uint32Array);
      /** @internal */
      this._p = store(this, [list, clips.length, views, masks.length, rest._p, rest.jointCount,
        store(this, restFloats), this.floatCount, root, ...wordsOf(up), rootParts], Uint32Array);
      check('nkw_mixer_set_validate', x.nkw_mixer_set_validate(this._p, badAt()), bad);
    } catch (error) {
      this.dispose();
      throw error;
    }
  }
  #clipWords({ clip, reference = null, events = [], markers = [], start = 0, end = 0 }) {
    return [expect(Clip, clip)._p, addressOf(Pose, reference), reference?.jointCount ?? 0,
      store(this, markRows(events)), events.length, store(this, markers), markers.length, ...wordsOf([start, end])];
  }
}
const wordsOf = floats => new Uint32Array(Float32Array.from(floats).buffer);

/** Plays the clips of a set: fades, layers, clips in step, events, root motion; the state of one character (mixer.h). */
export class Mixer extends Owner {
  #set; #frame; #work; #workBytes; #poses; #posesBytes; #floats; #events; #capacity;
  constructor(set, { events = 64 } = {}) {
    super();
    this.#set = expect(MixerSet, set);
    const stride = 16 * Math.ceil(set.jointCount / 16);
    this.#workBytes = 4 * ((MIXER_SLOTS + 4) * 10 * stride + 3 * set.floatCount) + 16;
    this.#posesBytes = 4 * 50 * stride;
    this.#capacity = events;
    /** @internal */
    this._p = this._take(STATE_BYTES);
    [this.#frame, this.#work, this.#poses] = [68, this.#workBytes, this.#posesBytes].map(n => this._take(n));
    [this.#floats, this.#events] = [4 * set.floatCount + 4, 24 * events + 4].map(n => this._take(n));
    u8.fill(0, this._p, this._p + STATE_BYTES);
    u8.fill(0, this.#poses, this.#poses + this.#posesBytes);
  }
  #at(slot, member) {
    if (!(number(slot) >= 0 && slot < MIXER_SLOTS))
      throw new RangeError(`nakawari: no slot ${slot}`);
    return this._use()._p + slot * SLOT_BYTES + SLOT[member];
  }
  /** Begins to play a clip of the set; returns its slot. What is left out is 0. */
  play({ clip = 0, mask = 0, layer = 0, group = 0, mode = 0, blend = 0, sync = 0, transition = 0, fade = 0, time = 0 }) {
    const options = words(1, clip, mask, layer, group, mode, blend, sync, transition, ...wordsOf([fade, time]));
    check('nkw_mixer_play', x.nkw_mixer_play(this._use()._p, this.#set._use()._p, options, words(0, 0)));
    return u32[at];
  }
  /** Fades a slot out. */
  stop(slot, fade = 0) {
    check('nkw_mixer_stop', x.nkw_mixer_stop(this._use()._p, number(slot), number(fade)));
  }
  setWeight(slot, weight) {
    f32[this.#at(slot, 'weight') >> 2] = number(weight);
  }
  setSpeed(slot, speed) {
    f32[this.#at(slot, 'speed') >> 2] = number(speed);
  }
  /** What plays in a slot: { clip, time, weight, speed }; null if it is free. */
  slot(slot) {
    const word = member => this.#at(slot, member) >> 2;
    return u32[word('playing')] ? { clip: u32[word('clip')], weight: f32[word('weight')], speed: f32[word('speed')],
      time: new DataView(f32.buffer).getFloat64(this.#at(slot, 'time'), true) } : null;
  }
  /** The next frame: its pose and floats; returns { events, eventCount, motion }. */
  advance(seconds, pose, floats = null) {
    const { floatCount } = this.#set._use(), f = this.#frame >> 2;
    need('floats', floats?.length ?? floatCount, floatCount);
    u32.set([expect(Pose, pose)._p, pose.jointCount, floats ? this.#floats : 0, this.#poses, this.#events,
      this.#capacity, 0], f);
    check('nkw_mixer_advance', x.nkw_mixer_advance(this._use()._p, this.#set._p, number(seconds), this.#frame,
      words(0, this.#work + 15 & ~15, this.#workBytes - 16)));
    for (let k = 0; floats && k < floatCount; k++)
      floats[k] = f32[(this.#floats >> 2) + k];
    const eventCount = u32[f + 6], events = [];
    for (let k = 0, e = this.#events >> 2; k < Math.min(eventCount, this.#capacity); k++, e += 6)
      events.push({ slot: u32[e], clip: u32[e + 1], event: u32[e + 2], kind: u32[e + 3], weight: f32[e + 4],
        moment: f32[e + 5] });
    return { events, eventCount, motion: [...f32.subarray(f + 7, f + 17)] };
  }
  /** The state, as bytes for restore(): of this machine's byte order, for sets of the same clips. */
  save() {
    const state = new Uint8Array(STATE_BYTES + this.#posesBytes);
    state.set(u8.subarray(this._use()._p, this._p + STATE_BYTES));
    state.set(u8.subarray(this.#poses, this.#poses + this.#posesBytes), STATE_BYTES);
    return state;
  }
  /** Takes a state that was saved. What is not one is refused, and changes nothing. */
  restore(state) {
    if (state?.length !== STATE_BYTES + this.#posesBytes)
      throw new RangeError(`nakawari: ${state?.length ?? typeof state} bytes are no state of this mixer`);
    during(owner => {
      const copy = store(owner, state.subarray(0, STATE_BYTES), Uint8Array);
      check('nkw_mixer_validate', x.nkw_mixer_validate(copy, this.#set._use()._p, badAt()), bad);
      u8.set(state.subarray(0, STATE_BYTES), this._use()._p);
      u8.set(state.subarray(STATE_BYTES), this.#poses);
    });
  }
}
