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

@COMMON@
@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u)
{
    let i = id.x;
    if (i >= draw.vertex_count) {
        return;
    }
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
