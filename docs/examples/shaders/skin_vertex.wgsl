// SPDX-License-Identifier: MIT
// Made by docs/generate/shaders.cmake; do not edit.
struct Object {
    transform: mat4x4f,        // from the model to the world
    view_projection: mat4x4f,  // from the world to the clip space
}
@group(0) @binding(0) var<storage, read> joint_matrices: array<mat4x4f>;
@group(0) @binding(1) var<uniform> object: Object;

struct Input {
    @location(0) position: vec3f,
    @location(1) texcoord: vec2f,
    @location(2) normal: vec3f,
    @location(3) joints: vec4u,   // uint16x4
    @location(4) weights: vec4f,  // unorm16x4
}

struct Output {
    @location(0) position: vec3f,
    @location(1) texcoord: vec2f,
    @location(2) normal: vec3f,
    @builtin(position) clip: vec4f,
}

fn joint_matrix(i: u32) -> mat4x4f
{
    return joint_matrices[i];
}

// M = w0 M0 + w1 M1 + w2 M2 + w3 M3, the joint matrices from the number `first` on.
fn blended(joint: vec4u, weight: vec4f, first: u32) -> mat4x4f
{
    let two = joint_matrix(first + joint.x) * weight.x + joint_matrix(first + joint.y) * weight.y;
    let three = two + joint_matrix(first + joint.z) * weight.z;
    return three + joint_matrix(first + joint.w) * weight.w;
}

// M p for a point.
fn moved(m: mat4x4f, p: vec3f) -> vec3f
{
    let q = m * vec4f(p, 1.0);
    return q.xyz;
}

// v / |v|; 0 stays 0.
fn unit(v: vec3f) -> vec3f
{
    return v / max(length(v), 1e-30);
}

// M v, made unit: tangents and bitangents.
fn turned(m: mat4x4f, v: vec3f) -> vec3f
{
    let q = m * vec4f(v, 0.0);
    return unit(q.xyz);
}

// (M^-1)^T n, made unit: normals. With the columns a, b, c of the 3x3 block,
//     (M^-1)^T = (b x c, c x a, a x b) / det,    det = a . (b x c),
// and only the sign of det counts.
fn turned_normal(m: mat4x4f, n: vec3f) -> vec3f
{
    let a = m * vec4f(1.0, 0.0, 0.0, 0.0);
    let b = m * vec4f(0.0, 1.0, 0.0, 0.0);
    let c = m * vec4f(0.0, 0.0, 1.0, 0.0);
    let bc = cross(b.xyz, c.xyz);
    let side = step(0.0, dot(a.xyz, bc)) * 2.0 - 1.0;
    let r = bc * n.x + cross(c.xyz, a.xyz) * n.y + cross(a.xyz, b.xyz) * n.z;
    return unit(r * side);
}

@vertex
fn main(v: Input) -> Output
{
    let m = object.transform * blended(v.joints, v.weights, 0u);
    var r: Output;
    r.position = moved(m, v.position);
    r.texcoord = v.texcoord;
    r.normal = turned_normal(m, v.normal);
    r.clip = object.view_projection * vec4f(r.position, 1.0);
    return r;
}
