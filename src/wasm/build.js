
const textAt = (owner, string) => store(owner, new TextEncoder().encode(`${string}\0`), Uint8Array);

const textsAt = (owner, strings) => strings ? store(owner, strings.map(s => textAt(owner, s)), Uint32Array) : 0;

function namesAt(owner, { clip = '', joints, floats }, jointCount, floatCount) {
  need('names of joints', joints?.length ?? jointCount, jointCount);
  need('names of floats', floats?.length ?? floatCount, floatCount);
  return store(owner, [textAt(owner, clip), textsAt(owner, joints), textsAt(owner, floats)], Uint32Array);
}

// The source of a clip, in memory of `owner`.
function clipSource(owner, { jointCount = 0, floatCount = 0, tracks = [], rest = null, restFloats, format, names }) {
  need('restFloats', restFloats?.length ?? floatCount, floatCount);
  const list = store(owner, tracks.flatMap(t => [t.target, t.index, ...expect(Track, t.track)._words]), Uint32Array);
  return store(owner, [list, tracks.length, jointCount, floatCount, addressOf(Pose, rest), rest?.jointCount ?? 0,
    store(owner, restFloats), format ?? CLIP_FLOAT32,
    names ? namesAt(owner, names, jointCount, floatCount) : 0], Uint32Array);
}

function buildClip(clip, source, owner) {
  const from = clipSource(owner, source), count = 12 * source.tracks.length, work = owner._take(count + 16);
  const build = () => x.nkw_clip_build(from, words(1, clip._p ?? 0, clip.size ?? 0), words(0, 0), badAt(),
    words(3, work, count));
  const asked = build();
  if (!u32[at])
    check('nkw_clip_build', asked, bad);
  clip.size = u32[at];
  clip._p = clip._take(clip.size);
  check('nkw_clip_build', build(), bad);
}
