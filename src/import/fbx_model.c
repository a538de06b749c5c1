/* SPDX-License-Identifier: MIT */
#include <nakawari/quat.h>
#include <nakawari/vec.h>

#include "fbx.h"

static const nkw_vec3 zero = {0.0f, 0.0f, 0.0f}, one = {1.0f, 1.0f, 1.0f};

nkw_quat nkwi_fbx_turn(nkw_vec3 degrees, nkw_euler_order order)
{
    static const double radians = 0x1.1df46a2529d39p-6;
    const nkw_vec3 angles = {(float)(radians * (double)degrees.x), (float)(radians * (double)degrees.y),
                             (float)(radians * (double)degrees.z)};
    return nkw_quat_from_euler(angles, order);
}

/* FBX names the order in which the axes turn: XYZ turns about X first, Rz * Ry * Rx. */
static nkw_euler_order order_of(int number)
{
    static const nkw_euler_order orders[] = {NKW_EULER_ZYX, NKW_EULER_YZX, NKW_EULER_XZY,
                                             NKW_EULER_ZXY, NKW_EULER_YXZ, NKW_EULER_XYZ};
    return number >= 0 && number < 6 ? orders[number] : NKW_EULER_ZYX;
}

static int is_zero(nkw_vec3 v)
{
    return v.x == 0.0f && v.y == 0.0f && v.z == 0.0f;
}

/* RotationActive 0, and a rotation space for limits only, switch off the order, PreRotation and PostRotation. */
nkwi_fbx_model nkwi_fbx_model_of(const nkwi_fbx *fbx, size_t object)
{
    const nkw_quat identity = {0.0f, 0.0f, 0.0f, 1.0f};
    nkwi_fbx_model m;
    const int active = nkwi_fbx_number(fbx, object, "RotationActive", 1.0) != 0.0 &&
                       nkwi_fbx_number(fbx, object, "RotationSpaceForLimitOnly", 0.0) == 0.0;
    const double order = active ? nkwi_fbx_number(fbx, object, "RotationOrder", 0.0) : 0.0;
    const double inherit = nkwi_fbx_number(fbx, object, "InheritType", NKWI_FBX_RSRS);
    m.object = object;
    m.inherit = inherit == 0.0 ? NKWI_FBX_RRSS : inherit == 2.0 ? NKWI_FBX_RRS : NKWI_FBX_RSRS;
    m.is_spheric = order >= 6.0;
    m.order = order_of(order >= 0.0 && order < 7.0 ? (int)order : 0);
    m.before = active ? nkwi_fbx_turn(nkwi_fbx_vector(fbx, object, "PreRotation", zero), NKW_EULER_ZYX) : identity;
    m.after = active
                  ? nkw_quat_conjugate(nkwi_fbx_turn(nkwi_fbx_vector(fbx, object, "PostRotation", zero), NKW_EULER_ZYX))
                  : identity;
    m.rotation_offset = nkwi_fbx_vector(fbx, object, "RotationOffset", zero);
    m.rotation_pivot = nkwi_fbx_vector(fbx, object, "RotationPivot", zero);
    m.scaling_offset = nkwi_fbx_vector(fbx, object, "ScalingOffset", zero);
    m.scaling_pivot = nkwi_fbx_vector(fbx, object, "ScalingPivot", zero);
    m.has_pivot = !is_zero(m.rotation_pivot) || !is_zero(m.scaling_offset) || !is_zero(m.scaling_pivot);
    m.translation = nkwi_fbx_vector(fbx, object, "Lcl Translation", zero);
    m.rotation = nkwi_fbx_vector(fbx, object, "Lcl Rotation", zero);
    m.scaling = nkwi_fbx_vector(fbx, object, "Lcl Scaling", one);
    const nkw_vec3 turn = nkwi_fbx_vector(fbx, object, "GeometricRotation", zero);
    m.geometry.translation = nkwi_fbx_vector(fbx, object, "GeometricTranslation", zero);
    m.geometry.rotation = nkwi_fbx_turn(turn, NKW_EULER_ZYX);
    m.geometry.scale = nkwi_fbx_vector(fbx, object, "GeometricScaling", one);
    m.has_geometry = !is_zero(m.geometry.translation) || !is_zero(turn) || m.geometry.scale.x != 1.0f ||
                     m.geometry.scale.y != 1.0f || m.geometry.scale.z != 1.0f;
    return m;
}

nkw_quat nkwi_fbx_rotation(const nkwi_fbx_model *model, nkw_vec3 degrees)
{
    return nkw_quat_mul(nkw_quat_mul(model->before, nkwi_fbx_turn(degrees, model->order)), model->after);
}

nkw_vec3 nkwi_fbx_translation(const nkwi_fbx_model *model, nkw_vec3 t, nkw_quat rotation, nkw_vec3 s)
{
    const nkw_vec3 sum = nkw_vec3_add(t, model->rotation_offset);
    if (!model->has_pivot)
        return sum;
    nkw_vec3 arm = nkw_vec3_sub(nkw_vec3_add(model->scaling_offset, model->scaling_pivot), model->rotation_pivot);
    arm = nkw_vec3_sub(arm, nkw_vec3_mul(s, model->scaling_pivot));
    return nkw_vec3_add(nkw_vec3_add(sum, model->rotation_pivot), nkw_quat_rotate(rotation, arm));
}
