StructuredBuffer<float> source : register(t0);
StructuredBuffer<float> weights : register(t1);
StructuredBuffer<float4x4> joint_matrices : register(t2);
RWStructuredBuffer<float> destination : register(u3);
cbuffer Draw : register(b0) {
    uint source_first;       // floats before the mesh in `source`
    uint vertex_count;
    uint weights_first;      // floats before the mesh in `weights`
    uint matrices_first;     // matrices before the frame: chunk.first + frame * chunk.joint_count
    uint destination_first;  // floats before the mesh in `destination`
};

float4x4 joint_matrix(uint i)
{
    return joint_matrices[i];
}

float3 vector_at(uint at)
{
    return float3(source[at], source[at + 1u], source[at + 2u]);
}

void store(uint at, float3 v)
{
    destination[at] = v.x;
    destination[at + 1u] = v.y;
    destination[at + 2u] = v.z;
}

@COMMON@
[numthreads(64, 1, 1)]
void main(uint3 id : SV_DispatchThreadID)
{
    uint i = id.x;
    if (i >= vertex_count)
        return;
    uint w = weights_first + 8u * i, s = source_first + 14u * i, d = destination_first + 14u * i;
    float4 weight = float4(weights[w], weights[w + 1u], weights[w + 2u], weights[w + 3u]);
    uint4 joint = uint4(float4(weights[w + 4u], weights[w + 5u], weights[w + 6u], weights[w + 7u]));
    float4x4 m = blended(joint, weight, matrices_first);
    float sum = weight.x + weight.y + weight.z + weight.w;
    store(d, moved(m, vector_at(s)) / sum);
    store(d + 3u, turned_normal(m, vector_at(s + 3u)));
    store(d + 6u, turned(m, vector_at(s + 6u)));
    store(d + 9u, turned(m, vector_at(s + 9u)));
    destination[d + 12u] = source[s + 12u];
    destination[d + 13u] = source[s + 13u];
}
