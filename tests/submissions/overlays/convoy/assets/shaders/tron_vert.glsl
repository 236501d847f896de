#version 330 core
#define POINTS 8
#define SPOTS 2

layout(location = 0) in vec3 inPos;
layout(location = 1) in vec2 inTex;
layout(location = 2) in vec3 inNormal;

struct PointLight {
    vec3 position;
    vec3 color;
    vec3 attenuation;
};

struct SpotLight {
    PointLight base;
    vec3 direction;
    float innerCos;
    float outerCos;
};

uniform mat4 model;
uniform mat4 view;
uniform mat4 projection;
uniform vec2 tcMultiplier;
uniform PointLight points[POINTS];
uniform SpotLight spots[SPOTS];

out VertexData {
    vec2 uv;
    vec3 normal;
    vec3 toCamera;
    vec3 toPoint[POINTS];
    vec3 toSpot[SPOTS];
} vs;

vec3 intoView(vec3 worldPos) {
    return (view * vec4(worldPos, 1.0)).xyz;
}

void main() {
    vec3 p = intoView((model * vec4(inPos, 1.0)).xyz);
    gl_Position = projection * vec4(p, 1.0);

    vs.uv = inTex * tcMultiplier;
    vs.normal = (view * model * vec4(inNormal, 0.0)).xyz;
    vs.toCamera = -p;
    for (int i = 0; i < POINTS; i++) {
        vs.toPoint[i] = intoView(points[i].position) - p;
    }
    for (int i = 0; i < SPOTS; i++) {
        vs.toSpot[i] = intoView(spots[i].base.position) - p;
    }
}
