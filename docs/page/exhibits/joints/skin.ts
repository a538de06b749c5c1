// SPDX-License-Identifier: MIT
// The skinned capsule of a state.
import * as N from 'nakawari/all';
import { vertex } from '../../kit/skinned';
import type { Room } from '../../shell/exhibit';
import { around, joints, positions, weightsOf, type Influence } from './mesh';
import { chain, type Joint, type State } from './model';

export interface Skinned {
  list: Joint[];
  /** Of all vertices, four each. */
  weights: Uint16Array;
  positions: Float32Array;
}

/** The vertex that is chosen. */
export const chosen = ({ ring, column }: State) => ring * around + column;

/** For each joint the vertex that is chosen, moved by the matrix of this joint alone. */
export const movedBy = (state: State, { list }: Skinned) => list.map(joint =>
  N.mat4TransformPoint([0, 0, 0], joint.M, vertex(positions, chosen(state))));

function build(influence: Influence, normalised: boolean) {
  const weights = weightsOf(influence, normalised), count = positions.length / 3;
  const mesh = new N.Mesh({ positions, weights, influenceCount: joints,
    joints: Uint16Array.from({ length: count * joints }, (_, i) => i % joints) });
  return { mesh, weights };
}

/** A function that skins the state; the meshes, one for each way to weigh, live as long as the exhibit. */
export function skinner(room: Room<State>): () => Skinned {
  const built = new Map<string, ReturnType<typeof build>>();
  const palette = new N.Palette({ jointCount: joints, format: N.PALETTE_MAT4 }), models = new N.Matrices(joints);
  room.closed(() => [...[...built.values()].map(b => b.mesh), palette, models].forEach(owner => owner.dispose()));
  return () => {
    const { influence, order } = room.state, key = `${influence} ${order === 'unnormalised'}`, list = chain(room.state);
    const { mesh, weights } = built.get(key) ?? build(influence, order !== 'unnormalised');
    built.set(key, { mesh, weights });
    models.array.set(list.flatMap(joint => joint.M));
    return { list, weights, positions: mesh.skinLinear(palette.update(models)).skinned.positions! };
  };
}
