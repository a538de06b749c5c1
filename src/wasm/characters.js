
/** `count` matrices of sixteen floats, column by column. */
export class Matrices extends Floats {
  constructor(count) {
    super(16 * count);
    this.matrixCount = count;
  }
}

/** The parent of each joint, or -1; a parent comes before its children (skeleton.h). */
export class Skeleton extends Owner {
  get _type() { return 'nkw_skeleton'; }
  constructor(parents) {
    super();
    try {
      this.jointCount = parents.length;
      /** @internal */
      this._p = store(this, [store(this, parents, Int32Array), parents.length], Uint32Array);
      check('nkw_skeleton_validate', x.nkw_skeleton_validate(this._p, badAt()), bad);
    } catch (error) {
      this.dispose();
      throw error;
    }
  }
  /** Model matrices of a pose; `root`, 16 floats or null, places the whole skeleton. */
  models(pose, out, root = null) {
    need('matrices', expect(Matrices, out).matrixCount, this.jointCount);
    check('nkw_skeleton_models_from_pose',
      x.nkw_skeleton_models_from_pose(this._use()._p, viewOf(0, pose), root ? w(16, root, 16) : 0, 0,
        out._p));
    return out;
  }
}

/** A weight for each joint (blend.h), 1 at first. */
export class Mask extends Floats {
  get _data() { return 'nkw_mask'; }
  constructor(jointCount) {
    super(16 * Math.ceil(jointCount / 16));
    this.jointCount = jointCount;
    this.array.fill(1);
  }
}

const viewOf = (i, pose) => expect(Pose, pose)._view(i);
const maskView = (i, mask) => words(i, addressOf(Mask, mask), mask?.jointCount ?? 0);

/** Poses between two: t = 0 is a, t = 1 is b; nlerp for rotations. */
export function poseBlend(a, b, t, out, mask = null) {
  check('nkw_pose_blend', x.nkw_pose_blend(viewOf(0, a), viewOf(2, b), number(t), maskView(4, mask), viewOf(6, out)));
  return out;
}

/** The same by slerp. */
export function poseBlendSlerp(a, b, t, out, mask = null) {
  check('nkw_pose_blend_slerp',
    x.nkw_pose_blend_slerp(viewOf(0, a), viewOf(2, b), number(t), maskView(4, mask), viewOf(6, out)));
  return out;
}

/** The difference of a pose from a reference, for poseAdditiveApply. */
export function poseAdditiveBuild(a, reference, side, out) {
  check('nkw_pose_additive_build',
    x.nkw_pose_additive_build(viewOf(0, a), viewOf(2, reference), number(side), viewOf(6, out)));
  return out;
}

/** A pose with a share of a difference. */
export function poseAdditiveApply(base, delta, weight, side, out, mask = null) {
  check('nkw_pose_additive_apply',
    x.nkw_pose_additive_apply(viewOf(0, base), viewOf(2, delta), number(weight), maskView(4, mask), number(side),
      viewOf(6, out)));
  return out;
}

// The arrays of a skin: { jointCount, joints, inverseBind }.
function skinOf(owner, skin, all = 0) {
  const { joints, inverseBind } = skin;
  const jointCount = skin.jointCount ?? joints?.length ?? (inverseBind ? inverseBind.length / 16 : all);
  need('joints', joints?.length ?? jointCount, jointCount);
  need('floats of inverseBind', inverseBind?.length ?? 16 * jointCount, 16 * jointCount);
  return [store(owner, joints, Int32Array), store(owner, inverseBind), jointCount];
}

const elementFloats = [16, 12, 8, 9, 12, 12];

/** The joint matrices of a skin (palette.h): { joints, inverseBind, jointCount, globalInverse, format }. */
export class Palette extends Owner {
  get _data() { return 'nkw_palette'; }
  constructor({ format = PALETTE_MAT4, globalInverse, ...skin }) {
    super();
    [this._joints, this._bind, this.jointCount] = skinOf(this, skin);
    need('floats of globalInverse', globalInverse?.length ?? 16, 16);
    this._global = store(this, globalInverse);
    this.format = format;
    this.floats = (elementFloats[format] ?? 16) * this.jointCount;
    /** @internal */
    this._p = this._take(4 * this.floats);
  }
  /** @internal */
  _view(i) {
    return words(i, this._use()._p, this.jointCount, this.format);
  }
  /** Computes the palette from model matrices. */
  update(models) {
    check('nkw_palette_from_models', x.nkw_palette_from_models(words(0, expect(Matrices, models)._p,
      models.matrixCount, this._joints, this._bind, this._global, this.jointCount), this._view(8)));
    return this;
  }
  /** The elements, not a copy. */
  get array() {
    return new Float32Array(f32.buffer, this._use()._p, this.floats);
  }
}

// The first n values of an array.
const first = (array, n) => array.length > n ? Array.prototype.slice.call(array, 0, n) : array;

/**
 * `count` characters of one skeleton and skin, each at its own time of one clip. `array` receives 16 floats for each
 * joint of each character, one character after the other.
 */
