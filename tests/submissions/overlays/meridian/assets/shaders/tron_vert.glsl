#version 330 core

const int POINT_LIGHTS = 5;

struct PointLight {
    vec3 position;
    vec3 color;
    vec3 attenuation;
};

struct SpotLight {
    PointLight source;
    vec3 direction;
    float cosInner;
    float cosOuter;
};

layout(location = 0) in vec3 position;
layout(location = 1) in vec2 texCoord;
layout(location = 2) in vec3 normal;

uniform mat4 model;
uniform mat4 view;
uniform mat4 projection;
uniform vec2 tcMultiplier;
uniform PointLight points[POINT_LIGHTS];
uniform SpotLight spot;

out vec2 uv;
out vec3 viewNormal;
out vec3 toCamera;
out vec3 toPoints[POINT_LIGHTS];
out vec3 toSpot;

vec3 toView(vec3 worldPosition) {
    return (view * vec4(worldPosition, 1.0)).xyz;
}

void main() {
    mat4 modelView = view * model;
    vec4 viewPosition = modelView * vec4(position, 1.0);

    uv = texCoord * tcMultiplier;
    viewNormal = inverse(transpose(mat3(modelView))) * normal;
    toCamera = -viewPosition.xyz;
    for (int i = 0; i < POINT_LIGHTS; i++) {
        toPoints[i] = toView(points[i].position) - viewPosition.xyz;
    }
    toSpot = toView(spot.source.position) - viewPosition.xyz;

    gl_Position = projection * viewPosition;
}
