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

@COMMON@
@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) id: vec3u)
{
    if (id.x < draw.vertex_count) {
        skin_vertex(id.x);
    }
}
