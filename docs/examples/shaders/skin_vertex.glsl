#version 450
// SPDX-License-Identifier: MIT
// Made by docs/generate/shaders.cmake; do not edit.
layout(location = 0) in vec3 position_in;
layout(location = 1) in vec2 texcoord_in;
layout(location = 2) in vec3 normal_in;
layout(location = 3) in uvec4 joints_in;  // glVertexAttribIPointer, GL_UNSIGNED_SHORT
layout(location = 4) in vec4 weights_in;  // glVertexAttribPointer, GL_UNSIGNED_SHORT, GL_TRUE
layout(std430, binding = 0) readonly buffer Palette { mat4 joint_matrices[]; };
layout(std140, binding = 0) uniform Object {
    mat4 transform;        // from the model to the world
    mat4 view_projection;  // from the world to the clip space
};
layout(location = 0) out vec3 position_out;
layout(location = 1) out vec2 texcoord_out;
layout(location = 2) out vec3 normal_out;

mat4 joint_matrix(uint i)
{
    return joint_matrices[i];
}

// M = w0 M0 + w1 M1 + w2 M2 + w3 M3, the joint matrices from the number `first` on.
mat4 blended(uvec4 joint, vec4 weight, uint first)
{
    mat4 two = joint_matrix(first + joint.x) * weight.x + joint_matrix(first + joint.y) * weight.y;
    mat4 three = two + joint_matrix(first + joint.z) * weight.z;
    return three + joint_matrix(first + joint.w) * weight.w;
}

// M p for a point.
vec3 moved(mat4 m, vec3 p)
{
    vec4 q = m * vec4(p, 1.0);
    return q.xyz;
}

// v / |v|; 0 stays 0.
vec3 unit(vec3 v)
{
    return v / max(length(v), 1e-30);
}

// M v, made unit: tangents and bitangents.
vec3 turned(mat4 m, vec3 v)
{
    vec4 q = m * vec4(v, 0.0);
    return unit(q.xyz);
}

// (M^-1)^T n, made unit: normals. With the columns a, b, c of the 3x3 block,
//     (M^-1)^T = (b x c, c x a, a x b) / det,    det = a . (b x c),
// and only the sign of det counts.
vec3 turned_normal(mat4 m, vec3 n)
{
    vec4 a = m * vec4(1.0, 0.0, 0.0, 0.0);
    vec4 b = m * vec4(0.0, 1.0, 0.0, 0.0);
    vec4 c = m * vec4(0.0, 0.0, 1.0, 0.0);
    vec3 bc = cross(b.xyz, c.xyz);
    float side = step(0.0, dot(a.xyz, bc)) * 2.0 - 1.0;
    vec3 r = bc * n.x + cross(c.xyz, a.xyz) * n.y + cross(a.xyz, b.xyz) * n.z;
    return unit(r * side);
}

void main()
{
    mat4 m = transform * blended(joints_in, weights_in, 0u);
    position_out = moved(m, position_in);
    texcoord_out = texcoord_in;
    normal_out = turned_normal(m, normal_in);
    gl_Position = view_projection * vec4(position_out, 1.0);
}
