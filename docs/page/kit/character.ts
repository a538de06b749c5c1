// SPDX-License-Identifier: MIT
// The example character for the exhibits of clips: a script of its own, because a page that is a file cannot fetch.
export { default } from '../../examples/character.glb';
