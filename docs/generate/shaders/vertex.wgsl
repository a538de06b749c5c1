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

@COMMON@
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
