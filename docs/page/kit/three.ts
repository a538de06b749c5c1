// SPDX-License-Identifier: MIT
// What the exhibits use of three.js: a script of its own, loaded where a file's model or a crowd is shown.
export * from 'three';
export { GLTFLoader } from 'three/examples/jsm/loaders/GLTFLoader.js';
export { OrbitControls } from 'three/examples/jsm/controls/OrbitControls.js';
