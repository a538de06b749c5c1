// SPDX-License-Identifier: MIT
// Made by docs/generate/shaders.cmake; do not edit.
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

// M = w0 M0 + w1 M1 + w2 M2 + w3 M3, the joint matrices from the number `first` on.
float4x4 blended(uint4 joint, float4 weight, uint first)
{
    float4x4 two = joint_matrix(first + joint.x) * weight.x + joint_matrix(first + joint.y) * weight.y;
    float4x4 three = two + joint_matrix(first + joint.z) * weight.z;
    return three + joint_matrix(first + joint.w) * weight.w;
}

// M p for a point.
float3 moved(float4x4 m, float3 p)
{
    float4 q = mul(m, float4(p, 1.0));
    return q.xyz;
}

// v / |v|; 0 stays 0.
float3 unit(float3 v)
{
    return v / max(length(v), 1e-30);
}

// M v, made unit: tangents and bitangents.
float3 turned(float4x4 m, float3 v)
{
    float4 q = mul(m, float4(v, 0.0));
    return unit(q.xyz);
}

// (M^-1)^T n, made unit: normals. With the columns a, b, c of the 3x3 block,
//     (M^-1)^T = (b x c, c x a, a x b) / det,    det = a . (b x c),
// and only the sign of det counts.
float3 turned_normal(float4x4 m, float3 n)
{
    float4 a = mul(m, float4(1.0, 0.0, 0.0, 0.0));
    float4 b = mul(m, float4(0.0, 1.0, 0.0, 0.0));
    float4 c = mul(m, float4(0.0, 0.0, 1.0, 0.0));
    float3 bc = cross(b.xyz, c.xyz);
    float side = step(0.0, dot(a.xyz, bc)) * 2.0 - 1.0;
    float3 r = bc * n.x + cross(c.xyz, a.xyz) * n.y + cross(a.xyz, b.xyz) * n.z;
    return unit(r * side);
}

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
