StructuredBuffer<float> source : register(t0);
StructuredBuffer<float> weights : register(t1);
StructuredBuffer<float4x4> joint_matrices : register(t2);
RWStructuredBuffer<float> destination : register(u3);
struct Draw {
    uint source_first;       // floats before the mesh in `source`
    uint vertex_count;
    uint weights_first;      // floats before the mesh in `weights`
    uint matrices_first;     // matrices before the frame: chunk.first + frame * chunk.joint_count
    uint destination_first;  // floats before the mesh in `destination`
};
cbuffer Parameters : register(b0) {
    Draw draw;
};

float4x4 joint_matrix(uint i)
{
    return joint_matrices[i];
}

@COMMON@
[numthreads(64, 1, 1)]
void main(uint3 id : SV_DispatchThreadID)
{
    if (id.x < draw.vertex_count) {
        skin_vertex(id.x);
    }
}
