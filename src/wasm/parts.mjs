// SPDX-License-Identifier: MIT
// What the package holds. A part has the functions of its stems whose shapes fit (functions.mjs), those that its
// sources call, and the enumerations of its stems. A new stem is added here; the generator refuses a public function
// that is neither in a part nor below.
const values = ['scalar', 'vec', 'quat', 'orient', 'curve'];
const algebra = ['mat', 'euler', 'axes', 'transform', 'arrays', 'dual', 'box', 'handle', 'ease', 'rotation', 'limit',
  'spring', 'inertia', 'segment', 'playback', 'root'];
const curves = ['fcurve', 'spline', 'nurbs', 'polycurve', 'track', 'dialect', 'edit', 'fit', 'reduce', 'clip_reduce',
  'timecode'];
const bodies = ['pose', 'clip', 'skeleton', 'blend', 'mirror', 'transition', 'ik', 'foot', 'retarget', 'blendspace',
  'layer', 'bounds', 'palette', 'morph', 'partition', 'mesh'];

const clips = ['track', 'pose', 'build', 'clip'];

// Structs of these stems are objects, also if they have floats only.
export const objectStems = ['root', 'polycurve', 'ik', 'foot', 'box', 'bounds', 'clip', 'clip_reduce'];

export const parts = [
  {
    name: 'values', stems: values, sources: [], batch: false, limit: 12,
    without: new RegExp('mat[34]|_wxyz|bezier_split|cubic_(convert|evaluate|sum)|quintic|' +
      'quat_(swing|twist|mean|turns|look|pow)|_path$|from_catmull_rom|_from_vectors|perpendicular|integrate|' +
      'angular_velocity|euler_|nkw_wrap$|nkw_pow|equal_within|_towards'),
  },
  { name: 'math', stems: [...values, ...algebra], enums: ['keyframe'],
    sources: ['objects', 'columns', 'records', 'keyframes'], batch: true, limit: 100, without: /pose_/ },
  { name: 'player', stems: [], enums: ['playback'], sources: ['objects', 'pose', 'player', 'clip', 'head'], limit: 25 },
  { name: 'clips', stems: [], enums: ['track', 'clip', 'playback'], sources: ['objects', ...clips, 'head'], limit: 35 },
  { name: 'characters', stems: [], enums: ['track', 'clip', 'playback', 'blend', 'palette', 'skin'],
    sources: ['objects', ...clips, 'head', 'characters'], limit: 68 },
  { name: 'all', stems: [...values, ...algebra, ...curves, ...bodies], enums: ['keyframe', 'palette', 'skin', 'mixer'],
    sources: ['objects', 'columns', 'records', 'keyframes', ...clips, 'characters', 'motion', 'meshes', 'mixer'],
    batch: true, limit: 250 },
];

// Scripts for the objects of another library, and the part on top of which each is: its memory is that of this part.
export const adapters = { three: 'characters', 'all/three': 'all' };

