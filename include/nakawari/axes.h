/* SPDX-License-Identifier: MIT */
/**
 * @file
 * The axes and the handedness of tools, and the conversion between them.
 *
 * Tools differ in the axis that points up, the axis that points forward, and in handedness. A conversion is a matrix P
 * whose rows are unit axes with signs: it exchanges components and negates some of them. A point p becomes P p. The
 * matrix A of a transform becomes P A P^T, so
 *
 *     translation     P t
 *     rotation        (det P) P q.xyz, q.w     a mirrored rotation turns in the opposite direction
 *     scale           |P| s                    exchanged, signs unchanged
 *
 * Models, rest poses, tracks and inverse bind matrices that are all converted by one P show the same motion, seen from
 * other axes. If det P = -1, handedness changes: then also reverse the order of the vertices of each triangle, and
 * negate the w of glTF tangents.
 *
 * Every conversion is exact: only signs and places change. The conversion by the inverse map restores the bits.
 * Units are separate: multiply translations by the number of target units in a source unit (0.01 from cm to m).
 */
#ifndef NAKAWARI_AXES_H
#define NAKAWARI_AXES_H

#include "euler.h"
#include "types.h"

#ifdef __cplusplus
extern "C" {
#endif

/** An axis with its sign. -axis is the opposite direction. Any other number is read as NKW_AXIS_X. */
typedef enum nkw_axis {
    NKW_AXIS_NEGATIVE_Z = -3,
    NKW_AXIS_NEGATIVE_Y = -2,
    NKW_AXIS_NEGATIVE_X = -1,
    NKW_AXIS_X = 1,
    NKW_AXIS_Y = 2,
    NKW_AXIS_Z = 3,
    NKW_AXIS_MAX_ENUM = 0x7fffffff
} nkw_axis;

/** The axes of a tool: the directions right, up and forward of a character or camera. */
typedef struct nkw_axes {
    nkw_axis right, up, forward;
} nkw_axes;
NKW_SIZE(nkw_axes, 12, 12);

/**
 * Axes of tools, as initialisers: nkw_axes file = NKW_AXES_BLENDER. Forward is the direction a character faces.
 *
 * Names with _CAMERA are of view spaces: forward is the direction in which a camera of the tool looks. Cameras of
 * glTF, Blender, Maya, Godot and OpenUSD are those of OpenGL, and look against the direction that their characters
 * face: from NKW_AXES_OPENGL_CAMERA to NKW_AXES_GLTF is half a turn about y, not the identity. Convert the data of a
 * file between two names without _CAMERA, its view matrices between two with it.
 *
 * Cameras of Unity, Direct3D and Unreal look where their actors do: NKW_AXES_UNITY, NKW_AXES_UNREAL.
 */
#define NKW_AXES_GLTF                                                                                                  \
    {                                                                                                                  \
        NKW_AXIS_NEGATIVE_X, NKW_AXIS_Y, NKW_AXIS_Z                                                                    \
    } /* right-handed; Maya, VRM 1.0 */
#define NKW_AXES_GODOT                                                                                                 \
    {                                                                                                                  \
        NKW_AXIS_NEGATIVE_X, NKW_AXIS_Y, NKW_AXIS_Z                                                                    \
    } /* right-handed; models (Vector3.MODEL_FRONT), as those of glTF */
#define NKW_AXES_USD_Y                                                                                                 \
    {                                                                                                                  \
        NKW_AXIS_NEGATIVE_X, NKW_AXIS_Y, NKW_AXIS_Z                                                                    \
    } /* right-handed; upAxis = "Y" */
#define NKW_AXES_USD_Z                                                                                                 \
    {                                                                                                                  \
        NKW_AXIS_NEGATIVE_X, NKW_AXIS_Z, NKW_AXIS_NEGATIVE_Y                                                           \
    } /* right-handed; upAxis = "Z", front views as of Blender */
#define NKW_AXES_BLENDER                                                                                               \
    {                                                                                                                  \
        NKW_AXIS_NEGATIVE_X, NKW_AXIS_Z, NKW_AXIS_NEGATIVE_Y                                                           \
    } /* right-handed; 3ds Max */
#define NKW_AXES_UNITY                                                                                                 \
    {                                                                                                                  \
        NKW_AXIS_X, NKW_AXIS_Y, NKW_AXIS_Z                                                                             \
    } /* left-handed; Direct3D */
#define NKW_AXES_UNREAL                                                                                                \
    {                                                                                                                  \
        NKW_AXIS_Y, NKW_AXIS_Z, NKW_AXIS_X                                                                             \
    } /* left-handed; actors and components */
#define NKW_AXES_UNREAL_MESH                                                                                           \
    {                                                                                                                  \
        NKW_AXIS_NEGATIVE_X, NKW_AXIS_Z, NKW_AXIS_Y                                                                    \
    } /* left-handed; skeletal meshes, which a character turns by -90 degrees to face +x */
#define NKW_AXES_OPENGL_CAMERA                                                                                         \
    {                                                                                                                  \
        NKW_AXIS_X, NKW_AXIS_Y, NKW_AXIS_NEGATIVE_Z                                                                    \
    } /* right-handed; cameras of this library */
#define NKW_AXES_OPENCV_CAMERA                                                                                         \
    {                                                                                                                  \
        NKW_AXIS_X, NKW_AXIS_NEGATIVE_Y, NKW_AXIS_Z                                                                    \
    } /* right-handed; COLMAP, ROS optical frames */

/** A conversion: component x of the result is the input component that .x names, with its sign; y, z likewise. */
typedef struct nkw_axes_map {
    nkw_axis x, y, z;
} nkw_axes_map;
NKW_SIZE(nkw_axes_map, 12, 12);

/** 1 if x, y and z name three different axes, otherwise 0. Functions accept any map; others have no inverse. */
NKW_API int nkw_axes_map_is_valid(nkw_axes_map map);

/** {X, Y, Z}: no change. As an initialiser and as an argument. */
#define NKW_AXES_MAP_IDENTITY (NKW_LITERAL(nkw_axes_map){NKW_AXIS_X, NKW_AXIS_Y, NKW_AXIS_Z})

/**
 * The conversion that maps right, up and forward of `from` to those of `to`. From NKW_AXES_BLENDER to NKW_AXES_GLTF it
 * maps (x, y, z) to (x, z, -y). If right, up and forward of `from` or of `to` are not three different axes, the result
 * is {0, 0, 0}, for which nkw_axes_map_is_valid returns 0.
 */
NKW_API nkw_axes_map nkw_axes_map_from_axes(nkw_axes from, nkw_axes to);

/** The conversion back. Of a map that is not valid: the identity. */
NKW_API nkw_axes_map nkw_axes_map_inverse(nkw_axes_map map);

/** 1 if the conversion changes handedness, det P = -1, otherwise 0. */
NKW_API int nkw_axes_map_is_mirror(nkw_axes_map map);

/**
 * P v: a point, a direction, a velocity, a tangent of a curve, a vertex or a normal. The columns of the matrix P are
 * the converted unit vectors. Angular velocities and scales: nkw_axes_convert_values.
 */
NKW_API nkw_vec3 nkw_axes_convert_vec3(nkw_axes_map map, nkw_vec3 v);

/** ((det P) P q.xyz, q.w): rotate(convert(q), P v) = P rotate(q, v). w does not change, so neither does the path. */
NKW_API nkw_quat nkw_axes_convert_quat(nkw_axes_map map, nkw_quat q);

/** Translation, rotation and scale, each as above. */
NKW_API nkw_trs nkw_axes_convert_trs(nkw_axes_map map, const nkw_trs *trs);

/** P M P^T with P extended by 1: model, local, inverse bind matrices. Row and column 3 are converted as vectors. */
NKW_API nkw_mat4 nkw_axes_convert_mat4(nkw_axes_map map, const nkw_mat4 *m);

/**
 * Euler angles of an order, (det P) P angles, and in `order` the order of the result: the factors keep their places,
 * about other axes. Of a map that is not valid the order does not change; an unknown order is read as NKW_EULER_XYZ.
 */
NKW_API nkw_vec3 nkw_axes_convert_euler(nkw_axes_map map, nkw_vec3 angles, nkw_euler_order *order);

/** The meaning of the floats of a value, for arrays of values. Any other number is read as NKW_AXES_VEC3. */
typedef enum nkw_axes_kind {
    NKW_AXES_VEC3, /**< 3 floats, P v as nkw_axes_convert_vec3 */
    NKW_AXES_ANGULAR, /**< 3 floats, (det P) P v: an angular velocity, a torque, an axis times an angle */
    NKW_AXES_SCALE, /**< 3 floats, |P| s */
    NKW_AXES_QUAT, /**< 4 floats, nkw_axes_convert_quat */
    NKW_AXES_KIND_COUNT,
    NKW_AXES_KIND_MAX_ENUM = 0x7fffffff
} nkw_axes_kind;

/** The floats in a value of a kind. */
#define NKW_AXES_WIDTH(kind) ((kind) == NKW_AXES_QUAT ? 4u : 3u)

/**
 * Converts `count` values of NKW_AXES_WIDTH(kind) contiguous floats: the vertices of a mesh, the keys and tangents of a
 * track. `out` may be `values`, and must not overlap it otherwise.
 */
NKW_API void nkw_axes_convert_values(nkw_axes_map map, const float *values, size_t count, nkw_axes_kind kind,
                                     float *out);

#ifdef __cplusplus
}
#endif

#endif
