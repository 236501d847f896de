#version 330 core

layout(location = 0) in vec3 position;
layout(location = 1) in vec2 texCoord;
layout(location = 2) in vec3 normal;

//uniforms
// translation object to world
uniform mat4 model_matrix;
uniform mat4 view_matrix;
uniform mat4 proj_matrix;

uniform vec2 tcMultiplier;

uniform vec3 bikeLightPos;
uniform vec3 spotLightPos;
uniform vec3 ecke1LightPos;
uniform vec3 ecke2LightPos;
uniform vec3 ecke3LightPos;
uniform vec3 ecke4LightPos;

out struct VertexData
{
    vec2 tc;
    vec3 normal;
    vec3 toCamera;
    vec3 toBikeLight;
    vec3 toSpotLight;
    vec3 toEcke1;
    vec3 toEcke2;
    vec3 toEcke3;
    vec3 toEcke4;
} vertexData;

void main() {
    mat4 modelview = view_matrix * model_matrix;
    vec4 pos = modelview * vec4(position, 1.0f);
    mat4 normalMat = transpose(inverse(modelview));

    gl_Position = proj_matrix * pos;

    vertexData.tc = texCoord * tcMultiplier;
    vertexData.normal = (normalMat * vec4(normal, 0.0f)).xyz;

    // Kamera ist im View Space im Ursprung
    vertexData.toCamera = -pos.xyz;

    vec4 lp = view_matrix * vec4(bikeLightPos, 1.0f);
    vertexData.toBikeLight = (lp - pos).xyz;

    vec4 lpSpot = view_matrix * vec4(spotLightPos, 1.0f);
    vertexData.toSpotLight = (lpSpot - pos).xyz;

    vec4 lpEcke1 = view_matrix * vec4(ecke1LightPos, 1.0f);
    vec4 lpEcke2 = view_matrix * vec4(ecke2LightPos, 1.0f);
    vec4 lpEcke3 = view_matrix * vec4(ecke3LightPos, 1.0f);
    vec4 lpEcke4 = view_matrix * vec4(ecke4LightPos, 1.0f);
    vertexData.toEcke1 = (lpEcke1 - pos).xyz;
    vertexData.toEcke2 = (lpEcke2 - pos).xyz;
    vertexData.toEcke3 = (lpEcke3 - pos).xyz;
    vertexData.toEcke4 = (lpEcke4 - pos).xyz;
}
