// SPDX-License-Identifier: MIT
// What the exhibits use of three.js: a script of its own, loaded where a model or a crowd is shown.
export * from 'three';
export { GLTFLoader } from 'three/examples/jsm/loaders/GLTFLoader.js';
export { MTLLoader } from 'three/examples/jsm/loaders/MTLLoader.js';
export { OBJLoader } from 'three/examples/jsm/loaders/OBJLoader.js';
export { OrbitControls } from 'three/examples/jsm/controls/OrbitControls.js';
