// SPDX-License-Identifier: MIT
// Made by docs/generate/shaders.cmake; do not edit.
struct Draw {
    source_first: u32,       // floats before the mesh in `source`
    vertex_count: u32,
    weights_first: u32,      // floats before the mesh in `weights`
    matrices_first: u32,     // matrices before the frame: chunk.first + frame * chunk.joint_count
    destination_first: u32,  // floats before the mesh in `destination`
}
@group(0) @binding(0) var<storage, read> source: array<f32>;
@group(0) @binding(1) var<storage, read> weights: array<f32>;
@group(0) @binding(2) var<storage, read> joint_matrices: array<mat4x4f>;
@group(0) @binding(3) var<storage, read_write> destination: array<f32>;
@group(0) @binding(4) var<uniform> draw: Draw;

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

fn vector_at(at: u32) -> vec3f
{
    return vec3f(source[at], source[at + 1u], source[at + 2u]);
}

fn store(at: u32, v: vec3f)
{
    destination[at] = v.x;
    destination[at + 1u] = v.y;
    destination[at + 2u] = v.z;
}

// Vertex i of the mesh: 4 weights, then 4 joints as floats; position 3, normal 3, tangent 3, bitangent 3, texture 2.
fn skin_vertex(i: u32)
{
    let w = draw.weights_first + 8u * i;
    let s = draw.source_first + 14u * i;
    let d = draw.destination_first + 14u * i;
    let weight = vec4f(weights[w], weights[w + 1u], weights[w + 2u], weights[w + 3u]);
    let joint = vec4u(vec4f(weights[w + 4u], weights[w + 5u], weights[w + 6u], weights[w + 7u]));
    let m = blended(joint, weight, draw.matrices_first);
    let sum = weight.x + weight.y + weight.z + weight.w;
    store(d, moved(m, vector_at(s)) / sum);
    store(d + 3u, turned_normal(m, vector_at(s + 3u)));
    store(d + 6u, turned(m, vector_at(s + 6u)));
    store(d + 9u, turned(m, vector_at(s + 9u)));
    destination[d + 12u] = source[s + 12u];
    destination[d + 13u] = source[s + 13u];
}

@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u)
{
    if (id.x < draw.vertex_count) {
        skin_vertex(id.x);
    }
}
