#version 450
layout(local_size_x = 64) in;
layout(std430, binding = 0) readonly buffer Source { float source[]; };
layout(std430, binding = 1) readonly buffer Weights { float weights[]; };
layout(std430, binding = 2) readonly buffer Palette { mat4 joint_matrices[]; };
layout(std430, binding = 3) buffer Destination { float destination[]; };
layout(std140, binding = 0) uniform Draw {
    uint source_first;       // floats before the mesh in `source`
    uint vertex_count;
    uint weights_first;      // floats before the mesh in `weights`
    uint matrices_first;     // matrices before the frame: chunk.first + frame * chunk.joint_count
    uint destination_first;  // floats before the mesh in `destination`
};

mat4 joint_matrix(uint i)
{
    return joint_matrices[i];
}

vec3 vector_at(uint at)
{
    return vec3(source[at], source[at + 1u], source[at + 2u]);
}

void store(uint at, vec3 v)
{
    destination[at] = v.x;
    destination[at + 1u] = v.y;
    destination[at + 2u] = v.z;
}

@COMMON@
void main()
{
    uint i = gl_GlobalInvocationID.x;
    if (i >= vertex_count)
        return;
    uint w = weights_first + 8u * i, s = source_first + 14u * i, d = destination_first + 14u * i;
    vec4 weight = vec4(weights[w], weights[w + 1u], weights[w + 2u], weights[w + 3u]);
    uvec4 joint = uvec4(vec4(weights[w + 4u], weights[w + 5u], weights[w + 6u], weights[w + 7u]));
    mat4 m = blended(joint, weight, matrices_first);
    float sum = weight.x + weight.y + weight.z + weight.w;
    store(d, moved(m, vector_at(s)) / sum);
    store(d + 3u, turned_normal(m, vector_at(s + 3u)));
    store(d + 6u, turned(m, vector_at(s + 6u)));
    store(d + 9u, turned(m, vector_at(s + 9u)));
    destination[d + 12u] = source[s + 12u];
    destination[d + 13u] = source[s + 13u];
}
