// SPDX-License-Identifier: MIT
// Made by docs/generate/shaders.cmake; do not edit.
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

// Vertex i of the mesh: 4 weights, then 4 joints as floats; position 3, normal 3, tangent 3, bitangent 3, texture 2.
void skin_vertex(uint i)
{
    uint w = draw.weights_first + 8u * i;
    uint s = draw.source_first + 14u * i;
    uint d = draw.destination_first + 14u * i;
    float4 weight = float4(weights[w], weights[w + 1u], weights[w + 2u], weights[w + 3u]);
    uint4 joint = uint4(float4(weights[w + 4u], weights[w + 5u], weights[w + 6u], weights[w + 7u]));
    float4x4 m = blended(joint, weight, draw.matrices_first);
    float sum = weight.x + weight.y + weight.z + weight.w;
    store(d, moved(m, vector_at(s)) / sum);
    store(d + 3u, turned_normal(m, vector_at(s + 3u)));
    store(d + 6u, turned(m, vector_at(s + 6u)));
    store(d + 9u, turned(m, vector_at(s + 9u)));
    destination[d + 12u] = source[s + 12u];
    destination[d + 13u] = source[s + 13u];
}

[numthreads(64, 1, 1)]
void main(uint3 id : SV_DispatchThreadID)
{
    if (id.x < draw.vertex_count) {
        skin_vertex(id.x);
    }
}
