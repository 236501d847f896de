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

const vec3 CORNERS[4] = vec3[](
    vec3(-15.0, 1.5, -15.0),
    vec3(15.0, 1.5, -15.0),
    vec3(-15.0, 1.5, 15.0),
    vec3(15.0, 1.5, 15.0)
);

out vec2 tc;
out vec3 normalView;
out vec3 toCamera;
out vec3 toBike;
out vec3 toSpot;
out vec3 toCorner[4];

// from the vertex (in view space) to a light
vec3 toLight(vec3 lightPos, vec3 pos) {
    return (view * vec4(lightPos, 1.0)).xyz - pos;
}

void main() {
    mat4 modelView = view * model;
    vec4 pos = modelView * vec4(position, 1.0);
    gl_Position = projection * pos;

    tc = texCoord * tcMultiplier;
    normalView = transpose(inverse(mat3(modelView))) * normal;

    // in view space the camera is at the origin
    toCamera = -pos.xyz;
    toBike = toLight(bikePos, pos.xyz);
    toSpot = toLight(spotPos, pos.xyz);
    for (int i = 0; i < 4; i++) toCorner[i] = toLight(CORNERS[i], pos.xyz);
}
