#version 330 core

#define MAX_LIGHTS 8

layout(location = 0) in vec3 position;
layout(location = 1) in vec2 texCoord;
layout(location = 2) in vec3 normal;

struct Light {
    vec3 pos;
    vec3 col;
    vec3 att;
};

// uniforms
uniform mat4 model_matrix;
uniform mat4 view_matrix;
uniform mat4 projection_matrix;
uniform vec2 tcMultiplier;
uniform Light lights[MAX_LIGHTS];
uniform Light spot;

out vec2 vTexCoord;
out vec3 vNormal;
out vec3 vToCamera;
out vec3 vToLight[MAX_LIGHTS];
out vec3 vToSpot;

void main() {
    vec4 worldPos = model_matrix * vec4(position, 1.0);
    vec4 viewPos = view_matrix * worldPos;

    for (int i = 0; i < MAX_LIGHTS; i++) {
        vToLight[i] = (view_matrix * vec4(lights[i].pos, 1.0) - viewPos).xyz;
    }
    vToSpot = (view_matrix * vec4(spot.pos, 1.0) - viewPos).xyz;
    vToCamera = -viewPos.xyz;

    vNormal = mat3(transpose(inverse(view_matrix * model_matrix))) * normal;
    vTexCoord = texCoord * tcMultiplier;
    gl_Position = projection_matrix * viewPos;
}
