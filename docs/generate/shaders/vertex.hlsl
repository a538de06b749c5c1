StructuredBuffer<float4x4> joint_matrices : register(t0);
cbuffer Object : register(b0) {
    float4x4 transform;        // from the model to the world
    float4x4 view_projection;  // from the world to the clip space
};

struct Input {
    float3 position : POSITION;
    float2 texcoord : TEXCOORD0;
    float3 normal : NORMAL;
    uint4 joints : BLENDINDICES;    // R16G16B16A16_UINT
    float4 weights : BLENDWEIGHT;   // R16G16B16A16_UNORM
};

struct Output {
    float3 position : POSITION;
    float2 texcoord : TEXCOORD0;
    float3 normal : NORMAL;
    float4 clip : SV_Position;
};

float4x4 joint_matrix(uint i)
{
    return joint_matrices[i];
}

@COMMON@
Output main(Input v)
{
    float4x4 m = mul(transform, blended(v.joints, v.weights, 0u));
    Output r;
    r.position = moved(m, v.position);
    r.texcoord = v.texcoord;
    r.normal = turned_normal(m, v.normal);
    r.clip = mul(view_projection, float4(r.position, 1.0));
    return r;
}
