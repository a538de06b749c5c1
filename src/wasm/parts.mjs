// SPDX-License-Identifier: MIT
// What the package holds. A part has the functions of its stems whose shapes fit (functions.mjs), those that its
// sources call, and the enumerations of its stems. A new stem is added here; the generator refuses a public function that is
// neither in a part nor below.
const values = ['scalar', 'vec', 'quat', 'orient', 'curve'];
const algebra = ['mat', 'euler', 'axes', 'transform', 'dual', 'curve_point', 'handle', 'ease', 'rotation', 'limit',
  'spring', 'inertia', 'segment', 'playback', 'root'];

export const parts = [
  {
    name: 'values', stems: values, sources: [], batch: false, limit: 12,
    without: new RegExp('mat[34]|_wxyz|bezier_(split|from)|hermite_from_bezier|' +
      'quat_(swing|twist|mean|turns|look|pow)|_path$|nonuniform|_from_vectors|perpendicular|integrate|angular_velocity|euler_|nkw_wrap$|nkw_pow'),
  },
  { name: 'math', stems: [...values, ...algebra], enums: ['keyframe'], sources: ['objects', 'columns', 'keyframes'],
    batch: true, limit: 100 },
  { name: 'clips', stems: [], enums: ['track', 'clip'], sources: ['objects', 'clips'], limit: 36 },
  { name: 'characters', stems: [], enums: ['track', 'clip', 'blend', 'palette', 'skin'],
    sources: ['objects', 'clips', 'characters'], limit: 75 },
  { name: 'all', stems: [...values, ...algebra], enums: ['keyframe', 'track', 'clip', 'blend', 'palette', 'skin'],
    sources: ['objects', 'columns', 'keyframes', 'clips', 'characters'], batch: true, limit: 150 },
];

// Scripts on top of the part of characters, for the objects of another library.
export const adapters = ['three'];

const later = 'not bound yet';
// Public functions without a function in JavaScript, and why: names or whole stems.
export const excluded = {
  nkw_version: 'the version is in package.json',
  nkw_playback_passed: later, nkw_playback_passed_f64: later, nkw_playback_head_f64: later,
  nkw_pose_root_remove: later, nkw_root_remove_keys: later, nkw_root_delta: later, nkw_root_place: later,
  nkw_axes_convert_values: later,
};
export const excludedStems = {
  fcurve: later, spline: later, nurbs: later, polycurve: later, dialect: later, edit: later, fit: later,
  timecode: 'ticks of 64 bits: BigInt; not bound yet', reduce: later, transition: later, ik: later, foot: later,
  retarget: later, blendspace: later, morph: later, bounds: later, partition: later,
};
// Of these stems the sources call what their objects need; the rest is not bound yet.
export const partial = [
  'track', 'keyframe', 'pose', 'clip', 'skeleton', 'blend', 'palette', 'skin', 'crowd', 'segment',
];
