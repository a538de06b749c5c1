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
} draw;

mat4 joint_matrix(uint i)
{
    return joint_matrices[i];
}

@COMMON@
void main()
{
    if (gl_GlobalInvocationID.x < draw.vertex_count) {
        skin_vertex(gl_GlobalInvocationID.x);
    }
}
