#version 330 core
#define MAX_LIGHTS 8

layout(location = 0) in vec3 a_pos;
layout(location = 1) in vec2 a_uv;
layout(location = 2) in vec3 a_normal;

// everything in world space
struct Light {
    vec3 pos;
    vec3 dir;
    vec3 color;
    vec3 k;     // constant, linear, quadratic
    vec2 cone;  // cos(inner), cos(outer)
};

uniform Light lights[MAX_LIGHTS];
uniform int u_lightCount;

uniform mat4 u_model;
uniform mat4 u_view;
uniform mat4 u_proj;
uniform mat3 u_normalMat;
uniform vec2 u_tiling;

out Varyings {
    vec2 uv;
    vec3 normal;
    vec3 toEye;
    vec3 toLight[MAX_LIGHTS];
} vs;

void main() {
    vec3 p = (u_view * u_model * vec4(a_pos, 1.0)).xyz;

    vs.uv = a_uv * u_tiling;
    vs.normal = u_normalMat * a_normal;
    vs.toEye = -p; // the eye sits in (0, 0, 0)

    for (int i = 0; i < u_lightCount; i++) {
        vec3 lightPos = (u_view * vec4(lights[i].pos, 1.0)).xyz;
        vs.toLight[i] = lightPos - p;
    }

    gl_Position = u_proj * vec4(p, 1.0);
}
