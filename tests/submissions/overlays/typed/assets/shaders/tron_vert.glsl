#version 330 core

layout(location = 0) in vec3 in_position;
layout(location = 1) in vec2 in_uv;
layout(location = 2) in vec3 in_normal;

uniform mat4 u_model;
uniform mat4 u_view;
uniform mat4 u_proj;
uniform mat3 u_normal;
uniform vec2 u_tiling;

out vec3 v_position;
out vec3 v_normal;
out vec2 v_uv;

void main() {
    vec4 viewPosition = u_view * (u_model * vec4(in_position, 1.0));
    v_position = viewPosition.xyz;
    v_normal = u_normal * in_normal;
    v_uv = u_tiling * in_uv;
    gl_Position = u_proj * viewPosition;
}
