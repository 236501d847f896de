#version 330 core

layout(location = 0) in vec3 position;
layout(location = 1) in vec2 texCoord;
layout(location = 2) in vec3 normal;

uniform mat4 model;
uniform mat4 view;
uniform mat4 projection;
uniform vec2 tcMultiplier;

// positions of the lights in world space
uniform vec3 bikePos;
uniform vec3 spotPos;
uniform vec3 corner1Pos;
uniform vec3 corner2Pos;
uniform vec3 corner3Pos;
uniform vec3 corner4Pos;

out struct VertexData {
    vec2 tc;
    vec3 normalView;
    vec3 toCamera;
    vec3 toBike;
    vec3 toSpot;
    vec3 toCorner1;
    vec3 toCorner2;
    vec3 toCorner3;
    vec3 toCorner4;
} vertexData;

// from the vertex (in view space) to a light
vec3 toLight(vec3 lightPos, vec3 pos) {
    return (view * vec4(lightPos, 1.0)).xyz - pos;
}

void main() {
    mat4 modelView = view * model;
    vec4 pos = modelView * vec4(position, 1.0);
    gl_Position = projection * pos;

    vertexData.tc = texCoord * tcMultiplier;
    vertexData.normalView = transpose(inverse(mat3(modelView))) * normal;

    // in view space the camera is at the origin
    vertexData.toCamera = -pos.xyz;
    vertexData.toBike = toLight(bikePos, pos.xyz);
    vertexData.toSpot = toLight(spotPos, pos.xyz);
    vertexData.toCorner1 = toLight(corner1Pos, pos.xyz);
    vertexData.toCorner2 = toLight(corner2Pos, pos.xyz);
    vertexData.toCorner3 = toLight(corner3Pos, pos.xyz);
    vertexData.toCorner4 = toLight(corner4Pos, pos.xyz);
}
