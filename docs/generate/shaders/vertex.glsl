#version 450
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

@COMMON@
void main()
{
    mat4 m = transform * blended(joints_in, weights_in, 0u);
    position_out = moved(m, position_in);
    texcoord_out = texcoord_in;
    normal_out = turned_normal(m, normal_in);
    gl_Position = view_projection * vec4(position_out, 1.0);
}