export class Crowd extends Owner {
  constructor({ skeleton, count, ...skin }) {
    super();
    this.skeleton = expect(Skeleton, skeleton);
    if (!Number.isInteger(count))
      throw new RangeError(`nakawari: ${count} characters`);
    this.count = count;
    const n = skeleton.jointCount, stride = Math.ceil(n / 16) * 16;
    [this._joints, this._bind, this.jointCount] = skinOf(this, skin, n);
    this._poses = this._take(640 * n);
    this._models = this._take(768 * n);
    this._palette = this._take(768 * this.jointCount);
    this._roots = this._take(768);
    this._work = store(this, [this._take(640 * stride || 16), 640 * stride], Uint32Array);
    this._times = this._take(4 * count || 4);
    this._from = this._take(64 * count || 4);
    this._cursors = { clip: null, block: 0, count: 0 };
    this.floats = 16 * this.jointCount * count;
    /** @internal */
    this._p = this._take(4 * this.floats);
  }
  get array() {
    return new Float32Array(f32.buffer, this._use()._p, this.floats);
  }
  /** Samples the clip at times[i] for character i. `roots`: 16 floats for each character, or null. */
  play(clip, times, roots = null) {
    need('times', times?.length, this.count);
    need('floats of roots', roots?.length ?? 16 * this.count, 16 * this.count);
    this._use();
    f32.set(first(times, this.count), this._times >> 2);
    if (roots)
      f32.set(first(roots, 16 * this.count), this._from >> 2);
    for (let k = 0; k < this.count; k += 16)
      this.#sixteen(clip, k, Math.min(16, this.count - k), roots);
    return this;
  }
  #sixteen(clip, first, count, roots) {
    const n = this.skeleton.jointCount, lanes = (from, step) =>
      words(32, ...Array.from({ length: 16 }, (_, i) => i < count ? from + step * i : 0));
    const poses = words(4, this._poses, n), models = words(6, this._models, n);
    const palette = words(8, this._palette, this.jointCount), none = words(10, roots ? this._roots : 0, 1);
    const players = words(12, this._times + 4 * first, 0, count);
    check('nkw_crowd_sample', x.nkw_crowd_sample(players, expect(Clip, clip)._p, poses, this._work));
    if (roots)
      x.nkw_crowd_from_matrices(lanes(this._from + 64 * first, 64), none);
    check('nkw_crowd_models_from_pose',
      x.nkw_crowd_models_from_pose(addressOf(Skeleton, this.skeleton), poses, none, models));
    x.nkw_crowd_palette_from_models(models, this._joints, this._bind, palette);
    const step = 64 * this.jointCount;
    x.nkw_crowd_to_matrices(palette, lanes(this._p + step * first, step));
  }
}

const formats = new Map(
  [[Uint8Array, SKIN_U8], [Uint16Array, SKIN_U16], [Uint32Array, SKIN_U32], [Float32Array, SKIN_F32]]);
const streams = ['positions', 'normals', 'tangents', 'bitangents'];

/**
 * Vertices and their influences (skin.h). Vectors are three floats; joints are Uint8Array, Uint16Array, Uint32Array or
 * Float32Array; weights Uint8Array, Uint16Array or Float32Array. `skinned` has the results.
 */
export class Mesh extends Owner {
  constructor({ joints, weights, influenceCount = 4, ...vectors }) {
    super();
    try {
      this.vertexCount = vectors.positions.length / 3;
      const all = this.vertexCount * influenceCount, [from, to] = [[], []];
      need('joints', joints.length, all);
      need('weights', weights.length, all);
      for (const name of streams) {
        need(`floats of ${name}`, vectors[name]?.length ?? 3 * this.vertexCount, 3 * this.vertexCount);
        from.push(store(this, vectors[name]), 0);
        to.push(vectors[name] ? this._take(12 * this.vertexCount) : 0, 0);
      }
      const data = array => [store(this, array, array.constructor), 0, formats.get(array.constructor) ?? 99];
      this._skin = store(this, [this.vertexCount, influenceCount, ...data(joints), ...data(weights)], Uint32Array);
      [this._from, this._to] = [from, to];
      [this._in, this._out] = [store(this, from, Uint32Array), store(this, to, Uint32Array)];
    } catch (error) {
      this.dispose();
      throw error;
    }
  }
  #vectors(places) {
    this._use();
    return Object.fromEntries(streams.map((name, i) =>
      [name, places[2 * i] ? new Float32Array(f32.buffer, places[2 * i], 3 * this.vertexCount) : null]));
  }
  /** The vectors of the bind pose, not copies: positions, normals, tangents, bitangents; null where there are none. */
  get vectors() {
    return this.#vectors(this._from);
  }
  /** The skinned vectors, not copies; null where the mesh has none. */
  get skinned() {
    return this.#vectors(this._to);
  }
  /**
   * Linear blend skinning by a Palette of PALETTE_MAT4. Options, as nkw_skin_options: keepLength, inverseNormals,
   * divideByWeights.
   */
  skinLinear(palette, { keepLength = false, inverseNormals = false, divideByWeights = false } = {}) {
    this._use();
    const by = expect(Palette, palette)._view(0);
    words(3, 0, 0, 0, +keepLength, +inverseNormals, +divideByWeights);
    check('nkw_skin_linear', x.nkw_skin_linear(this._skin, by, this._in, this._out));
    return this;
  }
  /** Dual-quaternion skinning by a Palette of PALETTE_DUAL_QUAT. */
  skinDualQuat(palette) {
    this._use();
    check('nkw_skin_dual_quat',
      x.nkw_skin_dual_quat(this._skin, expect(Palette, palette)._view(0), this._in, this._out));
    return this;
  }
}
