// SPDX-License-Identifier: MIT
// The example character: a script of its own, because a page that is a file cannot fetch.
export { default } from '../../examples/character.glb';
