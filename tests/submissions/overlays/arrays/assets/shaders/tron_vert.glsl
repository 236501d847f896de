#version 330 core

layout(location = 0) in vec3 position;
layout(location = 1) in vec2 texCoord;
layout(location = 2) in vec3 normal;

uniform mat4 model;
uniform mat4 view;
uniform mat4 projection;
uniform vec2 tcMultiplier;

const int POINTS = 5;

// lights, with their positions in world space
struct Light {
    vec3 pos;
    vec3 color;
    vec3 att;
};

struct Spot {
    vec3 pos;
    vec3 color;
    vec3 att;
    vec3 dir;
    float inner;
    float outer;
};

uniform Light points[POINTS];
uniform Spot spot;

out vec2 tc;
out vec3 normalView;
out vec3 toCamera;
out vec3 toPoints[POINTS];
out vec3 toSpot;

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
    for (int i = 0; i < POINTS; i++) {
        toPoints[i] = toLight(points[i].pos, pos.xyz);
    }
    toSpot = toLight(spot.pos, pos.xyz);
}
