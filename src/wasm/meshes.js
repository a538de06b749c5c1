
// The vectors of a mesh or of a target: { positions, normals, tangents, bitangents }, as nkw_vertices_view.
const vectorsAt = (owner, vectors) => streams.flatMap(name => [store(owner, vectors[name]), 0]);

/** Morph targets of a mesh (morph.h): [{ positions, normals, tangents, bitangents, indices }], differences each. */
export class Morph extends Owner {
  constructor(mesh, targets) {
    super();
    try {
      this.mesh = expect(Mesh, mesh);
      this.targetCount = targets.length;
      const all = targets.flatMap(({ indices, ...deltas }) => {
        const count = indices?.length ?? mesh.vertexCount;
        for (const name of streams)
          need(`floats of ${name}`, deltas[name]?.length ?? 3 * count, 3 * count);
        return [...vectorsAt(this, deltas), store(this, indices, Uint32Array), count];
      });
      const base = Object.fromEntries(Object.entries(mesh.vectors).map(([name, array]) => [name, array?.slice()]));
      this._base = store(this, vectorsAt(this, base), Uint32Array);
      /** @internal */
      this._p = store(this, [store(this, all, Uint32Array), targets.length, mesh.vertexCount], Uint32Array);
      check('nkw_morph_validate', x.nkw_morph_validate(this._p, badAt()), bad);
      this._weights = this._take(4 * targets.length || 4);
    } catch (error) {
      this.dispose();
      throw error;
    }
  }
  /** Writes the vectors of the mesh: those it was made of, and the differences by their weights. */
  apply(weights) {
    need('weights', weights.length, this.targetCount);
    f32.set(weights, this._use()._weights >> 2);
    x.nkw_morph_apply(this._p, this._weights, this._base, this.mesh._use()._in);
    return this;
  }
}

// A typed array of n joints or weights as nkw_skin_view, and what reads it back.
function skinView(array, n) {
  need('joints or weights', array.length, n);
  const block = temporary(n * array.BYTES_PER_ELEMENT), place = temporary(12);
  const copy = () => new array.constructor(f32.buffer, block, n);
  copy().set(array.subarray(0, n));
  u32.set([block, 0, formats.get(array.constructor) ?? 99], place >> 2);
  return { place, read: () => array.set(copy()) };
}

/** Checks the joints and weights of a mesh: the index of the error is a vertex (nkw_skin_validate). */
export function skinValidate(mesh, jointCount) {
  check('nkw_skin_validate', x.nkw_skin_validate(expect(Mesh, mesh)._skin, number(jointCount), badAt()), bad);
}

/** Weights that sum to 1 exactly (nkw_skin_normalize_weights), from and to Uint8Array, Uint16Array or Float32Array. */
export function skinNormalizeWeights(weights, out, influenceCount, vertexCount) {
  $t(() => {
    const n = influenceCount * vertexCount, from = skinView(weights, n), to = skinView(out, n);
    check('nkw_skin_normalize_weights',
      x.nkw_skin_normalize_weights(from.place, influenceCount, vertexCount, to.place));
    to.read();
  });
}

/** The keepCount largest weights of each vertex of a mesh, and their joints (nkw_skin_prune). */
export function skinPrune(mesh, keepCount, joints, weights) {
  $t(() => {
    const n = keepCount * mesh.vertexCount, to = [skinView(joints, n), skinView(weights, n)];
    check('nkw_skin_prune', x.nkw_skin_prune(expect(Mesh, mesh)._skin, keepCount, to[0].place, to[1].place));
    to.forEach(view => view.read());
  });
}

/** The boxes of the joints in the bind pose, and one of the vertices without influence (nkw_box_from_skin). */
export function boxFromSkin(mesh, boxes, jointCount) {
  $t(() => {
    const place = temporary((jointCount + 1) * $nkw_box[0]);
    check('nkw_box_from_skin', x.nkw_box_from_skin(expect(Mesh, mesh)._skin, mesh._in, place, jointCount));
    $v($nkw_box, boxes, place, jointCount + 1);
  });
}

/**
 * Partitions a mesh into parts of at most maxJointCount joints (nkw_partition_build): { parts, joints, triangles,
 * indices, vertices, jointSlots, weights, rejectedCount }.
 */
export function partitionBuild(mesh, maxJointCount) {
  return $t(() => {
    const from = $i($nkw_partition_mesh, mesh), all = get($nkw_partition_mesh, from), size = {};
    partitionBounds(size, mesh, maxJointCount);
    const slots = size.vertexCount * all.influenceCount, count = all.triangleCount;
    const arrays = [[$nkw_part, size.partCount], ['h', size.jointCount], ['u', count], ['u', 3 * count],
      ['u', size.vertexCount], ['h', slots], ['f', slots]];
    const places = arrays.map(([kind, n]) => temporary(n * sizeOf(kind))), out = temporary(48);
    u32.set(places, out >> 2);
    const result = x.nkw_partition_build(from, maxJointCount, out, badAt(),
      words(0, temporary(size.workBytes), size.workBytes));
    const [partCount, jointCount, triangleCount, vertexCount, rejectedCount] =
      u32.slice((out >> 2) + 7, (out >> 2) + 12);
    if (!rejectedCount)
      check('nkw_partition_build', result, bad);
    const used = [partCount, jointCount, triangleCount + rejectedCount, 3 * triangleCount, vertexCount,
      vertexCount * all.influenceCount, vertexCount * all.influenceCount];
    const [parts, ...rest] = arrays.map(([kind], i) => typeof kind === 'string'
      ? new arrayOf[kind](f32.buffer, places[i], used[i]).slice()
      : Array.from({ length: used[i] }, (_, k) => get(kind, places[i] + k * kind[0])));
    const names = ['joints', 'triangles', 'indices', 'vertices', 'jointSlots', 'weights'];
    return { parts, ...Object.fromEntries(names.map((name, i) => [name, rest[i]])), rejectedCount };
  });
}
