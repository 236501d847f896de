#version 330 core
#define float2 vec2
#define float3 vec3
#define float4 vec4
#define MAX_ADD_LIGHTS 6

// OS = object space, VS = view space
layout(location = 0) in float3 positionOS;
layout(location = 1) in float2 texcoord;
layout(location = 2) in float3 normalOS;

uniform mat4 _ObjectToWorld;
uniform mat4 _MatrixV;
uniform mat4 _MatrixP;
uniform mat4 _MatrixIT_MV;
uniform float2 _MainTex_Tiling;

// all of them in view space, LightManager does that
uniform float3 _MainLightPos;
uniform float3 _HeadLightPos;
uniform float3 _AddLightPos[MAX_ADD_LIGHTS];

out Varyings {
    float2 uv;
    float3 normalVS;
    float3 toCamera;
    float3 toMainLight;
    float3 toHeadLight;
    float3 toAddLight[MAX_ADD_LIGHTS];
} vertOut;

void main() {
    float3 positionVS = (_MatrixV * _ObjectToWorld * float4(positionOS, 1.0)).xyz;

    vertOut.uv = texcoord * _MainTex_Tiling;
    vertOut.normalVS = mat3(_MatrixIT_MV) * normalOS;

    // not normalized here, that would break the interpolation
    vertOut.toCamera = -positionVS;
    vertOut.toMainLight = _MainLightPos - positionVS;
    vertOut.toHeadLight = _HeadLightPos - positionVS;
    for (int i = 0; i < MAX_ADD_LIGHTS; i++) {
        vertOut.toAddLight[i] = _AddLightPos[i] - positionVS;
    }

    gl_Position = _MatrixP * float4(positionVS, 1.0);
}