// Of the arrays of a struct how many values they have, and of numbers in a struct what they are by default.
const stride = '10 * 16 * Math.ceil(jointCount / 16)';
const corners = '(mesh.indices?.length ?? lengthOf(mesh.positions, 3))';
const joints = { jointCount: 'parents.length', parents: 'jointCount' };
export const arrays = {
  nkw_fcurve: { keyCount: 'keys.length', keys: 'keyCount' },
  nkw_spline: { count: 'times.length', width: '1', stride: 'width', times: 'count',
    values: '(count - 1) * stride + width', tcb: '3 * count', endTangents: '2 * width' },
  nkw_nurbs: { width: '1', stride: 'width', count: 'lengthOf(points, width)',
    points: '(count - 1) * stride + width', weights: 'count', knots: 'count + degree + 1' },
  nkw_polycurve: { count: 'lengthOf(cubics, 12)', cubics: '12 * count' },
  nkw_easing: { curve: '[0, 0, 0, 0]', count: '(inputs ?? []).length', inputs: 'count', outputs: 'count' },
  nkw_playback_step: { keyCount: 'times.length', times: 'keyCount' },
  nkw_track: { count: 'times.length', width: '1', times: 'count', keyInterpolation: 'count',
    values: 'count * width * (interpolation === INTERPOLATION_CUBICSPLINE ? 3 : 1)' },
  nkw_partition_mesh: { influenceCount: '4', triangleCount: 'indices.length / 3',
    vertexCount: 'weights.length / influenceCount', indices: '3 * triangleCount', materials: 'triangleCount',
    joints: 'vertexCount * influenceCount', weights: 'vertexCount * influenceCount', depths: 'jointCount' },
  nkw_mesh: { vertexCount: 'lengthOf(positions, 3)', positions: '3 * vertexCount',
    triangleCount: 'indices ? indices.length / 3 : vertexCount / 3', indices: '3 * triangleCount' },
  nkw_mesh_surface: { normals: '3 * lengthOf(normals, 3)', texcoords: '2 * lengthOf(texcoords, 2)' },
  nkw_palette_source: { modelCount: 'lengthOf(models, 16)',
    jointCount: 'joints?.length ?? (inverseBind ? lengthOf(inverseBind, 16) : modelCount)',
    models: '16 * modelCount', joints: 'jointCount', inverseBind: '16 * jointCount', globalInverse: '16' },
  nkw_clip_reduction: { parents: '(parents ?? []).length', tolerances: '(tolerances ?? []).length',
    distances: '(distances ?? []).length', floatTolerance: '0' },
  nkw_skeleton: joints,
  nkw_pose_view: { data: stride }, nkw_pose_span: { data: stride },
  nkw_mask_view: { data: stride.slice(5) }, nkw_mask_span: { data: stride.slice(5) },
  nkw_pose_velocity_view: { data: stride.replace('10', '9') },
  nkw_pose_velocity_span: { data: stride.replace('10', '9') },
  nkw_pose_inertia: { data: stride.replace('10', '30') },
  nkw_pose_dead_blend: { data: stride.replace('10', '23') },
  nkw_mirror_rig: { parents: 'rest.jointCount', pair: 'rest.jointCount' },
  nkw_ik_chain: { count: 'lengthOf(offsets, 3)', offsets: '3 * count', limits: '14 * count' },
  nkw_ik_pose: { models: '16 * pose.jointCount', root: '16' },
  nkw_ik_reach: { limits: '14 * jointCount' },
  nkw_retarget: { joints: 'target.jointCount' },
  nkw_blendspace: { dimension: '1', count: 'lengthOf(samples, dimension)', samples: 'count * dimension' },
  nkw_palette_view: { data: '0' },
  nkw_tree: { nodeCount: 'firstChild.length', firstChild: 'nodeCount', nextSibling: 'nodeCount' },
};
// Of the arrays of a function how many values they have, where it is not `count` or one.
export const lengths = {
  nkw_axes_convert_values: { values: 'count * (kind === AXES_QUAT ? 4 : 3)', out: 'count * (kind === AXES_QUAT ? 4 : 3)' },
  nkw_spline_knots: { knots: 'spline.times.length' },
  nkw_nurbs_evaluate: { out: 'curve.width ?? 1' },
  nkw_nurbs_make_knots: { knots: 'count + degree + 1' },
  nkw_timeline_from_times: { timeline: '1' },
  nkw_polycurve_measure: { lengths: 'lengthCount' },
  nkw_polycurve_at_length: { lengths: 'lengthCount' },
  nkw_polycurve_frames: { frames: 'frameCount' },
  nkw_polycurve_flatten: { points: 'capacity', count: '1' },
  nkw_playback_passed: { keys: 'capacity', count: '1' },
  nkw_track_sample_segment: { out: 'track.width' },
  nkw_track_convert_axes: { values: 'trackValueCount(track)' },
  nkw_track_align: { values: 'trackValueCount(track)' },
  nkw_track_resample_within: { span: '[track.count, track.width]' },
  nkw_track_trim: { span: '[track.count + 1, track.width]' },
  nkw_track_retime: { span: '[2 * track.count, track.width]' },
  nkw_track_join: { span: '[first.count + second.count, first.width]' },
  nkw_track_close: { span: '[track.count, track.width]' },
  nkw_track_fit: { span: '[track.count, track.width]' },
  nkw_track_reduce: { span: '[track.count, track.width]' },
  nkw_track_from_fcurves: { span: '[4096, count]' },
  nkw_track_from_euler_fcurves: { span: '[4096, 4]' },
  nkw_fcurve_from_track: { keys: 'track.count' },
  nkw_pose_from_trs: { trs: 'pose.jointCount' }, nkw_trs_from_pose: { out: 'pose.jointCount' },
  nkw_mask_from_times: { times: 'mask.jointCount' },
  nkw_pose_mirror: { pair: 'pose.jointCount' },
  nkw_mirror_pairs_from_models: { models: 'skeleton.jointCount', pair: 'skeleton.jointCount' },
  nkw_track_mirror_rest: { values: 'trackValueCount(track)' },
  nkw_pose_layers_blend: { layers: 'layerCount' }, nkw_pose_layers_validate: { layers: 'layerCount' },
  nkw_skeleton_pose_from_models: { models: 'skeleton.jointCount' },
  nkw_skeleton_locals_from_models: { models: 'skeleton.jointCount', locals: 'skeleton.jointCount' },
  nkw_skeleton_models_from_locals: { locals: 'skeleton.jointCount', models: 'skeleton.jointCount' },
  nkw_skeleton_depths: { depths: 'skeleton.parents.length', order: 'skeleton.parents.length' },
  nkw_skeleton_from_parents: { node_parents: 'jointCount', joint_of_node: 'jointCount', node_of_joint: 'jointCount',
    parents: 'jointCount' },
  nkw_skeleton_from_tree: { joint_of_node: 'tree.firstChild.length', node_of_joint: 'tree.firstChild.length',
    parents: 'tree.firstChild.length' },
  nkw_ticks_convert: { out: '1' }, nkw_ticks_to_seconds: { seconds: '1' },
  nkw_root_split_keys: { rule: '1' },
  nkw_ik_chain_solve: { rotations: 'lengthOf(chain.offsets, 3)' },
  nkw_retarget_map_chain: { source_chain: 'sourceCount', target_chain: 'targetCount',
    joints: 'retarget.target.jointCount' },
  nkw_retarget_chain_scale: { source_chain: 'sourceCount', target_chain: 'targetCount' },
  nkw_blendspace_weights: { point: 'space.dimension ?? 1',
    weights: 'space.count ?? lengthOf(space.samples, space.dimension ?? 1)' },
  nkw_palette_to_mat4: { out: 'palette.jointCount' },
  nkw_palette_inverse_bind: { out: 'source.joints?.length ?? lengthOf(source.models, 16)' },
  nkw_mesh_normals: { normals: corners }, nkw_mesh_fix_facing: { indices: corners, facing: '1' },
  nkw_mesh_tangents: { tangents: `4 * ${corners}`, bitangents: corners },
  nkw_box_from_palette: { boxes: 'palette.jointCount + 1' },
};
// The working memory that a function needs: bytes of an nkw_work, or elements.
export const work = {
  nkw_pose_mirror_rest: '16 * rig.rest.jointCount', nkw_track_mirror_rest: '16 * rig.rest.jointCount',
  nkw_track_difference: '8 * track.width',
  nkw_track_resample_within: '8 * track.width',
  nkw_track_fit: '8 * (track.count * (track.width + 5) + track.width)',
  nkw_ik_chain_solve: '16 * lengthOf(chain.offsets, 3)',
  nkw_ik_pose_chain: '44 * reach.jointCount',
  nkw_mesh_normals: `64 * ${corners}`, nkw_mesh_tangents: `64 * ${corners}`, nkw_mesh_fix_facing: `64 * ${corners}`,
  nkw_retarget_apply: '32 * (source.jointCount + out.jointCount)',
};

// Public functions without a function in JavaScript, and why: names or whole stems.
export const excluded = {
  nkw_partition_vertices: 'it reads a partition, which is not kept: nkw_mat4_transform_point of the bind matrices',
  nkw_version: 'the version is in package.json',
  nkw_mesh_weld: 'it compares bytes: a Map of strings',
  nkw_mirror_pairs_from_names: 'names are strings: nkw_mirror_pairs_from_models',
  nkw_segment_find_n: 'nkw_segment_find for each time',
};
export const excludedStems = {
  clip_motion: 'clips are objects of clip.sample: not bound yet',
  chunk: 'clips are objects of clip.sample: not bound yet',
  records: 'poses in JavaScript are component arrays: nkw_pose_from_trs, nkw_trs_from_pose',
  fingerprint: 'results of 64 bits, of data that C keeps',
  character: 'one block of views and pointers: objects of the package own their memory',
};
// Of these stems the sources call what their objects need; the rest is not bound yet.
export const partial = ['keyframe', 'track', 'pose', 'clip', 'skeleton', 'blend', 'palette', 'skin', 'crowd', 'reduce',
  'clip_reduce'];
